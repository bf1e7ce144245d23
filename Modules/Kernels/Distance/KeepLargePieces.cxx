#include "Distance/Coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
enum : std::uint8_t
{
  Outside = 0,
  Kept = 1,
  Unseen = 2
};

/// Collects the piece that holds `start` and leaves its samples marked Kept.
void Flood(const glm::ivec3& dims, std::vector<std::uint8_t>& mark, std::size_t start,
  std::vector<std::size_t>& piece)
{
  const std::size_t row = dims.x, slice = row * dims.y;
  std::array<std::size_t, 27> around; // of a sample that is not at the border; wraps below 0
  for (std::size_t n = 0; n < around.size(); ++n)
    around[n] = (n / 9 - 1) * slice + (n / 3 % 3 - 1) * row + (n % 3 - 1);
  const auto visit = [&](std::size_t q)
  {
    if (mark[q] != Unseen)
      return;
    mark[q] = Kept;
    piece.push_back(q);
  };
  piece.assign(1, start);
  mark[start] = Kept;
  for (std::size_t n = 0; n < piece.size(); ++n)
  {
    const std::size_t p = piece[n];
    const int i = static_cast<int>(p % row), j = static_cast<int>(p / row % dims.y),
              k = static_cast<int>(p / slice);
    if (i > 0 && i + 1 < dims.x && j > 0 && j + 1 < dims.y && k > 0 && k + 1 < dims.z)
    {
      for (const std::size_t step : around)
        visit(p + step);
      continue;
    }
    for (int z = std::max(k - 1, 0); z <= std::min(k + 1, dims.z - 1); ++z)
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, dims.y - 1); ++y)
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, dims.x - 1); ++x)
          visit(z * slice + y * row + x);
  }
}
} // namespace

std::vector<std::uint8_t> KeepLargePieces(
  const AnyGridView& source, double isovalue, double leastMm3, const ProgressFunction& progress)
{
  const GridGeometry& geometry = GeometryOf(source);
  geometry.Validate();
  if (!std::isfinite(isovalue) || !(leastMm3 >= 0.0))
    throw std::invalid_argument("pieces: the isovalue must be finite and the least volume, " +
                                std::to_string(leastMm3) + " mm3, at least 0");
  std::vector<std::uint8_t> mark(geometry.Size());
  std::visit(
    [&](const auto& view)
    {
      for (std::size_t p = 0; p < mark.size(); ++p)
        mark[p] = double(view.data[p]) >= isovalue ? Unseen : Outside;
    },
    source);
  ReportProgress(progress, 0.2);
  const double voxel = geometry.spacing.x * geometry.spacing.y * geometry.spacing.z;
  std::vector<std::size_t> piece;
  std::vector<std::uint8_t> result(mark.size(), 0);
  const std::size_t step = mark.size() / 50 + 1; // samples between two reports
  for (std::size_t p = 0; p < mark.size(); ++p)
  {
    if (p % step == 0) // not at every piece: noise has millions
      ReportProgress(progress, 0.2 + 0.8 * double(p) / double(mark.size()));
    if (mark[p] != Unseen)
      continue;
    Flood(geometry.dims, mark, p, piece);
    if (double(piece.size()) * voxel >= leastMm3)
      for (const std::size_t q : piece)
        result[q] = 1;
  }
  ReportProgress(progress, 1.0);
  return result;
}

} // namespace hasp
