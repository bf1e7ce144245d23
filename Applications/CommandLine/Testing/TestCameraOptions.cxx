#include "CameraOptions.h"
#include "Failure.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

namespace
{

using hasp::CameraOptions;

/// A patient: wider than deep, not at the origin.
class Camera : public testing::Test
{
protected:
  Camera()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(-10, 90, 0, 50, 100, 180);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
  }
  /// The camera's place relative to the middle of the patient.
  std::array<double, 3> From(const CameraOptions& options)
  {
    hasp::PlaceCamera(this->renderer, options);
    const double* p = this->renderer->GetActiveCamera()->GetPosition();
    return { p[0] - 40, p[1] - 25, p[2] - 140 };
  }
  static CameraOptions View(const char* name)
  {
    CameraOptions options;
    options.view = name;
    return options;
  }

  vtkNew<vtkRenderer> renderer;
};

TEST_F(Camera, RefusesWhatIsNoView)
{
  EXPECT_THROW(this->From(View("inside")), hasp::Failure);
  CameraOptions options;
  options.zoom = 0.0;
  EXPECT_THROW(this->From(options), hasp::Failure);
  options = {};
  options.direction = { 0, 0, 0 };
  EXPECT_THROW(this->From(options), hasp::Failure);
  options.direction = { 0, 1, 0 };
  options.viewUp = { 0, -3, 0 };
  EXPECT_THROW(this->From(options), hasp::Failure);
}

TEST_F(Camera, NamesAreThePatients)
{
  // LPS: x grows to the patient's left, y to the back, z to the head.
  EXPECT_LT(this->From(View("front"))[1], -100.0);
  EXPECT_GT(this->From(View("back"))[1], 100.0);
  EXPECT_GT(this->From(View("left"))[0], 100.0);
  EXPECT_LT(this->From(View("right"))[0], -100.0);
  EXPECT_GT(this->From(View("top"))[2], 100.0);
  EXPECT_LT(this->From(View("bottom"))[2], -100.0);
  EXPECT_DOUBLE_EQ(this->renderer->GetActiveCamera()->GetViewUp()[1], -1.0); // face upwards
}

TEST_F(Camera, TheFrontViewShowsThePatientsLeftOnTheRight)
{
  this->From(View("front"));
  const double left[3] = { 90, 25, 140 };
  vtkCamera* camera = this->renderer->GetActiveCamera();
  const double* m = camera->GetViewTransformMatrix()->GetData();
  EXPECT_GT(m[0] * left[0] + m[1] * left[1] + m[2] * left[2] + m[3], 10.0);
}

TEST_F(Camera, ADirectionAloneKeepsTheHeadUp)
{
  CameraOptions options;
  options.direction = { 1, 1, 0 };
  EXPECT_LT(this->From(options)[0], -50.0);
  EXPECT_DOUBLE_EQ(this->renderer->GetActiveCamera()->GetViewUp()[2], 1.0);
  options.direction = { 0, 0, -2 };
  EXPECT_GT(this->From(options)[2], 100.0);
  EXPECT_DOUBLE_EQ(this->renderer->GetActiveCamera()->GetViewUp()[1], -1.0);
}

} // namespace
