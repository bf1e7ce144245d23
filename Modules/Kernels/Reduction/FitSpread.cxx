#include "Grid/ParallelFor.h"
#include "Reduction/PairPull.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace hasp
{

namespace
{
using Matrix = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

constexpr double LooseMm = 10.0;   // of a direction that nothing holds
constexpr double LeastHeld = 1e-3; // of the stiffest direction of those that move
constexpr int Draws = 2000;

/// Of all units at once, in their unknowns on end: what holds them, and what may have moved them.
struct JointPull
{
  Matrix stiffness, squares;
  Column gap;
};

/// As few patches as there are unknowns would seem to fit without error.
double FewPatches(std::size_t count)
{
  return count > 7 ? double(count) / (double(count) - 6.0) : 7.0;
}

/// A small way of the other unit, as the way of this one that it does as much as: in the unknowns
/// of each. The pull on the other one is the transpose's, negative.
Matrix6 AsOwnWay(const GroupUnknowns& unknowns, const GroupUnknowns& others)
{
  return unknowns.fromPose * CarriedBy(unknowns.middle - others.middle) * others.toPose;
}

JointPull SumPulls(std::span<const SpreadPair> pairs, const std::vector<GroupUnknowns>& unknowns,
  const std::vector<PairPull>& pulls)
{
  const Eigen::Index size = 6 * Eigen::Index(unknowns.size());
  JointPull sum{ Matrix::Zero(size, size), Matrix::Zero(size, size), Column::Zero(size) };
  std::vector<std::size_t> patches(unknowns.size());
  for (std::size_t n = 0; n < pairs.size(); ++n)
  {
    patches[pairs[n].unit] += pulls[n].patches.size();
    if (pairs[n].other)
      patches[*pairs[n].other] += pulls[n].patches.size();
  }
  for (std::size_t n = 0; n < pairs.size(); ++n)
  {
    const auto& [unit, other, scene] = pairs[n];
    const Eigen::Index own = 6 * Eigen::Index(unit), its = other ? 6 * Eigen::Index(*other) : own;
    Eigen::Matrix<double, 6, Eigen::Dynamic> way = Matrix::Zero(6, other ? 12 : 6);
    way.leftCols<6>().setIdentity(); // of one before the other
    double few = FewPatches(patches[unit]);
    if (other)
    {
      way.rightCols<6>() = -AsOwnWay(unknowns[unit], unknowns[*other]);
      few = std::max(few, FewPatches(patches[*other]));
    }
    Matrix6 squares = Matrix6::Zero();
    for (const Column6& pull : pulls[n].patches)
      squares += few * pull * pull.transpose();
    const auto spread = [&](Matrix& to, const Matrix6& of)
    {
      const Matrix all = way.transpose() * of * way;
      for (Eigen::Index row = 0; row < all.rows(); row += 6)
        for (Eigen::Index column = 0; column < all.cols(); column += 6)
          to.block<6, 6>(row == 0 ? own : its, column == 0 ? own : its) +=
            all.block<6, 6>(row, column);
    };
    spread(sum.stiffness, pulls[n].stiffness);
    spread(sum.squares, squares);
    const Column gap = way.transpose() * pulls[n].gap;
    sum.gap.segment<6>(own) += gap.head<6>();
    if (other)
      sum.gap.segment<6>(its) += gap.tail<6>();
  }
  return sum;
}

/// What holds those best that move along each axis: a chip is as stiff as its own small faces are,
/// whatever else is put together.
Column StiffestAlong(const Matrix& axes, const Matrix& stiffness)
{
  Column stiffest = Column::Zero(axes.cols());
  for (Eigen::Index own = 0; own < axes.rows(); own += 6)
  {
    const Matrix6 block = stiffness.block<6, 6>(own, own);
    const Eigen::SelfAdjointEigenSolver<Matrix6> held(block, Eigen::EigenvaluesOnly);
    stiffest += std::max(held.eigenvalues().maxCoeff(), 0.0) *
                axes.middleRows<6>(own).colwise().squaredNorm().transpose();
  }
  return stiffest;
}

/// Covariance along axes that hold by `held` each: a sandwich.
Matrix CovarianceOf(
  const Column& held, const Column& stiffest, const Matrix& squares, const Column& gap)
{
  const auto holds = [&](Eigen::Index axis) { return held[axis] > LeastHeld * stiffest[axis]; };
  Matrix covariance = Matrix::Zero(held.size(), held.size());
  for (Eigen::Index row = 0; row < held.size(); ++row)
    for (Eigen::Index column = 0; column < held.size(); ++column)
      if (holds(row) && holds(column))
        covariance(row, column) =
          (squares(row, column) + gap[row] * gap[column]) / (held[row] * held[column]);
  for (Eigen::Index row = 0; row < held.size(); ++row)
    if (!holds(row) || covariance(row, row) > LooseMm * LooseMm)
    {
      covariance.row(row).setZero();
      covariance.col(row).setZero();
      covariance(row, row) = LooseMm * LooseMm;
    }
  return covariance;
}

double Quantile95(std::vector<double>& values)
{
  const auto at = values.begin() + std::ptrdiff_t(0.95 * double(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Quantiles of ways (mm) and turns (degrees): a sum of squares of different widths has no closed
/// form.
FitSpread SpreadOf(const Matrix6& covariance, const Matrix6& toPose)
{
  FitSpread spread;
  const Matrix6 pose = toPose * covariance * toPose.transpose();
  std::size_t entry = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      spread.covariance[entry++] = pose(row, column);
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
    const Column6 way = root * draw;
    mm.push_back(way.norm());
    degrees.push_back((toPose * way).tail<3>().norm() * 180.0 / M_PI);
  }
  spread.within95Mm = Quantile95(mm);
  spread.within95Degrees = std::min(180.0, Quantile95(degrees));
  return spread;
}
} // namespace

std::vector<FitSpread> MeasureSpreads(std::span<const SpreadUnit> units,
  std::span<const SpreadPair> pairs, const FitSettings& settings, double gapMm, double factor)
{
  if (units.empty())
    return {};
  std::vector<GroupUnknowns> unknowns;
  for (const SpreadUnit& unit : units)
    unknowns.push_back(UnknownsOf(unit));
  std::vector<PairPull> pulls(pairs.size());
  ParallelFor(0, std::int64_t(pairs.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        pulls[n] =
          MeasurePairPull(units[pairs[n].unit], unknowns[pairs[n].unit], pairs[n].scene, settings);
    });
  const JointPull sum = SumPulls(pairs, unknowns, pulls);
  const Eigen::SelfAdjointEigenSolver<Matrix> held(sum.stiffness);
  const Matrix& axes = held.eigenvectors();
  const Matrix covariance =
    factor * factor *
    CovarianceOf(held.eigenvalues(), StiffestAlong(axes, sum.stiffness),
      axes.transpose() * sum.squares * axes, gapMm * (axes.transpose() * sum.gap));
  std::vector<FitSpread> spreads;
  for (std::size_t n = 0; n < units.size(); ++n)
  {
    const auto own = axes.middleRows<6>(6 * Eigen::Index(n));
    spreads.push_back(SpreadOf(own * covariance * own.transpose(),
      CarriedBy(units[n].groupInWorld.position - unknowns[n].middle) * unknowns[n].toPose));
  }
  return spreads;
}

void MeasureSpread(std::span<const GroupBody> moved, const FitScene& scene,
  const FitSettings& settings, FractureFit& fit, double gapMm, double factor)
{
  const SpreadUnit unit{ moved, fit.groupInWorld };
  const SpreadPair before{ 0, {}, scene };
  fit.spread = MeasureSpreads({ &unit, 1 }, { &before, 1 }, settings, gapMm, factor)[0];
}

} // namespace hasp
