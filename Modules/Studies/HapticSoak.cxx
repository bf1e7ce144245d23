#include "Studies/HapticSoak.h"
#include "Haptics/ContactFriction.h"
#include "Haptics/FieldContact.h"
#include "Haptics/ForceLimiter.h"
#include "Haptics/PassivityObserver.h"
#include "Haptics/VirtualCoupling.h"
#include "Studies/BenchBodies.h"
#include "Studies/CpuSeconds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace hasp
{
namespace
{

constexpr double TickS = 0.001;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Gradients that are no numbers in half of the places, and distances in a part of them.
struct HoledBody : ImplicitField
{
  Sample At(const glm::dvec3& p) const noexcept override
  {
    return p.x > 0.0 ? Sample{ p.y > 3.0 ? NaN : p.z, glm::dvec3(NaN) }
                     : Sample{ p.z, { 0.0, 0.0, 1.0 } };
  }
};

class Soak
{
public:
  explicit Soak(std::uint32_t seed)
    : Random(seed),
      Contact(FootPoints(3, 10.0), 1.0, this->Wall),
      Friction({ .coefficient = 0.3 }),
      Limiter({ .rampInS = 0.1 })
  {
    this->Figures.limitN = this->Limiter.Limits().force;
  }

  void Tick()
  {
    if (this->Figures.ticks % 2000 == 0)
      this->Change();
    this->Walk();
    const bool lost = this->In(0.0, 1.0) < 0.001;
    RigidPose read = this->Device;
    if (lost)
      read.orientation.x = this->In(0.0, 1.0) < 0.5 ? NaN : 1e9;
    this->Rubbed.contact = &this->Contact;
    this->Rubbed.friction = &this->Friction;
    const CouplingTick tick = this->Coupling.Tick(read, this->Rubbed);
    this->Friction.Settle(this->Coupling.Tool());
    const Wrench out = this->Limiter.Limit(this->Control.Tick(read, tick.onDevice), TickS);
    ++this->Figures.ticks;
    this->Figures.badPoses += (tick.status & CouplingTick::BadDevicePose) != 0;
    this->Figures.badContacts += (tick.status & CouplingTick::Unsolved) != 0;
    this->Figures.touched += tick.sums.contacts > 0;
    this->Check(out);
  }

  SoakFigures Figures;

private:
  struct RubbedContact : ToolContact
  {
    FieldContact* contact = nullptr;
    ContactFriction* friction = nullptr;
    Answer At(const RigidPose& tool) noexcept override
    {
      Answer answer = this->contact->At(tool);
      this->friction->Add(tool, answer);
      return answer;
    }
  };

  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  glm::dvec3 Vector(double size)
  {
    return { this->In(-size, size), this->In(-size, size), this->In(-size, size) };
  }

  void Change()
  {
    const std::array<const ImplicitField*, 7> bodies{ &this->Wall, &this->Plate, &this->Groove,
      &this->Hole, &this->Slot, &this->Ball, &this->Holed };
    this->Contact.SetField(*bodies[static_cast<std::size_t>(this->In(0.0, 6.999))]);
    this->Contact.SetStiffness(
      this->In(0.0, 1.0) < 0.1 ? 0.0 : std::pow(10.0, this->In(-3.0, 4.0)));
    this->Coupling.SetSpring({ std::pow(10.0, this->In(-2.0, 1.0)),
      std::pow(10.0, this->In(0.0, 4.0)), this->In(0.5, 20.0), this->In(10.0, 600.0) });
    if (this->In(0.0, 1.0) < 0.3)
    {
      this->Limiter.Restart();
      this->Last = {};
    }
    ++this->Figures.changes;
  }

  /// Of a hand in a hurry: 0.3 m/s, kept about the bodies; jumps a few times a minute.
  void Walk()
  {
    this->Speed += this->Vector(40.0) - 0.05 * this->Speed - 0.2 * this->Device.position;
    this->Device.position += this->Speed * TickS;
    this->Turning += this->Vector(1.0) - 0.05 * this->Turning;
    this->Device.orientation =
      glm::normalize(TurnBy(this->Turning * TickS) * this->Device.orientation);
    if (this->In(0.0, 1.0) < 1e-4)
      this->Device = { this->Vector(this->In(0.0, 1.0) < 0.5 ? 20.0 : 1e4),
        TurnBy(this->Vector(3.0)) };
  }

  void Check(const Wrench& out)
  {
    const ForceLimits& limits = this->Limiter.Limits();
    const RigidPose& tool = this->Coupling.Tool();
    const double force = glm::length(out.force), torque = glm::length(out.torque);
    this->Figures.notFinite += !IsFinite(out) || !IsPose(tool);
    this->Figures.overLimit +=
      force > limits.force * (1.0 + 1e-12) || torque > limits.torque * (1.0 + 1e-12);
    this->Figures.overSlew +=
      force > glm::length(this->Last.force) + limits.forceSlew * TickS + 1e-9 ||
      torque > glm::length(this->Last.torque) + limits.torqueSlew * TickS + 1e-9;
    this->Figures.largestForceN = std::max(this->Figures.largestForceN, force);
    this->Last = out;
  }

  std::mt19937 Random;
  WallBody Wall;
  PlateBody Plate;
  GrooveBody Groove;
  HoleBody Hole;
  SlotBody Slot;
  BallBody Ball;
  HoledBody Holed;
  FieldContact Contact;
  ContactFriction Friction;
  RubbedContact Rubbed;
  VirtualCoupling Coupling;
  PassivityController Control;
  ForceLimiter Limiter;
  RigidPose Device;
  glm::dvec3 Speed{ 0.0 }, Turning{ 0.0 };
  Wrench Last;
};

} // namespace

SoakFigures RunSoak(std::uint64_t ticks, std::uint32_t seed, const ProgressFunction& progress)
{
  const double began = CpuSeconds();
  Soak soak(seed);
  while (soak.Figures.ticks < ticks)
  {
    if (soak.Figures.ticks % 65'536 == 0)
      ReportProgress(
        progress, static_cast<double>(soak.Figures.ticks) / static_cast<double>(ticks));
    soak.Tick();
  }
  soak.Figures.cpuS = CpuSeconds() - began;
  return soak.Figures;
}

} // namespace hasp
