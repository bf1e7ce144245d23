#include "Window/PanelArea.h"

#include <QEvent>
#include <QScrollBar>

namespace hasp
{

PanelArea::PanelArea(QWidget* panel, QWidget* parent) : QScrollArea(parent)
{
  this->setWidgetResizable(true);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setFrameShape(QFrame::NoFrame);
  this->setFocusPolicy(Qt::NoFocus); // Tab goes to what is in it
  this->setWidget(panel);
}

QSize PanelArea::minimumSizeHint() const
{
  const QSize bar = this->verticalScrollBar()->sizeHint();
  return { this->widget()->minimumSizeHint().width() + bar.width(), bar.height() };
}

/// What is in the panel has become wider, or narrower.
bool PanelArea::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->widget() && event->type() == QEvent::LayoutRequest)
    this->updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

} // namespace hasp
