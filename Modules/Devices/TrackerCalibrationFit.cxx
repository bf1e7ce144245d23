#include "Devices/TrackerCalibration.h"

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
[[noreturn]] void Refuse(const Text& write)
{
  std::ostringstream text;
  text << "tracker calibration: ";
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

Cloud MakeCloud(std::span<const CalibrationPair> pairs, glm::dvec3 CalibrationPair::*side)
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

void CheckSpread(const Cloud& cloud, const char* where)
{
  const double root = std::sqrt(static_cast<double>(cloud.centred.cols()));
  const double length = cloud.spread[0] / root, width = cloud.spread[1] / root;
  if (length <= 1e-12 * cloud.mean.norm()) // what rounding leaves
    Refuse([&](auto& text) { text << where << " all points are the same"; });
  if (!(width >= LeastWidth * length))
    Refuse(
      [&](auto& text)
      {
        text << where << " the points lie almost on a line: spread " << width
             << " mm across it and " << length << " mm along it, must be at least " << LeastWidth
             << " of that; add a point well off the line";
      });
}

void CheckPairs(std::span<const CalibrationPair> pairs)
{
  if (pairs.size() < LeastPairs || pairs.size() > MostPairs)
    Refuse(
      [&](auto& text)
      {
        text << "there are " << pairs.size() << " pairs of points, must be in [" << LeastPairs
             << ", " << MostPairs << "]";
      });
  for (std::size_t n = 0; n < pairs.size(); ++n)
    for (const double value : { pairs[n].trackerMm.x, pairs[n].trackerMm.y, pairs[n].trackerMm.z,
           pairs[n].roomMm.x, pairs[n].roomMm.y, pairs[n].roomMm.z })
      if (!(std::abs(value) <= MostMm))
        Refuse([&](auto& text)
          { text << "pair " << n + 1 << " holds " << value << ", must be within " << MostMm; });
}

double Rms(const Cloud& tracker, const Cloud& room, const Eigen::Matrix3d& rotation)
{
  return std::sqrt((room.centred - rotation * tracker.centred).squaredNorm() /
                   static_cast<double>(room.centred.cols()));
}
} // namespace

CalibrationFit FitTrackerToRoom(std::span<const CalibrationPair> pairs)
{
  CheckPairs(pairs);
  const Cloud tracker = MakeCloud(pairs, &CalibrationPair::trackerMm),
              room = MakeCloud(pairs, &CalibrationPair::roomMm);
  CheckSpread(tracker, "for the tracker");
  CheckSpread(room, "in the room");

  // The orthogonal matrix nearest to the correlation, and with det +1 by turning its least axis.
  const Eigen::Matrix3d correlation = room.centred * tracker.centred.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d &u = svd.matrixU(), &v = svd.matrixV();
  Eigen::Vector3d signs(1, 1, (u * v.transpose()).determinant() < 0.0 ? -1 : 1);
  const Eigen::Matrix3d rotation = u * signs.asDiagonal() * v.transpose();
  const double rms = Rms(tracker, room, rotation), mirrored = Rms(tracker, room, u * v.transpose());
  if (signs[2] < 0.0 && rms > MirrorGain * mirrored && rms > 1e-6 * room.spread.norm())
    Refuse(
      [&](auto& text)
      {
        text << "one side is the mirror image of the other: residual " << rms << " mm as they are, "
             << mirrored << " mm with an axis turned round. Is the tracker's"
             << " frame left-handed, or were points mixed up?";
      });

  CalibrationFit fit;
  const Eigen::Quaterniond q(rotation);
  const Eigen::Vector3d at = room.mean - rotation * tracker.mean;
  fit.calibration.trackerToRoom = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
  fit.calibration.trackerInRoomMm = { at.x(), at.y(), at.z() };
  const Eigen::Matrix3Xd apart = room.centred - rotation * tracker.centred;
  for (Eigen::Index n = 0; n < apart.cols(); ++n)
    fit.residualsMm.push_back(apart.col(n).norm());
  fit.rmsMm = rms;
  fit.spreadRatio = room.spread.norm() / tracker.spread.norm();
  return fit;
}

} // namespace hasp
