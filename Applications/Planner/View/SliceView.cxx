#include "View/SliceView.h"

#include "View/SliceGrid.h"
#include "View/SliceIsoline.h"
#include "View/SliceMarks.h"
#include "View/ViewMarks.h"

#include "QVTKInteractor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkRenderer.h"

#include <QResizeEvent>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace hasp
{

namespace
{

constexpr double CameraMm = 1000.0;  // from the slice; parallel, so any will do
constexpr double LabelLiftMm = 0.01; // far more than the depth buffer's step of 2000 mm / 2^24
constexpr double IsolineLiftMm = 0.02;
constexpr double ContourLiftMm = 0.03;
constexpr double RoomAround = 1.04;
constexpr double LeastZoom = 0.05, MostZoom = 200.0;

} // namespace

SliceView::SliceView(SliceAxis axis, QWidget* parent)
  : FrameView(parent),
    Which(axis),
    Shape(FrameOf(axis))
{
  this->framesAimed = 0.0; // a slice is a value per pixel: always all of them
  vtkNew<SliceStyle> style;
  style->tell = [this](const SliceMouse& mouse) { this->OnMouse(mouse); };
  this->interactor()->SetInteractorStyle(style);
  this->Renderer()->SetBackground(0.0, 0.0, 0.0);
  this->Renderer()->AddViewProp(this->Grey.Prop());
  this->Renderer()->GetActiveCamera()->ParallelProjectionOn();
  this->PlaceCamera();
}

SliceView::~SliceView()
{
  static_cast<SliceStyle*>(this->interactor()->GetInteractorStyle())->tell = {};
}

void SliceView::SetImage(vtkImageData* image, bool hounsfield)
{
  this->Shown = image;
  this->Hounsfield = hounsfield;
  this->Grey.SetImage(image);
  if (image)
  {
    this->Step = StepAlong(image, this->Shape.normalAxis);
    const double* range = image->GetScalarRange();
    this->GreyRange = std::max(range[1] - range[0], 1e-6);
  }
  this->ResetView();
}

void SliceView::SetPlace(const glm::dvec3& place)
{
  const int normal = this->Shape.normalAxis;
  const bool other = place[normal] != this->At[normal];
  this->At = place;
  if (!other)
    return this->MarksChanged();
  this->PlaceCamera();
  this->Draw();
}

void SliceView::SetWindowLevel(double window, double level)
{
  this->Window = window;
  this->Level = level;
  this->Grey.SetWindowLevel(window, level);
  this->Draw();
}

void SliceView::SetCrosshairVisible(bool visible)
{
  this->CrossVisible = visible;
  this->MarksChanged();
}

void SliceView::SetZoom(double zoom, const glm::dvec3& fixed)
{
  const double before = this->Closer;
  this->Closer = std::clamp(zoom, LeastZoom, MostZoom);
  this->Middle = fixed + (this->Middle - fixed) * (before / this->Closer);
  this->PlaceCamera();
  this->Draw();
}

void SliceView::ResetView()
{
  this->Closer = 1.0;
  if (this->Shown)
  {
    const WorldBox box = BoxOf(this->Shown);
    this->Middle = 0.5 * (box.low + box.high);
  }
  this->PlaceCamera();
  this->Draw();
}

/// From the frame, the middle and the zoom alone.
void SliceView::PlaceCamera()
{
  double halfHeight = 100.0;
  if (this->Shown && !this->size().isEmpty())
  {
    const WorldBox box = BoxOf(this->Shown);
    const glm::dvec3 half = 0.5 * RoomAround * (box.high - box.low);
    halfHeight = std::max(glm::dot(half, glm::abs(this->Shape.up)),
      glm::dot(half, glm::abs(this->Shape.right)) * this->height() / this->width());
  }
  glm::dvec3 target = this->Middle;
  target[this->Shape.normalAxis] = this->At[this->Shape.normalAxis];
  const glm::dvec3 from = target + CameraMm * this->Shape.towardsViewer;
  vtkCamera* camera = this->Renderer()->GetActiveCamera();
  camera->SetFocalPoint(target.x, target.y, target.z);
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetViewUp(this->Shape.up.x, this->Shape.up.y, this->Shape.up.z);
  camera->SetParallelScale(halfHeight / this->Closer);
  camera->SetClippingRange(1.0, 2.0 * CameraMm);
}

void SliceView::resizeEvent(QResizeEvent* event)
{
  FrameView::resizeEvent(event);
  this->PlaceCamera();
}

void SliceView::SetLabels(
  vtkImageData* labels, const std::map<int, glm::dvec3>& colours, double opacity)
{
  if (this->Labels && !labels)
  {
    this->Renderer()->RemoveViewProp(this->Labels->Prop());
    this->Labels.reset();
  }
  if (!this->Labels && labels)
  {
    this->Labels = std::make_unique<SliceImage>(SliceImage::Kind::Labels);
    this->Renderer()->AddViewProp(this->Labels->Prop());
  }
  if (labels)
  {
    this->Labels->SetLabelColours(colours, opacity);
    this->Labels->SetImage(labels);
  }
  this->Draw();
}

void SliceView::SetContours(const std::vector<SliceContour>& contours)
{
  if (!this->Contours && !contours.empty())
    this->Contours = std::make_unique<SliceContours>(this->Renderer());
  if (this->Contours)
    this->Contours->Set(contours);
  if (contours.empty())
    this->Contours.reset();
  this->Draw();
}

void SliceView::SetIsovalueLine(const std::optional<double>& value)
{
  if (value == this->Isovalue)
    return;
  this->Isovalue = value;
  if (!value)
    this->Isoline.reset();
  else if (!this->Isoline)
    this->Isoline = std::make_unique<SliceIsoline>(this->Renderer());
  this->Draw();
}

void SliceView::Prepare()
{
  const glm::dvec3& normal = this->Shape.towardsViewer;
  this->PlaceCamera();
  this->Grey.Follow();
  this->Grey.SetPlane(this->At, normal);
  if (this->Labels)
  {
    this->Labels->Follow();
    this->Labels->SetPlane(this->At, normal, LabelLiftMm);
  }
  if (this->Isoline && this->Shown)
    this->Isoline->Cut(this->Shown, *this->Isovalue, this->Shape, this->At, IsolineLiftMm);
  if (this->Contours)
    this->Contours->Cut(this->At, normal, ContourLiftMm);
}

std::optional<double> SliceView::GreyValue() const
{
  return this->Shown ? GreyAt(this->Shown, this->At) : std::nullopt;
}

QString SliceView::PlaceText() const
{
  const double along = this->At[this->Shape.normalAxis];
  glm::dvec3 side(0.0);
  side[this->Shape.normalAxis] = along == 0.0 ? this->Shape.next[this->Shape.normalAxis] : along;
  const int decimals = this->Step < 0.1 ? 2 : 1;
  return tr("%1 %2 mm").arg(SideLetter(side), NumberText(std::abs(along), 'f', decimals));
}

QString SliceView::GreyText() const
{
  const std::optional<double> value = this->GreyValue();
  if (!value)
    return {};
  return this->Hounsfield ? tr("%1 HU").arg(NumberText(*value, 'f', 0))
                          : tr("grey %1").arg(NumberText(*value, 'g', 5));
}

} // namespace hasp
