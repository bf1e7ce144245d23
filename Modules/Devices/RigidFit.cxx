#include "Devices/RigidFit.h"

#include <glm/geometric.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr std::size_t LeastPairs = 3, MostPairs = 10'000;
constexpr double MostMm = 1e6;
constexpr double LeastWidth =
  0.02; ///< of the length; below, a turn about the line is anybody's guess
/// A mirror image is refused where mirroring would leave so much smaller residuals. Noise alone, on
/// points that lie in a plane, does that in less than one of a thousand calibrations.
constexpr double MirrorGain = 5.0;

template <class Text>
[[noreturn]] void Refuse(const RigidFitWords& words, const Text& write)
{
  std::ostringstream text;
  text << words.what << ": ";
  write(text);
  throw std::invalid_argument(text.str());
}

/// Points less their mean, a column each.
struct Cloud
{
  Eigen::Vector3d mean;
  Eigen::Matrix3Xd centred;
  Eigen::Vector3d spread; ///< root of the sum of squares along the principal axes, largest first
};

Eigen::Vector3d ToEigen(const glm::dvec3& v)
{
  return { v.x, v.y, v.z };
}

Cloud MakeCloud(std::span<const PointPair> pairs, glm::dvec3 PointPair::*side)
{
  Cloud cloud;
  cloud.centred.resize(3, static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t n = 0; n < pairs.size(); ++n)
    cloud.centred.col(static_cast<Eigen::Index>(n)) = ToEigen(pairs[n].*side);
  cloud.mean = cloud.centred.rowwise().mean();
  cloud.centred.colwise() -= cloud.mean;
  cloud.spread = Eigen::JacobiSVD<Eigen::Matrix3Xd>(cloud.centred).singularValues();
  return cloud;
}

void CheckSpread(const Cloud& cloud, const RigidFitWords& words, const char* where)
{
  const double root = std::sqrt(static_cast<double>(cloud.centred.cols()));
  const double length = cloud.spread[0] / root, width = cloud.spread[1] / root;
  if (length <= 1e-12 * cloud.mean.norm()) // what rounding leaves
    Refuse(words, [&](auto& text) { text << where << " all points are the same"; });
  if (!(width >= LeastWidth * length))
    Refuse(words,
      [&](auto& text)
      {
        text << where << " the points lie almost on a line: spread " << width
             << " mm across it and " << length << " mm along it, must be at least " << LeastWidth
             << " of that; add a point well off the line";
      });
}

void CheckPairs(std::span<const PointPair> pairs, const RigidFitWords& words)
{
  if (pairs.size() < LeastPairs || pairs.size() > MostPairs)
    Refuse(words,
      [&](auto& text)
      {
        text << "there are " << pairs.size() << " pairs of points, must be in [" << LeastPairs
             << ", " << MostPairs << "]";
      });
  for (std::size_t n = 0; n < pairs.size(); ++n)
    for (const double value : { pairs[n].from.x, pairs[n].from.y, pairs[n].from.z, pairs[n].to.x,
           pairs[n].to.y, pairs[n].to.z })
      if (!(std::abs(value) <= MostMm))
        Refuse(words, [&](auto& text)
          { text << "pair " << n + 1 << " holds " << value << ", must be within " << MostMm; });
}

double Rms(const Cloud& from, const Cloud& to, const Eigen::Matrix3d& rotation)
{
  return std::sqrt(
    (to.centred - rotation * from.centred).squaredNorm() / static_cast<double>(to.centred.cols()));
}
} // namespace

RigidFit FitRigid(std::span<const PointPair> pairs, const RigidFitWords& words)
{
  CheckPairs(pairs, words);
  const Cloud from = MakeCloud(pairs, &PointPair::from), to = MakeCloud(pairs, &PointPair::to);
  CheckSpread(from, words, words.from);
  CheckSpread(to, words, words.to);

  // The orthogonal matrix nearest to the correlation, and with det +1 by turning its least axis.
  const Eigen::Matrix3d correlation = to.centred * from.centred.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d &u = svd.matrixU(), &v = svd.matrixV();
  Eigen::Vector3d signs(1, 1, (u * v.transpose()).determinant() < 0.0 ? -1 : 1);
  const Eigen::Matrix3d rotation = u * signs.asDiagonal() * v.transpose();
  const double rms = Rms(from, to, rotation), mirrored = Rms(from, to, u * v.transpose());
  if (signs[2] < 0.0 && rms > MirrorGain * mirrored && rms > 1e-6 * to.spread.norm())
    Refuse(words,
      [&](auto& text)
      {
        text << "one side is the mirror image of the other: residual " << rms << " mm as they are, "
             << mirrored << " mm with an axis turned round. Is " << words.whose
             << "'s frame left-handed, or were points mixed up?";
      });

  RigidFit fit;
  const Eigen::Quaterniond q(rotation);
  const Eigen::Vector3d at = to.mean - rotation * from.mean;
  fit.turn = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
  fit.shift = { at.x(), at.y(), at.z() };
  const Eigen::Matrix3Xd apart = to.centred - rotation * from.centred;
  for (Eigen::Index n = 0; n < apart.cols(); ++n)
    fit.residualsMm.push_back(apart.col(n).norm());
  fit.rmsMm = rms;
  fit.spreadRatio = to.spread.norm() / from.spread.norm();
  return fit;
}

} // namespace hasp
