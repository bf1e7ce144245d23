#include "Window/StereoPage.h"

#include "Window/PlannerWindow.h"
#include "Window/StereoSettings.h"
#include "Window/StereoWindow.h"

#include <QAction>
#include <QMenu>
#include <QPointer>

namespace hasp
{
namespace
{

/// What was chosen last, and the window that shows it.
class StereoControl : public QObject
{
public:
  StereoControl(PlannerWindow& window, QAction* toggle)
    : QObject(&window),
      Window(window),
      Toggle(toggle)
  {
    this->Choices.stereo.layout = "anaglyph"; // any screen, and glasses of paper
    connect(toggle, &QAction::toggled, this,
      [this](bool on)
      {
        if (on)
          this->Open();
        else if (this->Shown)
          this->Shown->close();
      });
  }

  void Ask()
  {
    StereoSettings page(this->Window, this->Choices);
    if (page.exec() != QDialog::Accepted)
      return;
    this->Choices = page.Choices();
    if (this->Shown)
      this->Shown->close();
    this->Toggle->setChecked(true);
  }

private:
  void Open()
  {
    if (this->Shown)
      return;
    Planner& parts = this->Window.Parts();
    try
    {
      this->Shown = new StereoWindowWidget(
        parts.views.Scene(), this->Choices.stereo, this->Choices.head, &this->Window);
      connect(this->Shown, &StereoWindowWidget::Closed, this,
        [this]
        {
          this->Shown = nullptr; // it goes later, and another may come before
          this->Toggle->setChecked(false);
        });
      connect(this->Shown, &StereoWindowWidget::Warned, &parts, &Planner::SayFault);
      this->Shown->resize(960, 600);
      this->Choices.fullScreen ? this->Shown->showFullScreen() : this->Shown->show();
      parts.views.Scene().Draw();
    }
    catch (const std::exception& error)
    {
      delete this->Shown;
      parts.SayFault(PlannerWindow::tr("Stereo: %1").arg(QString::fromUtf8(error.what())));
      this->Toggle->setChecked(false);
    }
  }

  PlannerWindow& Window;
  QAction* Toggle;
  PlannerStereo Choices;
  QPointer<StereoWindowWidget> Shown;
};

} // namespace

void AddStereoActions(QMenu& menu, PlannerWindow& window)
{
  QAction* toggle = menu.addAction(PlannerWindow::tr("&Stereo"));
  toggle->setObjectName("view.stereo");
  toggle->setShortcut(QKeySequence("3"));
  toggle->setCheckable(true);
  auto* control = new StereoControl(window, toggle);
  QAction* settings = menu.addAction(PlannerWindow::tr("Stereo se&ttings …"));
  settings->setObjectName("view.stereo.settings");
  QObject::connect(settings, &QAction::triggered, control, &StereoControl::Ask);
}

} // namespace hasp
