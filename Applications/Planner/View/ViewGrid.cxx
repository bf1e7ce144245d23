#include "View/ViewGrid.h"

#include "View/SceneView.h"
#include "View/SliceGrid.h"
#include "View/SliceView.h"

#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkRenderer.h"

#include <QHBoxLayout>
#include <QSplitter>

#include <algorithm>

namespace hasp
{

namespace
{

constexpr double BoneWindow = 1000.0, BoneLevel = 400.0; // HU
constexpr int Half = 10000; // of a splitter: more than any screen, so that halves are equal

const char* NameOf(SliceAxis axis)
{
  switch (axis)
  {
    case SliceAxis::Axial:
      return "view.axial";
    case SliceAxis::Coronal:
      return "view.coronal";
    default:
      return "view.sagittal";
  }
}

} // namespace

ViewGrid::ViewGrid(QWidget* parent) : QWidget(parent), Space(new SceneView)
{
  this->Space->setObjectName("view.scene");
  for (const SliceAxis axis : SliceAxes)
  {
    auto* slice = new SliceView(axis);
    slice->setObjectName(NameOf(axis));
    this->Slices[std::size_t(axis)] = slice;
    this->LinkSlice(slice);
  }
  auto* upper = new QSplitter(Qt::Horizontal);
  auto* lower = new QSplitter(Qt::Horizontal);
  auto* rows = new QSplitter(Qt::Vertical, this);
  this->Bars = { upper, lower, rows };
  upper->addWidget(this->Slices[0]);
  upper->addWidget(this->Space);
  lower->addWidget(this->Slices[1]);
  lower->addWidget(this->Slices[2]);
  rows->addWidget(upper);
  rows->addWidget(lower);
  for (QSplitter* bar : this->Bars)
  {
    bar->setChildrenCollapsible(false);
    bar->setSizes({ Half, Half });
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(rows);
  for (FrameView* view : this->All())
  {
    view->setMinimumSize(80, 80);
    connect(view, &FrameView::DoubleClicked, this,
      [this, view] { this->Maximise(this->Large == view ? nullptr : view); });
  }
}

ViewGrid::~ViewGrid() = default;

std::array<FrameView*, 4> ViewGrid::All() const
{
  return { this->Slices[0], this->Space, this->Slices[1], this->Slices[2] };
}

vtkImageData* ViewGrid::Image() const
{
  return this->Shown;
}

void ViewGrid::LinkSlice(SliceView* slice)
{
  connect(slice, &SliceView::PlaceAsked, this, &ViewGrid::SetCrosshair);
  connect(slice, &SliceView::WindowLevelAsked, this, &ViewGrid::SetWindowLevel);
  connect(slice, &SliceView::ZoomAsked, this,
    [this, slice](double zoom, const glm::dvec3& fixed)
    {
      for (SliceView* each : this->Slices)
        each->SetZoom(zoom, each == slice ? fixed : this->At);
    });
  connect(slice, &SliceView::ResetAsked, this,
    [this]
    {
      for (SliceView* each : this->Slices)
        each->ResetView();
    });
  connect(slice, &SliceView::ShownInSceneChanged, this,
    [this, slice](bool shown) { this->ShowInScene(slice->Axis(), shown); });
}

void ViewGrid::SetImage(vtkImageData* image, bool hounsfield)
{
  this->Shown = image;
  for (SliceView* slice : this->Slices)
    slice->SetImage(image, hounsfield);
  for (const auto& inSpace : this->InSpace)
    if (inSpace)
      inSpace->SetImage(image);
  if (image)
  {
    const WorldBox box = BoxOf(image);
    const glm::dvec2 ends = hounsfield ? glm::dvec2(0.0) : GreyQuantiles(image, 0.01, 0.99);
    this->SetWindowLevel(hounsfield ? BoneWindow : std::max(ends.y - ends.x, 1e-6),
      hounsfield ? BoneLevel : 0.5 * (ends.x + ends.y));
    this->SetCrosshair(0.5 * (box.low + box.high));
  }
  this->SetCrosshairVisible(this->CrossVisible);
}

void ViewGrid::SetCrosshair(const glm::dvec3& place)
{
  this->At = this->Shown ? ClampInto(this->Shown, place) : place;
  for (SliceView* slice : this->Slices)
    slice->SetPlace(this->At);
  if (this->CrossVisible && this->Shown)
    this->Space->SetCrosshair(this->At);
  this->PlaceInScene();
  Q_EMIT this->CrosshairMoved();
}

void ViewGrid::SetWindowLevel(double window, double level)
{
  this->Width = window;
  this->Middle = level;
  for (SliceView* slice : this->Slices)
    slice->SetWindowLevel(window, level);
  this->PlaceInScene();
  Q_EMIT this->WindowLevelChanged();
}

void ViewGrid::SetCrosshairVisible(bool visible)
{
  const bool other = visible != this->CrossVisible;
  this->CrossVisible = visible;
  for (SliceView* slice : this->Slices)
    slice->SetCrosshairVisible(visible);
  this->Space->SetCrosshair(
    visible && this->Shown ? std::optional<glm::dvec3>(this->At) : std::nullopt);
  if (other)
    Q_EMIT this->CrosshairVisibleChanged(visible);
}

void ViewGrid::SetLabels(
  vtkImageData* labels, const std::map<int, glm::dvec3>& colours, double opacity)
{
  for (SliceView* slice : this->Slices)
    slice->SetLabels(labels, colours, opacity);
}

void ViewGrid::SetContours(const std::vector<SliceContour>& contours)
{
  for (SliceView* slice : this->Slices)
    slice->SetContours(contours);
}

void ViewGrid::SetIsovalueLine(const std::optional<double>& value)
{
  for (SliceView* slice : this->Slices)
    slice->SetIsovalueLine(value);
}

/// A prop of one window cannot be another's: the 3D view has slices of its own, once they are asked
/// for.
void ViewGrid::ShowInScene(SliceAxis axis, bool shown)
{
  auto& slice = this->InSpace.at(std::size_t(axis));
  if (slice)
    this->Space->Renderer()->RemoveViewProp(slice->Prop());
  slice.reset();
  if (shown)
  {
    slice = std::make_unique<SliceImage>(SliceImage::Kind::Grey);
    slice->DrawInSpace();
    slice->SetImage(this->Shown);
    this->Space->Renderer()->AddViewProp(slice->Prop());
  }
  this->PlaceInScene();
  this->Space->Draw();
}

void ViewGrid::PlaceInScene()
{
  for (const SliceAxis axis : SliceAxes)
    if (const auto& slice = this->InSpace[std::size_t(axis)])
    {
      slice->Follow();
      slice->SetPlane(this->At, FrameOf(axis).towardsViewer);
      slice->SetWindowLevel(this->Width, this->Middle);
      this->Space->Draw();
    }
}

void ViewGrid::Maximise(QWidget* view)
{
  if (view == this->Large)
    return;
  const std::array<FrameView*, 4> all = this->All();
  const bool keyboardWithin =
    std::any_of(all.begin(), all.end(), [](FrameView* each) { return each->hasFocus(); });
  this->Large = view;
  // Shown before the others are hidden: else the keyboard would go to whatever comes next.
  for (FrameView* each : all)
    if (!view || each == view)
      each->show();
  this->Bars[0]->setVisible(!view || view == all[0] || view == all[1]);
  this->Bars[1]->setVisible(!view || view == all[2] || view == all[3]);
  if (view && keyboardWithin)
    view->setFocus();
  for (FrameView* each : all)
    each->setVisible(!view || each == view);
  Q_EMIT this->MaximisedChanged();
}

void ViewGrid::DrawAll()
{
  this->PlaceInScene();
  for (FrameView* view : this->All())
    view->Draw();
}

bool ViewGrid::IsSettled() const
{
  const auto all = this->All();
  return std::none_of(
    all.begin(), all.end(), [](const FrameView* view) { return view->IsWaiting(); });
}

} // namespace hasp
