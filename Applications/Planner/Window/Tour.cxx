#include "Window/Tour.h"

#include "Window/PlannerWindow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace hasp
{

Tour::Tour(PlannerWindow& window, Sample sample)
  : QFrame(&window),
    Window(window),
    Stops(TourOf(sample)),
    Words(new QLabel),
    NextButton(new QPushButton(tr("&Next"))),
    Marker(new QFrame(&window))
{
  this->setObjectName("tour");
  this->setFrameShape(QFrame::StyledPanel);
  this->setStyleSheet("hasp--Tour { background: #2e4a2e; } QLabel { color: white; }");
  this->Words->setObjectName("tour.text");
  this->Words->setWordWrap(true);
  this->NextButton->setObjectName("tour.next");
  auto* leave = new QPushButton(tr("&Leave the tour"));
  leave->setObjectName("tour.leave");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(this->Words, 1);
  row->addWidget(this->NextButton);
  row->addWidget(leave);
  this->Marker->setStyleSheet("border: 3px solid #f0b429; background: transparent;");
  this->Marker->setAttribute(Qt::WA_TransparentForMouseEvents);
  connect(this->NextButton, &QPushButton::clicked, this, [this] { this->Go(this->Now + 1); });
  connect(leave, &QPushButton::clicked, this, &QObject::deleteLater);
  connect(this, &QObject::destroyed, this->Marker, &QObject::deleteLater);
  connect(&window.Parts().plan, &PlanSession::Changed, this, &Tour::Follow);
  connect(&window, &PlannerWindow::StepChosen, this,
    [this] { this->Mark(this->Stops[std::size_t(this->Now)].widget); });
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
  this->NextButton->setText(stop + 1 == int(this->Stops.size()) ? tr("&Done") : tr("&Next"));
  this->Window.ChooseStep(now.step);
  this->Mark(now.widget);
}

void Tour::Follow()
{
  const TourStop& now = this->Stops[std::size_t(this->Now)];
  if (now.isDone && now.isDone(this->Window.Parts().plan.Now()))
    this->Go(this->Now + 1);
}

void Tour::Mark(const QString& name)
{
  const auto* widget = name.isEmpty() ? nullptr : this->Window.findChild<QWidget*>(name);
  this->Marker->setVisible(widget && widget->isVisible());
  if (!widget)
    return;
  const QPoint corner = widget->mapTo(&this->Window, QPoint(0, 0));
  this->Marker->setGeometry(QRect(corner, widget->size()).adjusted(-4, -4, 4, 4));
  this->Marker->raise();
}

} // namespace hasp
