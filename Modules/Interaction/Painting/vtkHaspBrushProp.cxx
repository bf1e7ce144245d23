#include "vtkHaspBrushProp.h"

#include "Grid/Stopwatch.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

vtkStandardNewMacro(vtkHaspBrushProp);

namespace
{

constexpr int RingSides = 96;
constexpr double RingPixels = 2.0; // at 72 dpi
constexpr double BallOpacity = 0.35;

/// Of the eye that the camera is drawing for: its composite matrix leaves stereo out.
glm::dmat4 WorldToClip(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> clip;
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1),
    camera->GetModelViewTransformMatrix(), clip);
  return glm::transpose(glm::make_mat4(clip->GetData()));
}

/// Of two, the left one's; of one, that.
bool IsLookedThrough(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const bool rightAlone = window->GetStereoRender() && window->GetStereoType() == VTK_STEREO_RIGHT;
  return rightAlone || renderer->GetActiveCamera()->GetLeftEye() != 0;
}

} // namespace

vtkHaspBrushProp::vtkHaspBrushProp()
{
  this->PickableOff();
  this->DragableOff();
  this->UseBoundsOff();
}

vtkHaspBrushProp::~vtkHaspBrushProp() = default;

hasp::SeenDepth vtkHaspBrushProp::ViewOf(vtkRenderer* renderer)
{
  hasp::SeenDepth view;
  renderer->GetTiledSizeAndOrigin(&view.size.x, &view.size.y, &view.origin.x, &view.origin.y);
  // After a frame of two eyes the camera stands for the right one.
  const bool other = !IsLookedThrough(renderer);
  if (other)
    renderer->GetActiveCamera()->SetLeftEye(1);
  view.clipToWorld = glm::inverse(WorldToClip(renderer));
  if (other)
    renderer->GetActiveCamera()->SetLeftEye(0);
  return view;
}

void vtkHaspBrushProp::Forget()
{
  this->Fresh = false;
  this->Seen = {};
  this->Milliseconds = 0.0;
}

bool vtkHaspBrushProp::SetBrush(const std::optional<Brush>& brush)
{
  if (brush == this->Shown)
    return false;
  this->Shown = brush;
  this->Modified();
  return true;
}

int vtkHaspBrushProp::RenderOpaqueGeometry(vtkViewport*)
{
  this->Taken = false; // a frame begins
  return 0;
}

int vtkHaspBrushProp::RenderVolumetricGeometry(vtkViewport* viewport)
{
  this->TakeDepth(viewport);
  return 0;
}

void vtkHaspBrushProp::TakeDepth(vtkViewport* viewport)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer == nullptr || renderer->GetSelector() != nullptr || !IsLookedThrough(renderer) ||
      std::exchange(this->Taken, true))
    return;
  if (!this->Look)
    return this->Forget();
  hasp::SeenDepth seen = ViewOf(renderer);
  if (this->Keep && this->Fresh && seen.origin == this->Seen.origin &&
      seen.size == this->Seen.size && seen.clipToWorld == this->Seen.clipToWorld)
    return;
  const hasp::Stopwatch watch;
  seen.depths = std::move(this->Seen.depths);
  seen.depths.resize(std::size_t(std::max(seen.size.x, 0)) * std::max(seen.size.y, 0));
  this->Seen = std::move(seen);
  const glm::ivec2 first = this->Seen.origin, last = first + this->Seen.size - 1;
  this->Fresh =
    !this->Seen.depths.empty() && renderer->GetRenderWindow()->GetZbufferData(first.x, first.y,
                                    last.x, last.y, this->Seen.depths.data()) != VTK_ERROR;
  this->Milliseconds = watch.Milliseconds();
}

int vtkHaspBrushProp::RenderOverlay(vtkViewport* viewport)
{
  this->TakeDepth(viewport); // where nobody has asked for volumes
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer == nullptr || renderer->GetSelector() != nullptr || !this->Shown)
    return 0;
  if (this->Shown->ball)
    this->DrawBall(viewport);
  this->DrawRing(renderer);
  return 1;
}

void vtkHaspBrushProp::DrawBall(vtkViewport* viewport)
{
  if (!this->Ball)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0, 0, 0);
    vtkNew<vtkCellArray> verts;
    verts->InsertNextCell({ 0 });
    vtkNew<vtkPolyData> point;
    point->SetPoints(points);
    point->SetVerts(verts);
    this->BallMapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
    this->BallMapper->SetInputData(point);
    this->Ball = vtkSmartPointer<vtkActor>::New();
    this->Ball->SetMapper(this->BallMapper);
    this->Ball->GetProperty()->SetOpacity(BallOpacity);
  }
  this->BallMapper->SetRadius(static_cast<float>(this->Shown->radiusMm));
  this->Ball->SetPosition(&this->Shown->world.x);
  this->Ball->GetProperty()->SetColor(&this->Shown->colour.x);
  this->Ball->RenderTranslucentPolygonalGeometry(viewport);
}

void vtkHaspBrushProp::DrawRing(vtkRenderer* renderer)
{
  if (!this->Ring)
  {
    this->RingPoints = vtkSmartPointer<vtkPoints>::New();
    this->RingPoints->SetNumberOfPoints(RingSides);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(RingSides + 1);
    for (int n = 0; n <= RingSides; ++n)
      lines->InsertCellPoint(n % RingSides);
    vtkNew<vtkPolyData> ring;
    ring->SetPoints(this->RingPoints);
    ring->SetLines(lines);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(ring);
    this->Ring = vtkSmartPointer<vtkActor2D>::New();
    this->Ring->SetMapper(mapper);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 normal;
  camera->GetDirectionOfProjection(&normal.x);
  normal = this->Shown->normal.value_or(normal);
  const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, helper)), v = glm::cross(normal, u);
  const glm::dmat4 worldToClip = WorldToClip(renderer);
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int n = 0; n < RingSides; ++n)
  {
    const double angle = 2.0 * std::numbers::pi * n / RingSides;
    const glm::dvec3 point =
      this->Shown->world + this->Shown->radiusMm * (std::cos(angle) * u + std::sin(angle) * v);
    const glm::dvec4 clip = worldToClip * glm::dvec4(point, 1.0);
    if (!(clip.w > 0.0))
      return; // it reaches behind the eye: there is no ring to be seen whole
    this->RingPoints->SetPoint(
      n, 0.5 * (clip.x / clip.w + 1.0) * size[0], 0.5 * (clip.y / clip.w + 1.0) * size[1], 0.0);
  }
  this->RingPoints->Modified();
  const double scale = std::max(1.0, renderer->GetRenderWindow()->GetDPI() / 72.0);
  this->Ring->GetProperty()->SetLineWidth(static_cast<float>(RingPixels * scale));
  this->Ring->GetProperty()->SetColor(&this->Shown->colour.x);
  this->Ring->RenderOverlay(renderer);
}

void vtkHaspBrushProp::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Ring)
    this->Ring->ReleaseGraphicsResources(window);
  if (this->Ball)
    this->Ball->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkHaspBrushProp::ListResources(hasp::ResourceList& resources) const
{
  resources.push_back({ "painting depth", this->Seen.depths.capacity() * sizeof(float),
    this->Milliseconds, this->Look ? "painting" : "nobody paints on a surface" });
}
