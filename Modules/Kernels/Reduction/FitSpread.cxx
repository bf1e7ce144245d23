#include "Reduction/FractureFit.h"

#include <Eigen/Dense>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

namespace hasp
{

namespace
{
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Column6 = Eigen::Matrix<double, 6, 1>;

constexpr double TogetherMm = 5.0; // residuals nearer to each other err together
constexpr double LooseMm = 10.0;   // of a direction that nothing holds
constexpr double LeastHeld = 1e-3; // of the stiffest direction
constexpr double TriedMm = 0.25;
constexpr int Draws = 2000;

Column6 ColumnOf(const Vector6& v)
{
  return Eigen::Map<const Column6>(v.data());
}

/// What residuals scatter by: sums of their pulls, those that are together first.
struct Scatter
{
  Matrix6 squares = Matrix6::Zero();
  Column6 gap = Column6::Zero(); ///< pull of a gap of 1 mm between all faces
};

Scatter ScatterOf(std::span<const FitResidual> residuals)
{
  Scatter made;
  std::map<std::tuple<int, int, int, bool>, Column6> boxes;
  for (const FitResidual& r : residuals)
  {
    const Column6 j = ColumnOf(r.slope);
    const glm::ivec3 box(glm::floor(r.place / TogetherMm));
    boxes.try_emplace({ box.x, box.y, box.z, r.face }, Column6::Zero()).first->second +=
      r.weight * r.mm * j;
    if (r.face)
      made.gap += r.weight * j;
  }
  for (const auto& [box, pull] : boxes)
    made.squares += pull * pull.transpose();
  // As few boxes as there are unknowns would seem to fit without error.
  const double count = double(boxes.size());
  made.squares *= count > 7.0 ? count / (count - 6.0) : 7.0;
  return made;
}

/// Mean over the group's surface of |way|^2 for a small shift and turn: way = x^T M x.
Matrix6 MeanSquares(std::span<const GroupBody> moved, const RigidPose& pose)
{
  Matrix6 mean = Matrix6::Zero();
  double area = 0.0;
  for (const GroupBody& body : moved)
  {
    const RigidPose placed = pose * body.bodyInGroup;
    const glm::dvec3 c = placed.Place(body.body->Centroid()) - pose.position;
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

double Quantile95(std::vector<double>& values)
{
  const auto at = values.begin() + std::ptrdiff_t(0.95 * double(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}
} // namespace

namespace
{
/// A group at a fit, moved by small ways.
class AroundFit
{
public:
  AroundFit(std::span<const GroupBody> moved, const FitScene& scene, const FitSettings& settings,
    const RigidPose& pose)
    : Moved(moved),
      Scene(scene),
      Settings(settings),
      Pose(pose)
  {
  }

  /// The pull about the fit's own origin, after a shift and turn.
  Column6 PullAt(const Column6& way, std::vector<FitResidual>* residuals = nullptr) const
  {
    const RigidPose pose{ this->Pose.position + glm::dvec3(way[0], way[1], way[2]),
      glm::normalize(TurnBy({ way[3], way[4], way[5] }) * this->Pose.orientation) };
    std::vector<PlacedBody> placed;
    for (const GroupBody& body : this->Moved)
      placed.push_back({ body.body, pose * body.bodyInGroup });
    return ColumnOf(SumFit(placed, this->Pose.position, this->Scene, this->Settings.law,
      std::size_t(this->Settings.points), residuals)
                      .pull);
  }

  /// How the pull changes along the six columns, by central differences: what really holds the
  /// fit. The fit's own matrix says more: the pulls on the two ends of a smooth face hold against
  /// each other, and go along when it slides.
  Matrix6 Stiffness(const Matrix6& ways) const
  {
    Matrix6 stiffness;
    for (int column = 0; column < 6; ++column)
    {
      const Column6 way = TriedMm * ways.col(column);
      stiffness.col(column) =
        ways.transpose() * (this->PullAt(-way) - this->PullAt(way)) / (2.0 * TriedMm);
    }
    return 0.5 * (stiffness + stiffness.transpose());
  }

private:
  std::span<const GroupBody> Moved;
  const FitScene& Scene;
  const FitSettings& Settings;
  RigidPose Pose;
};

/// Covariance in axes along which a way of 1 is 1 mm rms, from what holds along them.
Matrix6 CovarianceOf(const Column6& held, const Matrix6& squares, const Column6& gap)
{
  const double largest = std::max(held.maxCoeff(), 0.0);
  const auto holds = [&](int axis) { return held[axis] > LeastHeld * largest; };
  Matrix6 covariance = Matrix6::Zero();
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      if (holds(row) && holds(column))
        covariance(row, column) =
          (squares(row, column) + gap[row] * gap[column]) / (held[row] * held[column]);
  for (int row = 0; row < 6; ++row)
    if (!holds(row) || covariance(row, row) > LooseMm * LooseMm)
    {
      covariance.row(row).setZero();
      covariance.col(row).setZero();
      covariance(row, row) = LooseMm * LooseMm;
    }
  return covariance;
}

/// Quantiles of ways (mm) and turns (degrees): a sum of squares of different widths has no closed
/// form.
void DrawQuantiles(const Matrix6& covariance, const Matrix6& toPose, FitSpread& spread)
{
  const Eigen::SelfAdjointEigenSolver<Matrix6> widths(covariance);
  const Matrix6 root =
    widths.eigenvectors() * widths.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  std::vector<double> mm, degrees;
  for (int n = 0; n < Draws; ++n)
  {
    Column6 draw;
    for (int k = 0; k < 6; ++k)
      draw[k] = normal(engine);
    const Column6 way = root * draw, pose = toPose * way;
    mm.push_back(way.norm());
    degrees.push_back(pose.tail<3>().norm() * 180.0 / M_PI);
  }
  spread.within95Mm = Quantile95(mm);
  spread.within95Degrees = std::min(180.0, Quantile95(degrees));
}
} // namespace

void MeasureSpread(std::span<const GroupBody> moved, const FitScene& scene,
  const FitSettings& settings, FractureFit& fit, double gapMm, double factor)
{
  const AroundFit around(moved, scene, settings, fit.groupInWorld);
  std::vector<FitResidual> residuals;
  around.PullAt(Column6::Zero(), &residuals);
  const Scatter scatter = ScatterOf(residuals);
  const Matrix6 mean = MeanSquares(moved, fit.groupInWorld);
  // mean = L L^T: in the unknowns y of x = L^-T y a way of 1 is 1 mm, whatever its direction.
  const Eigen::LLT<Matrix6> ways(mean + 1e-9 * mean.trace() * Matrix6::Identity());
  const Matrix6 toPose = ways.matrixU().solve(Matrix6::Identity());
  const Eigen::SelfAdjointEigenSolver<Matrix6> held(around.Stiffness(toPose));
  const Matrix6 toAxes = toPose * held.eigenvectors();
  const Matrix6 covariance =
    factor * factor *
    CovarianceOf(held.eigenvalues(), toAxes.transpose() * scatter.squares * toAxes,
      gapMm * (toAxes.transpose() * scatter.gap));
  const Matrix6 pose = toAxes * covariance * toAxes.transpose();
  std::size_t entry = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      fit.spread.covariance[entry++] = pose(row, column);
  DrawQuantiles(covariance, toAxes, fit.spread);
}

} // namespace hasp
