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

/// Mean over the unit's surface of |way|^2 for a small shift and turn: way^2 = x^T M x.
Matrix6 MeanSquares(const SpreadUnit& unit)
{
  Matrix6 mean = Matrix6::Zero();
  double area = 0.0;
  for (const GroupBody& body : unit.bodies)
  {
    const RigidPose placed = unit.groupInWorld * body.bodyInGroup;
    const glm::dvec3 c = placed.Place(body.body->Centroid()) - unit.groupInWorld.position;
    const glm::dmat3 turn = glm::mat3_cast(placed.orientation);
    const glm::dmat3 spread = turn * body.body->Spread() * glm::transpose(turn);
    Eigen::Matrix3d s;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        s(row, column) = spread[column][row] + c[row] * c[column];
    Eigen::Matrix3d cross; // of c: a turn t moves c by t x c = -cross t
    cross << 0, -c.z, c.y, c.z, 0, -c.x, -c.y, c.x, 0;
    const double weight = body.body->SurfaceArea();
    Matrix6 one = Matrix6::Zero();
    one.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity();
    one.topRightCorner<3, 3>() = -cross;
    one.bottomLeftCorner<3, 3>() = cross;
    one.bottomRightCorner<3, 3>() = s.trace() * Eigen::Matrix3d::Identity() - s;
    mean += weight * one;
    area += weight;
  }
  return mean / area;
}

/// The pull on the unit about its origin, after a small shift and turn.
Column6 PullAt(const SpreadUnit& unit, const Column6& way, const FitScene& other,
  const FitSettings& settings, std::vector<FitResidual>* residuals = nullptr)
{
  const RigidPose pose{ unit.groupInWorld.position + glm::dvec3(way[0], way[1], way[2]),
    glm::normalize(TurnBy({ way[3], way[4], way[5] }) * unit.groupInWorld.orientation) };
  std::vector<PlacedBody> placed;
  for (const GroupBody& body : unit.bodies)
    placed.push_back({ body.body, pose * body.bodyInGroup });
  return ColumnOf(SumFit(placed, unit.groupInWorld.position, other, settings.law,
    std::size_t(settings.points), residuals)
                    .pull);
}

/// How the pull changes along the columns, by central differences: what really holds the fit. The
/// fit's own matrix says more: the pulls on the two ends of a smooth face hold against each other,
/// and go along when it slides.
Matrix6 Stiffness(
  const SpreadUnit& unit, const Matrix6& ways, const FitScene& other, const FitSettings& settings)
{
  Matrix6 stiffness;
  for (int column = 0; column < 6; ++column)
  {
    const Column6 way = TriedMm * ways.col(column);
    stiffness.col(column) =
      ways.transpose() *
      (PullAt(unit, -way, other, settings) - PullAt(unit, way, other, settings)) / (2.0 * TriedMm);
  }
  return 0.5 * (stiffness + stiffness.transpose());
}
} // namespace

GroupUnknowns UnknownsOf(const SpreadUnit& unit)
{
  const Matrix6 mean = MeanSquares(unit);
  // mean = L L^T: with x = L^-T y, x^T mean x is |y|^2.
  const Eigen::LLT<Matrix6> root(mean + 1e-9 * mean.trace() * Matrix6::Identity());
  return { root.matrixU().solve(Matrix6::Identity()), root.matrixU() };
}

PairPull MeasurePairPull(const SpreadUnit& unit, const GroupUnknowns& unknowns,
  const FitScene& other, const FitSettings& settings)
{
  PairPull made{ Matrix6::Zero(), {}, Column6::Zero() };
  std::vector<FitResidual> residuals;
  PullAt(unit, Column6::Zero(), other, settings, &residuals);
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
  made.stiffness = Stiffness(unit, unknowns.toPose, other, settings);
  return made;
}

} // namespace hasp
