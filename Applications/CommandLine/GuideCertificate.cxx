#include "GuideCertificate.h"

#include "Planning/GuideRecipe.h"
#include "VtkMessages.h"
#include "vtkHaspVolumeView.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace hasp
{
namespace
{

/// As it will be printed: float32 corners, each triangle with its own, made one by place alone.
TriangleMesh ReadBack(const std::string& stl)
{
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(stl.c_str());
  reader->MergingOff();
  reader->Update();
  ThrowVtkError(ExitCode::FailedCheck, "the guide cannot be read back");
  return WeldPoints(MakeTriangleMesh(reader->GetOutput()));
}

const char* YesNo(bool yes)
{
  return yes ? "yes" : "NO";
}

std::string Line(const char* format, auto... figures)
{
  char text[200];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

} // namespace

GuideCertificate CertifyGuide(
  const std::string& stl, vtkImageData* volume, const GuideRecipe& recipe)
{
  const TriangleMesh mesh = ReadBack(stl);
  GuideCertificate certificate;
  certificate.mesh = CheckMesh(mesh);
#if HASP_WITH_CGAL
  if (certificate.mesh.degenerate == 0) // CGAL's predicates want triangles with an area
    certificate.selfIntersections = CountSelfIntersections(mesh);
#endif
  GuideGapSettings settings;
  settings.isovalue = recipe.isovalue;
  settings.gapMm = recipe.gapMm;
  settings.toleranceMm = certificate.toleranceMm;
  settings.nearMm = recipe.gapMm + 0.5 * recipe.thicknessMm;
  certificate.gapAskedMm = recipe.gapMm;
  certificate.gap = MeasureGuideGap(ViewImage(volume), mesh, settings);
  return certificate;
}

std::vector<std::string> FaultsOf(const GuideCertificate& certificate, double leastShare)
{
  std::vector<std::string> faults;
  const auto require = [&](bool holds, const std::string& fault)
  {
    if (!holds)
      faults.push_back(fault);
  };
  const MeshCheck& mesh = certificate.mesh;
  require(mesh.Closed(), "the mesh is not closed");
  require(mesh.TwoManifold(), "the mesh is not 2-manifold");
  require(mesh.Outward(), "the mesh does not face outward all over");
  require(mesh.degenerate == 0, "the mesh has triangles without an area");
  require(mesh.pieces == 1, "the guide is in " + std::to_string(mesh.pieces) + " pieces");
  if (!certificate.selfIntersections)
    require(false, "self-intersections were not measured (HASP_ENABLE_CGAL, no flat triangles)");
  else
    require(*certificate.selfIntersections == 0, "the mesh meets itself");
  const GuideGap& gap = certificate.gap;
  require(gap.innerWallMm2 > 0.0, "no wall faces bone within reach");
  require(gap.share >= leastShare,
    Line("only %.1f %% of the inner wall is within %.2f mm of the gap, at least %.1f %% must be",
      100.0 * gap.share, certificate.toleranceMm, 100.0 * leastShare));
  require(gap.leastAnywhere > 0.0, "a wall touches bone");
  return faults;
}

std::string CertificateText(const GuideCertificate& certificate)
{
  const MeshCheck& mesh = certificate.mesh;
  const GuideGap& gap = certificate.gap;
  const std::string meets =
    certificate.selfIntersections ? std::to_string(*certificate.selfIntersections) : "not measured";
  return Line("triangles           %zu, %zu piece(s), %.1f mm3\n", mesh.triangles, mesh.pieces,
           mesh.volumeMm3) +
         Line("closed              %s\n", YesNo(mesh.Closed())) +
         Line("2-manifold          %s\n", YesNo(mesh.TwoManifold())) +
         Line("outward             %s\n", YesNo(mesh.Outward())) + "self-intersections  " + meets +
         "\n" +
         Line("gap asked           %.3f mm; inner wall, what faces bone: %.1f mm2\n",
           certificate.gapAskedMm, gap.innerWallMm2) +
         Line("gap p5 p50 p95      %.3f  %.3f  %.3f mm by area, least %.3f, most %.3f\n", gap.p5,
           gap.p50, gap.p95, gap.least, gap.most) +
         Line("within %.2f mm      %.2f %% of the inner wall\n", certificate.toleranceMm,
           100.0 * gap.share) +
         Line("nearest of all      %.3f mm, whichever way the wall faces\n", gap.leastAnywhere);
}

nlohmann::ordered_json CertificateJson(const GuideCertificate& certificate)
{
  const MeshCheck& mesh = certificate.mesh;
  const GuideGap& gap = certificate.gap;
  nlohmann::ordered_json json{ { "triangles", mesh.triangles }, { "pieces", mesh.pieces },
    { "volume_mm3", mesh.volumeMm3 }, { "closed", mesh.Closed() },
    { "manifold", mesh.TwoManifold() }, { "outward", mesh.Outward() },
    { "degenerate", mesh.degenerate }, { "self_intersections", nullptr },
    { "gap_asked_mm", certificate.gapAskedMm }, { "inner_wall_mm2", gap.innerWallMm2 },
    { "gap_p5_mm", gap.p5 }, { "gap_p50_mm", gap.p50 }, { "gap_p95_mm", gap.p95 },
    { "gap_least_mm", gap.least }, { "gap_most_mm", gap.most },
    { "tolerance_mm", certificate.toleranceMm }, { "share_within", gap.share },
    { "nearest_wall_mm", gap.leastAnywhere } };
  if (certificate.selfIntersections)
    json["self_intersections"] = *certificate.selfIntersections;
  return json;
}

} // namespace hasp
