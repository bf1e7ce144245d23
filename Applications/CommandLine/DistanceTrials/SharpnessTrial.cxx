#include "ContourRivals.h"
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Distance/Testing/SlottedBlock.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <cstdio>

namespace hasp
{

void TrySharpness(ReportContext& context, const PlainContour& plain)
{
  const int step = context.settings.quick ? 9 : 1;
  std::mt19937 random(static_cast<std::mt19937::result_type>(context.settings.seed));
  const GridGeometry grid = TrialGrid(47); // 9.2 mm to each side
  Sharpness sharp, edges;
  Timing time, plainTime;
  int blocks = 0;
  const auto add = [](Timing& sum, const Timing& one)
  {
    sum.wallS += one.wallS;
    sum.cpuS += one.cpuS;
  };
  for (int n = 0; n < 27; n += step)
    for (const bool turned : { false, true })
    {
      SlottedBlock block;
      block.at = TrialVoxelMm * SubVoxelCentre(n, context.settings.seed);
      if (turned)
        block.axes = AnyAxes(random);
      const SolidPointer solid = block.Solid();
      TriangleMesh mesh;
      add(time, TimeOf([&] { mesh = SharpContour(*solid, grid); }));
      sharp.KeepMost(MeasureSharpness(block, mesh));
      ++blocks;
      if (!plain.absent.empty())
        continue;
      add(plainTime,
        TimeOf(
          [&] { mesh = plain.make(DenseValues(EvaluateNearSurface(*solid, grid, 1.2)), grid); }));
      edges.KeepMost(MeasureSharpness(block, mesh));
    }
  const auto row = [&](const char* id, double Sharpness::*figure, double bar, const char* what)
  {
    char text[200];
    ReportRow made;
    made.id = id;
    made.value = made.error = sharp.*figure;
    made.unit = made.errorUnit = "mm";
    made.better = Better::Lower;
    made.timeS = time.wallS / blocks;
    made.cpuS = time.cpuS / blocks;
    made.n = blocks;
    if (plain.absent.empty())
      std::snprintf(text, sizeof text, "%s of the sampled distances: %.4f mm, %.3g s",
        plain.name.c_str(), edges.*figure, plainTime.wallS / blocks);
    else
      std::snprintf(text, sizeof text, "closed form (%s)", plain.absent.c_str());
    made.rival = text;
    std::snprintf(text, sizeof text,
      "%s, the worst of %d places of a block with a slot of 1 mm and a hole of 2 mm, half of them "
      "turned any way, voxels of 0.4 mm (%.4f voxels)",
      what, blocks, sharp.*figure / TrialVoxelMm);
    made.data = text;
    made.bars = { { {}, bar } };
    context.report.rows.push_back(made);
  };
  row("contour.flatness", &Sharpness::flat, 0.02, "how far the slot's walls are off their planes");
  row("contour.edge", &Sharpness::edge, 0.05, "radius of edges, 0.4 mm and more from their ends");
  row("contour.hole", &Sharpness::hole, 0.03, "the fitted cylinder's diameter off 2 mm");
}

} // namespace hasp
