#include "StereoRig.h"
#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using hasp::StereoEye;
using hasp::StereoRig;

// A turned, off-centre screen in patient space and a head that is neither centred nor level.
StereoRig SkewRig(double separation = 63.0)
{
  const glm::dvec3 right = glm::normalize(glm::dvec3(0.6, 0.8, 0.1));
  const glm::dvec3 up = glm::normalize(glm::cross(glm::dvec3(0.3, -0.2, 0.9), right));
  const glm::dvec3 normal = glm::cross(right, up);
  StereoRig rig;
  rig.screen = { { 12, -40, 300 }, 2.0 * right, 0.5 * up, 480, 270 };
  rig.head = { rig.screen.center + 610.0 * normal + 140.0 * right - 75.0 * up,
    right + 0.1 * up + 0.05 * normal, separation };
  return rig;
}

glm::dvec3 PointAt(const StereoRig& rig, double x, double y, double towardsViewer)
{
  const glm::dvec3 right = glm::normalize(rig.screen.right);
  const glm::dvec3 up = glm::normalize(rig.screen.up);
  return rig.screen.center + x * right + y * up + towardsViewer * glm::cross(right, up);
}

// The textbook: an off-axis frustum as glFrustum has it, from the eye and the screen's corners.
glm::dvec2 Textbook(const StereoRig& rig, StereoEye eye, const glm::dvec3& point)
{
  const glm::dvec3 r = glm::normalize(rig.screen.right), u = glm::normalize(rig.screen.up);
  const glm::dvec3 n = glm::cross(r, u);
  const glm::dvec3 e = hasp::EyePosition(rig.head, eye);
  const glm::dvec3 lowerLeft =
    rig.screen.center - 0.5 * rig.screen.widthMm * r - 0.5 * rig.screen.heightMm * u;
  const glm::dvec3 upperRight =
    rig.screen.center + 0.5 * rig.screen.widthMm * r + 0.5 * rig.screen.heightMm * u;
  const double d = glm::dot(e - lowerLeft, n), near = 10, far = 5000;
  const glm::dmat4 projection =
    glm::frustum(glm::dot(r, lowerLeft - e) * near / d, glm::dot(r, upperRight - e) * near / d,
      glm::dot(u, lowerLeft - e) * near / d, glm::dot(u, upperRight - e) * near / d, near, far);
  const glm::dvec3 p = point - e;
  const glm::dvec4 clip =
    projection * glm::dvec4(glm::dot(r, p), glm::dot(u, p), glm::dot(n, p), 1.0);
  return glm::dvec2(clip) / clip.w;
}

glm::dvec2 ThroughCamera(const StereoRig& rig, StereoEye eye, const glm::dvec3& point)
{
  vtkNew<vtkCamera> camera;
  hasp::SetCameraToEye(camera, rig, eye);
  camera->SetClippingRange(10, 5000);
  const vtkMatrix4x4* matrix =
    camera->GetCompositeProjectionTransformMatrix(rig.screen.widthMm / rig.screen.heightMm, -1, 1);
  const double in[4] = { point.x, point.y, point.z, 1 };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix->GetData(), in, out);
  return { out[0] / out[3], out[1] / out[3] };
}

// 1e-4 pixel on a screen of 4000 pixels is 5e-8 of the range [-1,1]. vtkCamera goes through
// degrees and a near plane at 1/60 of the distance, so 1e-9 is what doubles leave.
constexpr double Tolerance = 5e-8;

void ExpectTextbook(const StereoRig& rig)
{
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
    for (const double x : { -200.0, 0.0, 230.0 })
      for (const double y : { -130.0, 0.0, 90.0 })
        for (const double depth : { -400.0, 0.0, 250.0 })
        {
          const glm::dvec3 point = PointAt(rig, x, y, depth);
          const glm::dvec2 truth = Textbook(rig, eye, point);
          const double scale =
            std::max(1.0, glm::length(truth)); // huge separations leave the screen
          EXPECT_LT(glm::length(ThroughCamera(rig, eye, point) - truth) / scale, Tolerance);
          EXPECT_LT(glm::length(hasp::ProjectToScreen(rig, eye, point) - truth) / scale, Tolerance);
        }
}

TEST(StereoRig, RefusesWhatHasNoViewer)
{
  StereoRig rig;
  EXPECT_NO_THROW(hasp::ValidateStereoRig(rig));
  for (const double bad : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    StereoRig broken = rig;
    broken.screen.widthMm = bad;
    EXPECT_THROW(hasp::ValidateStereoRig(broken), std::invalid_argument) << bad;
    broken = rig;
    broken.screen.heightMm = bad;
    EXPECT_THROW(hasp::ValidateStereoRig(broken), std::invalid_argument) << bad;
    broken = rig;
    broken.head.position.z = bad < 1e9 ? bad : -bad; // on, behind or nowhere near the screen
    EXPECT_THROW(hasp::ViewOfEye(broken, StereoEye::Left), std::invalid_argument) << bad;
  }
  StereoRig skewed = rig;
  skewed.screen.up = { 0.1, 1, 0 };
  EXPECT_THROW(hasp::ValidateStereoRig(skewed), std::invalid_argument);
  StereoRig swapped = rig;
  swapped.head.eyeSeparationMm = -1;
  EXPECT_THROW(hasp::ValidateStereoRig(swapped), std::invalid_argument);
  StereoRig sideways = rig; // one eye through the screen
  sideways.head.right = { 0, 0, 1 };
  sideways.head.eyeSeparationMm = 1300;
  EXPECT_THROW(hasp::ValidateStereoRig(sideways), std::invalid_argument);
  EXPECT_THROW(hasp::ProjectToScreen(rig, StereoEye::Left, { 0, 0, 600 }), std::invalid_argument);
}

TEST(StereoRig, TheCameraIsTheTextbooksFrustum)
{
  ExpectTextbook(StereoRig{});
  ExpectTextbook(SkewRig());
}

TEST(StereoRig, TinyAndHugeSeparationsAreExactToo)
{
  for (const double separation : { 0.0, 1e-9, 1e-3, 500.0, 1e4 })
  {
    SCOPED_TRACE(separation);
    ExpectTextbook(SkewRig(separation));
  }
  const StereoRig none = SkewRig(0.0);
  const glm::dvec3 point = PointAt(none, 10, 20, -30);
  EXPECT_EQ(hasp::ScreenDisparityMm(none, point), 0.0);
}

TEST(StereoRig, DisparityIsTheTextbooks)
{
  StereoRig rig = SkewRig();
  rig.head.right = rig.screen.right;         // parallel to the screen: the formula's case
  for (const double offset : { 0.0, 400.0 }) // a head moved aside changes no disparity
  {
    rig.head.position += offset * glm::normalize(rig.screen.right);
    for (const double depth : { -300.0, -1.0, 0.0, 5.0, 1000.0 })
    {
      const double expected = 63.0 * depth / (610.0 + depth);
      EXPECT_NEAR(hasp::ScreenDisparityMm(rig, PointAt(rig, -17, 8, -depth)), expected, 1e-9);
    }
  }
}

TEST(StereoRig, PointsOfTheScreenStayPutForEveryEye)
{
  const StereoRig rig = SkewRig();
  for (const StereoEye eye : { StereoEye::Left, StereoEye::Right })
  {
    const glm::dvec2 corner = ThroughCamera(rig, eye, PointAt(rig, 240, -135, 0));
    EXPECT_LT(glm::length(corner - glm::dvec2(1, -1)), Tolerance);
  }
  EXPECT_NEAR(hasp::ScreenDisparityMm(rig, PointAt(rig, 100, -50, 0)), 0.0, 1e-9);
}

TEST(StereoRig, TheEyeIsTheCamerasPosition)
{
  const StereoRig rig = SkewRig();
  vtkNew<vtkCamera> camera;
  hasp::SetCameraToEye(camera, rig, StereoEye::Right);
  glm::dvec3 position;
  camera->GetPosition(&position.x);
  EXPECT_EQ(position, hasp::EyePosition(rig.head, StereoEye::Right));
  // What volume mappers do: the inverse of the model-view must lead to the same place.
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(camera->GetModelViewTransformMatrix(), inverse);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(inverse->GetElement(axis, 3), position[axis], 1e-9);
}

TEST(StereoRig, AnEyeTooNearForVtksCameraIsRefused)
{
  StereoRig rig;
  rig.head.eyeSeparationMm = 0.0;
  vtkNew<vtkCamera> camera;
  rig.head.position.z = 1.5; // 2 atan(162.5 / 1.5) = 178.94 degrees
  hasp::SetCameraToEye(camera, rig, StereoEye::Left);
  EXPECT_EQ(camera->GetViewAngle(), hasp::ViewOfEye(rig, StereoEye::Left).viewAngleDegrees);
  rig.head.position.z = 0.5; // 179.65
  EXPECT_THROW(hasp::SetCameraToEye(camera, rig, StereoEye::Left), std::invalid_argument);
  EXPECT_EQ(camera->GetPosition()[2], 1.5); // untouched
}

TEST(StereoRig, WorldAndRoomSeeTheSame)
{
  const StereoRig room = SkewRig();
  const glm::dmat4 map = glm::scale(
    glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(5, -7, 90)), 1.1, glm::dvec3(1, 2, -1)),
    glm::dvec3(0.25));
  const StereoRig world = hasp::TransformStereoRig(room, map);
  const glm::dvec3 point = PointAt(room, 30, -60, -90);
  const glm::dvec3 mapped = map * glm::dvec4(point, 1.0);
  EXPECT_LT(glm::length(hasp::ProjectToScreen(world, StereoEye::Left, mapped) -
                        hasp::ProjectToScreen(room, StereoEye::Left, point)),
    1e-12);
  EXPECT_NEAR(world.head.eyeSeparationMm, 0.25 * 63.0, 1e-12);
  EXPECT_THROW(
    hasp::TransformStereoRig(room, glm::scale(map, glm::dvec3(1, 1, 2))), std::invalid_argument);
  EXPECT_THROW(
    hasp::TransformStereoRig(room, glm::scale(map, glm::dvec3(1, 1, -1))), std::invalid_argument);
  EXPECT_THROW(
    hasp::TransformStereoRig(room, glm::transpose(glm::translate(glm::dmat4(1.0), { 5, 0, 0 }))),
    std::invalid_argument);
  glm::dmat4 broken = map;
  broken[0][3] = NAN;
  EXPECT_THROW(hasp::TransformStereoRig(room, broken), std::invalid_argument);
}

TEST(StereoRig, AnOrdinaryCameraComesBackFromItsRig)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(10, 200, -30);
  camera->SetFocalPoint(-5, 3, 12);
  camera->SetViewUp(0.2, 0.1, 1);
  camera->SetViewAngle(22);
  camera->SetWindowCenter(0.3, -0.2);
  camera->SetClippingRange(10, 5000);
  for (const bool horizontal : { false, true })
  {
    camera->SetUseHorizontalViewAngle(horizontal);
    StereoRig rig = hasp::RigFromCamera(camera, 1.5, 2.0);
    EXPECT_NEAR(rig.head.eyeSeparationMm,
      2.0 * camera->GetDistance() * std::tan(1.0 / 180.0 * 3.14159265358979), 1e-9);
    EXPECT_NEAR(hasp::ScreenDisparityMm(rig, { -5, 3, 12 }), 0.0, 1e-9);
    rig.head.eyeSeparationMm = 0.0;
    vtkNew<vtkCamera> again;
    hasp::SetCameraToEye(again, rig, StereoEye::Left);
    again->SetClippingRange(10, 5000);
    const vtkMatrix4x4* wanted = camera->GetCompositeProjectionTransformMatrix(1.5, -1, 1);
    const vtkMatrix4x4* got = again->GetCompositeProjectionTransformMatrix(1.5, -1, 1);
    for (int k = 0; k < 16; ++k) // entries up to a few hundred
      EXPECT_NEAR(got->GetData()[k], wanted->GetData()[k], 1e-9) << k;
  }
}

TEST(StereoRig, CamerasWithoutAnEyeAreRefused)
{
  vtkNew<vtkCamera> camera;
  EXPECT_THROW(hasp::RigFromCamera(camera, 0.0, 2.0), std::invalid_argument);
  EXPECT_THROW(hasp::RigFromCamera(camera, 1.0, -1.0), std::invalid_argument);
  EXPECT_THROW(hasp::RigFromCamera(camera, 1.0, 91.0), std::invalid_argument);
  camera->SetViewUp(0, 0, 1); // along the view
  EXPECT_THROW(hasp::RigFromCamera(camera, 1.0, 2.0), std::invalid_argument);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewShear(0.1, 0, 1);
  EXPECT_THROW(hasp::RigFromCamera(camera, 1.0, 2.0), std::invalid_argument);
  camera->SetViewShear(0, 0, 1);
  camera->SetParallelProjection(true);
  EXPECT_THROW(hasp::RigFromCamera(camera, 1.0, 2.0), std::invalid_argument);
}

} // namespace
