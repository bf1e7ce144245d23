#include "Studies/SimulatedOperator.h"

#include "Studies/FracturedBlocks.h"
#include "Studies/SeededDice.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double NerveS = 0.06;      // what is felt is known so late
constexpr double GainMmPerNs = 20.0; // of the push: how fast the hand follows up or gives way
constexpr double SoftNPerMm = 0.2;   // hand and coupling in series, about
constexpr double SoftNmmPerRad = 250.0;
constexpr double MoveS = 0.12, ReadS = 0.1; // of a try: its move, and its end, when depth is read
constexpr double MoveShare = 0.3;           // of the push, while it moves to the side
constexpr double StandOffMm = 6.0;          // before the aim, where the approach begins
constexpr double TouchShare = 0.3;          // of the push: less is no contact
constexpr double WanderMm = 3.0;            // farther from the aim than its error + so much: lost
constexpr double LeastSearch = 0.1;         // of the first try's size
constexpr double MostSearch = 3.0;
constexpr double GapReachMm = 5.0;

/// What is seen between the group and the others: the median of distances, infinite where hardly
/// anything looks at them.
double SeenGap(const OperatorTask& task, const RigidPose& group)
{
  std::vector<double> gaps;
  std::size_t all = 0;
  for (const GroupBody& body : task.moved)
    for (const OrientedPoint& point : body.body->Points(1024))
    {
      ++all;
      const RigidPose pose = group * body.bodyInGroup;
      for (const PlacedBody& other : task.others.partners)
      {
        const RigidPose inOther = other.bodyInWorld.Inverse() * pose;
        const auto foot = other.body->FootOf(inOther.Place(point.place));
        if (foot && std::abs(foot->mm) < GapReachMm &&
            glm::dot(foot->outward, inOther.Turn(point.normal)) < -0.5)
          gaps.push_back(std::abs(foot->mm));
      }
    }
  if (double(gaps.size()) < task.leastSeen * double(all) || gaps.empty())
    return std::numeric_limits<double>::infinity();
  const auto middle = gaps.begin() + std::ptrdiff_t(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

class Trial
{
public:
  Trial(const OperatorTask& task, const RigidPose& start, const OperatorSettings& settings,
    const OperatorHelp& help, std::uint64_t seed);
  OperatorResult Run();

private:
  enum class Doing
  {
    Carry, ///< before the aim
    Feel,  ///< comes on, and tries from where it touches
    Settle ///< is back at the best and looks
  };
  void AimAnew();
  void Feel(const HapticTick& tick);
  void Carry();
  void Push();
  void Search();
  void EndTry();
  void EndSettling();
  void BeginTry(bool goOn);
  double Resistance() const { return -glm::dot(this->Felt.force, this->Task.push); }
  /// Without what is along the push.
  glm::dvec3 Aside(const glm::dvec3& v) const
  {
    return v - glm::dot(v, this->Task.push) * this->Task.push;
  }

  const OperatorTask& Task;
  const OperatorSettings& Settings;
  const OperatorHelp& Help;
  SeededDice Chance;
  OperatorNoise Noise;
  OperatorHand Hand;
  HapticStep Step;
  double TickS;
  OperatorResult Result;

  Doing Now = Doing::Carry;
  RigidPose Aim, Meant, Tool; ///< the tool as the eye follows it
  Wrench Felt;
  double SpeedMmPerS = 0.0;
  // The search.
  bool Touches = false, HasBest = false, Done = false;
  RigidPose Best; ///< what was meant there
  double BestDepth = 0.0, Size = 1.0, InTryS = 0.0;
  glm::dvec3 Shift{ 0.0 }, Turn{ 0.0 };           ///< of the try, as it goes on from the best
  glm::dvec3 WholeShift{ 0.0 }, WholeTurn{ 0.0 }; ///< with the way back to the best
  glm::dvec3 ReadSum{ 0.0 };
  int Reads = 0, Fails = 0;
};

HapticStepSettings Ready(HapticStepSettings settings)
{
  settings.budgetUs = std::numeric_limits<double>::infinity(); // virtual time is not measured
  return settings;
}

Trial::Trial(const OperatorTask& task, const RigidPose& start, const OperatorSettings& settings,
  const OperatorHelp& help, std::uint64_t seed)
  : Task(task),
    Settings(settings),
    Help(help),
    Chance(2 * seed + 1),
    Noise(settings.hand, 2 * seed),
    Hand(settings.hand, start),
    Step(Ready(help.step)),
    TickS(help.step.tickS),
    Meant(start),
    Tool(start)
{
  CheckOperator(settings);
  if (task.moved.empty() || !task.touch)
    throw std::invalid_argument("operator: a task needs a group to be moved and a scene to touch");
  if (!(std::abs(glm::length(task.push) - 1.0) < 1e-6))
    throw std::invalid_argument("operator: the push is not a unit vector");
  if (help.levels < 1)
    throw std::invalid_argument(
      "operator: levels is " + std::to_string(help.levels) + ", must be 1 or more");
  std::unique_ptr<HapticScene> scene = task.touch();
  this->Step.Swap(scene);
  this->Step.Place(start);
  this->Step.LimitLevels(help.levels);
  this->AimAnew();
}

void Trial::AimAnew()
{
  const double share = this->Chance.In(0.5, 1.0);
  const glm::dvec3 off = this->Chance.Direction() * (share * this->Settings.aimMm);
  const glm::dvec3 turn =
    this->Chance.Direction() * (share * glm::radians(this->Settings.aimDegrees));
  this->Aim = { this->Task.truth.position + off, TurnBy(turn) * this->Task.truth.orientation };
  this->Now = Doing::Carry;
  this->Touches = this->HasBest = false;
  this->Size = 1.0;
  this->Fails = 0;
  this->Step.Attract(false);
}

OperatorResult Trial::Run()
{
  std::uint64_t points = 0, touching = 0;
  const auto ticks = std::uint64_t(this->Settings.givesUpS / this->TickS);
  Wrench applied;
  for (std::uint64_t n = 0; n < ticks && !this->Done; ++n)
  {
    const double timeS = double(n) * this->TickS;
    const RigidPose shaken = this->Noise.At(timeS);
    this->Hand.Advance(
      { this->Meant.position + shaken.position, shaken.orientation * this->Meant.orientation },
      applied, this->TickS);
    const HapticTick tick = this->Step.Tick(this->Hand.Pose());
    applied = tick.onDevice;
    this->Feel(tick);
    if (tick.sums.contacts > 0)
    {
      ++touching;
      points += tick.points / std::uint32_t(std::max(1, tick.evaluations));
    }
    this->Result.seconds = timeS + this->TickS;
    this->Result.pose = tick.tool;
    switch (this->Now)
    {
      case Doing::Carry:
        this->Carry();
        break;
      case Doing::Feel:
      case Doing::Settle:
        this->Push();
        this->Search();
        break;
    }
  }
  this->Result.meanPoints = touching > 0 ? double(points) / double(touching) : 0.0;
  return this->Result;
}

void Trial::Feel(const HapticTick& tick)
{
  const double share = std::min(1.0, this->TickS / NerveS);
  const double force = glm::length(tick.onDevice.force);
  const double torque = glm::length(tick.onDevice.torque);
  const glm::dvec3& at = tick.tool.position;
  if (!std::isfinite(force + torque + at.x + at.y + at.z))
  {
    ++this->Result.notFinite;
    return;
  }
  this->Result.largestForceN = std::max(this->Result.largestForceN, force);
  const ForceLimits& limits = this->Help.step.limits;
  this->Result.overLimit +=
    force > limits.force * (1.0 + 1e-9) || torque > limits.torque * (1.0 + 1e-9);
  this->Felt.force += share * (tick.onDevice.force - this->Felt.force);
  this->Felt.torque += share * (tick.onDevice.torque - this->Felt.torque);
  const glm::dvec3 moved = share * (at - this->Tool.position);
  this->SpeedMmPerS = glm::length(moved) / this->TickS;
  this->Tool = { this->Tool.position + moved, tick.tool.orientation };
}

void Trial::Carry()
{
  const OperatorSettings& s = this->Settings;
  if (glm::length(this->Felt.force) > s.comfortN)
  {
    this->Meant.position -= s.speedMmPerS * this->TickS * this->Task.push;
    return;
  }
  const glm::dvec3 way = this->Aim.position - StandOffMm * this->Task.push - this->Meant.position;
  const glm::dvec3 turn =
    RotationVector(this->Aim.orientation * glm::conjugate(this->Meant.orientation));
  const double leftS =
    std::max(glm::length(way) / s.speedMmPerS, glm::length(turn) / glm::radians(s.turnDegreesPerS));
  const double share = leftS > this->TickS ? this->TickS / leftS : 1.0;
  this->Meant.position += share * way;
  this->Meant.orientation = glm::normalize(TurnBy(share * turn) * this->Meant.orientation);
  if (share < 1.0)
    return;
  this->Now = Doing::Feel;
  this->Step.Attract(this->Help.snap);
}

void Trial::Push()
{
  const OperatorSettings& s = this->Settings;
  // Moves to the side are made with less: what interlocks would hold them.
  const bool moves = this->Touches && this->InTryS < MoveS && this->WholeShift != glm::dvec3(0.0);
  const double wanted = moves ? MoveShare * s.pushN : s.pushN;
  double speed =
    std::clamp(GainMmPerNs * (wanted - this->Resistance()), -s.speedMmPerS, s.approachMmPerS);
  if (glm::length(this->Felt.force) > s.comfortN)
    speed = -s.speedMmPerS;
  this->Meant.position += speed * this->TickS * this->Task.push;
  // It goes where it is pushed aside, as a spring in a dashpot does.
  const double share = this->TickS / s.yieldS;
  this->Meant.position += share / SoftNPerMm * this->Aside(this->Felt.force);
  this->Meant.orientation =
    glm::normalize(TurnBy(share / SoftNmmPerRad * this->Felt.torque) * this->Meant.orientation);
}

void Trial::Search()
{
  if (!this->Touches)
  {
    this->Touches = this->Resistance() > TouchShare * this->Settings.pushN;
    if (this->Touches)
    {
      this->Shift = this->Turn = this->WholeShift = this->WholeTurn = glm::dvec3(0.0);
      this->InTryS = 0.0; // the first one only reads
    }
    // It passed the place where it aims and nothing is there: it looks again.
    const glm::dvec3 past = this->Tool.position - this->Aim.position;
    if (glm::dot(past, this->Task.push) > this->Settings.aimMm + WanderMm)
      this->EndSettling();
    return;
  }
  if (this->InTryS < MoveS)
  {
    const double share = this->TickS / MoveS;
    this->Meant.position += share * this->WholeShift;
    this->Meant.orientation =
      glm::normalize(TurnBy(share * this->WholeTurn) * this->Meant.orientation);
  }
  this->InTryS += this->TickS;
  if (this->InTryS > this->Settings.dwellS - ReadS)
  {
    this->ReadSum += this->Tool.position;
    ++this->Reads;
  }
  if (this->InTryS >= this->Settings.dwellS)
    this->EndTry();
}

void Trial::EndTry()
{
  const glm::dvec3 place = this->ReadSum / double(std::max(1, this->Reads));
  this->ReadSum = glm::dvec3(0.0);
  this->Reads = 0;
  if (this->Now == Doing::Settle)
    return this->EndSettling();
  const double depth =
    glm::dot(place, this->Task.push) + this->Settings.seesMm * this->Chance.Normal();
  const double strayed = glm::length(this->Aside(place - this->Aim.position));
  const bool held = this->Resistance() > TouchShare * this->Settings.pushN &&
                    strayed < this->Settings.aimMm + WanderMm;
  const bool gained = held && (!this->HasBest || depth > this->BestDepth + this->Settings.deeperMm);
  if (gained)
  {
    this->Best = this->Meant;
    this->BestDepth = depth;
    this->Fails = 0;
  }
  else
    ++this->Fails;
  // It is caught on something as long as a gap is seen: larger tries, and sooner another aim.
  const bool caught = SeenGap(this->Task, this->Tool) > this->Settings.gapMm;
  this->Fails += caught && !gained;
  this->Size *= gained || caught ? 1.1 : 0.85;
  this->Size = std::clamp(this->Size, LeastSearch, MostSearch);
  const bool goOn = gained && this->HasBest;
  this->HasBest = this->HasBest || gained;
  this->BeginTry(goOn);
}

void Trial::BeginTry(bool goOn)
{
  this->InTryS = 0.0;
  ++this->Result.tries;
  if (!goOn)
  {
    const double mm = this->Size * this->Settings.searchMm;
    const double turn = this->Size * glm::radians(this->Settings.searchDegrees);
    this->Shift = this->Aside(this->Chance.Direction() * (mm * this->Chance.In(0.3, 1.0)));
    this->Turn = this->Chance.Direction() * (turn * this->Chance.In(0.0, 1.0));
  }
  if (this->Fails >= this->Settings.patience)
  {
    this->Now = Doing::Settle;
    this->Shift = this->Turn = glm::dvec3(0.0);
  }
  this->WholeShift = this->Shift;
  this->WholeTurn = this->Turn;
  if (!this->HasBest)
    return;
  this->WholeShift += this->Aside(this->Best.position - this->Meant.position);
  this->WholeTurn +=
    RotationVector(this->Best.orientation * glm::conjugate(this->Meant.orientation));
}

void Trial::EndSettling()
{
  const bool opposed = this->Resistance() > TouchShare * this->Settings.pushN;
  if (opposed && SeenGap(this->Task, this->Tool) <= this->Settings.gapMm)
  {
    if (this->SpeedMmPerS <= this->Settings.stillMmPerS)
      this->Result.content = this->Done = true;
    else
      this->InTryS = MoveS; // it waits until it is still
    return;
  }
  ++this->Result.lifts;
  this->AimAnew();
}

} // namespace

OperatorTask TaskOf(const FracturedBlocks& blocks)
{
  const auto kept = std::make_shared<const FracturedBlocks>(blocks);
  return { [kept] { return kept->TouchScene(); }, blocks.MovedGroup(), blocks.SceneOfOthers(),
    blocks.Moved().whole.bodyInWorld, blocks.push };
}

RigidPose StartBefore(const OperatorTask& task, std::uint64_t seed)
{
  SeededDice dice(seed);
  const glm::dvec3 aside = dice.Direction() * dice.In(0.0, 5.0);
  const glm::dvec3 turn = dice.Direction() * glm::radians(dice.In(0.0, 15.0));
  return { task.truth.position - dice.In(12.0, 18.0) * task.push + aside,
    TurnBy(turn) * task.truth.orientation };
}

HapticStepSettings OperatorHelp::TouchSteps()
{
  HapticStepSettings settings;
  settings.contact.attraction = 0.01F;
  settings.contact.captureMm = 3.0F;
  return settings;
}

OperatorResult PutInPlace(const OperatorTask& task, const RigidPose& start,
  const OperatorSettings& settings, const OperatorHelp& help, std::uint64_t seed)
{
  if (!IsPose(start))
    throw std::invalid_argument("operator: the start is no pose");
  return Trial(task, start, settings, help, seed).Run();
}

} // namespace hasp
