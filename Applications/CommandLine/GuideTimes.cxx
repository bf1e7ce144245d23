#include "CraniumGuide.h"
#include "Failure.h"
#include "GuideClaims.h"
#include "GuideRivals.h"
#include "MeasuredRows.h"
#include "PartCertificate.h"
#include "ReportGuides.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "ScratchFolder.h"
#include "VtkMessages.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Grid/Phantom.h"
#include "Planning/GuideRecipeFile.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace hasp
{
namespace
{

FindSelfIntersectionsFunction SelfIntersections()
{
#if HASP_WITH_CGAL
  return FindSelfIntersections;
#else
  return {};
#endif
}

/// The demo's guide on the demo's CT; empty without it.
GuideSubject CraniumSubject(const std::string& path, std::string& why)
{
  if (!std::filesystem::exists(path))
  {
    why = "no CT at --volume (Utilities/Scripts/cranium prints where the demo's is)";
    return {};
  }
  const ReportVolume volume = ReadReportVolume(path);
  if (volume.name != "cranium")
  {
    why = "the recipe fits the demo's CT alone, and --volume is another";
    return {};
  }
  return { volume.image, ParseGuideRecipe(CraniumGuideRecipe()), volume.data };
}

/// A band with a slot and a hole over the phantom's left frontal bone.
GuideSubject PhantomSubject()
{
  const PhantomSettings head;
  GuideRecipe recipe;
  glm::dvec3 outward(0.0);
  for (const double left : { 0.25, 0.40, 0.55 })
  {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(left, -1.0, 0.6));
    recipe.landmarks.push_back(PhantomOuterTable(head, direction));
    outward += direction;
  }
  recipe.withdrawal = glm::normalize(outward);
  recipe.thicknessMm = 3.0;
  const glm::dvec3 across = glm::normalize(recipe.landmarks[2] - recipe.landmarks[0]);
  recipe.slots = { { recipe.landmarks[1], across, 1.2, 8.0, 6.0, 0.0 } };
  recipe.holes = { { recipe.landmarks[2], recipe.withdrawal, 2.0, 10.0, 0.0 } };
  GridGeometry scan;
  scan.spacing = { 0.5, 0.5, 0.6 };
  scan.dims = glm::ivec3(glm::ceil(70.0 / scan.spacing)) + 1;
  scan.origin = recipe.landmarks[1] - 0.5 * scan.spacing * glm::dvec3(scan.dims - 1);
  return { MakeImage(scan, SamplePhantom(scan)), recipe,
    "phantom's left frontal bone, voxels of 0.5 x 0.5 x 0.6 mm" };
}

struct Made
{
  TriangleMesh mesh;
  FitCertificate certificate;
};

/// From the recipe to a file that is read back and certified.
Made MakeOnce(const GuideSubject& subject, const std::string& stl)
{
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(subject.image);
  filter->SetRecipe(subject.recipe);
  filter->Update();
  ThrowVtkError(ExitCode::FailedCheck, "no guide for the report");
  Made made;
  WriteSurface(filter->GetOutput(), stl);
  made.mesh = ReadBackStl(stl);
  made.certificate = CertifyFit(
    made.mesh, ViewImage(subject.image), ClaimsOf(filter->GetMadeRecipe()), SelfIntersections());
  return made;
}

std::string Verdict(const FitCertificate& certificate)
{
  std::string text = certificate.Holds() ? "its certificate is green" : "its certificate is red";
  for (const FitFault& fault : certificate.faults)
    text += "; " + fault.text;
  return text;
}

void TrySubject(ReportContext& context, const GuideSubject& subject, const std::string& at)
{
  const ScratchFolder scratch;
  const std::string stl = scratch.Path() / "guide.stl";
  Made made;
  const int runs = context.settings.quick ? 3 : 5;
  std::vector<double> wall, cpu;
  for (int run = 0; run < runs; ++run)
  {
    context.progress(double(run) / runs, "");
    const Timing time = TimeOf([&] { made = MakeOnce(subject, stl); });
    wall.push_back(time.wallS);
    cpu.push_back(time.cpuS);
  }
  const Quartiles seconds = QuartilesOf(wall);
  const GapShare gap = GapOf(made.mesh, subject);
  ReportRow time;
  time.id = "guides.time" + at;
  time.value = seconds.median;
  time.q1 = seconds.q1;
  time.q3 = seconds.q3;
  time.unit = "s";
  time.better = Better::Lower;
  time.rival = RivalText(MeshBooleanGuide(subject), subject);
  time.error = gap.p95Mm;
  time.errorUnit = "mm off the gap, 95 % of the inner wall";
  time.timeS = seconds.median;
  time.cpuS = QuartilesOf(cpu).median;
  time.n = runs;
  time.data = subject.data + "; recipe to STL file, read back and certified; " +
              std::to_string(made.mesh.triangles.size()) + " triangles; " +
              Verdict(made.certificate);
  if (at.empty())
    time.bars = { { {}, 5.0 } };
  ReportRow row;
  row.id = "guides.gap.p95" + at;
  row.value = row.error = gap.p95Mm;
  row.unit = row.errorUnit = "mm";
  row.better = Better::Lower;
  row.rival =
    "the scan's own trilinear isosurface, by a measure that shares nothing with what made "
    "the guide";
  row.timeS = seconds.median;
  row.n = int(made.mesh.triangles.size());
  char text[120];
  std::snprintf(text, sizeof text, "; %.2f %% of %.0f mm2 of inner wall within 0.1 mm of the gap",
    100.0 * gap.within, gap.innerWallMm2);
  row.data = subject.data + text;
  row.bars = { { {}, 0.1 } };
  context.report.rows.push_back(time);
  context.report.rows.push_back(row);
  TryPreview(context, subject, made.mesh, at);
}

} // namespace

GapShare GapOf(const TriangleMesh& mesh, const GuideSubject& subject)
{
  constexpr double WithinMm = 0.1;
  GuideGapSettings settings;
  settings.isovalue = subject.recipe.isovalue;
  settings.gapMm = subject.recipe.gapMm;
  settings.nearMm = subject.recipe.gapMm + 0.5 * subject.recipe.thicknessMm;
  const std::vector<MeshSample> samples = SampleMesh(mesh, GapSampleMm);
  std::vector<glm::dvec3> places;
  for (const MeshSample& sample : samples)
    places.push_back(sample.point);
  const auto nearest =
    DistanceToIsosurface(ViewImage(subject.image), settings.isovalue, places, settings.nearMm);
  const auto at = [&](double tolerance)
  {
    settings.toleranceMm = tolerance;
    return MeasureGuideGap(samples, nearest, settings);
  };
  const GuideGap asked = at(WithinMm);
  double low = 0.0, high = 2.0 * settings.nearMm; // the share grows with the tolerance
  for (int n = 0; n < 10; ++n)
  {
    const double middle = 0.5 * (low + high);
    (at(middle).share >= 0.95 ? high : low) = middle;
  }
  return { high, asked.share, asked.innerWallMm2 };
}

void TryGuideTimes(ReportContext& context)
{
  std::string why;
  context.progress(0.0, "guides: the demo's guide");
  const GuideSubject cranium = CraniumSubject(context.settings.volume, why);
  if (cranium.image)
    TrySubject(context, cranium, "");
  else
    for (const char* id : { "guides.time", "guides.gap.p95", "guides.preview" })
      context.report.rows.push_back(AbsentRow(id, "the demo's guide on a real CT", why));
  context.progress(0.0, "guides: a guide on the phantom");
  TrySubject(context, PhantomSubject(), "@phantom");
}

} // namespace hasp
