#include "Failure.h"
#include "GuideRivals.h"
#include "Pairing.h"
#include "ReportGuides.h"
#include "ReportRegistry.h"
#include "VtkMessages.h"
#include "vtkHaspClusteredCellFilter.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/SurfaceDistance.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace hasp
{
namespace
{

constexpr double PreviewSpacingMm = 0.8;

struct Preview
{
  vtkSmartPointer<vtkImageData> field;
  std::size_t cells = 0;
};

/// From the recipe to what a mapper draws.
Preview PreviewOnce(const GuideSubject& subject)
{
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(subject.image);
  filter->SetRecipe(subject.recipe);
  Preview preview;
  preview.field = filter->MakePreview(std::max(PreviewSpacingMm, subject.recipe.spacingMm));
  ThrowVtkError(ExitCode::FailedCheck, "no preview of a guide for the report");
  vtkNew<vtkHaspClusteredCellFilter> cells;
  cells->SetInputData(preview.field);
  cells->SetIsoValue(0.0);
  cells->Update();
  ThrowVtkError(ExitCode::FailedCheck, "no active cells of a preview for the report");
  preview.cells = std::size_t(cells->GetOutput()->GetNumberOfCells());
  return preview;
}

struct Misses
{
  double rmsMm = 0.0, p95Mm = 0.0, p99Mm = 0.0, maxMm = 0.0;
  glm::dvec3 maxAt{ 0.0 };
};

/// How far the points lie off the preview's surface; what has none near it is off by all of that.
Misses MissesOf(const std::vector<glm::dvec3>& points, vtkImageData* field)
{
  const double reachMm = 4.0 * field->GetSpacing()[0];
  const auto nearest = DistanceToIsosurface(ViewImage(field), 0.0, points, reachMm);
  Misses misses;
  std::vector<double> off;
  double squares = 0.0;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const double mm = nearest[n] ? std::abs(nearest[n]->distance) : reachMm;
    if (off.empty() || mm > misses.maxMm)
    {
      misses.maxMm = mm;
      misses.maxAt = points[n];
    }
    squares += mm * mm;
    off.push_back(mm);
  }
  std::sort(off.begin(), off.end());
  misses.rmsMm = std::sqrt(squares / double(off.size()));
  misses.p95Mm = off[off.size() * 95 / 100];
  misses.p99Mm = off[off.size() * 99 / 100];
  return misses;
}

std::string Said(const Preview& preview, const Misses& misses)
{
  std::ostringstream text;
  text.precision(3);
  text << "; recipe to field and " << preview.cells << " active cells, voxels of "
       << preview.field->GetSpacing()[0] << " mm; 95 % of points within " << misses.p95Mm
       << " mm, 99 % within " << misses.p99Mm << ", at most " << misses.maxMm << " ("
       << misses.maxMm / preview.field->GetSpacing()[0] << " voxels) at (" << misses.maxAt.x << ", "
       << misses.maxAt.y << ", " << misses.maxAt.z << ")";
  return text.str();
}

} // namespace

void TryPreview(ReportContext& context, const GuideSubject& subject, const TriangleMesh& finished,
  const std::string& at)
{
  constexpr int Runs = 3;
  Preview preview;
  std::vector<double> wall, cpu;
  for (int run = 0; run < Runs; ++run)
  {
    const Timing time = TimeOf([&] { preview = PreviewOnce(subject); });
    wall.push_back(time.wallS);
    cpu.push_back(time.cpuS);
  }
  const Misses misses = MissesOf(finished.points, preview.field);
  const Quartiles seconds = QuartilesOf(wall);
  ReportRow row;
  row.id = "guides.preview" + at;
  row.unit = std::string("s");
  row.value = row.timeS = seconds.median;
  row.q1 = seconds.q1;
  row.q3 = seconds.q3;
  row.cpuS = QuartilesOf(cpu).median;
  row.better = Better::Lower;
  row.rival = "the finished guide, whose points the error is of: guides.time" + at;
  row.error = misses.rmsMm;
  row.errorUnit = "mm RMS";
  row.n = Runs;
  row.data = subject.data + Said(preview, misses);
  if (at.empty())
    row.bars = { { {}, 1.0 } };
  context.report.rows.push_back(row);
}

} // namespace hasp
