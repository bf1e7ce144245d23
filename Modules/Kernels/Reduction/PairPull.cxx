#include "Reduction/PairPull.h"

#include <glm/common.hpp>

#include <map>
#include <tuple>

namespace hasp
{

namespace
{
constexpr double TogetherMm = 5.0; // residuals nearer to each other err together
constexpr double TriedMm = 0.25;

Column6 ColumnOf(const Vector6& v)
{
  return Eigen::Map<const Column6>(v.data());
}

/// Mean over the unit's surface.
glm::dvec3 MiddleOf(const SpreadUnit& unit)
{
  glm::dvec3 middle(0.0);
  double area = 0.0;
  for (const GroupBody& body : unit.bodies)
  {
    const RigidPose placed = unit.groupInWorld * body.bodyInGroup;
    middle += body.body->SurfaceArea() * placed.Place(body.body->Centroid());
    area += body.body->SurfaceArea();
  }
  return middle / area;
}

/// Mean over the unit's surface of |way|^2 for a small shift and turn about `middle`: x^T M x.
Matrix6 MeanSquares(const SpreadUnit& unit, const glm::dvec3& middle)
{
  Matrix6 mean = Matrix6::Zero();
  double area = 0.0;
  for (const GroupBody& body : unit.bodies)
  {
    const RigidPose placed = unit.groupInWorld * body.bodyInGroup;
    const glm::dvec3 c = placed.Place(body.body->Centroid()) - middle;
    const glm::dmat3 turn = glm::mat3_cast(placed.orientation);
    const glm::dmat3 spread = turn * body.body->Spread() * glm::transpose(turn);
    Eigen::Matrix3d s;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        s(row, column) = spread[column][row] + c[row] * c[column];
    const Eigen::Matrix3d carry = CarriedBy(c).topRightCorner<3, 3>();
    const double weight = body.body->SurfaceArea();
    Matrix6 one = Matrix6::Zero();
    one.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity();
    one.topRightCorner<3, 3>() = carry;
    one.bottomLeftCorner<3, 3>() = carry.transpose();
    one.bottomRightCorner<3, 3>() = s.trace() * Eigen::Matrix3d::Identity() - s;
    mean += weight * one;
    area += weight;
  }
  return mean / area;
}

/// The pull on the unit about its middle, after a small shift and turn about that.
Column6 PullAt(const SpreadUnit& unit, const glm::dvec3& middle, const Column6& way,
  const FitScene& other, const FitSettings& settings, std::vector<FitResidual>* residuals = nullptr)
{
  const glm::dquat turn = TurnBy({ way[3], way[4], way[5] });
  const RigidPose& group = unit.groupInWorld;
  const RigidPose pose{ middle + glm::dvec3(way[0], way[1], way[2]) +
                          turn * (group.position - middle),
    glm::normalize(turn * group.orientation) };
  std::vector<PlacedBody> placed;
  for (const GroupBody& body : unit.bodies)
    placed.push_back({ body.body, pose * body.bodyInGroup });
  return ColumnOf(
    SumFit(placed, middle, other, settings.law, std::size_t(settings.points), residuals).pull);
}

/// How the pull changes along the columns, by central differences: what really holds the fit. The
/// fit's own matrix says more: the pulls on the two ends of a smooth face hold against each other,
/// and go along when it slides.
Matrix6 Stiffness(const SpreadUnit& unit, const GroupUnknowns& unknowns, const FitScene& other,
  const FitSettings& settings)
{
  const Matrix6& ways = unknowns.toPose;
  const auto pull = [&](const Column6& way)
  { return PullAt(unit, unknowns.middle, way, other, settings); };
  Matrix6 stiffness;
  for (int column = 0; column < 6; ++column)
  {
    const Column6 way = TriedMm * ways.col(column);
    stiffness.col(column) = ways.transpose() * (pull(-way) - pull(way)) / (2.0 * TriedMm);
  }
  return 0.5 * (stiffness + stiffness.transpose());
}
} // namespace

Matrix6 CarriedBy(const glm::dvec3& arm)
{
  Matrix6 carry = Matrix6::Identity(); // a turn t moves that place by t x arm
  carry.topRightCorner<3, 3>() << 0, arm.z, -arm.y, -arm.z, 0, arm.x, arm.y, -arm.x, 0;
  return carry;
}

GroupUnknowns UnknownsOf(const SpreadUnit& unit)
{
  const glm::dvec3 middle = MiddleOf(unit);
  const Matrix6 mean = MeanSquares(unit, middle);
  // mean = L L^T: with x = L^-T y, x^T mean x is |y|^2.
  const Eigen::LLT<Matrix6> root(mean + 1e-9 * mean.trace() * Matrix6::Identity());
  return { middle, root.matrixU().solve(Matrix6::Identity()), root.matrixU() };
}

PairPull MeasurePairPull(const SpreadUnit& unit, const GroupUnknowns& unknowns,
  const FitScene& other, const FitSettings& settings)
{
  PairPull made{ Matrix6::Zero(), {}, Column6::Zero() };
  std::vector<FitResidual> residuals;
  PullAt(unit, unknowns.middle, Column6::Zero(), other, settings, &residuals);
  if (residuals.empty()) // too far from each other
    return made;
  std::map<std::tuple<int, int, int, bool>, Column6> boxes;
  for (const FitResidual& r : residuals)
  {
    const Column6 pull = r.weight * (unknowns.toPose.transpose() * ColumnOf(r.slope));
    const glm::ivec3 box(glm::floor(r.place / TogetherMm));
    boxes.try_emplace({ box.x, box.y, box.z, r.face }, Column6::Zero()).first->second +=
      r.mm * pull;
    if (r.face)
      made.gap += pull;
  }
  for (const auto& [box, pull] : boxes)
    made.patches.push_back(pull);
  made.stiffness = Stiffness(unit, unknowns, other, settings);
  return made;
}

} // namespace hasp
