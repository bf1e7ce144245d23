#ifndef HapticRenderScene_h
#define HapticRenderScene_h

// Actors, frames and listeners for tests of the render side.
#include "TouchScene.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspHeadlessWindows.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <functional>
#include <string>
#include <thread>

namespace hasp::testing
{

/// What is reported as an error meanwhile.
inline std::string ErrorsOf(vtkObject* object, const std::function<void()>& call)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* to, void* text)
    { *static_cast<std::string*>(to) += static_cast<const char*>(text); });
  const auto tag = object->AddObserver(vtkCommand::ErrorEvent, listen);
  call();
  object->RemoveObserver(tag);
  return said;
}

/// Counts an event.
class Count
{
public:
  Count(vtkObject* object, unsigned long event) : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { ++static_cast<Count*>(self)->times; });
    object->AddObserver(event, this->Command);
  }
  ~Count() { this->Object->RemoveObserver(this->Command); }
  Count(const Count&) = delete;
  Count& operator=(const Count&) = delete;
  int times = 0;

private:
  vtkSmartPointer<vtkObject> Object;
  vtkNew<vtkCallbackCommand> Command;
};

template <class Owner>
std::size_t BytesOf(Owner* owner)
{
  ResourceList list;
  owner->ListResources(list);
  std::size_t bytes = 0;
  for (const ResourceUse& use : list)
    bytes += use.bytes;
  return bytes;
}

/// A mesh; open where it does not go all the way round.
inline vtkSmartPointer<vtkActor> BallActor(
  double radius, double throughDegrees = 360.0, const glm::dvec3& at = glm::dvec3(0.0))
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(64);
  source->SetPhiResolution(48);
  source->SetEndTheta(throughDegrees);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(at.x, at.y, at.z);
  return actor;
}

/// About the origin, samples 0.5 mm apart, to 10 mm: the isosurface of -r is a ball of radius r.
/// flatter: its depth counts for so much less, and the ball of radius r is one of r / flatter high.
inline vtkSmartPointer<vtkImageData> GreyBall(double flatter = 1.0)
{
  constexpr int side = 41;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  image->SetOrigin(-10, -10, -10);
  image->SetSpacing(0.5, 0.5, 0.5);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType n = 0; n < side * side * side; ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    values->InsertNextValue(static_cast<float>(-std::hypot(p[0], p[1], flatter * p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}
inline vtkSmartPointer<vtkActor> GreyBallActor(double radius, const glm::dvec3& at)
{
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(GreyBall());
  mapper->SetIsoValue(-radius);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(at.x, at.y, at.z);
  return actor;
}

inline RigidPose Pose(vtkProp3D* prop)
{
  glm::dmat3 axes;
  RigidPose pose;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      axes[column][row] = prop->GetMatrix()->GetElement(row, column);
    pose.position[row] = prop->GetMatrix()->GetElement(row, 3);
  }
  pose.orientation = glm::normalize(glm::quat_cast(axes));
  return pose;
}
inline void Set(vtkMatrix4x4* matrix, const RigidPose& pose)
{
  const glm::dmat3 axes = glm::mat3_cast(pose.orientation);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, pose.position[row]);
  }
}

/// Frames without pictures until a WORKER is done.
inline void UpdateUntilReady(vtkHaspHapticInteractor* haptic)
{
  do
  {
    haptic->Update();
    std::this_thread::yield();
  } while (haptic->GetState() == vtkHaspHapticInteractor::Baking);
}

/// A scene whose camera looks along -z: device axes are the world's.
struct Frames
{
  Frames()
  {
    this->window->AddRenderer(this->renderer);
    this->window->SetSize(200, 200);
    this->renderer->GetActiveCamera()->SetPosition(0, 0, 100);
    this->haptic->SetRenderer(this->renderer);
    this->haptic->SetSpacing(0.6);
  }
  /// Draws nothing: what is held is where things are. Counted in ticks of the thread.
  void UntilTicks(std::uint64_t ticks)
  {
    do
    {
      this->haptic->Update();
      std::this_thread::yield();
    } while (
      this->haptic->GetLoop()->IsRunning() && this->haptic->GetLoop()->GetSnapshot().ticks < ticks);
  }

  const bool headless = hasp::UseHeadlessWindows(); ///< before the first window
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHaspHapticInteractor> haptic;
};

} // namespace hasp::testing

#endif
