#pragma once
#include <QToolBar>

#include <vector>

class QActionGroup;

namespace hasp
{

class StepPanel;

/// The steps of the workflow in a row: Import · Split · … · Export. They may be taken in any order;
/// one that still needs something says what, in its tip and below its panel's title. Ctrl+1 to
/// Ctrl+8 choose them. Threads: RENDER.
class WorkflowBar : public QToolBar
{
  Q_OBJECT
public:
  /// The panels must outlive it.
  WorkflowBar(const std::vector<StepPanel*>& panels, QWidget* parent = nullptr);

  void Choose(int step);
  void Refresh(); ///< what each still needs

Q_SIGNALS:
  void Chosen(int step);

private:
  std::vector<StepPanel*> Panels;
  std::vector<QAction*> Actions;
};

} // namespace hasp
