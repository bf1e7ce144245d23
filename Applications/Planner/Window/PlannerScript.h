#pragma once
#include "Window/PlannerOptions.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <vector>

namespace hasp
{

class PlannerWindow;

/// What the command line asks of the window, one thing after the other, each when the one before is
/// done: no job runs, and no frame is to come. Threads: RENDER.
class PlannerScript : public QObject
{
  Q_OBJECT
public:
  PlannerScript(PlannerWindow& window, const PlannerOptions& options);

  void Begin();
  int ExitCode() const { return this->Code; }

private:
  void Next();
  void Fail(int code, const QString& text);
  void AddInputs();
  void AddOutputs();
  void LookForRed();
  void Shoot();
  void Explain();
  void Measure();

  PlannerWindow& Window;
  const PlannerOptions& Options;
  std::vector<std::function<void()>> Waiting; ///< the next one last
  QTimer Look;
  int Code = 0;
};

} // namespace hasp
