#pragma once
#include "Planning/DerivedPart.h"

#include <QObject>

#include <map>
#include <string>
#include <vector>

namespace hasp
{

struct Planner;

/// Parts that were made and do not hold. The plan keeps none of them, as with `hasp run`; until
/// they are made again, or another plan is opened, their reports are here, so that it is seen why.
/// One for a planner, made when it is first asked for. Threads: RENDER.
class RedParts : public QObject
{
  Q_OBJECT
public:
  static RedParts& Of(Planner& planner);

  struct Part
  {
    std::vector<PartInput> inputs;
    std::string stl, report; ///< as PartFile's (RunParts.h)
  };

  /// The one of the plan as it is now: nullptr if there is none, or the object has changed since.
  const Part* Find(PlanId object) const;
  void Put(PlanId object, Part part);
  void Drop(PlanId object);
  /// Another after each plan that is opened: what a job made for one is nothing of the next.
  int Round() const { return this->Plans; }

Q_SIGNALS:
  void Changed();

private:
  explicit RedParts(Planner& planner);

  Planner& Owner;
  std::map<PlanId, Part> Parts;
  int Plans = 0;
};

} // namespace hasp
