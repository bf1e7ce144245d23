#include "Devices/Drivers/ForceTrial.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr std::array<glm::dvec3, 6> Directions{ glm::dvec3(1, 0, 0), { -1, 0, 0 }, { 0, 1, 0 },
  { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
constexpr double EachS = 1.0;
constexpr double LeastShare = 0.1, MostShare = 10.0, LeastSpan = 2.0;
constexpr std::size_t LeastReadings = 3;

double NewtonOf(const ForceTrial& trial) noexcept
{
  return std::isfinite(trial.newton) ? std::clamp(trial.newton, 0.0, ForceTrial::mostN) : 0.0;
}

Wrench AlongAxes(double newton, double heldS) noexcept
{
  const double turn = heldS / EachS;
  const auto axis = static_cast<std::size_t>(std::fmod(std::floor(turn), Directions.size()));
  const double sine = std::sin(glm::pi<double>() * (turn - std::floor(turn)));
  return { Directions[axis] * (newton * sine * sine), {} };
}

Wrench Along(const glm::dvec3& direction, double newton) noexcept
{
  const double length = glm::length(direction);
  if (!(length > 0.0) || !std::isfinite(length))
    return {};
  return { direction * (newton / length), {} };
}
} // namespace

Wrench WrenchOf(const ForceTrial& trial, double heldS) noexcept
{
  if (!(heldS > 0.0) || !std::isfinite(heldS))
    return {};
  switch (trial.kind)
  {
    case ForceTrial::Kind::Axes:
      return AlongAxes(NewtonOf(trial), heldS);
    case ForceTrial::Kind::Steady:
      return Along(trial.direction, NewtonOf(trial));
    default:
      return {};
  }
}

ScaleFit FitScale(std::span<const ScaleReading> readings)
{
  if (readings.size() < LeastReadings)
    throw std::invalid_argument("a spring scale has to be read " + std::to_string(LeastReadings) +
                                " times or more, not " + std::to_string(readings.size()));
  double saidSaid = 0.0, saidRead = 0.0;
  double least = readings.front().saidN, most = least;
  for (const auto& [said, read] : readings)
  {
    if (!(said > 0.0) || !(read > 0.0) || !std::isfinite(said) || !std::isfinite(read))
      throw std::invalid_argument("a reading of a spring scale is " + std::to_string(read) +
                                  " N where " + std::to_string(said) +
                                  " N were asked for; both must be positive");
    saidSaid += said * said;
    saidRead += said * read;
    least = std::min(least, said);
    most = std::max(most, said);
  }
  if (most < LeastSpan * least)
    throw std::invalid_argument("the forces that were read have to lie further apart: the largest"
                                " at least twice the smallest");
  ScaleFit fit{ .share = saidRead / saidSaid };
  if (!(fit.share >= LeastShare && fit.share <= MostShare))
    throw std::invalid_argument("the scale read " + std::to_string(fit.share) +
                                " times what was asked for, must be 0.1 to 10: is it in newton, and"
                                " along the axis that is pushed?");
  for (const auto& [said, read] : readings)
  {
    const double off = std::abs(read - fit.share * said);
    fit.rmsN += off * off;
    fit.worstN = std::max(fit.worstN, off);
  }
  fit.rmsN = std::sqrt(fit.rmsN / static_cast<double>(readings.size()));
  return fit;
}

} // namespace hasp
