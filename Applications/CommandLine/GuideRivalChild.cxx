// hasp-guide-rival: a guide by Booleans of meshes, in a process of its own, so that a crash or a
// loop without an end costs `hasp report guides` this rival alone. See GuideRivals.h.
//
// Usage: hasp-guide-rival VOLUME RECIPE OUT.stl
// Output: seconds   (of surface, shell and Booleans; reading and writing do not count)
#include "GuideRivalTools.h"

#include "Grid/TriangleMesh.h"
#include "Planning/GuideRecipeFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkBooleanOperationPolyDataFilter.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExtractVOI.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkTriangleFilter.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>

namespace
{

using namespace hasp;

constexpr double Facing = 0.2; ///< least cosine between the bone's normal and the way off it
constexpr int Smoothings = 20; ///< of normals: scans are stepped
constexpr int Round = 64;      ///< corners of a hole

vtkSmartPointer<vtkImageData> Around(vtkImageData* image, const GuideRecipe& recipe)
{
  const GridGeometry grid = ImageGeometry(image);
  glm::dvec3 low(1e30), high(-1e30);
  for (const glm::dvec3& p : recipe.landmarks)
  {
    const glm::dvec3 reach = (0.5 * recipe.widthMm + AroundMm) / grid.spacing;
    low = glm::min(low, grid.WorldToIndex(p) - reach);
    high = glm::max(high, grid.WorldToIndex(p) + reach);
  }
  const glm::ivec3 from = glm::max(glm::ivec3(low), glm::ivec3(0));
  const glm::ivec3 to = glm::min(glm::ivec3(high) + 1, grid.dims - 1);
  vtkNew<vtkExtractVOI> part;
  part->SetInputData(image);
  part->SetVOI(from.x, to.x, from.y, to.y, from.z, to.z);
  part->Update();
  return part->GetOutput();
}

double FromLandmarks(const glm::dvec3& p, const GuideRecipe& recipe)
{
  double least = 1e30;
  for (std::size_t n = 0; n + 1 < recipe.landmarks.size(); ++n)
  {
    const glm::dvec3 a = recipe.landmarks[n], ab = recipe.landmarks[n + 1] - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    least = std::min(least, glm::length(p - a - t * ab));
  }
  return least;
}

/// Unit normals of points, out of bone, smoothed over their neighbours.
std::vector<glm::dvec3> Normals(const TriangleMesh& mesh, int smoothings)
{
  std::vector<glm::dvec3> normals(mesh.points.size(), glm::dvec3(0.0));
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      normals[t[k]] +=
        glm::cross(mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]);
  const auto unit = [](glm::dvec3& n) { n = glm::length(n) > 0.0 ? glm::normalize(n) : n; };
  std::for_each(normals.begin(), normals.end(), unit);
  for (int pass = 0; pass < smoothings; ++pass)
  {
    std::vector<glm::dvec3> sum = normals;
    for (const glm::uvec3& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        sum[t[k]] += normals[t[(k + 1) % 3]] + normals[t[(k + 2) % 3]];
    std::for_each(sum.begin(), sum.end(), unit);
    normals = sum;
  }
  return normals;
}

/// Triangles whose normals point out of bone, whichever way VTK has them.
TriangleMesh Outwards(TriangleMesh mesh, const glm::dvec3& withdrawal, const GuideRecipe& recipe)
{
  const auto normals = Normals(mesh, 0);
  std::size_t nearest = 0;
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    if (glm::length(mesh.points[n] - recipe.landmarks[0]) <
        glm::length(mesh.points[nearest] - recipe.landmarks[0]))
      nearest = n;
  if (glm::dot(normals[nearest], withdrawal) < 0.0)
    for (glm::uvec3& t : mesh.triangles)
      std::swap(t.y, t.z);
  return mesh;
}

/// Of the bone's surface, what the guide lies on.
TriangleMesh Patch(vtkImageData* image, const GuideRecipe& recipe)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, recipe.isovalue);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  const TriangleMesh bone =
    Outwards(MakeTriangleMesh(contour->GetOutput()), recipe.withdrawal, recipe);
  const auto normals = Normals(bone, 3);
  const Mesh mesh = MakePolyData(bone);
  vtkNew<vtkDoubleArray> inside;
  for (std::size_t n = 0; n < bone.points.size(); ++n)
    inside->InsertNextValue(std::min(0.5 * recipe.widthMm - FromLandmarks(bone.points[n], recipe),
      5.0 * (glm::dot(normals[n], recipe.withdrawal) - Facing)));
  mesh->GetPointData()->SetScalars(inside);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(mesh);
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(clip->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(largest->GetOutputPort());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return MakeTriangleMesh(clean->GetOutput());
}

/// The patch twice, moved off, and the rims joined.
TriangleMesh Shell(const TriangleMesh& patch, const GuideRecipe& recipe)
{
  const auto normals = Normals(patch, Smoothings);
  const auto count = static_cast<std::uint32_t>(patch.points.size());
  TriangleMesh shell;
  for (const double off : { recipe.gapMm, recipe.gapMm + recipe.thicknessMm })
    for (std::size_t n = 0; n < patch.points.size(); ++n)
      shell.points.push_back(patch.points[n] + off * normals[n]);
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
  for (const glm::uvec3& t : patch.triangles)
  {
    shell.triangles.push_back({ t.x, t.z, t.y });
    shell.triangles.push_back(t + count);
    for (int k = 0; k < 3; ++k)
      edges[{ t[k], t[(k + 1) % 3] }] = true;
  }
  for (const auto& [edge, there] : edges)
    if (const auto [a, b] = edge; !edges.contains({ b, a }))
    {
      shell.triangles.push_back({ a, b, b + count });
      shell.triangles.push_back({ a, b + count, a + count });
    }
  return shell;
}

Mesh Guide(vtkImageData* image, const GuideRecipe& recipe)
{
  Mesh guide = MakePolyData(Shell(Patch(Around(image, recipe), recipe), recipe));
  for (const Mesh& tool : Tools(recipe))
  {
    vtkNew<vtkBooleanOperationPolyDataFilter> boolean;
    boolean->SetOperationToDifference();
    boolean->SetInputData(0, guide);
    boolean->SetInputData(1, tool);
    guide = Cleaned(boolean);
  }
  return guide;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 4)
    return 2;
  vtkObject::GlobalWarningDisplayOff();
  try
  {
    const LoadedVolume volume = LoadVolume(OpenVolume(argv[1]));
    const GuideRecipe recipe = ReadGuideRecipe(argv[2]);
    const auto start = std::chrono::steady_clock::now();
    const Mesh guide = Guide(volume.image, recipe);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    WriteSurface(guide, argv[3]);
    std::printf("%.9g\n", spent.count());
  }
  catch (const std::exception&)
  {
    return 1;
  }
}
