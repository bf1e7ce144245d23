#include "ImplantRim.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double LeastFacing = 0.5; // cosine, to the axis
constexpr std::size_t LeastPlaces = 20;
constexpr double CountedShare = 0.6; // of the places: the rest may be sunk or broken
constexpr double LeastFarthestMm = 0.3;
constexpr double MatchedMm = 2.0;
constexpr double MostShiftMm = 6.0, MostTiltDeg = 8.0;

RigidPose About(const glm::dvec3& middle, const glm::dvec3& shift, const glm::dvec3& turn)
{
  const glm::dquat orientation = TurnBy(turn);
  return { middle + shift - orientation * middle, orientation };
}

std::vector<double> Sizes(
  const ImplicitSolid& mirrored, std::span<const glm::dvec3> places, const RigidPose& pose)
{
  const RigidPose back = pose.Inverse();
  std::vector<double> sizes;
  for (const glm::dvec3& p : places)
    sizes.push_back(std::abs(mirrored.At(back.Place(p))));
  return sizes;
}

/// At a share of them.
double Quantile(std::vector<double> values, double share)
{
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Along the axis, and about the two others.
glm::dvec3 Step(const ImplicitSolid& mirrored, std::span<const glm::dvec3> places,
  const glm::dmat3& axes, const glm::dvec3& middle, const RigidPose& pose)
{
  const std::vector<double> sizes = Sizes(mirrored, places, pose);
  const double farthest = std::max(Quantile(sizes, CountedShare), LeastFarthestMm);
  const RigidPose back = pose.Inverse();
  glm::dmat3 squares(1e-9);
  glm::dvec3 sides(0.0);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    if (sizes[n] > farthest)
      continue;
    const ImplicitSolid::Sample s = mirrored.SampleAt(back.Place(places[n]));
    const glm::dvec3 gradient = pose.Turn(s.gradient);
    const glm::dvec3 lever = glm::cross(places[n] - middle, gradient);
    const glm::dvec3 row(
      glm::dot(gradient, axes[2]), glm::dot(lever, axes[0]), glm::dot(lever, axes[1]));
    squares += glm::outerProduct(row, row);
    sides += s.value * row;
  }
  return glm::inverse(squares) * sides;
}

void Check(const LaidTable& laid, const std::vector<double>& sizes)
{
  const auto matched =
    std::count_if(sizes.begin(), sizes.end(), [](double mm) { return mm <= MatchedMm; });
  std::ostringstream text;
  text.precision(3);
  if (2 * std::size_t(matched) < sizes.size())
    text << "only " << 100.0 * double(matched) / double(sizes.size())
         << " % of the outer table around the outline come to lie within " << MatchedMm
         << " mm of it";
  else if (std::abs(laid.shiftMm) > MostShiftMm || laid.tiltDeg > MostTiltDeg)
    text << "it would have to be moved by " << laid.shiftMm << " mm and " << laid.tiltDeg
         << " degrees, at most " << MostShiftMm << " and " << MostTiltDeg << " are allowed";
  else
    return;
  throw std::runtime_error("implant: mirrored bone does not meet the bone around the hole: " +
                           text.str() + "; give another mirror plane, or another outline");
}
} // namespace

std::vector<glm::dvec3> RimPlaces(
  const ImplicitSolid& bone, const ColumnLayer& depth, double outsideMm)
{
  const GridGeometry& grid = depth.grid;
  std::vector<glm::dvec3> places;
  for (std::size_t n = 0; n < depth.values.size(); ++n)
  {
    if (!(depth.values[n] <= 0.0F && depth.values[n] >= -outsideMm))
      continue;
    const glm::dvec2 column = depth.Place(n);
    const auto at = [&](double z) { return grid.origin + grid.direction * glm::dvec3(column, z); };
    double z = grid.spacing.z * grid.Cells().z, above = bone.At(at(z));
    while (above > 0.0 && z > 0.0)
    {
      const double next = z - std::max(0.5 * grid.spacing.z, 0.5 * above),
                   value = bone.At(at(next));
      if (value <= 0.0)
      {
        const glm::dvec3 p = at(glm::mix(z, next, above / (above - value)));
        if (glm::dot(bone.SampleAt(p).gradient, grid.direction[2]) >= LeastFacing)
          places.push_back(p);
      }
      z = next;
      above = value;
    }
  }
  return places;
}

LaidTable LayOnRim(
  const ImplicitSolid& mirrored, std::span<const glm::dvec3> places, const glm::dmat3& axes)
{
  if (places.size() < LeastPlaces)
    throw std::runtime_error("implant: there is no outer table around the outline to lay the "
                             "mirrored side on; go around the hole on the outside of the skull");
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : places)
    middle += p / double(places.size());
  LaidTable laid;
  for (int n = 0; n < 30; ++n)
  {
    const glm::dvec3 step = Step(mirrored, places, axes, middle, laid.pose);
    // A bad start shall not throw it off.
    const double size =
      std::max({ std::abs(step.x) / 2.0, std::abs(step.y) / 0.05, std::abs(step.z) / 0.05 });
    const glm::dvec3 held = step / std::max(size, 1.0);
    laid.pose = About(middle, held.x * axes[2], held.y * axes[0] + held.z * axes[1]) * laid.pose;
    if (size < 1e-5)
      break;
  }
  laid.shiftMm = glm::dot(laid.pose.Place(middle) - middle, axes[2]);
  laid.tiltDeg = glm::degrees(glm::length(RotationVector(laid.pose.orientation)));
  const std::vector<double> sizes = Sizes(mirrored, places, laid.pose);
  Check(laid, sizes);
  for (const double mm : sizes)
    laid.rmsMm += mm * mm / double(sizes.size());
  laid.rmsMm = std::sqrt(laid.rmsMm);
  laid.p95Mm = Quantile(sizes, 0.95);
  return laid;
}

} // namespace hasp
