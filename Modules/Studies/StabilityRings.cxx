#include "Studies/StepCases.h"

#include <cmath>
#include <vector>

namespace hasp
{
namespace
{

constexpr double Isovalue = 1000.0, PerMm = 100.0, ChangeAtS = 1.0;

/// Grey above z = 0 as far as its grid goes, 10 x 10 mm, without preparation: a foot, too.
HapticShell GreyFoot(const DynamicPointShellSettings& settings)
{
  const GridGeometry grid{ { 11, 11, 17 }, { -5.0, -5.0, -8.0 }, glm::dvec3(1.0), glm::dmat3(1.0) };
  auto samples = std::make_shared<std::vector<std::int16_t>>();
  for (int k = 0; k < grid.dims.z; ++k)
    samples->insert(samples->end(), std::size_t(grid.dims.x) * grid.dims.y,
      static_cast<std::int16_t>(Isovalue + PerMm * (k - 8)));
  auto source = std::make_shared<DynamicShellSource>();
  source->volume.grid = GridView<const std::int16_t>{ samples->data(), grid };
  source->volume.blocks = std::make_shared<MinMaxBlocks>(source->volume.grid);
  source->volume.owner = samples;
  source->volume.isovalue = Isovalue;
  source->settings = settings;
  return { nullptr, {}, source };
}

StepCase PressedGrey(const BenchHand& hand, const DynamicPointShellSettings& settings = {})
{
  StepCase made = PressedStep(hand, 0.1F);
  made.shell = [settings] { return GreyFoot(settings); };
  return made;
}

/// From one surface to another and back, for ever, each `everyS`; `mm`: how far apart they are.
StepRenderer::Change ToAndFro(double everyS, double mm)
{
  return [=](double t, HapticStep& step)
  { step.SetIsovalue(0, Isovalue - (std::fmod(t, 2.0 * everyS) < everyS ? 0.0 : PerMm * mm)); };
}

} // namespace

// Points that come and go while they press: what a tool of grey values feels of them. The spring is
// what it was, and contact, however it changes, is in series with it.
void AddRingRows(std::vector<StabilityRow>& rows)
{
  DynamicPointShellSettings small;
  small.points = 512;
  small.pointsPerTick = 64;
  for (const BenchHand& hand : { NoHand(), LooseHand(), FirmHand() })
  {
    AddStep(rows, "ring.rest", "ring: a grey foot", PressedGrey(hand));
    AddStep(rows, "ring.small", "ring: room for 512 points, 64 a tick", PressedGrey(hand, small));
    StepCase levels = PressedStep(hand, 0.1F);
    levels.change = [](double t, HapticStep& step)
    { step.LimitLevels(std::fmod(t, 0.04) < 0.02 ? 1 : 3); };
    AddStep(rows, "ring.levels", "ring: levels come and go 25 times a second", levels);
    StepCase refresh = PressedGrey(hand);
    refresh.change = ToAndFro(0.05, 0.001);
    AddStep(rows, "ring.refresh", "ring: all points drawn anew 20 times a second", refresh);
    for (const double mm : { 0.1, 0.5, -0.5 })
    {
      StepCase jump = PressedGrey(hand);
      jump.change =
        Once(ChangeAtS, [mm](HapticStep& step) { step.SetIsovalue(0, Isovalue - PerMm * mm); });
      AddStep(rows, "ring.isovalue" + Figure(1000.0 * mm) + "um",
        "ring: an isovalue whose surface is " + Figure(mm) + " mm lower in contact", jump,
        ChangeAtS);
    }
  }
}

} // namespace hasp
