#pragma once
#include "Reduction/FractureFit.h"

#include <Eigen/Dense>

#include <vector>

namespace hasp
{

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Column6 = Eigen::Matrix<double, 6, 1>;

/// A group's own unknowns y: a shift and turn x about the middle of its surface (world axes; mm,
/// rad) is toPose y, and a way |y| of 1 moves its surface by 1 mm rms, whatever its direction.
struct GroupUnknowns
{
  glm::dvec3 middle; ///< world
  Matrix6 toPose, fromPose;
};

/// A small shift and turn about one place, as about another that lies by `arm` from it.
Matrix6 CarriedBy(const glm::dvec3& arm);

GroupUnknowns UnknownsOf(const SpreadUnit& unit);

/// What a unit's pull is made of before one other, in the unit's unknowns. All for small ways.
struct PairPull
{
  Matrix6 stiffness;            ///< minus the pull's derivative, symmetric
  std::vector<Column6> patches; ///< pulls of residuals, those within 5 mm as one: they err together
  Column6 gap;                  ///< pull of a gap of 1 mm between all faces
};

PairPull MeasurePairPull(const SpreadUnit& unit, const GroupUnknowns& unknowns,
  const FitScene& other, const FitSettings& settings);

} // namespace hasp
