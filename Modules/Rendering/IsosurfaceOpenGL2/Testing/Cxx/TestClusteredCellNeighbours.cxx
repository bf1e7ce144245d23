// What else is in the scene: OpenGL's state, other actors, viewports, clipping planes.
#include "AttributeTestScene.h"
#include "BallScene.h"
#include "HaspGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using hasp::testing::BallScene;

class CellNeighbours : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellNeighbours, OpenGLIsLeftAsItWasFound)
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

TEST_F(CellNeighbours, PointsDrawnAfterwardsLookAsWithoutUs)
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

TEST_F(CellNeighbours, EachViewportShowsWhatItsOwnWindowWould)
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

TEST_F(CellNeighbours, MoreThanSixPlanesComeAndGo)
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

} // namespace
