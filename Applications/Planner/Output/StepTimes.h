#pragma once
#include <string>
#include <vector>

namespace hasp
{

/// How long a user was at a step of the workflow.
struct StepTime
{
  std::string step;
  int visits = 0;
  double activeS = 0.0; ///< between signs of life, a pause counting no more than `pauseS`
  double wallS = 0.0;   ///< all of it

  bool operator==(const StepTime&) const = default;
};

/// Sums up times of steps. Moments are seconds of whatever clock, never going back; one that does
/// counts as no time. Any thread, one at a time.
class StepTimes
{
public:
  explicit StepTimes(double pauseS) : PauseS(pauseS) {}

  /// The user goes to a step, and leaves the one before. Empty: to none.
  void Enter(const std::string& step, double now);
  /// The user did something.
  void Alive(double now);
  /// Adds what was kept of an earlier run.
  void Add(const StepTime& time);

  const std::string& Step() const { return this->At; }
  /// Of the visit that goes on; of no step: nothing.
  StepTime Visit(double now) const;
  /// Of all that have been left, in the order in which they were first entered.
  const std::vector<StepTime>& Left() const { return this->Times; }

private:
  std::vector<StepTime> Times;
  std::string At;
  double PauseS, EnteredS = 0.0, AliveS = 0.0, ActiveS = 0.0;
};

} // namespace hasp
