// Mappers, windows and images come, go and change in every order; OpenGL is left as it was found.
#include "AttributeTestScene.h"
#include "HaspGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

vtkSmartPointer<vtkImageData> Ball(int dims, double spacing, double radius)
{
  hasp::GridGeometry g{ glm::ivec3(dims), {}, glm::dvec3(spacing), glm::dmat3(1) };
  g.origin = -0.5 * g.spacing * glm::dvec3(g.dims - 1);
  return hasp::MakeImage(
    g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, radius), g, 100, 0));
}

/// A ball of radius 8 in the middle of a window of 60 x 60, which covers it in part.
struct BallScene : CellTestScene
{
  BallScene() : CellTestScene(60, 60)
  {
    this->Mapper->SetInputData(Ball(20, 1, 8));
    this->Look({ 0, -40, 0 }, { 0, 0, 0 }, 10, 100);
  }
  bool Shows()
  {
    this->Draw();
    return this->Point(30, 30).has_value();
  }
};

hasp::ResourceUse GPUCells(vtkHaspClusteredCellMapper* mapper)
{
  hasp::ResourceList list;
  mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == "active cells, GPU")
      return use;
  ADD_FAILURE();
  return {};
}

int BuffersOf(vtkRenderWindow* window)
{
  window->MakeCurrent();
  int count = 0;
  for (GLuint name = 1; name < 1000; ++name)
    count += glIsBuffer(name);
  return count;
}

class CellLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellLives, AMapperMovesBetweenWindows)
{
  BallScene first, second;
  ASSERT_TRUE(first.Shows());
  second.Mapper = first.Mapper;
  second.Actor->SetMapper(first.Mapper); // and still in the first one
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(second.Shows()) << n;
    EXPECT_TRUE(first.Shows()) << n;
  }
}

TEST_F(CellLives, TwoWindowsOfOneMapperUploadOnceEach)
{
  BallScene first;
  auto second = std::make_unique<BallScene>();
  second->Mapper = first.Mapper;
  second->Actor->SetMapper(first.Mapper);
  ASSERT_TRUE(first.Shows());
  const auto once = GPUCells(first.Mapper);
  ASSERT_TRUE(second->Shows());
  const auto both = GPUCells(first.Mapper);
  EXPECT_EQ(both.bytes, 2 * once.bytes);
  EXPECT_GT(both.milliseconds, once.milliseconds);
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(first.Shows());
    EXPECT_TRUE(second->Shows());
    EXPECT_EQ(GPUCells(first.Mapper).milliseconds, both.milliseconds) << "something was uploaded";
  }
  first.Mapper->SetIsoValue(100); // a smaller ball, in both
  EXPECT_TRUE(first.Shows());
  EXPECT_TRUE(second->Shows());
  const auto smaller = GPUCells(first.Mapper);
  EXPECT_NE(smaller.milliseconds, both.milliseconds);
  EXPECT_LT(smaller.bytes, both.bytes);
  second.reset();
  EXPECT_EQ(GPUCells(first.Mapper).bytes, smaller.bytes / 2);
  EXPECT_TRUE(first.Shows());
}

TEST_F(CellLives, AMapperOutlivesAWindowThatForgotIt)
{
  auto first = std::make_unique<BallScene>();
  ASSERT_TRUE(first->Shows());
  const auto mapper = first->Mapper;
  first->Actor->SetMapper(nullptr); // now nothing tells the mapper that the window goes
  BallScene second;
  first.reset();
  second.Mapper = mapper;
  second.Actor->SetMapper(mapper);
  EXPECT_TRUE(second.Shows());
}

TEST_F(CellLives, AWindowThatIsClosedAndOpenedAgainForgetsNothing)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  const auto mapper = scene.Mapper;
  scene.Actor->SetMapper(nullptr);
  scene.Window->Finalize();
  scene.Draw();
  scene.Actor->SetMapper(mapper);
  EXPECT_TRUE(scene.Shows());
}

TEST_F(CellLives, ADeletedMapperFreesItsBuffers)
{
  BallScene scene;
  scene.Actor->VisibilityOff();
  scene.Draw();
  const int before = BuffersOf(scene.Window);
  scene.Actor->VisibilityOn();
  ASSERT_TRUE(scene.Shows());
  EXPECT_GT(BuffersOf(scene.Window), before);
  scene.Actor->SetMapper(nullptr);
  scene.Mapper = nullptr;
  EXPECT_EQ(BuffersOf(scene.Window), before);
}

TEST_F(CellLives, EverythingIsFreedWhoeverGoesFirst)
{
  const auto names = [](vtkRenderWindow* window)
  {
    window->MakeCurrent();
    std::array<int, 4> count{};
    for (GLuint name = 1; name < 1000; ++name)
    {
      count[0] += glIsBuffer(name);
      count[1] += glIsTexture(name);
      count[2] += glIsFramebuffer(name);
      count[3] += glIsVertexArray(name);
    }
    return count;
  };
  const auto draw = [](hasp::testing::AttributeScene& scene)
  {
    scene.Mapper->SetRenderer(
      HASP_WITH_EMBREE ? vtkHaspClusteredCellMapper::Trace : vtkHaspClusteredCellMapper::Rasterize);
    const int traced = scene.Covered();
    scene.Mapper->SetLabelArrayName("label");
    scene.Mapper->SetLabelColor(1, 1, 0, 0);
    scene.Mapper->SetScalarVisibility(true);
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectColorArray("height");
    scene.Mapper->SetBlendNormals(true);
    EXPECT_NEAR(scene.Covered(), traced, 2);
  };
  auto dying = std::make_unique<hasp::testing::AttributeScene>();
  auto mapper = dying->Mapper;
  draw(*dying);
  dying->Actor->SetMapper(nullptr); // now nothing tells the mapper that the window goes
  hasp::testing::AttributeScene scene;
  scene.Actor->VisibilityOff();
  scene.Draw();
  const auto before = names(scene.Window);
  dying.reset();
  scene.Actor->VisibilityOn();
  scene.Mapper = mapper;
  scene.Actor->SetMapper(mapper);
  draw(scene);
  EXPECT_GT(names(scene.Window), before);
  scene.Actor->SetMapper(nullptr);
  scene.Mapper = nullptr;
  mapper = nullptr;
  EXPECT_EQ(names(scene.Window), before);
}

TEST_F(CellLives, DeletingAMapperLeavesTheOtherWindowsContextCurrent)
{
  BallScene first, second;
  ASSERT_TRUE(first.Shows());
  ASSERT_TRUE(second.Shows());
  first.Actor->SetMapper(nullptr);
  first.Mapper = nullptr;
  EXPECT_TRUE(second.Window->IsCurrent());
}

TEST_F(CellLives, ImagesThatShareSamplesAreToldApart)
{
  BallScene scene;
  const auto small = Ball(20, 1, 8);
  vtkNew<vtkImageData> large;
  large->ShallowCopy(small);
  large->SetSpacing(2, 2, 2);
  large->SetOrigin(-19, -19, -19);
  small->GetPointData()->GetScalars()->Modified(); // the MTime of both
  ASSERT_EQ(small->GetMTime(), large->GetMTime());
  scene.Mapper->SetInputData(small);
  scene.Draw();
  const auto near = scene.Point(30, 30);
  scene.Mapper->SetInputData(large);
  scene.Draw();
  const auto far = scene.Point(30, 30);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(near->y, -8.0, 0.1);
  EXPECT_NEAR(far->y, -16.0, 0.2);
}

TEST_F(CellLives, ChangedInputIsSeenAndWhatIsBrokenIsAnError)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  vtkImageData* image = scene.Mapper->GetImage();
  // Other scalars: the middle is empty.
  vtkNew<vtkShortArray> nothing;
  nothing->SetNumberOfValues(image->GetNumberOfPoints());
  nothing->FillValue(-5);
  const vtkSmartPointer<vtkDataArray> ball = image->GetPointData()->GetScalars();
  image->GetPointData()->SetScalars(nothing);
  EXPECT_FALSE(scene.Shows());
  EXPECT_EQ(GPUCells(scene.Mapper).bytes, 0U);
  image->GetPointData()->SetScalars(ball);
  EXPECT_TRUE(scene.Shows());
  // An extent without samples for it: an error, not a crash.
  scene.Mapper->SetGlobalWarningDisplay(false);
  image->SetDimensions(20, 20, 4000);
  EXPECT_FALSE(scene.Shows());
  scene.Mapper->SetGlobalWarningDisplay(true);
  image->SetDimensions(20, 20, 20);
  EXPECT_TRUE(scene.Shows());
  // Single slices and single voxels have no surface, and that is no error.
  image->SetDimensions(400, 20, 1);
  EXPECT_FALSE(scene.Shows());
  EXPECT_TRUE(scene.Mapper->UpdateCells());
  scene.Mapper->SetInputData(Ball(1, 1, 8));
  EXPECT_FALSE(scene.Shows());
  EXPECT_TRUE(scene.Mapper->UpdateCells());
}

TEST_F(CellLives, MoreThanSixPlanesComeAndGo)
{
  BallScene scene;
  const auto add = [&](double nx, double ny, double at)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(nx, ny, 0);
    plane->SetOrigin(nx * at, ny * at, 0);
    scene.Mapper->AddClippingPlane(plane);
  };
  const auto depth = [&]
  {
    scene.Draw();
    const auto point = scene.Point(30, 30);
    return point ? point->y : 1e9;
  };
  EXPECT_NEAR(depth(), -8.0, 0.1);
  for (int n = 0; n < 9; ++n)
    add(std::cos(n), std::sin(n), -30); // keep everything
  EXPECT_NEAR(depth(), -8.0, 0.1);
  add(0, 1, 2); // keeps the far part: the back wall shows
  EXPECT_NEAR(depth(), 8.0, 0.1);
  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_NEAR(depth(), -8.0, 0.1);
}

TEST_F(CellLives, EachViewportShowsWhatItsOwnWindowWould)
{
  const auto pixels = [](vtkRenderWindow* window, int x, int width)
  {
    vtkNew<vtkUnsignedCharArray> rgb;
    window->GetPixelData(x, 0, x + width - 1, 59, 0, rgb);
    return std::vector<unsigned char>(
      rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  };
  BallScene alone;
  ASSERT_TRUE(alone.Shows());
  const auto truth = pixels(alone.Window, 0, 60);

  BallScene scene;
  scene.Window->SetSize(120, 60);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0, 1, 1);
  scene.Renderer->SetViewport(0, 0, 0.5, 1);
  right->SetActiveCamera(scene.Renderer->GetActiveCamera());
  right->AddActor(scene.Actor);
  scene.Window->AddRenderer(right);
  scene.Window->Render();
  EXPECT_EQ(pixels(scene.Window, 0, 60), truth);
  EXPECT_EQ(pixels(scene.Window, 60, 60), truth);
}

TEST_F(CellLives, OpenGLIsLeftAsItWasFound)
{
  const GLenum switches[] = { GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_MULTISAMPLE,
    GL_PROGRAM_POINT_SIZE, GL_SCISSOR_TEST, GL_STENCIL_TEST };
  const GLenum values[] = { GL_ACTIVE_TEXTURE, GL_ARRAY_BUFFER_BINDING, GL_BLEND_DST_ALPHA,
    GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_SRC_RGB, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
    GL_DRAW_FRAMEBUFFER_BINDING, GL_DRAW_INDIRECT_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_BINDING,
    GL_VERTEX_ARRAY_BINDING };
  const auto state = [&]
  {
    std::vector<GLint> all;
    for (const GLenum name : switches)
      all.push_back(glIsEnabled(name));
    for (const GLenum name : values)
      glGetIntegerv(name, &all.emplace_back());
    GLint colors[4];
    glGetIntegerv(GL_COLOR_WRITEMASK, colors);
    all.insert(all.end(), colors, colors + 4);
    for (GLuint slot = 0; slot < 8; ++slot)
      glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, slot, &all.emplace_back());
    return all;
  };
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetRenderFramebuffer()->Bind();
  const int renderers[] = { vtkHaspClusteredCellMapper::Rasterize,
    HASP_WITH_EMBREE ? vtkHaspClusteredCellMapper::Trace : vtkHaspClusteredCellMapper::Rasterize };
  for (const int renderer : renderers)
    for (const bool sized : { false, true })
    {
      scene.Mapper->SetRenderer(renderer);
      (sized ? glEnable : glDisable)(GL_PROGRAM_POINT_SIZE);
      const auto before = state();
      scene.Mapper->Render(scene.Renderer, scene.Actor);
      EXPECT_EQ(state(), before) << "renderer " << renderer;
      scene.Mapper->SetIsoValue(scene.Mapper->GetIsoValue() + 1); // with an upload
      scene.Mapper->Render(scene.Renderer, scene.Actor);
      EXPECT_EQ(state(), before) << "renderer " << renderer;
    }
  glDisable(GL_PROGRAM_POINT_SIZE);

  hasp::testing::AttributeScene attributes;
  attributes.Draw();
  vtkOpenGLRenderWindow::SafeDownCast(attributes.Window)->GetRenderFramebuffer()->Bind();
  const auto before = state();
  attributes.Mapper->SetLabelArrayName("label");
  attributes.Mapper->SetLabelColor(1, 1, 0, 0);
  attributes.Mapper->SetScalarVisibility(true);
  attributes.Mapper->SetScalarModeToUsePointFieldData();
  attributes.Mapper->SelectColorArray("height");
  attributes.Mapper->SetInterpolateScalarsBeforeMapping(true);
  for (const bool culled : { true, false })
    for (const bool blended : { false, true })
    {
      attributes.Mapper->SetOcclusionCulling(culled);
      attributes.Mapper->SetBlendNormals(blended);
      attributes.Mapper->Render(attributes.Renderer, attributes.Actor);
      EXPECT_EQ(state(), before) << "culled " << culled << ", blended " << blended;
    }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(CellLives, PointsDrawnAfterwardsLookAsWithoutUs)
{
  BallScene scene;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(14);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> points;
  points->SetMapper(mapper);
  points->GetProperty()->SetRepresentationToPoints();
  points->GetProperty()->SetPointSize(5);
  scene.Renderer->AddActor(points);
  scene.Mapper->SetIsoValue(700); // a ball of radius 1 in the middle, nothing elsewhere
  const auto corner = [&]
  {
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    scene.Window->GetPixelData(0, 0, 24, 59, 0, rgb);
    return std::vector<unsigned char>(
      rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  };
  const auto with = corner();
  scene.Actor->VisibilityOff();
  const auto without = corner();
  EXPECT_EQ(with, without);
  EXPECT_NE(without, std::vector<unsigned char>(without.size(), 0));
}

TEST_F(CellLives, WindowsOfNoSizeDrawNothing)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  for (const auto& [width, height] : { std::pair{ 1, 1 }, { 3, 1 }, { 0, 0 } })
  {
    scene.Window->SetSize(width, height);
    scene.Window->Render();
  }
  scene.Window->SetSize(60, 60);
  EXPECT_TRUE(scene.Shows());
}

} // namespace
