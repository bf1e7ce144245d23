#include "Grid/GreyLevels.h"
#include "Grid/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{
namespace
{

constexpr double Lowest = -4096.0, BinWidth = 10.0;
constexpr int Bins = 1230; ///< up to 8204; what is beyond goes into the last bins

using Histogram = std::array<std::int64_t, Bins>;

int BinOf(double value)
{
  return static_cast<int>(std::clamp((value - Lowest) / BinWidth, 0.0, Bins - 1.0));
}

double Middle(int bin)
{
  return Lowest + (bin + 0.5) * BinWidth;
}

struct Histograms
{
  Histogram all{}, frame{};
  /// Smallest and largest sample in each bin of the frame: a plateau of one value is padding.
  std::array<double, Bins> least, most;

  Histograms()
  {
    this->least.fill(1e300);
    this->most.fill(-1e300);
  }
  void Add(double value, bool inFrame)
  {
    const int bin = BinOf(value);
    ++this->all[bin];
    if (!inFrame)
      return;
    ++this->frame[bin];
    this->least[bin] = std::min(this->least[bin], value);
    this->most[bin] = std::max(this->most[bin], value);
  }
  void Add(const Histograms& other)
  {
    for (int b = 0; b < Bins; ++b)
    {
      this->all[b] += other.all[b];
      this->frame[b] += other.frame[b];
      this->least[b] = std::min(this->least[b], other.least[b]);
      this->most[b] = std::max(this->most[b], other.most[b]);
    }
  }
};

template <typename T>
Histograms Count(const GridView<const T>& grid)
{
  const glm::ivec3& dims = grid.geometry.dims;
  const int edgeX = std::max(1, dims.x / 25), edgeY = std::max(1, dims.y / 25);
  constexpr int slab = 16;
  std::vector<Histograms> slots((dims.z + slab - 1) / slab);
  ParallelFor(0, dims.z, slab,
    [&](std::int64_t first, std::int64_t last)
    {
      Histograms& counts = slots[first / slab];
      for (int k = static_cast<int>(first); k < last; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i)
            counts.Add(double(grid(i, j, k)),
              i < edgeX || j < edgeY || i >= dims.x - edgeX || j >= dims.y - edgeY);
    });
  Histograms all;
  for (const Histograms& slot : slots)
    all.Add(slot);
  return all;
}

/// Counts in [from, to).
double Within(const Histogram& h, double from, double to)
{
  double count = 0.0;
  for (int b = BinOf(from); b < BinOf(to); ++b)
    count += static_cast<double>(h[b]);
  return count;
}

struct Plateau
{
  double level = 0.0;
  double count = 0.0; ///< within `reach` of it
};

/// The fullest window of 2 * reach with its middle in [from, to).
Plateau FullestPlateau(const Histogram& h, double from, double to, double reach)
{
  const int wide = static_cast<int>(reach / BinWidth);
  Plateau best;
  for (int b = BinOf(from); b < BinOf(to); ++b)
  {
    double count = 0.0, sum = 0.0;
    for (int n = std::max(b - wide, 0); n <= std::min(b + wide, Bins - 1); ++n)
    {
      count += static_cast<double>(h[n]);
      sum += static_cast<double>(h[n]) * Middle(n);
    }
    if (count > best.count)
      best = { sum / count, count };
  }
  return best;
}

/// Takes plateaus of a single value below what air can be out of both histograms.
void TakePaddingOut(Histograms& h)
{
  for (int b = 0; b < BinOf(-1100.0); ++b)
    if (h.frame[b] > 0 && h.least[b] == h.most[b])
      h.all[b] = h.frame[b] = 0;
}

constexpr double Top = Lowest + Bins * BinWidth;

void AirOfFrame(const Histograms& h, GreyLevels& levels)
{
  const double all = Within(h.all, Lowest, Top), frame = Within(h.frame, Lowest, Top);
  const Plateau air = FullestPlateau(h.frame, Lowest, Top, 50.0);
  if (air.count < 0.3 * frame || frame == 0.0 ||
      Within(h.all, Lowest, air.level - 150.0) > 0.01 * all)
    return;
  const double above = Within(h.all, air.level + 150.0, Top);
  const Plateau soft = FullestPlateau(h.all, air.level + 200.0, Top, 60.0);
  const bool standsOut = above > 0.0 && soft.count >= 0.1 * above;
  const bool couldBeTissue = air.level > -150.0 && air.level < 150.0;
  const bool brighterYet = Within(h.all, soft.level + 200.0, Top) >= 0.01 * above;
  if (couldBeTissue && !(standsOut && soft.level - air.level >= 400.0 && brighterYet))
    return;
  levels.air = air.level;
  levels.airIsElsewhere = air.level < -1100.0 || air.level > -900.0;
  if (standsOut)
    levels.softTissue = soft.level;
}

} // namespace

GreyLevels FindGreyLevels(const AnyGridView& grid)
{
  Histograms h = std::visit([](const auto& view) { return Count(view); }, grid);
  TakePaddingOut(h);
  GreyLevels levels;
  const double all = Within(h.all, Lowest, Top);
  if (all == 0.0)
    return levels;
  if (Within(h.all, -1100.0, -900.0) < 0.02 * all)
  {
    AirOfFrame(h, levels);
    return levels;
  }
  levels.air = FullestPlateau(h.all, -1100.0, -900.0, 50.0).level;
  const double above = Within(h.all, -700.0, Top);
  const Plateau soft = FullestPlateau(h.all, -640.0, Top, 60.0);
  if (above == 0.0 || soft.count < 0.2 * above)
    return levels;
  levels.softTissue = soft.level;
  levels.softIsElsewhere =
    (soft.level >= -700.0 && soft.level < -200.0) || (soft.level > 200.0 && soft.level <= 500.0);
  return levels;
}

} // namespace hasp
