#include "CameraPaths.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace hasp
{
namespace
{

glm::dvec3 Turned(const glm::dvec3& v, double radians, const glm::dvec3& axis)
{
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), radians, axis) * glm::dvec4(v, 0.0));
}

} // namespace

CameraPath::CameraPath(IsosurfaceView& view)
  : View(view),
    Position(glm::make_vec3(view.camera->GetPosition())),
    Focus(glm::make_vec3(view.camera->GetFocalPoint())),
    Up(glm::make_vec3(view.camera->GetViewUp()))
{
}

void CameraPath::Place(const glm::dvec3& position, const glm::dvec3& focus)
{
  vtkCamera* camera = this->View.camera;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(this->Up.x, this->Up.y, this->Up.z);
  vtkNew<vtkRenderer> fit; // only to place near and far plane
  fit->SetActiveCamera(camera);
  fit->ResetCameraClippingRange(this->View.image->GetBounds());
  this->View.CameraMoved();
}

void CameraPath::Orbit(int frame, double degrees)
{
  this->Place(
    this->Focus + Turned(this->Position - this->Focus, glm::radians(degrees * frame), this->Up),
    this->Focus);
}

void CameraPath::Fly(int frame, int frames, const glm::dvec3& target, double nearest)
{
  const glm::dvec3 way = this->Position - target;
  const double left = nearest / glm::length(way);
  this->Place(target + way * std::pow(left, double(frame) / frames), target);
}

void CameraPath::Jitter(int frame)
{
  const auto wave = [frame](double period, double phase)
  { return std::sin(2.0 * 3.14159265358979 * (frame / period + phase)); };
  const glm::dvec3 ahead = this->Focus - this->Position;
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, this->Up));
  const glm::dvec3 shift =
    5.0 / std::sqrt(3.0) * glm::dvec3(wave(23, 0.0), wave(31, 0.3), wave(41, 0.6));
  const glm::dvec3 looking = Turned(
    Turned(ahead, glm::radians(3.0 / std::sqrt(2.0)) * wave(29, 0.1), glm::normalize(this->Up)),
    glm::radians(3.0 / std::sqrt(2.0)) * wave(37, 0.8), right);
  this->Place(this->Position + shift, this->Position + shift + looking);
}

void CameraPath::ShiftPixels(double x, double y)
{
  this->View.camera->SetWindowCenter(2.0 * x / this->View.width, 2.0 * y / this->View.height);
  this->View.CameraMoved();
}

} // namespace hasp
