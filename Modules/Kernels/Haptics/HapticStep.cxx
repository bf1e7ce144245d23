#include "Haptics/HapticStep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

void Require(bool holds, double value, const char* name, const char* range)
{
  if (!holds)
    throw std::invalid_argument(std::string(name) + " of a haptic step is " +
                                std::to_string(value) + "; it must be " + range);
}

void RequirePositive(double value, const char* name)
{
  Require(value > 0.0 && std::isfinite(value), value, name, "positive and finite");
}

void RequireNotNegative(double value, const char* name)
{
  Require(value >= 0.0 && std::isfinite(value), value, name, "finite and not negative");
}

/// The controller's tick is the step's.
PassivityControllerSettings Ticking(PassivityControllerSettings passivity, double tickS)
{
  RequirePositive(tickS, "The tick");
  passivity.tickS = tickS;
  return passivity;
}

constexpr double UpdateShare = 0.05;     // of a tick in the mean of what updates take
constexpr double HardAt = 0.5;           // voxels: as deep as a tool is ever to be
constexpr double HardShare = 0.5;        // of the pressure there, that the force limit is
constexpr double MostHardening = 1000.0; // a contact that is meant to be soft stays softer

double NowUs() noexcept
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::micro>(now).count();
}

/// Towards `wanted` by a share of what is between both, and there at last.
double Nearer(double now, double wanted, double share) noexcept
{
  const double next = now + (wanted - now) * share;
  return std::abs(next - wanted) <= 1e-6 * std::abs(wanted) ? wanted : next;
}

} // namespace

/// The scene with friction, as long as there is time.
class HapticStep::TimedContact : public ToolContact
{
public:
  explicit TimedContact(HapticStep& step) : Step(step), BeganUs(NowUs()) {}

  Answer At(const RigidPose& tool) noexcept override
  {
    Answer answer;
    const double before = NowUs();
    if (this->Step.Held)
    {
      answer = this->Step.Held->At(tool);
      this->Points += this->Step.Held->PointsDone();
    }
    else
      answer.clearanceMm = std::numeric_limits<double>::infinity();
    const double after = NowUs();
    this->MostAttracted = std::max(this->MostAttracted, answer.sums.attractedArea);
    // More is in reach than a tick ago: this answer is already to keep to the bound.
    const double fade = this->Step.Plan.contact.fade;
    const double allowed = this->Step.AllowedFade(answer.sums.attractedArea);
    if (allowed < fade)
    {
      answer.sums.attraction.force *= allowed / fade;
      answer.sums.attraction.torque *= allowed / fade;
    }
    this->Step.Friction.Add(tool, answer);
    this->SpentUs += after - before;
    // Another one takes as long as this one.
    answer.last = after - this->BeganUs + (after - before) > this->Step.Settings.budgetUs;
    return answer;
  }

  HapticStep& Step;
  double BeganUs, SpentUs = 0.0, MostAttracted = 0.0;
  std::uint32_t Points = 0;
};

HapticStep::HapticStep(const HapticStepSettings& settings)
  : Settings(settings),
    Coupling(settings.coupling),
    Friction(settings.friction),
    Limiter(settings.limits),
    Passivity(Ticking(settings.passivity, settings.tickS)),
    WantedContact(settings.contact),
    WantedSpring(settings.coupling.spring)
{
  Require(settings.budgetUs > 0.0, settings.budgetUs, "The budget", "positive");
  RequirePositive(settings.fadeS, "The fade");
  RequirePositive(settings.slewS, "The slew");
  RequirePositive(settings.contact.captureMm, "The capture distance");
  RequireNotNegative(settings.leastContactMm2, "The least contact");
  RequireNotNegative(settings.contact.stiffness, "The stiffness of contact");
  RequireNotNegative(settings.contact.attraction, "The attraction");
  if (settings.blendTicks < 5)
    throw std::invalid_argument("Levels of a haptic step are blended in " +
                                std::to_string(settings.blendTicks) + " ticks; it takes 5 or more");
  this->Plan.contact = settings.contact;
  this->Plan.contact.fade = 0.0F;
}

void HapticStep::Place(const RigidPose& tool) noexcept
{
  this->Coupling.Place(tool);
  this->Friction.Restart();
  this->Limiter.Restart();
  this->Passivity.Restart();
  this->Fade = 0.0;
  if (this->Held)
    this->Held->Grow(1.0);
}

void HapticStep::Swap(std::unique_ptr<HapticScene>& scene) noexcept
{
  if (scene)
    scene->TakeGrowth(this->Held.get());
  std::swap(this->Held, scene);
  this->Friction.Restart();
  this->AttractedMm2 = 0.0;
  if (!this->Held)
    return;
  this->Plan.finest = std::min(this->Plan.finest, std::max(0.0, this->Held->Levels() - 1.0));
  const double voxel = this->Held->SmallestSpacing();
  const double radius = this->Held->RadiusMm();
  this->Coupling.SetTravel(std::isfinite(voxel) ? 0.25 * voxel : 1.0, radius > 0.0 ? radius : 1.0);
}

void HapticStep::SetIsovalue(std::size_t shell, double isovalue) noexcept
{
  if (this->Held)
    this->Held->SetIsovalue(shell, isovalue);
}

void HapticStep::Slew() noexcept
{
  const double share = std::min(1.0, 3.0 * this->Settings.tickS / this->Settings.slewS);
  ContactSettings& contact = this->Plan.contact;
  // By its cubic root: contact is far stiffer than the coupling, a small share is felt already.
  const double root =
    Nearer(std::cbrt(contact.stiffness), std::cbrt(this->WantedContact.stiffness), share);
  contact.stiffness = static_cast<float>(root * root * root);
  contact.attraction =
    static_cast<float>(Nearer(contact.attraction, this->WantedContact.attraction, share));
  contact.captureMm =
    static_cast<float>(Nearer(contact.captureMm, this->WantedContact.captureMm, share));
  CouplingSpring spring = this->Coupling.GetSettings().spring;
  spring.stiffness = Nearer(spring.stiffness, this->WantedSpring.stiffness, share);
  spring.turnStiffness = Nearer(spring.turnStiffness, this->WantedSpring.turnStiffness, share);
  spring.forceLimit = Nearer(spring.forceLimit, this->WantedSpring.forceLimit, share);
  spring.torqueLimit = Nearer(spring.torqueLimit, this->WantedSpring.torqueLimit, share);
  this->Coupling.SetSpring(spring);
  if (this->Held)
    this->Held->Grow(this->Settings.tickS / this->Settings.slewS);
  this->Harden();
  this->SlewAttraction();
  this->SlewLevels();
}

void HapticStep::Harden() noexcept
{
  ContactSettings& contact = this->Plan.contact;
  contact.hardening = 0.0F;
  const double voxel = this->Held ? this->Held->SmallestSpacing() : 0.0;
  const double linear =
    contact.stiffness * this->Settings.leastContactMm2 * HardAt * voxel; // N, that deep
  if (!(linear > 0.0) || !std::isfinite(linear))
    return;
  contact.hardMm = static_cast<float>(HardAt * voxel);
  const double wanted = this->Coupling.GetSettings().spring.forceLimit / (HardShare * linear) - 1.0;
  contact.hardening = static_cast<float>(std::clamp(wanted, 0.0, MostHardening));
}

double HapticStep::AllowedFade(double attractedMm2) const noexcept
{
  // a A / R, and at the tool's radius a A r^2 / R: the steepest that attraction changes.
  const ContactSettings& contact = this->Plan.contact;
  const VirtualCouplingSettings& coupling = this->Coupling.GetSettings();
  const double slope = contact.attraction * attractedMm2 / contact.captureMm;
  const double turning = slope * coupling.radiusMm * coupling.radiusMm;
  return std::min({ 1.0, slope > 0.0 ? 0.5 * coupling.spring.stiffness / slope : 1.0,
    turning > 0.0 ? 0.5 * coupling.spring.turnStiffness / turning : 1.0 });
}

void HapticStep::SlewAttraction() noexcept
{
  const double most = this->Settings.tickS / this->Settings.fadeS;
  this->Fade += std::clamp((this->Attracts ? 1.0 : 0.0) - this->Fade, -most, most);
  // Down at once, up gradually: what is held is held by a steady law, which pumps no energy.
  this->Bound = std::min(this->AllowedFade(this->AttractedMm2), this->Bound + most);
  const double u = this->Fade;
  this->Plan.contact.fade = static_cast<float>(u * u * (3.0 - 2.0 * u) * this->Bound);
}

void HapticStep::SlewLevels() noexcept
{
  if (!this->Held || this->Held->Levels() == 0)
    return;
  int levels = std::min(this->Held->Levels(), this->MostLevels);
  // An evaluation is to fit twice, for the second step, after the dynamic shells.
  const double leftUs = std::max(0.0, this->Settings.budgetUs - this->UpdateUs);
  if (std::isfinite(leftUs))
    levels = std::min(levels, this->Cost.Levels(this->Held->NearPoints(), 0.5 * leftUs));
  const double wanted = std::max(0, levels - 1);
  const double most = 1.0 / this->Settings.blendTicks;
  this->Plan.finest += std::clamp(wanted - this->Plan.finest, -most, most);
}

void HapticStep::UpdateScene() noexcept
{
  this->Held->Set(this->Plan);
  const double before = NowUs();
  this->Held->Update(this->Coupling.Tool());
  // A tick in which the core was taken away does not count for more than a whole budget.
  const double us = std::min(NowUs() - before, this->Settings.budgetUs);
  this->UpdateUs += UpdateShare * (us - this->UpdateUs);
}

HapticTick HapticStep::Tick(const RigidPose& device) noexcept
{
  this->Slew();
  TimedContact contact(*this);
  if (this->Held)
    this->UpdateScene();
  const CouplingTick coupled = this->Coupling.Tick(device, contact);
  this->Friction.Settle(this->Coupling.Tool());
  this->Cost.Measure(contact.Points, contact.SpentUs);
  this->AttractedMm2 = contact.MostAttracted;

  HapticTick tick;
  Wrench wanted = coupled.onDevice;
  if (this->Settings.control)
    wanted = this->Passivity.Tick(device, wanted);
  tick.onDevice = this->Limiter.Limit(wanted, this->Settings.tickS);
  this->Passivity.Hold(tick.onDevice);
  tick.tool = this->Coupling.Tool();
  tick.sums = coupled.sums;
  tick.levels = this->Plan.finest;
  tick.points = contact.Points;
  tick.evaluations = coupled.evaluations;
  tick.status = coupled.status;
  return tick;
}

} // namespace hasp
