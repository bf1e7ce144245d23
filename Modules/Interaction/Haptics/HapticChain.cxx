#include "HapticChain.h"

#include "Realtime/LoopThread.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{

namespace
{
constexpr double LongestTickS = 0.1; // after a pause the clutch's fade does not leap

/// So much of another way between world and device that the hand would feel it as a knock.
constexpr double KnockTurnRad = 0.1, KnockScale = 1.25;

bool Knocks(const HapticControl& before, const HapticControl& now) noexcept
{
  const double cosine = std::abs(glm::dot(before.axes, now.axes)); // of half the turn
  const double scale = std::max(before.scale / now.scale, now.scale / before.scale);
  return cosine < std::cos(0.5 * KnockTurnRad) || scale > KnockScale;
}
bool IsPositive(double value) noexcept
{
  return value > 0.0 && std::isfinite(value);
}
bool IsNotNegative(double value) noexcept
{
  return value >= 0.0 && std::isfinite(value);
}
}

const char* WrongIn(const HapticControl& control) noexcept
{
  if (!IsNotNegative(control.contact.stiffness) || !IsNotNegative(control.contact.attraction))
    return "stiffness and attraction of contact must be finite and not negative";
  if (!IsPositive(control.contact.captureMm))
    return "the capture distance of contact must be positive and finite";
  const CouplingSpring& spring = control.spring;
  if (!IsPositive(spring.stiffness) || !IsPositive(spring.turnStiffness) ||
      !IsPositive(spring.forceLimit) || !IsPositive(spring.torqueLimit))
    return "stiffnesses and limits of the spring must be positive and finite";
  return nullptr;
}

CouplingSpring SpringFor(const DeviceProfile& profile, const CouplingSpring& wanted, double scale,
  double gain, double tickS) noexcept
{
  CouplingSpring spring = wanted;
  const double felt = scale * gain, turnFelt = gain / scale;
  if (profile.forceAxes == 0 || !(profile.peakForceN > 0.0) || !(felt > 0.0))
    return spring;
  const double stable =
    StableStiffness(profile.dampingNsPerMm, tickS, profile.delayTicks * tickS) / felt;
  spring.stiffness = std::min(spring.stiffness, stable);
  spring.forceLimit = std::min(spring.forceLimit, profile.peakForceN / gain);
  if (turnFelt > 1.0)
    spring.turnStiffness /= turnFelt;
  if (profile.forceAxes == 6 && profile.peakTorqueNmm > 0.0)
    spring.torqueLimit = std::min(spring.torqueLimit, profile.peakTorqueNmm / turnFelt);
  return spring;
}

HapticChain::HapticChain(std::unique_ptr<HapticDevice> device, const HapticChainSettings& settings)
  : Settings(settings),
    Device(std::move(device), settings.watchdog),
    Mapping(settings.workspace),
    Step(settings.step)
{
  this->Isovalues = this->Now.isovalues;
  this->Now.contact = settings.step.contact;
  this->Now.spring = settings.step.coupling.spring;
  this->Now.scale = settings.workspace.scale;
  this->Step.Aim(SpringFor(this->Device.Profile(), this->Now.spring, this->Now.scale,
    settings.workspace.forceGain, settings.step.tickS));
}

void HapticChain::OfferScene(std::unique_ptr<HapticSceneOffer> offer) noexcept
{
  if (offer && offer->scene)
  {
    const auto untaken = this->Scenes.Offer(nullptr);
    const bool tool = offer->scene->Levels() > 0;
    if (untaken && tool && !offer->start)
      offer->start = untaken->start;
    this->Scenes.Offer(std::move(offer));
  }
  this->Scenes.Collect();
}

const HapticSnapshot* HapticChain::Latest() noexcept
{
  this->Snapshots.Update();
  return this->Snapshots.Latest();
}

void HapticChain::TakeControl() noexcept
{
  if (!this->Controls.Update())
    return;
  const HapticControl before = std::exchange(this->Now, *this->Controls.Latest());
  if (WrongIn(this->Now) != nullptr)
  {
    this->Now.contact = before.contact;
    this->Now.spring = before.spring;
  }
  const auto& axes = this->Now.axes;
  if (axes != before.axes && !this->Mapping.SetAxes(axes))
    this->Now.axes = before.axes;
  if (this->Now.scale != before.scale && !this->Mapping.SetScale(this->Now.scale))
    this->Now.scale = before.scale;
  this->Holding = this->Holding && !Knocks(before, this->Now);
  if (this->Now.placed != before.placed)
  {
    this->Mapping.Place(this->Now.place);
    this->Placed = false; // the tool comes along
  }
  this->Step.Aim(this->Now.contact);
  this->Step.Aim(SpringFor(this->Device.Profile(), this->Now.spring, this->Now.scale,
    this->Settings.workspace.forceGain, this->Settings.step.tickS));
  this->Step.Attract(this->Now.attract);
  this->Step.LimitLevels(std::max(1, this->Now.levels));
  this->SetIsovalues();
}

void HapticChain::SetIsovalues() noexcept
{
  for (std::size_t shell = 0; shell < HapticControl::MostIsovalues; ++shell)
  {
    const double wanted = this->Now.isovalues[shell];
    if (std::isnan(wanted) || wanted == this->Isovalues[shell])
      continue;
    this->Step.SetIsovalue(shell, wanted);
    this->Isovalues[shell] = wanted;
  }
}

void HapticChain::TakeScene() noexcept
{
  auto offer = this->Scenes.Take();
  if (!offer)
    return;
  this->Step.Swap(offer->scene);
  this->Scene = offer->number;
  if (offer->start)
    this->Take(*offer->start);
  this->Isovalues = HapticControl().isovalues; // it was told nothing
  this->SetIsovalues();
  this->Scenes.GiveBack(std::move(offer));
}

void HapticChain::Take(const RigidPose& tool) noexcept
{
  this->Last = {};
  this->Last.tool = tool;
  this->Step.Place(tool);
  this->Placed = true;
}

void HapticChain::Place(const RigidPose& tool) noexcept
{
  this->TakeControl(); // which may place the device, and the tool with it: that came before
  this->Take(tool);
}

void HapticChain::AnswerDiscs() noexcept
{
  auto request = this->Requests.Take();
  if (!request)
    return;
  const HapticScene* scene = this->Step.Scene();
  request->count = scene != nullptr ? scene->CopyDynamicDiscs(request->room) : 0;
  request->tool = this->Last.tool;
  this->Requests.GiveBack(std::move(request));
}

void HapticChain::Tick(std::uint64_t number, std::int64_t nowNs) noexcept
{
  this->Run(number, nowNs, true);
}

void HapticChain::Poll(std::int64_t nowNs) noexcept
{
  this->Run(this->Ticks, nowNs, false);
}

Wrench HapticChain::Feel(const RigidPose& device) noexcept
{
  if (!this->Placed)
    this->Step.Place(device);
  else if (!this->Holding || (!this->Device.Whole() && !Has(this->Status, DeviceStatus::Stale)))
    this->Step.Place(this->Last.tool); // it was away, or silenced: forces grow from zero
  this->Placed = true;
  this->Last = this->Step.Tick(device);
  return this->Mapping.ToDevice(this->Last.onDevice);
}

void HapticChain::Run(std::uint64_t number, std::int64_t nowNs, bool forces) noexcept
{
  const bool records = forces && this->Recorder != nullptr;
  const std::int64_t beganNs = records ? MonotonicClock().CpuNs() : 0;
  this->TakeControl();
  this->TakeScene();
  this->Status = this->Device.Read(nowNs, this->Sample);
  const bool takes = TakesForce(this->Status);
  const double dtS =
    this->Ticks == 0
      ? this->Settings.step.tickS
      : std::clamp(1e-9 * static_cast<double>(NsBetween(this->BeforeNs, nowNs)), 0.0, LongestTickS);
  const bool held = this->Now.clutched || (this->Sample.buttons & this->Now.clutch) != 0;
  if (takes)
    this->Mapping.Update(this->Sample.pose, held, dtS);
  else
    ++this->Away;
  Wrench onDevice;
  if (takes && forces)
    onDevice = this->Feel(this->Mapping.Tool());
  else
  {
    const RigidPose tool = forces ? this->Last.tool : this->Mapping.Tool();
    this->Last = {};
    this->Last.tool = tool;
  }
  this->Placed = this->Placed && forces;
  this->Holding = takes && forces;
  this->Device.Write(onDevice);
  this->BeforeNs = nowNs;
  ++this->Ticks;
  this->AnswerDiscs();
  this->Publish(nowNs, onDevice);
  if (records)
    this->Recorder->Push({ .number = number,
      .nowNs = nowNs,
      .sample = this->Sample,
      .status = this->Status,
      .wrench = onDevice,
      .costNs = static_cast<std::uint32_t>(MonotonicClock().CpuNs() - beganNs),
      .contacts = this->Last.sums.contacts });
}

void HapticChain::Publish(std::int64_t nowNs, const Wrench& onDevice) noexcept
{
  HapticSnapshot seen;
  seen.ticks = this->Ticks;
  seen.nowNs = nowNs;
  seen.status = this->Status;
  seen.buttons = this->Sample.buttons;
  seen.raw = this->Sample.pose;
  seen.device = this->Mapping.Tool();
  seen.tool = this->Last.tool;
  seen.onDevice = onDevice;
  seen.felt = this->Last.onDevice;
  seen.contact = this->Last.sums.contact;
  seen.attraction = this->Last.sums.attraction;
  seen.contactAreaMm2 = this->Last.sums.contactArea;
  seen.attractedAreaMm2 = this->Last.sums.attractedArea;
  seen.deepestMm = this->Last.sums.deepestMm;
  seen.levels = this->Last.levels;
  seen.contacts = this->Last.sums.contacts;
  seen.points = this->Last.points;
  seen.stepStatus = this->Last.status;
  seen.scene = this->Scene;
  seen.away = this->Away;
  this->Snapshots.Write(seen);
}

void HapticChain::Rest() noexcept
{
  this->Device.Write({});
  this->Holding = false;
}

} // namespace hasp
