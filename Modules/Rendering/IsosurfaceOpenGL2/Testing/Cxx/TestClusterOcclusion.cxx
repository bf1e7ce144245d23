// Occlusion culling changes no pixel, whatever camera, isovalue and other actors do, and does leave
// out what is hidden.
#include "CellTestScene.h"
#include "HaspGL.h"
#include "Isosurface/ClusteredCells.h"

#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

constexpr int PixelsX = 100, PixelsY = 50;

vtkSmartPointer<vtkImageData> Gyroid()
{
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(36, { 1, 0.9, 1.3 });
  return hasp::MakeImage(
    g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(14), g, 100, 0));
}

std::size_t CullingBytes(vtkHaspClusteredCellMapper* mapper)
{
  hasp::ResourceList list;
  mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == "occlusion culling")
      return use.bytes;
  ADD_FAILURE();
  return 0;
}

/// Points and triangles, boxes too, that one frame sends on.
GLuint Primitives(CellTestScene& scene)
{
  GLuint query = 0, count = 0;
  scene.Window->MakeCurrent();
  glGenQueries(1, &query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  scene.Window->Render();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

/// A gyroid in two viewports, the right one in parallel projection, and a ball that moves through.
struct Gyroids : CellTestScene
{
  vtkNew<vtkRenderer> Right;
  vtkNew<vtkActor> Ball;

  Gyroids(vtkImageData* image, bool culling) : CellTestScene(PixelsX, PixelsY)
  {
    this->Mapper->SetInputData(image);
    this->Mapper->SetOcclusionCulling(culling);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(8);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    this->Ball->SetMapper(mapper);
    this->Renderer->AddActor(this->Ball);
    this->Renderer->SetViewport(0, 0, 0.6, 1);
    this->Right->SetViewport(0.6, 0, 1, 1);
    this->Right->AddActor(this->Actor);
    this->Window->AddRenderer(this->Right);
    vtkCamera* camera = this->Right->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(28);
    camera->SetPosition(80, 20, 30);
    this->Right->ResetCameraClippingRange();
  }

  /// Frame n of a walk: round the volume, then inside it, with jumps, other isovalues, a clipping
  /// plane for a while, and the ball now before, now behind the surface.
  void Step(int n)
  {
    if (n % 8 == 7)
      this->Mapper->SetIsoValue(40 * std::sin(n));
    std::mt19937 random(n / 13); // a jump every 13 frames
    const double at = 0.05 * n + random() % 100;
    const bool within = n / 13 % 2 == 1;
    const double radius = within ? 10 : 70;
    const glm::dvec3 eye(radius * std::cos(at), radius * std::sin(at), 0.4 * radius * std::sin(n));
    this->Look(eye, { 3, 0, 5 }, within ? 0.2 : 20, 150);
    this->Right->GetActiveCamera()->Azimuth(n % 9 == 8 ? 100 : 2);
    this->Right->ResetCameraClippingRange();
    this->Ball->SetPosition(0.5 * eye.x, 25 * std::cos(0.3 * n), 0);
    if (n == 42)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(-1, -0.3, 0.2);
      this->Mapper->AddClippingPlane(plane);
    }
    if (n == 50)
      this->Mapper->RemoveAllClippingPlanes();
    this->Draw();
  }

  std::vector<unsigned char> Colors()
  {
    vtkNew<vtkUnsignedCharArray> rgb;
    this->Window->GetPixelData(0, 0, PixelsX - 1, PixelsY - 1, 0, rgb);
    return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
  }
  std::vector<float> Depths()
  {
    vtkNew<vtkFloatArray> depth;
    this->Window->GetZbufferData(0, 0, PixelsX - 1, PixelsY - 1, depth);
    return { depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues() };
  }
};

class ClusterOcclusion : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// Legs of one walk of 65 frames; each ends with the jump to the next.
class ClusterOcclusionWalk : public ClusterOcclusion, public ::testing::WithParamInterface<int>
{
};

TEST_P(ClusterOcclusionWalk, ChangesNoPixel)
{
  const auto image = Gyroid();
  Gyroids culled(image, true), whole(image, false);
  std::size_t surface = 0;
  for (int n = 13 * GetParam(); n < 13 * GetParam() + 15; ++n)
  {
    culled.Step(n);
    whole.Step(n);
    const auto depths = whole.Depths();
    ASSERT_EQ(culled.Depths(), depths) << "frame " << n;
    ASSERT_EQ(culled.Colors(), whole.Colors()) << "frame " << n;
    for (const float depth : depths)
      surface += depth < 1.0F;
  }
  EXPECT_GT(surface, 15U * PixelsX * PixelsY / 4);
}

INSTANTIATE_TEST_SUITE_P(Legs, ClusterOcclusionWalk, ::testing::Range(0, 5));

/// Seven walls, one behind the other.
vtkSmartPointer<vtkImageData> Walls()
{
  const hasp::GridGeometry g{ { 60, 60, 60 }, glm::dvec3(-29.5), { 1, 1, 1 }, glm::dmat3(1) };
  const hasp::AnalyticVolume waves{ "waves",
    [](const glm::dvec3& p) { return std::sin(0.75 * p.y); }, 0.75 };
  return hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(waves, g, 100, 0));
}

TEST_F(ClusterOcclusion, LeavesOutWhatIsHidden)
{
  const auto image = Walls();
  GLuint primitives[2];
  for (const bool culling : { false, true })
  {
    CellTestScene scene(60, 60);
    scene.Mapper->SetInputData(image);
    scene.Mapper->SetOcclusionCulling(culling);
    scene.Look({ 0, -150, 0 }, { 0, 0, 0 }, 50, 300);
    scene.Draw(); // nothing is known yet, and the pieces from front to back help
    scene.Draw(); // all that the first frame drew is drawn first
    primitives[culling] = Primitives(scene);
  }
  // Of 14 walls, in 8 layers of clusters, the first layer hides all others from a far eye. Boxes
  // are some 6 of 130 primitives a cluster.
  EXPECT_LT(primitives[1], 0.25 * primitives[0]);
  EXPECT_GT(primitives[1], 0.1 * primitives[0]);
}

// Seen from the middle of a cluster, all its faces are out of view and its surface is in front.
TEST_F(ClusterOcclusion, TheEyeMayBeInsideABox)
{
  const auto image = Walls();
  std::size_t surface = 0;
  for (int n = 0; n < 16; ++n)
  {
    std::vector<float> depths[2];
    for (const bool culling : { false, true })
    {
      CellTestScene scene(30, 30);
      scene.Mapper->SetInputData(image);
      scene.Mapper->SetOcclusionCulling(culling);
      const glm::dvec3 eye(-1.5, -20 + 1.1 * n, -1.5);
      scene.Look(eye, eye + glm::dvec3(0, 1, 0), 0.05, 100);
      scene.Draw();
      scene.Draw();
      for (int pixel = 0; pixel < 900; ++pixel)
      {
        const auto point = scene.Point(pixel % 30, pixel / 30);
        depths[culling].push_back(point ? static_cast<float>(point->y) : 1e9F);
        surface += point.has_value();
      }
    }
    EXPECT_EQ(depths[1], depths[0]) << n;
  }
  EXPECT_GT(surface, 10000U);
}

TEST_F(ClusterOcclusion, WhatOtherActorsHideIsLeftOutToo)
{
  CellTestScene scene(60, 60);
  scene.Mapper->SetInputData(Gyroid());
  scene.Look({ 0, -120, 0 }, { 0, 0, 0 }, 10, 300);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(45);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(mapper);
  ball->SetPosition(0, -60, 0);
  scene.Renderer->RemoveActor(scene.Actor); // the ball is to be drawn first
  scene.Renderer->AddActor(ball);
  scene.Renderer->AddActor(scene.Actor);
  scene.Draw();
  scene.Draw();
  const GLuint hidden = Primitives(scene);
  ball->VisibilityOff();
  const GLuint jumped = Primitives(scene);
  scene.Draw();
  const GLuint seen = Primitives(scene);
  EXPECT_LT(hidden, 0.4 * seen);
  EXPECT_GT(jumped, 0.9 * seen);
}

TEST_F(ClusterOcclusion, IsThereOnlyWhileItIsUsed)
{
  CellTestScene scene(60, 60);
  scene.Mapper->SetInputData(Gyroid());
  scene.Look({ 0, -120, 0 }, { 0, 0, 0 }, 10, 300);
  EXPECT_EQ(CullingBytes(scene.Mapper), 0U);
  scene.Actor->GetProperty()->SetOpacity(0.5); // translucent surfaces hide nothing
  scene.Draw();
  EXPECT_EQ(CullingBytes(scene.Mapper), 0U);
  scene.Actor->GetProperty()->SetOpacity(1.0);
  scene.Draw();
  EXPECT_EQ(CullingBytes(scene.Mapper), 24 * scene.Mapper->GetCells().clusters.size());
  scene.Mapper->OcclusionCullingOff();
  scene.Draw();
  EXPECT_EQ(CullingBytes(scene.Mapper), 0U);
}

} // namespace
