#pragma once
#include <QLabel>

namespace hasp
{

struct Planner;

/// How to begin, written over the 3D view while the plan is of nothing yet. The mouse goes through
/// it. Widget: start.hint. Threads: RENDER.
class StartHint : public QLabel
{
  Q_OBJECT
public:
  explicit StartHint(Planner& planner);

private:
  void Follow();

  Planner& Of;
};

} // namespace hasp
