#include "Window/Tour.h"

#include "Window/PlannerWindow.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>

namespace hasp
{
namespace
{

void Reveal(QWidget& widget)
{
  for (QWidget *at = &widget, *above = at->parentWidget(); above;
       at = above, above = at->parentWidget())
  {
    // A page is a child of the stack that is a child of the tabs.
    if (auto* tabs = qobject_cast<QTabWidget*>(above->parentWidget());
        tabs && tabs->indexOf(at) >= 0)
      tabs->setCurrentWidget(at);
    if (auto* area = qobject_cast<QScrollArea*>(above->parentWidget());
        area && area->widget() == at)
      area->ensureWidgetVisible(&widget);
  }
}

} // namespace

Tour::Tour(PlannerWindow& window, Sample sample)
  : QFrame(&window),
    Window(window),
    Stops(TourOf(sample)),
    Words(new QLabel),
    BackButton(new QPushButton(tr("Back"))),
    NextButton(new QPushButton(tr("Ne&xt"))),
    Marker(new QFrame(&window))
{
  this->setObjectName("tour");
  this->setFrameShape(QFrame::StyledPanel);
  this->setStyleSheet("hasp--Tour { background: #2e4a2e; } QLabel { color: white; }");
  this->Words->setObjectName("tour.text");
  this->Words->setWordWrap(true);
  this->BackButton->setObjectName("tour.back");
  this->NextButton->setObjectName("tour.next");
  auto* leave = new QPushButton(tr("Leave the tour"));
  leave->setObjectName("tour.leave");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(this->Words, 1);
  row->addWidget(this->BackButton);
  row->addWidget(this->NextButton);
  row->addWidget(leave);
  this->Marker->setObjectName("tour.marker");
  this->Marker->setStyleSheet("border: 3px solid #f0b429; background: transparent;");
  this->Marker->setAttribute(Qt::WA_TransparentForMouseEvents);
  connect(this->BackButton, &QPushButton::clicked, this, [this] { this->Go(this->Now - 1); });
  connect(this->NextButton, &QPushButton::clicked, this, [this] { this->Go(this->Now + 1); });
  connect(leave, &QPushButton::clicked, this, &QObject::deleteLater);
  connect(this, &QObject::destroyed, this->Marker, &QObject::deleteLater);
  connect(&window.Parts().plan, &PlanSession::Changed, this, &Tour::Follow);
  connect(&window, &PlannerWindow::StepChosen, this, [this] { this->Choose(); });
  this->Go(0);
}

void Tour::Go(int stop)
{
  if (stop >= int(this->Stops.size()))
  {
    this->deleteLater();
    return;
  }
  this->Now = stop;
  const TourStop& now = this->Stops[std::size_t(stop)];
  this->Words->setText(tr("%1 of %2: %3").arg(stop + 1).arg(this->Stops.size()).arg(now.text));
  this->BackButton->setEnabled(stop > 0);
  this->NextButton->setText(stop + 1 == int(this->Stops.size()) ? tr("D&one") : tr("Ne&xt"));
  this->Window.ChooseStep(now.step);
  this->Choose();
}

void Tour::Follow()
{
  const TourStop& now = this->Stops[std::size_t(this->Now)];
  if (now.isDone && now.isDone(this->Window.Parts().plan.Now()))
    this->Go(this->Now + 1);
}

void Tour::Choose()
{
  for (const QPointer<QWidget>& watched : this->Watched)
    if (watched)
      watched->removeEventFilter(this);
  this->Watched.clear();
  this->Marked = nullptr;
  for (const QString& name : this->Stops[std::size_t(this->Now)].widget.split(' '))
  {
    auto* widget = this->Window.findChild<QWidget*>(name);
    if (!widget)
      continue;
    Reveal(*widget);
    this->Marked = widget;
    if (widget->isVisible())
      break;
  }
  for (QWidget* at = this->Marked; at; at = at->parentWidget())
  {
    at->installEventFilter(this);
    this->Watched.emplace_back(at);
  }
  this->Mark();
}

/// It, or what it is in, has been scrolled, resized, shown or hidden.
bool Tour::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
      // Once all of them are where they will be.
      QMetaObject::invokeMethod(this, &Tour::Mark, Qt::QueuedConnection);
      break;
    default:
      break;
  }
  return QFrame::eventFilter(watched, event);
}

void Tour::Mark()
{
  const QRect seen = this->Marked ? this->Marked->visibleRegion().boundingRect() : QRect();
  this->Marker->setVisible(!seen.isEmpty());
  if (seen.isEmpty())
    return;
  const QPoint corner = this->Marked->mapTo(&this->Window, seen.topLeft());
  this->Marker->setGeometry(QRect(corner, seen.size()).adjusted(-4, -4, 4, 4));
  this->Marker->raise();
}

} // namespace hasp
