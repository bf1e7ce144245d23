#include "Grid/AnalyticVolumes.h"
#include "Haptics/HapticStep.h"
#include "Studies/BenchBodies.h"
#include "Studies/HapticSoak.h"
#include "Studies/SoakParts.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace hasp
{
namespace
{

constexpr double TickS = 0.001;

/// Signed distances, NEGATIVE INSIDE, of a form that is told positive inside.
std::vector<float> Distances(const AnalyticVolume& form, const GridGeometry& grid)
{
  return SampleAnalytic<float>(form, grid, -1.0, 0.0);
}

std::shared_ptr<const DistanceMap> Map(const AnalyticVolume& form, bool skewed)
{
  const GridGeometry grid = MapGrid(skewed);
  const std::vector<float> distances = Distances(form, grid);
  return std::make_shared<DistanceMap>(GridView<const float>{ distances.data(), grid });
}

std::shared_ptr<const PointShell> BallShell(double radius, int points)
{
  const GridGeometry grid = MapGrid(false);
  const std::vector<float> distances = Distances(AnalyticSphere(glm::dvec3(0.0), radius), grid);
  return PointShell::OfSurface(
    { distances.data(), grid }, glm::dvec3(0.0), { .points = points, .coarsest = 16 });
}

class StepSoak
{
public:
  explicit StepSoak(std::uint32_t seed)
    : Dice(seed),
      Settings(TheSettings()),
      Step(Settings),
      Judge(Settings.limits)
  {
    const AnalyticVolume ground{ "ground", [](const glm::dvec3& p) { return -p.z; }, 1.0 };
    const AnalyticVolume plate{ "plate", [](const glm::dvec3& p) { return 0.4 - std::abs(p.z); },
      1.0 };
    const AnalyticVolume ball = AnalyticSphere({ 0.0, 0.0, -6.0 }, 8.0);
    for (const bool skewed : { false, true })
      for (const AnalyticVolume& form : { ground, plate, ball })
        this->Maps.push_back(Map(form, skewed));
    this->Shells = { BallShell(4.0, 256), BallShell(2.0, 64), BallShell(9.0, 64) };
    this->Figures.limitN = this->Settings.limits.force;
  }

  void Tick()
  {
    if (this->Figures.ticks % 2000 == 0)
      this->Change();
    const HapticTick tick = this->Step.Tick(this->Hand.Next(this->Dice, TickS));
    ++this->Figures.ticks;
    this->Figures.badPoses += (tick.status & CouplingTick::BadDevicePose) != 0;
    this->Figures.badContacts += (tick.status & CouplingTick::Unsolved) != 0;
    this->Figures.touched += tick.sums.contacts > 0;
    this->Judge.Check(tick.onDevice, tick.tool, TickS, this->Figures);
  }

  SoakFigures Figures;

private:
  static HapticStepSettings TheSettings()
  {
    HapticStepSettings settings;
    settings.friction.coefficient = 0.3;
    settings.limits.rampInS = 0.1;
    settings.control = true;
    settings.budgetUs = std::numeric_limits<double>::infinity(); // the same on every machine
    return settings;
  }

  std::unique_ptr<HapticScene> Scene()
  {
    SoakDice& dice = this->Dice;
    if (dice.Falls(0.05))
      return nullptr;
    const auto near = [&dice](double mm) -> RigidPose {
      return { dice.Vector(mm), TurnBy(dice.Vector(1.0)) };
    };
    std::vector<HapticShell> shells;
    for (int n = dice.Falls(0.3) ? 2 : 1; n > 0; --n)
      shells.push_back({ .shell = this->Shells[dice.Below(3)], .shellInTool = near(3.0) });
    std::vector<HapticBody> bodies;
    for (int n = dice.Falls(0.3) ? 2 : 1; n > 0; --n)
      bodies.push_back({ this->Maps[dice.Below(6)], dice.Falls(0.5) ? RigidPose{} : near(4.0) });
    return std::make_unique<HapticScene>(std::move(shells), std::move(bodies));
  }

  void Change()
  {
    SoakDice& dice = this->Dice;
    if (dice.Falls(0.7))
    {
      std::unique_ptr<HapticScene> scene = this->Scene();
      this->Step.Swap(scene);
    }
    ContactSettings contact;
    contact.stiffness =
      dice.Falls(0.1) ? 0.0F : static_cast<float>(std::pow(10.0, dice.In(-4.0, 1.0)));
    contact.attraction = static_cast<float>(std::pow(10.0, dice.In(-4.0, 0.0)));
    contact.captureMm = static_cast<float>(dice.In(0.5, 5.0));
    this->Step.Aim(contact);
    this->Step.Aim(CouplingSpring{ std::pow(10.0, dice.In(-2.0, 1.0)),
      std::pow(10.0, dice.In(0.0, 4.0)), dice.In(0.5, 20.0), dice.In(10.0, 600.0) });
    this->Step.Attract(dice.Falls(0.5));
    this->Step.LimitLevels(dice.Falls(0.5) ? 99 : 1 + dice.Below(3));
    if (dice.Falls(0.1))
    {
      this->Step.Place({ dice.Vector(10.0), TurnBy(dice.Vector(3.0)) });
      this->Judge.Restart();
    }
    ++this->Figures.changes;
  }

  SoakDice Dice;
  SoakHand Hand;
  std::vector<std::shared_ptr<const DistanceMap>> Maps;
  std::vector<std::shared_ptr<const PointShell>> Shells;
  HapticStepSettings Settings;
  HapticStep Step;
  SoakJudge Judge;
};

} // namespace

SoakFigures RunStepSoak(std::uint64_t ticks, std::uint32_t seed, const ProgressFunction& progress)
{
  StepSoak soak(seed);
  return SoakFor(ticks, soak, progress);
}

} // namespace hasp
