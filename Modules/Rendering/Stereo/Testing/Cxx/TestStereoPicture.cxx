#include "StereoLayout.h"
#include "StereoRig.h"
#include "vtkHaspStereoPicture.h"

#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspStereoCamera.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using hasp::StereoEye;
using hasp::StereoLayout;

/// A window of 600 x 400 pixels with small unlit balls, and the picture of it.
class StereoPicture : public testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  StereoPicture()
  {
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(600, 400);
    this->window->AddRenderer(this->renderer);
    this->camera->SetPosition(40, -500, 60);
    this->camera->SetFocalPoint(0, 0, 0);
    this->camera->SetViewUp(0, 0, 1);
    this->renderer->SetActiveCamera(this->camera);
    this->picture->SetRenderer(this->renderer);
    this->picture->SetEyeAngle(8.0);
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&this->errors);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* errors, void*) { ++*static_cast<int*>(errors); });
    this->picture->AddObserver("ErrorEvent", count);
  }

  void AddBall(const glm::dvec3& center)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(center.x, center.y, center.z);
    ball->SetRadius(5.0);
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(48);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->renderer->AddActor(actor);
  }

  /// Middle of the bright pixels between two columns; pixel centres lie at half numbers.
  static glm::dvec2 Bright(vtkImageData* image, int firstColumn, int columns)
  {
    const int* dims = image->GetDimensions();
    glm::dvec2 sum(0.0);
    double count = 0.0;
    for (int y = 0; y < dims[1]; ++y)
      for (int x = 0; x < columns; ++x)
        if (image->GetScalarComponentAsDouble(firstColumn + x, y, 0, 1) > 127.0)
        {
          sum += glm::dvec2(x + 0.5, y + 0.5);
          ++count;
        }
    return sum / count;
  }

  glm::dvec2 Expected(const hasp::StereoRig& rig, StereoEye eye, const glm::dvec3& point) const
  {
    return (hasp::ProjectToScreen(rig, eye, point) + 1.0) * 0.5 * glm::dvec2(600, 400);
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkHaspStereoPicture> picture;
  int errors = 0;
};

TEST_F(StereoPicture, SaysWhyThereIsNone)
{
  this->picture->SetRenderer(nullptr);
  EXPECT_EQ(this->picture->Render(), nullptr);
  vtkNew<vtkRenderer> homeless;
  this->picture->SetRenderer(homeless);
  EXPECT_EQ(this->picture->Render(), nullptr);
  this->picture->SetRenderer(this->renderer);
  this->picture->SetRig({}); // 520 x 325 mm in a viewport of 600 x 400
  EXPECT_EQ(this->picture->Render(), nullptr);
  this->picture->ClearRig();
  this->camera->SetParallelProjection(true);
  EXPECT_EQ(this->picture->Render(), nullptr);
  EXPECT_EQ(this->errors, 4);
  vtkNew<vtkImageData> earlier;
  earlier->SetDimensions(2, 2, 1);
  EXPECT_FALSE(this->picture->RenderInto(earlier));
  EXPECT_EQ(earlier->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->errors, 5);
  this->picture->SetLayoutName("anaglyph");
  this->picture->SetLayoutName("quad");
  EXPECT_EQ(this->picture->GetLayoutName(), "anaglyph");
  EXPECT_EQ(this->errors, 6);
}

/// What shares work between the eyes reads which one is drawn; vtkRenderWindow says left to all.
TEST_F(StereoPicture, TheCameraSaysWhichEyeIsDrawn)
{
  std::vector<int> lefts;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&lefts);
  note->SetCallback(
    [](vtkObject* renderer, unsigned long, void* all, void*)
    {
      static_cast<std::vector<int>*>(all)->push_back(
        static_cast<vtkRenderer*>(renderer)->GetActiveCamera()->GetLeftEye());
    });
  this->renderer->AddObserver("EndEvent", note);
  const auto drawn = [&](StereoLayout layout)
  {
    lefts.clear();
    this->picture->SetLayout(layout);
    EXPECT_NE(this->picture->Render(), nullptr);
    return lefts;
  };
  EXPECT_EQ(drawn(StereoLayout::SideBySide), (std::vector<int>{ 1, 0 }));
  EXPECT_EQ(drawn(StereoLayout::Right), (std::vector<int>{ 0 }));
  EXPECT_EQ(drawn(StereoLayout::Left), (std::vector<int>{ 1 }));
  EXPECT_EQ(drawn(StereoLayout::Mono), (std::vector<int>{ 1 }));
  EXPECT_EQ(this->renderer->GetActiveCamera()->GetLeftEye(), 1);
}

TEST_F(StereoPicture, PointsAreWhereGeometryPutsThemInBothEyes)
{
  for (const glm::dvec3& point :
    { glm::dvec3(0, 0, 0), glm::dvec3(-60, 80, 30), glm::dvec3(50, -150, -40) })
  {
    this->renderer->RemoveAllViewProps();
    this->AddBall(point);
    const auto image = this->picture->Render();
    ASSERT_NE(image, nullptr);
    ASSERT_EQ(image->GetDimensions()[0], 1200);
    const hasp::StereoRig rig = hasp::RigFromCamera(this->camera, 1.5, 8.0);
    // Balls of 17 to 28 pixels, counted in whole pixels: the middle is known to 0.05 pixel (one
    // standard deviation); perspective moves the outline's middle by (5 mm / 350 mm)^2 of its
    // place, 0.05 pixel.
    EXPECT_LT(
      glm::length(Bright(image, 0, 600) - this->Expected(rig, StereoEye::Left, point)), 0.2);
    EXPECT_LT(
      glm::length(Bright(image, 600, 600) - this->Expected(rig, StereoEye::Right, point)), 0.2);
  }
}

TEST_F(StereoPicture, AGivenScreenWithAHeadAsideIsDrawnExactly)
{
  hasp::StereoRig rig;
  rig.screen = { { 10, 20, -5 }, { 1, 0, 0 }, { 0, 0, 1 }, 300, 200 };
  rig.head = { { 130, -480, 70 }, { 1, 0, 0.05 }, 64 };
  const glm::dvec3 point(-20, 90, 25);
  this->AddBall(point);
  this->picture->SetRig(rig);
  this->picture->SetLayout(StereoLayout::TopBottom);
  const auto image = this->picture->Render();
  ASSERT_NE(image, nullptr);
  ASSERT_EQ(image->GetDimensions()[1], 800);
  this->picture->SetLayout(StereoLayout::Right);
  const auto right = this->picture->Render();
  EXPECT_LT(glm::length(Bright(right, 0, 600) - this->Expected(rig, StereoEye::Right, point)), 0.2);
  this->picture->SetLayout(StereoLayout::Left);
  const auto left = this->picture->Render();
  EXPECT_LT(glm::length(Bright(left, 0, 600) - this->Expected(rig, StereoEye::Left, point)), 0.2);
  // The top of the picture is the left eye's.
  const std::size_t half = 3 * 600 * 400;
  const auto* both = static_cast<unsigned char*>(image->GetScalarPointer());
  EXPECT_TRUE(
    std::equal(both, both + half, static_cast<unsigned char*>(right->GetScalarPointer())));
  EXPECT_TRUE(std::equal(
    both + half, both + 2 * half, static_cast<unsigned char*>(left->GetScalarPointer())));
}

TEST_F(StereoPicture, MonoIsTheOrdinaryView)
{
  this->AddBall({ -30, 40, 20 });
  this->picture->SetLayout(StereoLayout::Mono);
  const auto mono = this->picture->Render();
  const glm::dvec2 found = Bright(mono, 0, 600);
  this->renderer->ResetCameraClippingRange();
  const vtkMatrix4x4* matrix = this->camera->GetCompositeProjectionTransformMatrix(1.5, -1, 1);
  const double in[4] = { -30, 40, 20, 1 };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix->GetData(), in, out);
  const glm::dvec2 ordinary(300 * (out[0] / out[3] + 1.0), 200 * (out[1] / out[3] + 1.0));
  EXPECT_LT(glm::length(found - ordinary), 0.2); // as above
}

TEST_F(StereoPicture, TheCameraAndTheWindowComeBackAsTheyWere)
{
  this->AddBall({ 0, 0, 0 });
  this->window->SetStereoRender(true);
  this->window->SetSwapBuffers(false);
  const vtkMTimeType before = this->camera->GetMTime();
  ASSERT_NE(this->picture->Render(), nullptr);
  EXPECT_EQ(this->renderer->GetActiveCamera(), this->camera.Get());
  EXPECT_EQ(this->camera->GetMTime(), before);
  EXPECT_TRUE(this->window->GetStereoRender());
  EXPECT_FALSE(this->window->GetSwapBuffers());
}

TEST_F(StereoPicture, MonoMakesNoSecondEye)
{
  this->AddBall({ 0, 0, 0 });
  for (const StereoLayout layout : { StereoLayout::Mono, StereoLayout::Left, StereoLayout::Right,
         StereoLayout::SideBySide, StereoLayout::TopBottom, StereoLayout::Anaglyph,
         StereoLayout::Mono }) // once more after two eyes: released
  {
    this->picture->SetLayout(layout);
    ASSERT_NE(this->picture->Render(), nullptr);
    hasp::ResourceList list;
    this->picture->ListResources(list);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].resource, "second eye");
    EXPECT_FALSE(list[0].reason.empty());
    if (hasp::NeedsSecondEye(layout))
    {
      EXPECT_EQ(list[0].bytes, 3u * 600 * 400);
      EXPECT_GT(list[0].milliseconds, 0.0);
    }
    else
    {
      EXPECT_EQ(list[0].bytes, 0u);
      EXPECT_EQ(list[0].milliseconds, 0.0);
    }
  }
}

} // namespace
