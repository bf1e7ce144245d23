#pragma once
#include "Tools/Planner.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace hasp
{

/// The next left press in the 3D view says a place; the tool is then put away. A press beside all
/// that is shown turns the view. Threads: RENDER.
class PickTool : public Tool
{
  Q_OBJECT
public:
  PickTool(Planner& planner, const QString& hint, QObject* parent = nullptr);
  ~PickTool() override;

  void Begin() override;
  void End() override;
  QString Hint() const override { return this->Line; }

Q_SIGNALS:
  void Picked(const hasp::PlanScene::Place& place);

private:
  bool Press();

  Planner& Of;
  QString Line;
  vtkNew<vtkCallbackCommand> Command;
};

} // namespace hasp
