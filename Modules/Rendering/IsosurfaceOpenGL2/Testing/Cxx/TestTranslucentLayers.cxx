// Layers of translucent cells and polydata by depth peeling, held pixel by pixel against all that
// the ray meets, sorted on the CPU. Silhouettes are left out: LayerScene.h says which, and why.
#include "Grid/Phantom.h"
#include "LayerScene.h"

#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

namespace
{

using hasp::AnalyticSphere;
using hasp::AnalyticTorus;
using hasp::testing::LayerError;
using hasp::testing::LayerScene;

constexpr int Width = 120, Height = 90;

class TranslucentLayers : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// A layer too few, too many or out of order is many grey levels; what may differ is a rounding in
/// the end and one of each layer's colour in 16 bits. leastDeep: of pixels with four layers.
LayerError Hold(LayerScene& scene, int leastDeep, double silhouettes = 0.01)
{
  const LayerError e = scene.Compare();
  std::cout << "largest " << e.largest << ", rms " << e.rms << " of 255; " << e.deep << " of "
            << e.compared << " pixels have 4 to " << e.layers << " layers; silhouettes "
            << 100 * e.SilhouetteShare() << " %\n";
  EXPECT_LE(e.largest, LayerError::Allowed);
  EXPECT_GE(e.deep, leastDeep);
  EXPECT_LT(e.SilhouetteShare(), silhouettes);
  return e;
}

vtkSmartPointer<vtkPolyData> Sphere(double x, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, 0.13, 0.17); // no pixel's middle on its seam
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(14);
  sphere->SetPhiResolution(9);
  sphere->Update();
  return sphere->GetOutput();
}

void AddPlanes(LayerScene& s, double opacity)
{
  s.AddPlane({ -30, -5, -30 }, { 60, 5, 0 }, { 0, 3, 60 }, { 1, 0, 0 }, opacity);
  s.AddPlane({ -30, 8, -30 }, { 60, -7, 0 }, { 0, 3, 60 }, { 0, 0, 1 }, opacity);
}

/// Cells, mesh, cells within each other, and two planes through all: eight layers.
void AddNested(LayerScene& s, double opacity)
{
  s.AddBody(AnalyticSphere({ 0, 0, 0 }, 22), { 1, 0.8, 0.6 }, opacity);
  s.AddTriangles(Sphere(1, 18), { 0.9, 0.1, 0.8 }, opacity);
  s.AddBody(AnalyticSphere({ 3, 0, 0 }, 13), { 0.2, 0.8, 0.6 }, opacity);
  AddPlanes(s, opacity);
}

TEST_F(TranslucentLayers, OfCellsAndMeshesAreSortedAtAnyOpacity)
{
  for (const double opacity : { 0.001, 0.003, 0.05, 0.5, 0.95, 0.999 })
  {
    SCOPED_TRACE(opacity);
    LayerScene s(64, 48);
    AddNested(s, opacity);
    EXPECT_EQ(Hold(s, 900).layers, 8U);
  }
}

TEST_F(TranslucentLayers, OfDifferentOpacitiesAreSorted)
{
  LayerScene s(Width, Height);
  s.AddBody(AnalyticSphere({ 0, 0, 0 }, 22), { 1, 0.8, 0.6 }, 0.05);
  s.AddTriangles(Sphere(1, 18), { 0.9, 0.1, 0.8 }, 0.999);
  s.AddBody(AnalyticSphere({ 3, 0, 0 }, 13), { 0.2, 0.8, 0.6 }, 0.95);
  s.AddPlane({ -30, -25, -30 }, { 60, 0, 0 }, { 0, 3, 60 }, { 0, 1, 0 }, 0.5);
  AddPlanes(s, 0.002);
  Hold(s, 1500);
}

TEST_F(TranslucentLayers, ThatCutEachOtherAreSorted)
{
  LayerScene s(Width, Height);
  s.AddBody(AnalyticTorus({ 0, 0, 0 }, { 0, 0.6, 0.8 }, 15, 6), { 1, 0.8, 0.6 }, 0.5);
  s.AddBody(AnalyticTorus({ 4, 0, 0 }, { 0.8, 0, 0.6 }, 14, 5), { 0.2, 0.8, 0.6 }, 0.4);
  s.AddTriangles(Sphere(6, 14), { 0.9, 0.1, 0.8 }, 0.3);
  AddPlanes(s, 0.5);
  Hold(s, 900);
}

TEST_F(TranslucentLayers, EndAtOpaqueOnes)
{
  LayerScene s(Width, Height);
  AddNested(s, 0.4);
  s.AddBody(AnalyticSphere({ -4, 0, 5 }, 9), { 1, 1, 0 }, 1.0);                       // inside
  s.AddTriangles(Sphere(14, 7), { 0, 1, 1 }, 1.0);                                    // through
  s.AddPlane({ -60, 30, -60 }, { 100, 10, 0 }, { 0, 4, 60 }, { 0.1, 0.1, 0.1 }, 1.0); // behind
  s.AddPlane({ 10, -40, 0 }, { 15, 0, 0 }, { 0, 0, 15 }, { 0.8, 0.8, 0.1 }, 1.0);     // before
  Hold(s, 900);
}

/// Voxels of 5 mm, at random: thin necks, and rays that meet the surface two and three times in one
/// cell.
TEST_F(TranslucentLayers, OfNoiseHaveEveryRootOfACell)
{
  const hasp::GridGeometry grid{ { 9, 9, 9 }, glm::dvec3(-20), glm::dvec3(5), glm::dmat3(1) };
  std::vector<std::int16_t> samples(9 * 9 * 9);
  std::mt19937 random(3);
  for (std::int16_t& sample : samples)
    sample = static_cast<std::int16_t>(int(random() % 2001) - 1000);
  LayerScene s(2 * Width, 2 * Height);
  s.AddCells(hasp::MakeImage(grid, samples), 100, { 1, 0.8, 0.6 }, 0.3);
  EXPECT_GE(Hold(s, 3000).layers, 8U);
}

TEST_F(TranslucentLayers, OfAHeadsSkinBoneGhostAndPartAreSorted)
{
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(5));
  const auto image = hasp::MakeImage(grid, hasp::SamplePhantom(grid));
  LayerScene s(Width, Height);
  s.Look({ 160, -330, 120 }, { 0, 0, 0 }, 150, 600);
  s.AddCells(image, -500, { 0.9, 0.7, 0.6 }, 0.3);
  s.AddCells(image, 400, { 0.95, 0.9, 0.8 }, 0.4);
  s.AddTriangles(Sphere(-40, 45), { 0.2, 0.6, 0.9 }, 0.5);
  s.AddPlane({ -90, -20, -100 }, { 180, 30, 0 }, { 0, 10, 200 }, { 0.2, 0.9, 0.3 }, 0.2);
  EXPECT_GE(Hold(s, 1500).layers, 8U);
}

TEST_F(TranslucentLayers, AreSortedWhereTheyAreLit)
{
  LayerScene s(Width, Height);
  s.LightFrom({ 0.6, -1, 0.8 });
  AddNested(s, 0.5);
  Hold(s, 1500);
}

/// Labels of one mapper: opaque, translucent, nearly opaque (8 bits make it so), hidden.
TEST_F(TranslucentLayers, OfLabelsInOneMapperAreSorted)
{
  const hasp::GridGeometry grid{ { 44, 44, 44 }, glm::dvec3(-25.8), glm::dvec3(1.2),
    glm::dmat3(1) };
  const auto image =
    hasp::MakeImage(grid, hasp::SampleAnalytic<std::int16_t>(
                            AnalyticTorus({ 0, 0, 0 }, { 0, 0.6, 0.8 }, 15, 6), grid, 100, 0));
  vtkNew<vtkUnsignedShortArray> labels;
  labels->SetName("label");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    labels->InsertNextValue(static_cast<unsigned short>(1 + (n % 44) / 11)); // along x
  image->GetPointData()->AddArray(labels);
  const glm::dvec4 colors[] = { { 1, 0, 0, 0.5 }, { 0, 1, 0, 1 }, { 0, 0, 1, 0.999 },
    { 1, 1, 0, 0.2 } };
  const auto labelOf = [&](const hasp::TrilinearHit& hit)
  {
    // A cell between two labels has the one of more inside corners, the smaller of two.
    int count[2] = { 0, 0 };
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 at = hit.cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      count[corner & 1] += image->GetScalarComponentAsDouble(at.x, at.y, at.z, 0) >= 0;
    }
    return colors[(hit.cell.x + (count[1] > count[0] ? 1 : 0)) / 11];
  };
  for (const double opacity : { 1.0, 0.5 })
  {
    SCOPED_TRACE(opacity);
    LayerScene s(Width, Height);
    const auto mapper = s.AddCells(image, 0, { 1, 1, 1 }, opacity, labelOf);
    mapper->SetLabelArrayName("label");
    for (int n = 0; n < 4; ++n)
      mapper->SetLabelColor(n + 1, colors[n].r, colors[n].g, colors[n].b, colors[n].a);
    AddPlanes(s, 0.4);
    // Opacities of labels have 8 bits: half a level of each, and of what is behind it.
    Hold(s, opacity < 1.0 ? 500 : 200);
  }
}

/// A peel takes the nearest and the farthest layer.
TEST_F(TranslucentLayers, TakeHalfAsManyPeelsAsThereAre)
{
  for (const int peels : { 4, 1000, 2, 1 })
  {
    SCOPED_TRACE(peels);
    LayerScene s(64, 48);
    AddNested(s, 0.5);
    s.Renderer->SetMaximumNumberOfPeels(peels);
    if (peels >= 4)
    {
      Hold(s, 900);
      continue;
    }
    // What is left is blended in any order; peeled layers of half before it leave a part of it.
    const LayerError e = s.Compare();
    EXPECT_GT(e.largest, LayerError::Allowed);
    EXPECT_LE(e.largest, 255 * std::pow(0.5, peels) + 2.0);
  }
}

/// 6 pixels a voxel, and every sixth has its middle on a face between two cells, but for rounding.
TEST_F(TranslucentLayers, HaveNoSeamsInPicturesAlongTheAxes)
{
  const double voxel = 0.7, half = 0.5 / 6;
  const hasp::GridGeometry grid{ { 21, 21, 21 }, { -7.03, -7.11, -7.21 }, glm::dvec3(voxel),
    glm::dmat3(1) };
  LayerScene s(120, 120);
  for (const double radius : { 5.8, 4.3 })
    s.AddCells(hasp::MakeImage(grid, hasp::SampleAnalytic<float>(
                                       AnalyticSphere({ 0.2, 0.1, -0.1 }, radius), grid, 1, 0)),
      0, { 1, 0.8, 0.6 }, 0.5);
  const glm::dvec3 middle = grid.IndexToWorld(glm::dvec3(10 - half, 10, 10 - half));
  s.Look(middle - glm::dvec3(0, 100, 0), middle, 40, 180);
  s.Renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  s.Renderer->GetActiveCamera()->ParallelProjectionOn();
  s.Renderer->GetActiveCamera()->SetParallelScale(10 * voxel);
  const LayerError e = s.Compare();
  EXPECT_GT(e.deep, 4000);
  // Beside a silhouette two cells' roots of one point may be 5e-7 of the depth apart.
  EXPECT_LE(e.wrong, 2) << "of " << e.compared;
}

/// Two cells round the place of a hit on their common face each in its own way. What is drawn by
/// the one alone whose it is, is missing or there twice in one of 100,000 pixels: in one of these.
TEST_F(TranslucentLayers, AreWholeWhereCellsMeet)
{
  const hasp::GridGeometry grid{ glm::ivec3(100), glm::dvec3(-26.5), glm::dvec3(0.533),
    glm::dmat3(1) };
  const auto image = hasp::MakeImage(
    grid, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), grid, 300, 0));
  LayerScene s(200, 150);
  s.AddCells(image, 0, { 1, 0.8, 0.6 }, 0.3);
  s.Look(
    100.0 * glm::normalize(glm::dvec3(std::cos(1.0), std::sin(1.0), 0.3)), { 0, 0, 0 }, 40, 180);
  Hold(s, 9000);
}

TEST_F(TranslucentLayers, AreSortedInWindowsThatChangeAndInPartsOfThem)
{
  LayerScene s(64, 48);
  AddNested(s, 0.5);
  s.Compare();
  s.Window->SetSize(80, 64);
  Hold(s, 1200);
  vtkNew<vtkUnsignedCharArray> whole, part;
  s.Window->GetPixelData(0, 0, 79, 63, 0, whole);
  s.Window->SetSize(160, 64);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0, 0, 0.5, 1);
  s.Renderer->SetViewport(0.5, 0, 1, 1);
  s.Window->AddRenderer(other);
  s.Window->Render();
  s.Window->GetPixelData(80, 0, 159, 63, 0, part);
  for (vtkIdType n = 0; n < whole->GetNumberOfValues(); ++n)
    ASSERT_EQ(part->GetValue(n), whole->GetValue(n)) << n;
}

/// Rays find the front alone: where it has the choice the mapper draws all cells.
TEST_F(TranslucentLayers, OfTheRayCachingMapperAreSorted)
{
  LayerScene s(Width, Height);
  using Mapper = vtkHaspRayCachingMapper;
  s.AddBody<Mapper>(AnalyticSphere({ 0, 0, 0 }, 22), { 1, 0.8, 0.6 }, 0.5);
  s.AddBody<Mapper>(AnalyticSphere({ 3, 0, 0 }, 13), { 0.2, 0.8, 0.6 }, 0.5);
  AddPlanes(s, 0.5);
  Hold(s, 1500);
}

} // namespace
