#include "StereoHmd.h"
#include "StereoWindow.h"
#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{

using hasp::StereoEye;

/// Tangents as those of a common display: wider to the outside, and downwards.
const hasp::StereoHmd Display{ { hasp::FieldOfView{ 1.25, 1.05, 1.1, 1.3 },
  hasp::FieldOfView{ 1.05, 1.25, 1.1, 1.3 } } };

/// Tilted, turned and aside.
hasp::StereoHead Tilted()
{
  const glm::dvec3 right = glm::normalize(glm::dvec3(0.9, 0.2, -0.3));
  return { { 30, -50, 400 }, 2.0 * right, 61.0, glm::cross(glm::dvec3(0.1, 0.1, 1), right) };
}

/// The textbook: glFrustum with these tangents, for an eye beside the head.
glm::dvec2 Textbook(const hasp::StereoHead& head, StereoEye eye, const glm::dvec3& point)
{
  const hasp::FieldOfView& f = Display.fields[eye == StereoEye::Right];
  const glm::dvec3 x = glm::normalize(head.right), y = glm::normalize(head.up);
  const glm::dvec3 off = point - hasp::EyePosition(head, eye);
  const glm::dvec4 clip =
    glm::frustum(-f.left, f.right, -f.down, f.up, 1.0, 5000.0) *
    glm::dvec4(glm::dot(x, off), glm::dot(y, off), glm::dot(glm::cross(x, y), off), 1.0);
  return glm::dvec2(clip) / clip.w;
}

glm::dvec2 ThroughCamera(
  const hasp::EyeView& view, StereoEye eye, const hasp::EyeGrid& grid, const glm::dvec3& point)
{
  vtkNew<vtkCamera> camera;
  camera->SetUseExplicitProjectionTransformMatrix(true); // would be all that counts
  camera->SetExplicitAspectRatio(7.0);
  camera->SetUseExplicitAspectRatio(true);
  hasp::SetCameraToView(camera, view, eye, grid);
  camera->SetClippingRange(1, 5000);
  const double aspect = static_cast<double>(grid.size.x) / grid.size.y;
  const vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  const double in[4] = { point.x, point.y, point.z, 1 };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix->GetData(), in, out);
  return { out[0] / out[3], out[1] / out[3] };
}

TEST(StereoHmd, RefusesWhatIsNoDisplay)
{
  for (const double bad : { std::nan(""), -1.25, HUGE_VAL })
  {
    hasp::StereoHmd broken = Display;
    broken.fields[0].left = broken.fields[0].right = bad;
    EXPECT_THROW(hasp::ViewOfHmdEye(broken, {}, StereoEye::Left), std::invalid_argument);
  }
  hasp::StereoHead head;
  head.up = { 0.1, 1, 0 };
  EXPECT_THROW(hasp::ViewOfHmdEye(Display, head, StereoEye::Left), std::invalid_argument);
  head = {};
  head.position.y = NAN;
  EXPECT_THROW(hasp::ViewOfHmdEye(Display, head, StereoEye::Left), std::invalid_argument);
  head = {};
  head.eyeSeparationMm = -1.0;
  EXPECT_THROW(hasp::ViewOfHmdEye(Display, head, StereoEye::Left), std::invalid_argument);
}

TEST(StereoHmd, TheCameraIsTheTextbooksFrustumInPixelsOfAnyShape)
{
  const hasp::StereoHead head = Tilted();
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
    for (const glm::ivec2 size : { glm::ivec2(1080, 1200), glm::ivec2(500, 100) })
      for (const double x : { -300.0, 0.0, 120.0 })
      {
        const glm::dvec3 point(x, 40, -150);
        const hasp::EyeView view = hasp::ViewOfHmdEye(Display, head, eye);
        const glm::dvec2 truth = Textbook(head, eye, point);
        EXPECT_LT(glm::length(ThroughCamera(view, eye, { size }, point) - truth), 5e-8);
        // A grid that is shifted and scaled is that much beside it.
        const hasp::EyeGrid grid{ size, { 0.8, 1.25 }, { -0.1, 0.05 } };
        EXPECT_LT(
          glm::length(ThroughCamera(view, eye, grid, point) - (grid.scale * truth + grid.shift)),
          5e-8);
        // And a pixel's ray goes back through the point.
        const glm::dvec3 along = hasp::PointOnScreen(view, truth) - view.position;
        EXPECT_LT(
          glm::length(glm::cross(glm::normalize(along), glm::normalize(point - view.position))),
          1e-12);
      }
}

TEST(StereoHmd, EyesAreParallelAndLevel)
{
  // tangent = (x +- 31.5) / depth, and device x = (2 tangent + left - right) / (left + right).
  const auto seen = [](StereoEye eye, const glm::dvec3& point) {
    return ThroughCamera(hasp::ViewOfHmdEye(Display, {}, eye), eye, { { 1080, 1200 } }, point);
  };
  for (const double depth : { 500.0, 2000.0, 1e7 })
  {
    const glm::dvec3 point(10, 20, 600 - depth);
    const glm::dvec2 left = seen(StereoEye::Left, point), right = seen(StereoEye::Right, point);
    EXPECT_NEAR(left.x, (2 * (10 + 31.5) / depth + 1.25 - 1.05) / 2.3, 1e-9);
    EXPECT_NEAR(right.x, (2 * (10 - 31.5) / depth + 1.05 - 1.25) / 2.3, 1e-9);
    EXPECT_NEAR(left.y, right.y, 1e-12);
  }
}

TEST(StereoWindow, RefusesTwoKindsAtOnceAndLensesThatFold)
{
  hasp::StereoWindow window;
  EXPECT_NO_THROW(hasp::ValidateStereoWindow(window));
  EXPECT_THROW(hasp::ViewsOfEyes(window, {}, glm::dmat4(1.0)), std::invalid_argument);
  window.hmd = Display;
  EXPECT_NO_THROW(hasp::ValidateStereoWindow(window));
  window.lens = hasp::LensModel{ { -0.5, 0, 0 } };
  EXPECT_THROW(hasp::ValidateStereoWindow(window), std::invalid_argument);
  window.lens.reset();
  window.screen.emplace();
  EXPECT_THROW(hasp::ValidateStereoWindow(window), std::invalid_argument);
  window.hmd.reset();
  window.screen->heightMm = 0.0;
  EXPECT_THROW(hasp::ValidateStereoWindow(window), std::invalid_argument);
}

TEST(StereoWindow, ARoomStandsOnTheScreenOfACamera)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(40, -500, 60);
  camera->SetFocalPoint(0, 0, 10);
  camera->SetViewUp(0, 0, 1);
  hasp::StereoRig room;
  room.screen = { { 100, 0, -20 }, { 0.8, 0, 0.6 }, { 0, 3, 0 }, 400, 250 };
  room.head.position = room.screen.center + glm::dvec3(-360, 0, 480); // 600 mm before its middle
  const hasp::StereoRig world = hasp::RigOnScreen(camera, room);
  EXPECT_LT(glm::length(world.screen.center - glm::dvec3(0, 0, 10)), 1e-10);
  const double height = 2.0 * camera->GetDistance() * std::tan(15.0 / 180.0 * M_PI);
  EXPECT_NEAR(world.screen.heightMm, height, 1e-9);
  EXPECT_NEAR(world.head.eyeSeparationMm, 63.0 * height / 250.0, 1e-9);
  // The head is on the camera's axis, and the screen faces it.
  glm::dvec3 position;
  camera->GetPosition(&position.x);
  const glm::dvec3 axis = glm::normalize(position - world.screen.center);
  EXPECT_LT(
    glm::length(world.head.position - world.screen.center - axis * 600.0 * height / 250.0), 1e-9);
  hasp::ShowLifeSize(camera, room.screen);
  EXPECT_NEAR(hasp::RigOnScreen(camera, room).head.eyeSeparationMm, 63.0, 1e-9);
  camera->GetPosition(&position.x);
  EXPECT_LT(glm::length(glm::normalize(position - glm::dvec3(0, 0, 10)) - axis), 1e-12);
  camera->SetUseHorizontalViewAngle(true);
  EXPECT_NEAR(hasp::RigOnScreen(camera, room).screen.widthMm,
    2.0 * camera->GetDistance() * std::tan(15.0 / 180.0 * M_PI), 1e-9);
  camera->SetParallelProjection(true);
  EXPECT_THROW(hasp::RigOnScreen(camera, room), std::invalid_argument);
  camera->SetParallelProjection(false);
  camera->SetUseExplicitProjectionTransformMatrix(true);
  EXPECT_THROW(hasp::RigOnScreen(camera, room), std::invalid_argument);
  camera->SetUseExplicitProjectionTransformMatrix(false);
  camera->SetUseExplicitAspectRatio(true);
  EXPECT_THROW(hasp::RigOnScreen(camera, room), std::invalid_argument);
  camera->SetUseExplicitAspectRatio(false);
  room.screen.widthMm = -1.0;
  EXPECT_THROW(hasp::RigOnScreen(camera, room), std::invalid_argument);
  EXPECT_THROW(hasp::ShowLifeSize(camera, room.screen), std::invalid_argument);
}

} // namespace
