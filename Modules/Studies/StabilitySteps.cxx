#include "Grid/AnalyticVolumes.h"
#include "Studies/SampledLoop.h"
#include "Studies/StepCases.h"

#include <cmath>
#include <limits>

namespace hasp
{
namespace
{

/// z < height is solid.
std::shared_ptr<const DistanceMap> GroundMap(bool skewed, double height = 0.0)
{
  const GridGeometry grid = MapGrid(skewed);
  const std::vector<float> samples = SampleAnalytic<float>(
    { "ground", [=](const glm::dvec3& p) { return p.z - height; }, 1.0 }, grid, 1.0, 0.0);
  return std::make_shared<DistanceMap>(GridView<const float>{ samples.data(), grid });
}

/// A square foot of 10 mm at z = 0, facing down.
std::shared_ptr<const PointShell> FootShell(int perSide)
{
  std::vector<SurfacePoint> points;
  for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
      points.push_back(
        { { 10.0F * ((i + 0.5F) / perSide - 0.5F), 10.0F * ((j + 0.5F) / perSide - 0.5F), 0.0F },
          { 0.0F, 0.0F, -1.0F } });
  return PointShell::OfPoints(
    points, 100.0, glm::dvec3(0.0), { .points = perSide * perSide, .coarsest = 64 });
}

} // namespace

StepCase PressedStep(const BenchHand& hand, float stiffness)
{
  StepCase made;
  made.scene = PressScene(Frictionless(FalconLike()), hand, {}, 5.0);
  HapticStepSettings& s = made.settings;
  s.coupling = DefaultCoupling(made.scene.device, made.scene.clock, 1.0, 7.1);
  s.contact.stiffness = stiffness;
  s.limits.force = made.scene.device.forceLimitN;
  s.limits.torque = made.scene.device.torqueLimitNmm;
  s.limits.rampInS = 0.0;
  s.budgetUs = std::numeric_limits<double>::infinity(); // the same on every machine
  return made;
}

void AddStep(std::vector<StabilityRow>& rows, const std::string& id, const std::string& text,
  StepCase made, double lastS)
{
  StabilityRow row;
  row.id = id + "." + made.scene.hand.name;
  row.text = text + ", hand " + made.scene.hand.name;
  row.byDefault = true;
  row.law = "spectral radius of a tick, at most";
  row.figure = SampledLoop(made.scene.device, made.scene.hand, made.scene.clock)
                 .SpringRadius(made.settings.coupling.spring.stiffness);
  HoldWhenSettled(made.scene, SettlingRate(made.scene.clock, row.figure));
  made.scene.holdFromS += lastS;
  made.scene.seconds += lastS;
  row.run = [made = std::move(made)]
  {
    HapticShell shell = made.shell ? made.shell() : HapticShell{ FootShell(made.perSide), {} };
    auto scene = std::make_unique<HapticScene>(std::vector<HapticShell>{ std::move(shell) },
      std::vector<HapticBody>{ { GroundMap(made.skewed), {} } });
    StepRenderer renderer(made.settings, std::move(scene));
    renderer.OnTick(made.change);
    const BenchFigures figures = RunBench(made.scene, renderer);
    return StabilityRow::Outcome{ figures, Judge(made.scene, figures) };
  };
  rows.push_back(std::move(row));
}

StepRenderer::Change Once(double atS, std::function<void(HapticStep&)> act)
{
  return [atS, act = std::move(act)](double t, HapticStep& step)
  {
    if (t >= atS && t < atS + 0.00099)
      act(step);
  };
}

namespace
{

void Add(std::vector<StabilityRow>& rows, const std::string& id, const std::string& text,
  StepCase made, double lastS = 0.0)
{
  AddStep(rows, "step." + id, "step: " + text, std::move(made), lastS);
}

void AddChangingSteps(std::vector<StabilityRow>& rows, const BenchHand& hand)
{
  for (const double to : { 0.005, 2.0 })
  {
    StepCase made = PressedStep(hand, 0.1F);
    ContactSettings wanted = made.settings.contact;
    wanted.stiffness = static_cast<float>(to);
    made.change = Once(1.0, [wanted](HapticStep& step) { step.Aim(wanted); });
    Add(rows, "stiffness" + Figure(to), "stiffness 0.1 to " + Figure(to) + " N/mm/mm2 in contact",
      made, 1.0);
  }
  StepCase swapped = PressedStep(hand, 0.1F);
  swapped.change = Once(1.0,
    [](HapticStep& step)
    {
      auto scene = std::make_unique<HapticScene>(std::vector<HapticShell>{ { FootShell(32), {} } },
        std::vector<HapticBody>{ { GroundMap(false, 1.0), {} } });
      step.Swap(scene);
    });
  Add(rows, "swap", "a scene 1 mm higher in contact", swapped, 1.0);
  StepCase levels = PressedStep(hand, 0.1F);
  levels.change = [](double t, HapticStep& step)
  {
    step.LimitLevels(std::fmod(t, 0.2) < 0.1 ? 1 : 3); // five times a second, for ever
  };
  Add(rows, "levels", "levels come and go in contact", levels);
}

} // namespace

// The whole step before baked maps: what was shown for bodies in closed form holds for it.
void AddStepRows(std::vector<StabilityRow>& rows)
{
  for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
  {
    for (const bool skewed : { false, true })
      for (const double stiffness : { 0.1, 1.0 })
      {
        StepCase made = PressedStep(hand, static_cast<float>(stiffness));
        made.skewed = skewed;
        made.settings.coupling.travelMm = skewed ? 0.175 : 0.25;
        Add(rows, std::string("map.") + (skewed ? "skewed" : "even") + ".k" + Figure(stiffness),
          std::string(skewed ? "turned map of 0.7 x 1.1 x 1.6 mm" : "map of 1 mm") + ", " +
            Figure(stiffness) + " N/mm/mm2",
          made);
      }
    AddChangingSteps(rows, hand);
    StepCase snap = PressedStep(hand, 0.1F);
    snap.settings.contact.attraction = 0.02F;
    snap.settings.contact.captureMm = 3.0F;
    snap.change = Once(0.0, [](HapticStep& step) { step.Attract(true); });
    if (hand.stiffness > 0.0)
    {
      // Held where attraction's stiffness is most negative, beyond R / sqrt 5.
      StepCase hover = snap;
      hover.scene.start.position.z = 4.0;
      hover.scene.strokes = { { 0.5, 0.5, { 0.0, 0.0, -1.6 }, {} } };
      hover.scene.pressed = false;
      Add(rows, "hover", "held in Snap-to-fit's reach", hover);
    }
    Add(rows, "snap", "Snap-to-fit holds", snap);
  }
  for (const int perSide : { 1, 316 })
  {
    StepCase made = PressedStep(LooseHand(), 0.1F);
    made.perSide = perSide;
    made.scene.clock.tickS = 0.004; // 100,000 points at every tick of 1 ms are a second's work
    made.settings.tickS = 0.004;
    made.settings.coupling = DefaultCoupling(made.scene.device, made.scene.clock, 1.0, 7.1);
    Add(rows, "points" + std::to_string(perSide * perSide),
      std::to_string(perSide * perSide) + " points", made);
  }
}

} // namespace hasp
