#include "BorrowedView.h"
#include "DrawnEye.h"

#include "vtkHaspStereoCamera.h"
#include "vtkHaspStereoPair.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkHomogeneousTransform.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <list>
#include <stdexcept>

BorrowedView::BorrowedView(vtkRenderer* r, vtkCamera* of)
  : renderer(r),
    window(r->GetRenderWindow()),
    camera(r->GetActiveCamera()),
    settings(of),
    stereo(window->GetStereoRender()),
    swapBuffers(window->GetSwapBuffers())
{
  this->eyeCamera->DeepCopy(of);
  vtkNew<vtkInformation> information; // the pair is not the scene's camera's
  information->Copy(of->GetInformation());
  this->eyeCamera->SetInformation(information);
  r->GetTiledSizeAndOrigin(&this->size.x, &this->size.y, &this->origin.x, &this->origin.y);
  glm::dvec4 own;
  r->GetViewport(&own.x);
  vtkCollectionSimpleIterator at;
  vtkRendererCollection* renderers = this->window->GetRenderers();
  renderers->InitTraversal(at);
  while (vtkRenderer* other = renderers->GetNextRenderer(at))
  {
    glm::dvec4 viewport;
    other->GetViewport(&viewport.x);
    if (viewport.x >= own.x && viewport.y >= own.y && viewport.z <= own.z && viewport.w <= own.w)
      this->kept.push_back({ other, viewport });
    const bool shares =
      viewport == own && other->IsActiveCameraCreated() && other->GetActiveCamera() == this->camera;
    if (other == r || shares)
      this->throughEye.emplace_back(other);
  }
  for (vtkRenderer* one : this->throughEye)
    one->SetActiveCamera(this->eyeCamera);
  this->window->SetStereoRender(false);
  this->window->SetSwapBuffers(false); // a visible window does not flicker between the eyes
}

BorrowedView::~BorrowedView()
{
  this->ShowFrames();
  for (vtkRenderer* one : this->throughEye)
    one->SetActiveCamera(this->camera);
  this->window->SetStereoRender(this->stereo);
}

void BorrowedView::ShowFrames()
{
  for (const Kept& one : this->kept)
    one.renderer->SetViewport(
      one.viewport.x, one.viewport.y, one.viewport.z, one.viewport.w); // nothing if it is the same
  this->window->SetSwapBuffers(this->swapBuffers);
}

void BorrowedView::SetViewports(glm::ivec2 pixels)
{
  const int* windowSize = this->window->GetSize();
  const glm::dvec2 whole(windowSize[0], windowSize[1]);
  const glm::dvec2 low = glm::dvec2(this->origin) / whole;
  const glm::dvec2 squeeze = glm::dvec2(pixels) / glm::dvec2(this->size);
  const auto map = [&](const glm::dvec2& point) { return low + (point - low) * squeeze; };
  for (const Kept& one : this->kept)
  {
    const glm::dvec2 from = map({ one.viewport.x, one.viewport.y });
    glm::dvec2 to = map({ one.viewport.z, one.viewport.w });
    if (one.renderer == this->renderer)
      to = glm::dvec2(this->origin + pixels) / whole; // exactly, whatever its viewport's rounding
    one.renderer->SetViewport(from.x, from.y, to.x, to.y);
  }
}

void BorrowedView::Aim(const hasp::EyeView& view, hasp::StereoEye eye, const hasp::EyeGrid& grid)
{
  this->eyeCamera->SetUserTransform(this->settings->GetUserTransform()); // not the last eye's
  hasp::SetCameraToView(this->eyeCamera, view, eye, grid);
  if (grid.size != this->size)
    this->SetViewports(grid.size);
  this->ResetClippingRange();
}

void BorrowedView::ResetClippingRange()
{
  vtkBoundingBox visible;
  double bounds[6];
  for (vtkRenderer* one : this->throughEye)
  {
    one->ComputeVisiblePropBounds(bounds);
    if (vtkMath::AreBoundsInitialized(bounds))
      visible.AddBounds(bounds);
  }
  if (!visible.IsValid())
    return;
  visible.GetBounds(bounds);
  this->renderer->ResetCameraClippingRange(bounds);
}

/// Multiplied as vtkOpenGLCamera does, so that it is the frame's matrix to the last bit. That class
/// is not asked: it would keep a matrix from before the frame.
glm::dmat4 BorrowedView::WorldToClip() const
{
  vtkNew<vtkMatrix4x4> clip;
  vtkMatrix4x4::Multiply4x4(
    this->eyeCamera->GetProjectionTransformMatrix(this->renderer->GetTiledAspectRatio(), -1, 1),
    this->eyeCamera->GetModelViewTransformMatrix(), clip);
  return glm::transpose(glm::make_mat4(clip->GetData()));
}

void BorrowedView::Announce(const Eye& left, const Eye& right)
{
  hasp::StereoPair pair;
  this->Aim(right.view, hasp::StereoEye::Right, right.grid);
  pair.right = this->WorldToClip();
  this->Aim(left.view, hasp::StereoEye::Left, left.grid);
  pair.left = this->WorldToClip();
  hasp::SetStereoPair(this->eyeCamera->GetInformation(), pair);
}

void BorrowedView::Draw(const hasp::EyeView& view, hasp::StereoEye eye, const hasp::EyeGrid& grid)
{
  this->Aim(view, eye, grid);
  std::list<DrawnEye> drawn;
  for (vtkRenderer* one : this->throughEye)
    drawn.emplace_back(one, eye == hasp::StereoEye::Left);
  this->window->Render();
}

glm::ivec2 ViewportSize(vtkRenderer* renderer)
{
  if (!renderer)
    throw std::invalid_argument("stereo: no renderer; call SetRenderer");
  if (!renderer->GetRenderWindow())
    throw std::invalid_argument("stereo: the renderer is in no window; add it to one");
  int width, height, x, y;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (width < 1 || height < 1)
    throw std::invalid_argument("stereo: the viewport has no pixels; set the window's size");
  return { width, height };
}
