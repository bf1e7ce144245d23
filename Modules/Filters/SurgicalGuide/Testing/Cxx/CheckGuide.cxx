// Makes the guide of a recipe on a volume, writes it as STL, reads it back and prints what the file
// holds: is it a sound mesh, and how far is its inner wall from the trilinear bone surface.
// Usage: CheckGuide volume recipe.json guide.stl [least share of the inner wall within 0.2 mm]
// Exit status 1 if the mesh is unsound, meets itself, or the share is below the least.
#include "Evaluation/GuideGap.h"
#include "Evaluation/MeshCheck.h"
#include "Planning/GuideRecipe.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkImageData.h"
#if HASP_WITH_IOMEDICAL
#include "vtkHaspVolumeReader.h"
using VolumeReader = vtkHaspVolumeReader;
#else
#include "vtkMetaImageReader.h"
using VolumeReader = vtkMetaImageReader; // ignores the direction: only for volumes without one
#endif
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{

bool MeshIsSound(const hasp::TriangleMesh& mesh)
{
  const hasp::MeshCheck c = hasp::CheckMesh(mesh);
  std::printf("mesh: %zu points, %zu triangles, %zu piece(s), %.1f mm3, %.1f mm2\n", c.points,
    c.triangles, c.pieces, c.volumeMm3, c.areaMm2);
  std::printf(
    "      border %zu, crowded %zu, turned %zu edges; %zu pinched points; %zu degenerate\n",
    c.borderEdges, c.crowdedEdges, c.turnedEdges, c.pinchedPoints, c.degenerate);
  bool sound = c.Sound() && c.pieces == 1;
#if HASP_WITH_CGAL
  const std::size_t meets = sound ? hasp::CountSelfIntersections(mesh) : 0;
  std::printf("      %zu self-intersections (CGAL)\n", meets);
  sound = sound && meets == 0;
#endif
  return sound;
}

bool GapIsKept(vtkImageData* ct, const hasp::TriangleMesh& mesh, const hasp::GuideRecipe& recipe,
  double leastShare)
{
  hasp::GuideGapSettings settings;
  settings.isovalue = recipe.isovalue;
  settings.gapMm = recipe.gapMm;
  settings.nearMm = recipe.gapMm + 0.5 * recipe.thicknessMm;
  const auto g = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings);
  std::printf("gap:  asked %.3f mm; inner wall %.1f mm2, %.2f %% within %.2f mm, %.2f %% closer\n",
    recipe.gapMm, g.innerWallMm2, 100.0 * g.share, settings.toleranceMm, 100.0 * g.closer);
  std::printf(
    "      min %.3f, p5 %.3f, p50 %.3f, p95 %.3f, max %.3f; nearest of all walls %.3f mm\n",
    g.least, g.p5, g.p50, g.p95, g.most, g.leastAnywhere);
  return g.innerWallMm2 > 0.0 && g.share >= leastShare;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4)
  {
    std::fprintf(stderr, "usage: CheckGuide volume recipe.json guide.stl [least share]\n");
    return 1;
  }
  try
  {
    vtkNew<VolumeReader> reader;
    reader->SetFileName(argv[1]);
    reader->Update();
    vtkNew<vtkHaspGuideFilter> filter;
    filter->SetInputConnection(reader->GetOutputPort());
    if (!filter->ReadRecipe(argv[2]))
      return 1;
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (filter->GetOutput()->GetNumberOfPolys() == 0)
      return 1;
    vtkNew<vtkSTLWriter> writer;
    writer->SetInputConnection(filter->GetOutputPort());
    writer->SetFileName(argv[3]);
    writer->SetFileTypeToBinary();
    if (!writer->Write())
      return 1;
    vtkNew<vtkSTLReader> again;
    again->SetFileName(argv[3]);
    again->MergingOff();
    again->Update();
    const auto mesh = hasp::WeldPoints(hasp::MakeTriangleMesh(again->GetOutput()));
    std::printf("made in %.2f s\n", spent.count());
    const bool sound = MeshIsSound(mesh);
    const double least = argc > 4 ? std::atof(argv[4]) : 0.0;
    return GapIsKept(reader->GetOutput(), mesh, filter->GetRecipe(), least) && sound ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "CheckGuide: %s\n", error.what());
    return 1;
  }
}
