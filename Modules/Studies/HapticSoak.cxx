#include "Studies/HapticSoak.h"
#include "Haptics/ContactFriction.h"
#include "Haptics/FieldContact.h"
#include "Haptics/PassivityObserver.h"
#include "Haptics/VirtualCoupling.h"
#include "Realtime/ForceLimiter.h"
#include "Studies/BenchBodies.h"
#include "Studies/CpuSeconds.h"
#include "Studies/SoakParts.h"

#include <array>
#include <cmath>
#include <limits>

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
    : Dice(seed),
      Contact(FootPoints(3, 10.0), 1.0, this->Wall),
      Friction({ .coefficient = 0.3 }),
      Limiter({ .rampInS = 0.1 }),
      Judge(Limiter.Limits())
  {
    this->Figures.limitN = this->Limiter.Limits().force;
  }

  void Tick()
  {
    if (this->Figures.ticks % 2000 == 0)
      this->Change();
    const RigidPose read = this->Hand.Next(this->Dice, TickS);
    this->Rubbed.contact = &this->Contact;
    this->Rubbed.friction = &this->Friction;
    const CouplingTick tick = this->Coupling.Tick(read, this->Rubbed);
    this->Friction.Settle(this->Coupling.Tool());
    const Wrench out = this->Limiter.Limit(this->Control.Tick(read, tick.onDevice), TickS);
    ++this->Figures.ticks;
    this->Figures.badPoses += (tick.status & CouplingTick::BadDevicePose) != 0;
    this->Figures.badContacts += (tick.status & CouplingTick::Unsolved) != 0;
    this->Figures.touched += tick.sums.contacts > 0;
    this->Judge.Check(out, this->Coupling.Tool(), TickS, this->Figures);
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

  void Change()
  {
    const std::array<const ImplicitField*, 7> bodies{ &this->Wall, &this->Plate, &this->Groove,
      &this->Hole, &this->Slot, &this->Ball, &this->Holed };
    SoakDice& dice = this->Dice;
    this->Contact.SetField(*bodies[static_cast<std::size_t>(dice.Below(7))]);
    this->Contact.SetStiffness(dice.Falls(0.1) ? 0.0 : std::pow(10.0, dice.In(-3.0, 4.0)));
    this->Coupling.SetSpring({ std::pow(10.0, dice.In(-2.0, 1.0)),
      std::pow(10.0, dice.In(0.0, 4.0)), dice.In(0.5, 20.0), dice.In(10.0, 600.0) });
    if (dice.Falls(0.3))
    {
      this->Limiter.Restart();
      this->Judge.Restart();
    }
    ++this->Figures.changes;
  }

  SoakDice Dice;
  SoakHand Hand;
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
  SoakJudge Judge;
};

} // namespace

SoakFigures RunSoak(std::uint64_t ticks, std::uint32_t seed, const ProgressFunction& progress)
{
  Soak soak(seed);
  return SoakFor(ticks, soak, progress);
}

} // namespace hasp
