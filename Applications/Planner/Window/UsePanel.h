#pragma once
#include "Grid/ResourceUse.h"

#include <QTableWidget>

namespace hasp
{

struct Planner;

/// What this scene uses: each resource with its bytes and milliseconds, and what was left out, at 0
/// with the reason. Asked while it is shown alone, once a second at most. Threads: RENDER.
class UsePanel : public QTableWidget
{
  Q_OBJECT
public:
  explicit UsePanel(Planner& planner, QWidget* parent = nullptr);

  /// Of all parts, as it would be shown now.
  static ResourceList Resources(const Planner& planner);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void Refresh();

  Planner& Of;
  QTimer* Again;
};

} // namespace hasp
