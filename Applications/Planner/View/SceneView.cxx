#include "View/SceneView.h"

#include "View/OrientationCube.h"
#include "View/SceneStyle.h"
#include "View/SliceAxis.h"
#include "View/ViewMarks.h"

#include "QVTKInteractor.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace hasp
{

namespace
{

constexpr double CubeHalf = 22.0; // pixels
constexpr double CrosshairMm = 12.0;
constexpr double KeyDegrees = 5.0;
constexpr double KeyZoom = 1.1;

/// Bone is bright and of one colour: what shows its shape is light from above the viewer's left
/// shoulder, and a weaker one from the right that keeps shadows readable. Both go with the viewer.
void AddLight(vtkRenderer* renderer, double x, double y, double z, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

double HalfAngleTangent(vtkCamera* camera)
{
  return std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
}

glm::dvec3 Row(vtkMatrix4x4* matrix, int row)
{
  return { matrix->GetElement(row, 0), matrix->GetElement(row, 1), matrix->GetElement(row, 2) };
}

} // namespace

SceneView::SceneView(QWidget* parent) : FrameView(parent)
{
  vtkNew<SceneStyle> style;
  style->SetDefaultRenderer(this->Renderer());
  style->isSecondPress = [this] { return this->IsSecondPress(); };
  this->interactor()->SetInteractorStyle(style);
  this->Renderer()->SetBackground(0.09, 0.11, 0.15);
  this->Renderer()->SetBackground2(0.27, 0.32, 0.40);
  this->Renderer()->GradientBackgroundOn();
  AddLight(this->Renderer(), -0.4, 0.6, 1.0, 0.85);
  AddLight(this->Renderer(), 0.8, -0.2, 0.6, 0.30);
}

SceneView::~SceneView() = default;

void SceneView::ResetView()
{
  this->Renderer()->ResetCamera();
  this->Draw();
}

void SceneView::SetParallel(bool parallel)
{
  if (parallel == this->IsParallel())
    return;
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  if (parallel)
    camera->SetParallelScale(camera->GetDistance() * HalfAngleTangent(camera));
  else
  {
    const double distance = camera->GetParallelScale() / HalfAngleTangent(camera);
    camera->Dolly(camera->GetDistance() / distance);
  }
  camera->SetParallelProjection(parallel);
  this->Draw();
  Q_EMIT this->ParallelChanged(parallel);
}

bool SceneView::IsParallel() const
{
  return this->Renderer()->GetActiveCamera()->GetParallelProjection() != 0;
}

void SceneView::SetCrosshair(const std::optional<glm::dvec3>& place)
{
  this->Cross = place;
  this->MarksChanged();
}

void SceneView::Prepare()
{
  this->Renderer()->ResetCameraClippingRange();
}

void SceneView::SetWireframe(bool wireframe)
{
  vtkActorCollection* actors = this->Renderer()->GetActors();
  vtkCollectionSimpleIterator next;
  actors->InitTraversal(next);
  while (vtkActor* actor = actors->GetNextActor(next))
    actor->GetProperty()->SetRepresentation(wireframe ? VTK_WIREFRAME : VTK_SURFACE);
  this->Draw();
}

/// By the depth of the last frame; nothing where that is the background's.
void SceneView::TurnAboutPointer()
{
  const double toWindow = this->effectiveDevicePixelRatio();
  const int x = static_cast<int>(this->Pointer().x() * toWindow);
  const int y = static_cast<int>((this->height() - 1 - this->Pointer().y()) * toWindow);
  const double depth = this->Renderer()->GetZ(x, y);
  if (!(depth < 1.0))
    return;
  this->Renderer()->SetDisplayPoint(x, y, depth);
  this->Renderer()->DisplayToWorld();
  double world[4];
  this->Renderer()->GetWorldPoint(world);
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  double from[3], at[3], target[3];
  camera->GetPosition(from);
  camera->GetFocalPoint(at);
  for (int axis = 0; axis < 3; ++axis)
  {
    target[axis] = world[axis] / world[3];
    from[axis] += target[axis] - at[axis];
  }
  camera->SetFocalPoint(target);
  camera->SetPosition(from);
  this->Draw();
}

void SceneView::Turn(double azimuth, double elevation)
{
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  camera->Azimuth(azimuth);
  camera->Elevation(elevation);
  camera->OrthogonalizeViewUp();
  this->Moving();
  this->Draw();
}

void SceneView::Zoom(double closer)
{
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  if (camera->GetParallelProjection())
    camera->SetParallelScale(camera->GetParallelScale() / closer);
  else
    camera->Dolly(closer);
  this->Moving();
  this->Draw();
}

void SceneView::keyPressEvent(QKeyEvent* event)
{
  if (event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier))
    return FrameView::keyPressEvent(event);
  switch (event->key())
  {
    case Qt::Key_Left:
      return this->Turn(KeyDegrees, 0.0);
    case Qt::Key_Right:
      return this->Turn(-KeyDegrees, 0.0);
    case Qt::Key_Up:
      return this->Turn(0.0, -KeyDegrees);
    case Qt::Key_Down:
      return this->Turn(0.0, KeyDegrees);
    case Qt::Key_PageUp:
      return this->Zoom(KeyZoom);
    case Qt::Key_PageDown:
      return this->Zoom(1.0 / KeyZoom);
    case Qt::Key_W:
      return this->SetWireframe(true);
    case Qt::Key_S:
      return this->SetWireframe(false);
    case Qt::Key_R:
      return this->ResetView();
    case Qt::Key_F:
      return this->TurnAboutPointer();
    case Qt::Key_5:
      return this->SetParallel(!this->IsParallel());
    default:
      FrameView::keyPressEvent(event); // the window's
  }
}

void SceneView::PaintMarks(QPainter& painter)
{
  vtkMatrix4x4* view = this->Renderer()->GetActiveCamera()->GetModelViewTransformMatrix();
  const ViewAxes axes{ Row(view, 0), Row(view, 1), Row(view, 2) };
  const double reach = 2.0 * CubeHalf;
  PaintOrientationCube(painter, axes, QPointF(reach, this->height() - reach), CubeHalf);
  if (this->Cross)
    this->PaintCrosshair(painter);
  if (this->IsParallel())
    PaintRuler(painter, this->rect(), this->MmPerPixel());
  if (this->hasFocus())
    PaintFrame(painter, this->rect(), QColor(190, 200, 215), 2.0);
}

/// A line along each axis of the patient, in the colour of the slices that it is normal to.
void SceneView::PaintCrosshair(QPainter& painter) const
{
  for (const SliceAxis axis : SliceAxes)
  {
    const SliceFrame& frame = FrameOf(axis);
    const auto from = this->PixelOf(*this->Cross - CrosshairMm * frame.next);
    const auto to = this->PixelOf(*this->Cross + CrosshairMm * frame.next);
    if (from && to)
      PaintLine(painter, *from, *to, frame.colour);
  }
}

} // namespace hasp
