#include "Window/StereoWindow.h"

#include "Devices/HeadPose.h"
#include "StereoView.h"
#include "View/QtRenderWindow.h"
#include "View/SceneView.h"

#include "vtkNew.h"
#include "vtkRenderer.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QVTKOpenGLNativeWidget.h>

#include <utility>

namespace hasp
{
namespace
{
constexpr int HeadMs = 8; // a head is asked 120 times a second

} // namespace

StereoWindowWidget::StereoWindowWidget(
  SceneView& scene, const StereoChoices& choices, const HeadChoices& head, QWidget* parent)
  : QWidget(parent, Qt::Window),
    Shown(new QVTKOpenGLNativeWidget(this))
{
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->setObjectName("stereo.window");
  this->setWindowTitle(tr("Stereo - Hasp planner"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Shown);
  this->Shown->setAttribute(Qt::WA_TransparentForMouseEvents); // its interactor moves nothing
  this->Shown->setFocusPolicy(Qt::NoFocus);                    // nor has it VTK's keys
  this->setMouseTracking(true);
  vtkNew<QtRenderWindow> window;
  this->Shown->setRenderWindow(window.Get());
  HeadPose rest;
  rest.position = RoomHead(choices).position;
  std::unique_ptr<HeadTracker> tracker = MakeHeadTracker(head, rest);
  this->View = std::make_unique<StereoView>(scene.Renderer(), window, choices, std::move(tracker));
  connect(&scene, &SceneView::Shown, this, &StereoWindowWidget::Draw);
  connect(this->Shown, &QOpenGLWidget::resized, this, &StereoWindowWidget::Draw,
    Qt::QueuedConnection); // VTK has drawn one eye alone
  if (this->View->IsTracked())
  {
    connect(&this->Head, &QTimer::timeout, this,
      [this]
      {
        if (this->View->HeadMoved(SteadySeconds()))
          this->Draw();
      });
    this->Head.start(HeadMs);
  }
}

StereoWindowWidget::~StereoWindowWidget() = default;

void StereoWindowWidget::Draw()
{
  if (!this->isVisible() || !this->Shown->isValid())
    return;
  const bool drawn = this->View->Draw(SteadySeconds());
  this->Shown->update();
  for (const std::string& warning : this->View->TakeWarnings())
    Q_EMIT this->Warned(QString::fromStdString(warning));
  if (!std::exchange(this->Stays, !drawn) && !drawn)
    Q_EMIT this->Warned(tr("The stereo window keeps its last picture: two eyes need a perspective "
                           "view (5 in the 3D view)."));
}

void StereoWindowWidget::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_F11)
    this->isFullScreen() ? this->showNormal() : this->showFullScreen();
  else if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_3)
    this->close();
  else
    QWidget::keyPressEvent(event);
}

void StereoWindowWidget::mouseMoveEvent(QMouseEvent* event)
{
  this->View->PointAt(2.0 * event->x() / std::max(1, this->width()) - 1.0,
    1.0 - 2.0 * event->y() / std::max(1, this->height()));
}

void StereoWindowWidget::closeEvent(QCloseEvent* event)
{
  Q_EMIT this->Closed();
  QWidget::closeEvent(event);
}

} // namespace hasp
