// What is drawn against what is true: closed forms, and the CPU ray caster pixel by pixel.
#include "CellTestScene.h"
#include "Isosurface/ClusteredCells.h"
#include "Isosurface/RayCaster.h"

#include "vtkPlane.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using hasp::testing::CellTestScene;
using hasp::testing::ObliqueGrid;

struct Agreement
{
  int surface = 0;    ///< pixels where either shows a surface
  int disagree = 0;   ///< where only one does
  double depth = 0.0; ///< largest distance along the ray where both do and it does not graze, mm
  double truth = 0.0; ///< largest |value| of the analytic field there, mm
};

/// Compares every pixel with the ray caster, whose rays start on the near plane or where `start`
/// says.
Agreement Compare(const CellTestScene& scene, int width, int height, const hasp::RayCaster& caster,
  const hasp::AnalyticVolume& shape,
  const std::function<double(const glm::dvec3&, const glm::dvec3&)>& start = {})
{
  Agreement result;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const auto [origin, direction] = scene.Ray(x, y);
      const auto drawn = scene.Point(x, y);
      const auto hit = caster.Cast(origin, direction, start ? start(origin, direction) : 0.0);
      if (!drawn && !hit)
        continue;
      ++result.surface;
      const bool grazes = hit && std::abs(glm::dot(glm::normalize(hit->gradient), direction)) < 0.2;
      if (!drawn || !hit || (grazes && glm::length(*drawn - hit->position) > 0.5))
      {
        ++result.disagree; // at a silhouette the other may see the sheet behind
        continue;
      }
      if (grazes)
        continue;
      result.depth = std::max(result.depth, glm::length(*drawn - hit->position));
      result.truth = std::max(result.truth, std::abs(shape.value(*drawn)));
    }
  return result;
}

/// The scene of one shape on one grid, drawn; T is the sample type.
template <typename T>
struct ShapeScene
{
  hasp::AnalyticVolume shape;
  hasp::GridGeometry geometry;
  vtkSmartPointer<vtkImageData> image;
  hasp::AnyGridView grid;
  hasp::MinMaxBlocks blocks;
  double isovalue;
  CellTestScene scene;

  ShapeScene(const hasp::AnalyticVolume& shape_, const hasp::GridGeometry& geometry_,
    double scale = 100, double offset = 0, int width = 240, int height = 200)
    : shape(shape_),
      geometry(geometry_),
      image(hasp::MakeImage(geometry, hasp::SampleAnalytic<T>(shape, geometry, scale, offset))),
      grid(hasp::ViewImage(image)),
      blocks(grid),
      isovalue(offset),
      scene(width, height)
  {
    scene.Mapper->SetInputData(image);
    scene.Mapper->SetIsoValue(isovalue);
  }
  Agreement DrawAndCompare(int width = 240, int height = 200)
  {
    scene.Draw();
    return Compare(scene, width, height, hasp::RayCaster(grid, blocks, isovalue), shape);
  }
};

class CellDepth : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  /// The bar: 0.1 voxel from closed form; and from the ray caster float rounding of depth and
  /// corners.
  static void Hold(const Agreement& a, double voxel, const std::string& what)
  {
    EXPECT_GT(a.surface, 3000) << what;
    EXPECT_LE(a.disagree, 1 + a.surface / 500) << what;
    EXPECT_LT(a.truth, 0.1 * voxel) << what;
    EXPECT_LT(a.depth, 0.01 * voxel) << what;
    std::cout << what << ": " << a.surface << " pixels, " << a.disagree
              << " disagree, from closed form " << a.truth / voxel << " voxel, from the ray caster "
              << a.depth / voxel << " voxel\n";
  }
};

TEST_F(CellDepth, AnalyticShapesOnObliqueAnisotropicGrids)
{
  for (const auto& shape : { hasp::AnalyticSphere({ 0.3, -0.2, 0.1 }, 25),
         hasp::AnalyticTorus({ 0, 0, 0 }, glm::normalize(glm::dvec3(1, 2, -1)), 20, 9),
         hasp::AnalyticGyroid(30) })
  {
    ShapeScene<std::int16_t> s(shape, ObliqueGrid(64, { 1.0, 0.8, 1.3 }));
    s.scene.Look({ 90, -120, 60 }, { 0, 0, 0 }, 40, 300);
    s.scene.Renderer->GetActiveCamera()->Zoom(1.4);
    Hold(s.DrawAndCompare(), 1.0, shape.name);
  }
}

TEST_F(CellDepth, EverySampleType)
{
  const auto sphere = hasp::AnalyticSphere({ 0, 0, 0 }, 22);
  const auto g = ObliqueGrid(64, { 1, 1, 1 });
  const auto look = [](CellTestScene& scene) { scene.Look({ 60, -80, 40 }, { 0, 0, 0 }, 30, 200); };
  ShapeScene<std::uint16_t> a(
    sphere, g, 100, 40000); // above what a signed 16-bit corner could hold
  look(a.scene);
  Hold(a.DrawAndCompare(), 1.0, "uint16");
  ShapeScene<float> b(sphere, g, 1e-3, 1e-2);
  look(b.scene);
  Hold(b.DrawAndCompare(), 1.0, "float");
  // uint8 rounds distances to 1/8 voxel and saturates: the surface itself is that far from the
  // sphere.
  ShapeScene<std::uint8_t> c(sphere, g, 8, 128);
  look(c.scene);
  c.scene.Draw();
  const auto agreement =
    Compare(c.scene, 240, 200, hasp::RayCaster(c.grid, c.blocks, c.isovalue), sphere);
  EXPECT_LT(agreement.depth, 0.01);
  EXPECT_GT(agreement.surface, 3000);
}

TEST_F(CellDepth, TheSameSurfaceFromRotatedAndAnisotropicVolumes)
{
  // Truth is world space: three grids of the same sphere show it in the same pixels at the same
  // depth.
  const auto sphere = hasp::AnalyticSphere({ 1, 2, 3 }, 20);
  hasp::GridGeometry straight{ { 60, 60, 60 }, glm::dvec3(-29.5), { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::vector<glm::dvec3>> shown;
  for (const auto& g :
    { straight, ObliqueGrid(60, { 1, 1, 1 }), ObliqueGrid(70, { 0.9, 0.7, 1.5 }) })
  {
    ShapeScene<std::int16_t> s(sphere, g);
    s.scene.Look({ 60, -80, 40 }, { 1, 2, 3 }, 30, 200);
    s.scene.Draw();
    shown.emplace_back();
    for (int y = 0; y < 200; y += 3)
      for (int x = 0; x < 240; x += 3)
        shown.back().push_back(s.scene.Point(x, y).value_or(glm::dvec3(1e6)));
  }
  int both = 0;
  for (std::size_t n = 0; n < shown[0].size(); ++n)
    for (int other : { 1, 2 })
      if (glm::length(shown[0][n]) < 1e3 && glm::length(shown[other][n]) < 1e3)
      {
        // Two trilinear surfaces within 0.1 voxel of the sphere each, at up to 78 degrees to the
        // ray.
        EXPECT_LT(glm::length(shown[0][n] - shown[other][n]), 1.0);
        ++both;
      }
  EXPECT_GT(both, 1000);
}

TEST_F(CellDepth, ParallelOffAxisAndTurnedActors)
{
  ShapeScene<std::int16_t> s(hasp::AnalyticGyroid(30), ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
  vtkCamera* camera = s.scene.Renderer->GetActiveCamera();
  s.scene.Look({ 90, -120, 60 }, { 0, 0, 0 }, 40, 300);
  camera->SetParallelProjection(true);
  camera->SetParallelScale(28);
  Hold(s.DrawAndCompare(), 1.0, "parallel");
  camera->SetParallelProjection(false);
  camera->SetWindowCenter(0.6, -0.3); // an eye far beside the screen's middle
  Hold(s.DrawAndCompare(), 1.0, "off-axis");
  camera->SetWindowCenter(0, 0);

  // A turned and moved actor against an unturned one seen by a camera turned the other way.
  vtkNew<vtkTransform> turn;
  turn->Translate(3, -5, 7);
  turn->RotateWXYZ(33, 1, 2, 3);
  s.scene.Actor->SetUserTransform(turn);
  s.scene.Draw();
  const hasp::RayCaster caster(s.grid, s.blocks, 0.0);
  const glm::dmat4 back =
    glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(turn->GetMatrix()->GetData()))));
  int compared = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 240; ++x)
    {
      const auto [origin, direction] = s.scene.Ray(x, y);
      const auto drawn = s.scene.Point(x, y);
      const auto hit =
        caster.Cast(glm::dvec3(back * glm::dvec4(origin, 1)), glm::dmat3(back) * direction);
      if (!drawn || !hit ||
          std::abs(glm::dot(glm::normalize(hit->gradient), glm::dmat3(back) * direction)) < 0.2)
        continue;
      EXPECT_LT(glm::length(*drawn - origin - hit->t * direction), 0.01);
      ++compared;
    }
  EXPECT_GT(compared, 3000);
}

TEST_F(CellDepth, FromInsideTheVolumeAndThroughTheNearPlane)
{
  // The eye stands among the cells; some surround it, many are larger than any point OpenGL draws.
  ShapeScene<std::int16_t> s(hasp::AnalyticGyroid(30), ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
  for (const glm::dvec3 eye : { glm::dvec3(0, 0, 0), glm::dvec3(4, 4, -9), glm::dvec3(-7.5, 0, 2) })
  {
    s.scene.Look(eye, eye + glm::dvec3(1, 0.3, 0.2), 0.05, 100);
    const Agreement a = s.DrawAndCompare();
    EXPECT_GT(a.surface, 3000);
    EXPECT_LE(a.disagree, 1 + a.surface / 500);
    EXPECT_LT(a.depth, 0.05); // the depth buffer has few digits left at near 0.05
  }
}

TEST_F(CellDepth, AMillionVoxelsAway)
{
  ShapeScene<std::int16_t> s(hasp::AnalyticSphere({ 0, 0, 0 }, 25), ObliqueGrid(64, { 1, 1, 1 }));
  const glm::dvec3 away = glm::normalize(glm::dvec3(2, -3, 1)) * 1e6;
  s.scene.Look(away, { 0, 0, 0 }, 1e6 - 60, 1e6 + 60);
  s.scene.Renderer->GetActiveCamera()->SetViewAngle(0.0038);
  const Agreement a = s.DrawAndCompare();
  EXPECT_GT(a.surface, 3000);
  EXPECT_LE(a.disagree, 1 + a.surface / 200);
  EXPECT_LT(a.truth, 0.1);
}

TEST_F(CellDepth, ClippingPlanesShowWhatTheyUncover)
{
  ShapeScene<std::int16_t> s(hasp::AnalyticGyroid(30), ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
  s.scene.Look({ 90, -120, 60 }, { 0, 0, 0 }, 40, 300);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 1, 0.2)); // keeps the far half
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.x, normal.y, normal.z);
  plane->SetOrigin(1, 2, 3);
  s.scene.Mapper->AddClippingPlane(plane);
  s.scene.Draw();
  const auto start = [&](const glm::dvec3& origin, const glm::dvec3& direction)
  {
    const double t = glm::dot(glm::dvec3(1, 2, 3) - origin, normal) / glm::dot(direction, normal);
    return std::max(0.0, t); // all rays of this camera run along the normal
  };
  const Agreement a =
    Compare(s.scene, 240, 200, hasp::RayCaster(s.grid, s.blocks, 0.0), s.shape, start);
  Hold(a, 1.0, "clipped");
}

TEST_F(CellDepth, WhatCannotBeDrawnIsAnErrorAndWhatIsEmptyIsNot)
{
  CellTestScene none(50, 50);
  none.Mapper->SetGlobalWarningDisplay(false);
  none.Draw(); // no input: an error, no crash
  EXPECT_FALSE(none.Point(25, 25));
  vtkNew<vtkImageData> doubles;
  doubles->SetDimensions(4, 4, 4);
  doubles->AllocateScalars(VTK_DOUBLE, 1);
  none.Mapper->SetInputData(doubles);
  EXPECT_FALSE(none.Mapper->UpdateCells());
  none.Draw();
  none.Mapper->SetGlobalWarningDisplay(true);

  ShapeScene<float> s(hasp::AnalyticSphere({ 0, 0, 0 }, 10), ObliqueGrid(32, { 1, 1, 1 }));
  s.scene.Look({ 30, -40, 20 }, { 0, 0, 0 }, 10, 100);
  s.scene.Mapper->SetIsoValue(1e5); // beyond the samples: nothing, and no error
  s.scene.Draw();
  EXPECT_TRUE(s.scene.Mapper->UpdateCells());
  EXPECT_FALSE(s.scene.Point(120, 100));
  s.scene.Mapper->SetIsoValue(0);
  s.scene.Draw();
  EXPECT_TRUE(s.scene.Point(120, 100));
  s.scene.Mapper->SetIsoValue(std::nan(""));
  s.scene.Mapper->SetGlobalWarningDisplay(false);
  EXPECT_FALSE(s.scene.Mapper->UpdateCells());
  s.scene.Mapper->SetGlobalWarningDisplay(true);
}

} // namespace
