#include "View/FrameView.h"

#include "Grid/Stopwatch.h"
#include "View/ViewMarks.h"

#include "QVTKInteractor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <QScopeGuard>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{

namespace
{

constexpr int SettleMs = 300;
constexpr int LeastSettleMs = 100; // after a frame that took long: more motion may be waiting
constexpr int LeastFrameMs = 8;
constexpr double LeastShare = 0.5;
constexpr double ShareStep = 0.125; ///< few sizes: each costs new buffers
constexpr double RoomToGrow = 0.9;  ///< so that it does not go to and fro between two of them
constexpr int MostRefinements = 1000;

} // namespace

FrameView::FrameView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent),
    Marks(new ViewMarks(*this, [this](QPainter& painter) { this->PaintMarks(painter); }))
{
  this->Target->SetMultiSamples(0); // depth is read, and isosurfaces are traced ray by ray
  this->Target->AddRenderer(this->Scene);
  this->setRenderWindow(this->Target);
  this->Coming.setSingleShot(true);
  this->Later.setSingleShot(true);
  this->Settling.setSingleShot(true);
  connect(&this->Coming, &QTimer::timeout, this, &FrameView::Frame);
  connect(&this->Later, &QTimer::timeout, this, &FrameView::Draw);
  connect(&this->Settling, &QTimer::timeout, this, &FrameView::Settle);

  QVTKInteractor* interactor = this->interactor();
  interactor->EnableRenderOff(); // whoever asks it for a picture asks the view
  const auto observe = [&](unsigned long event, auto method, float priority)
  { this->Observers.push_back(interactor->AddObserver(event, this, method, priority)); };
  observe(vtkCommand::RenderEvent, &FrameView::Draw, 0.0F);
  observe(vtkCommand::LeftButtonPressEvent, &FrameView::SeePress, -1.0F); // after all others
}

FrameView::~FrameView()
{
  for (const unsigned long observer : this->Observers)
    this->interactor()->RemoveObserver(observer);
}

void FrameView::Draw()
{
  if (this->Coming.isActive())
    return;
  const qint64 since = this->SinceFrame.isValid() ? this->SinceFrame.elapsed() : LeastFrameMs;
  this->Coming.start(static_cast<int>(std::clamp<qint64>(LeastFrameMs - since, 0, LeastFrameMs)));
}

void FrameView::DrawNow(const ProgressFunction& progress)
{
  const double share = this->Scale;
  this->Rescale(1.0);
  const auto awaited = qScopeGuard([this] { this->Awaited = nullptr; });
  this->Awaited = &progress;
  for (int frame = 0; frame < MostRefinements && !this->GivenUp; ++frame)
  {
    this->Frame();
    if (!this->Coming.isActive()) // nobody asks for more
      break;
  }
  if (this->IsHeld())
    this->Rescale(share); // of the drag
  if (this->GivenUp)
    std::rethrow_exception(std::exchange(this->GivenUp, nullptr));
}

/// Within a frame, through which nothing may be thrown.
bool FrameView::Report(double share)
{
  try
  {
    if (this->Awaited && !this->GivenUp)
      ReportProgress(*this->Awaited, share);
  }
  catch (...)
  {
    this->GivenUp = std::current_exception();
  }
  return this->Awaited && !this->GivenUp;
}

QImage FrameView::Picture(const ProgressFunction& progress)
{
  this->DrawNow(progress);
  if (!this->isValid() || !this->isVisible())
    return {};
  return this->grab().toImage();
}

void FrameView::Frame()
{
  this->Coming.stop();
  if (!this->isValid() || !this->isVisible() || this->size().isEmpty())
  {
    this->Missed = true;
    return;
  }
  if (this->Drawing)
  {
    this->Draw();
    return;
  }
  this->DrawFrame();
}

void FrameView::DrawFrame()
{
  this->Coming.stop();
  this->Later.stop();
  this->Drawing = true;
  this->Missed = false;
  this->SinceFrame.start();
  if (this->before)
    this->before();
  this->Prepare();
  const Stopwatch watch;
  this->Target->Render();
  if (!this->Awaited) // else it may have waited for light, and says nothing of the next one
    this->Took = watch.Milliseconds();
  ++this->Drawn;
  std::copy_n(this->Target->GetSize(), 2, this->DrawnSize.begin());
  const bool more = this->after && this->after();
  this->Drawing = false;
  if (this->IsMoving() && !this->Waited && this->Settling.remainingTime() < LeastSettleMs)
  {
    this->Waited = true;
    this->Settling.start(LeastSettleMs);
  }
  this->MarksChanged();
  Q_EMIT this->Shown();
  if (more)
    this->Draw();
}

bool FrameView::IsStale() const
{
  return this->Missed ||
         !std::equal(this->DrawnSize.begin(), this->DrawnSize.end(), this->Target->GetSize());
}

/// Qt shows the last frame again whenever something beside it changes: no frame, unless the size is
/// another. Qt also paints before the view is visible, and there has to be a frame then: VTK 9.1
/// would make its buffer unusable by showing what it has not made.
void FrameView::paintGL()
{
  if (this->IsStale() && !this->Drawing)
    this->DrawFrame();
  QVTKOpenGLNativeWidget::paintGL();
}

/// Time goes with the number of pixels.
double FrameView::NextShare() const
{
  if (!(this->framesAimed > 0.0))
    return 1.0;
  if (!(this->Took > 0.0))
    return this->Scale;
  const double aimedMs = 1000.0 / this->framesAimed;
  double share = this->Scale * std::sqrt(aimedMs / this->Took);
  if (share > this->Scale)
    share = std::max(this->Scale, RoomToGrow * share);
  return std::clamp(ShareStep * std::floor(share / ShareStep), LeastShare, 1.0);
}

void FrameView::Rescale(double scale)
{
  if (scale == this->Scale)
    return;
  this->Scale = scale;
  this->setCustomDevicePixelRatio(scale < 1.0 ? scale * this->devicePixelRatioF() : 0.0);
  this->updateSize();
}

void FrameView::Moving()
{
  if (!this->IsHeld())
    this->Rescale(this->NextShare());
  this->Waited = false;
  this->Settling.start(SettleMs);
}

void FrameView::Settle()
{
  if (this->IsHeld())
    return; // at the release
  this->Rescale(1.0);
  if (this->IsStale())
    this->Draw();
}

void FrameView::MarksChanged()
{
  this->Marks->update();
}

std::optional<QPointF> FrameView::PixelOf(const glm::dvec3& world) const
{
  if (this->size().isEmpty())
    return std::nullopt;
  vtkMatrix4x4* matrix = this->Scene->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    double(this->width()) / this->height(), -1.0, 1.0);
  const double place[4] = { world.x, world.y, world.z, 1.0 };
  double clip[4];
  matrix->MultiplyPoint(place, clip);
  if (!(clip[3] > 0.0))
    return std::nullopt;
  return QPointF((1.0 + clip[0] / clip[3]) * 0.5 * this->width(),
    (1.0 - clip[1] / clip[3]) * 0.5 * this->height());
}

double FrameView::MmPerPixel() const
{
  vtkCamera* camera = this->Scene->GetActiveCamera();
  const double half =
    camera->GetParallelProjection()
      ? camera->GetParallelScale()
      : camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return 2.0 * half / std::max(1, this->height());
}

} // namespace hasp
