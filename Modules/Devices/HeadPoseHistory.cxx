#include "Devices/HeadPoseHistory.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr std::size_t EnoughPoses = 5; ///< a fit wants so many, one of them may be far off,
constexpr double OldestS = 0.25;       ///< and goes back so far for them
constexpr double LeastSpanS = 0.004;   ///< a velocity from less is noise
constexpr double FloorMm = 1.0;        ///< poses that near the line are no outliers
constexpr double FloorRad = 0.01;

/// Axis times angle of a turn, the short way round.
glm::dvec3 RotationVector(const glm::dquat& q)
{
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 v(sign * q.x, sign * q.y, sign * q.z);
  const double sine = glm::length(v);
  return sine < 1e-12 ? 2.0 * v : 2.0 * std::atan2(sine, sign * q.w) / sine * v;
}

glm::dquat FromRotationVector(const glm::dvec3& turn)
{
  const double angle = glm::length(turn);
  return angle < 1e-12 ? glm::dquat(1, 0, 0, 0) : glm::angleAxis(angle, turn / angle);
}

glm::dvec3 AtMost(const glm::dvec3& v, double most)
{
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}
} // namespace

void HeadPoseHistory::Add(const TimedHeadPose& pose)
{
  const bool close =
    this->Count >= 2 && pose.timeS - this->Poses[this->Count - 2].timeS < this->FitS / 20.0;
  if (close)
    --this->Count;
  if (this->Count == this->Poses.size())
  {
    std::move(this->Poses.begin() + 1, this->Poses.end(), this->Poses.begin());
    --this->Count;
  }
  this->Poses[this->Count++] = pose;
  this->Fit();
}

bool HeadPoseHistory::KeepStill(double timeS)
{
  const glm::dvec3 none(0.0);
  const bool moved = this->Position.rate != none || this->Turn.rate != none ||
                     this->Position.value != this->Newest().pose.position ||
                     this->Turn.value != none;
  this->Poses[0] = { timeS, this->Newest().pose };
  this->Count = 1;
  this->Fit();
  return moved;
}

void HeadPoseHistory::Fit()
{
  const TimedHeadPose& newest = this->Newest();
  std::size_t first = this->Count - 1;
  while (first > 0)
  {
    const double age = newest.timeS - this->Poses[first - 1].timeS;
    if (age > OldestS || (age > this->FitS && this->Count - first >= EnoughPoses))
      break;
    --first;
  }
  std::array<double, MostMotionSamples> times{};
  std::array<glm::dvec3, MostMotionSamples> positions, turns;
  const glm::dquat back = glm::conjugate(newest.pose.orientation);
  const std::size_t count = this->Count - first;
  for (std::size_t n = 0; n < count; ++n)
  {
    const TimedHeadPose& pose = this->Poses[first + n];
    times[n] = pose.timeS - newest.timeS;
    positions[n] = pose.pose.position;
    turns[n] = RotationVector(pose.pose.orientation * back);
  }
  const std::span<const double> t(times.data(), count);
  this->Position = FitEvenMotion(t, std::span(positions).first(count), FloorMm, LeastSpanS);
  this->Turn = FitEvenMotion(t, std::span(turns).first(count), FloorRad, LeastSpanS);
}

HeadPose HeadPoseHistory::Predict(double timeS, const PredictionLimits& limits) const
{
  const double ahead = std::clamp(timeS - this->Newest().timeS, 0.0, limits.timeS);
  const glm::dvec3 turn = this->Turn.value + AtMost(this->Turn.rate * ahead, limits.angleRad);
  return { this->Position.value + AtMost(this->Position.rate * ahead, limits.lengthMm),
    glm::normalize(FromRotationVector(turn) * this->Newest().pose.orientation) };
}

} // namespace hasp
