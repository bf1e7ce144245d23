#include "BallScan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <stdexcept>

namespace
{

constexpr double HalfEdgeMm = 1.0; ///< from tissue to bone

double Distance(const BallScan::Place& a, const BallScan::Place& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

double BallScan::ValueAt(const Place& place) const
{
  const double across =
    std::hypot(place[0] / this->half[0], place[1] / this->half[1], place[2] / this->half[2]);
  const double around = across < 0.95 ? Tissue : Air;
  double inside = -HalfEdgeMm; // the surface of a ball
  for (const Place& ball : this->balls)
    inside = std::max(inside, RadiusMm - Distance(ball, place));
  return around + std::min(1.0, 0.5 + 0.5 * inside / HalfEdgeMm) * (Bone - around);
}

void BallScan::Write(const std::filesystem::path& file) const
{
  const auto [x, y, z] = this->half;
  std::vector<std::int16_t> samples;
  std::mt19937 dice(7);
  for (int k = -z; k <= z; ++k)
    for (int j = -y; j <= y; ++j)
      for (int i = -x; i <= x; ++i)
      {
        const double value = this->ValueAt({ double(i), double(j), double(k) });
        samples.push_back(std::int16_t(std::lround(value) + int(dice() % (2 * Noise + 1)) - Noise));
      }
  std::ofstream out(file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      << "Offset = " << -x << ' ' << -y << ' ' << -z << "\nDimSize = " << 2 * x + 1 << ' '
      << 2 * y + 1 << ' ' << 2 * z + 1
      << "\nElementSpacing = 1 1 1\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  out.write(reinterpret_cast<const char*>(samples.data()),
    std::streamsize(samples.size() * sizeof samples[0]));
  if (!out.flush())
    throw std::runtime_error("the scan of balls cannot be written");
}
