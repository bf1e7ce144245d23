#pragma once
#include <QScrollArea>

namespace hasp
{

/// Where a step's panel is scrolled, up and down alone: never narrower than the panel and the bar
/// beside it, so that nothing is cut off at the right. Threads: RENDER.
class PanelArea : public QScrollArea
{
  Q_OBJECT
public:
  explicit PanelArea(QWidget* panel, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return this->minimumSizeHint(); }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace hasp
