#include "Studies/CoarseScan.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void Require(bool holds, const char* name, double value, const std::string& range)
{
  if (!holds)
    throw std::invalid_argument(
      std::string("coarse scan: ") + name + " is " + std::to_string(value) + ", must be " + range);
}

/// The share of a blurred box [low, high] that falls on an old voxel around `at`; index units.
double Share(double low, double high, double at, double blur)
{
  if (blur == 0.0)
    return std::max(0.0, std::min(high, at + 0.5) - std::max(low, at - 0.5));
  const auto below = [&](double x) { return 0.5 * std::erfc(-x / (blur * std::sqrt(2.0))); };
  return below(high - at) - below(low - at);
}

} // namespace

CoarseScan::CoarseScan(const GridGeometry& fine, const CoarseScanSettings& settings)
  : Fine(fine),
    Coarse(fine)
{
  fine.Validate();
  glm::dvec3 start(0.0); // of the new first voxel's middle, old index
  for (int a = 0; a < 3; ++a)
  {
    const double old = fine.spacing[a], asked = settings.spacingMm[a];
    Require(asked == 0.0 || (asked >= old * (1.0 - 1e-9) && asked <= 50.0), "spacingMm", asked,
      "0 or in [" + std::to_string(old) + ", 50]: the scan's own at least");
    Require(settings.blurMm[a] >= 0.0 && settings.blurMm[a] <= 10.0, "blurMm", settings.blurMm[a],
      "in [0, 10]");
    const double ratio = asked == 0.0 ? 1.0 : std::max(1.0, asked / old);
    this->Coarse.dims[a] = std::max(1, static_cast<int>(std::floor(fine.dims[a] / ratio + 1e-9)));
    this->Coarse.spacing[a] = ratio * old;
    start[a] = 0.5 * (ratio - 1.0);
    this->Rows[a] = RowsOf(fine.dims[a], this->Coarse.dims[a], ratio, settings.blurMm[a] / old);
    this->Boxes[a] = RowsOf(fine.dims[a], this->Coarse.dims[a], ratio, 0.0);
  }
  this->Coarse.origin = fine.IndexToWorld(start);
}

std::vector<CoarseScan::Row> CoarseScan::RowsOf(
  int fineCount, int coarseCount, double ratio, double blur)
{
  std::vector<Row> rows(coarseCount);
  for (int n = 0; n < coarseCount; ++n)
  {
    const double low = n * ratio - 0.5, high = low + ratio;
    const int from = std::max(0, static_cast<int>(std::floor(low - 4.0 * blur)));
    const int to = std::min(fineCount - 1, static_cast<int>(std::ceil(high + 4.0 * blur)));
    double sum = 0.0;
    rows[n].first = from;
    for (int i = from; i <= to; ++i)
    {
      rows[n].weights.push_back(static_cast<float>(Share(low, high, i, blur)));
      sum += rows[n].weights.back();
    }
    for (float& weight : rows[n].weights)
      weight = static_cast<float>(weight / sum);
  }
  return rows;
}

std::vector<std::int16_t> CoarseScan::Samples(std::span<const std::int16_t> fine) const
{
  if (fine.size() != this->Fine.Size())
    throw std::invalid_argument("coarse scan: " + std::to_string(fine.size()) +
                                " samples, must be one a voxel, " +
                                std::to_string(this->Fine.Size()));
  std::vector<float> now(fine.begin(), fine.end());
  glm::ivec3 dims = this->Fine.dims;
  for (int a = 0; a < 3; ++a) // axis by axis
  {
    glm::ivec3 next = dims;
    next[a] = this->Coarse.dims[a];
    const std::int64_t inner = a == 0 ? 1 : a == 1 ? dims.x : std::int64_t(dims.x) * dims.y;
    const std::int64_t outer = std::int64_t(dims.x) * dims.y * dims.z / (inner * dims[a]);
    std::vector<float> made(std::size_t(next.x) * next.y * next.z);
    ParallelFor(0, outer, 16,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t o = first; o < last; ++o)
          for (int n = 0; n < next[a]; ++n)
          {
            const Row& row = this->Rows[a][n];
            float* to = &made[(o * next[a] + n) * inner];
            for (std::size_t w = 0; w < row.weights.size(); ++w)
            {
              const float* from = &now[(o * dims[a] + row.first + std::int64_t(w)) * inner];
              for (std::int64_t i = 0; i < inner; ++i)
                to[i] += row.weights[w] * from[i];
            }
          }
      });
    now = std::move(made);
    dims = next;
  }
  std::vector<std::int16_t> samples(now.size());
  std::transform(now.begin(), now.end(), samples.begin(),
    [](float value) { return static_cast<std::int16_t>(std::lround(value)); });
  return samples;
}

std::vector<Label> CoarseScan::Labels(
  std::span<const Label> fine, std::span<const std::int16_t> coarse, double boneHU) const
{
  if (fine.size() != this->Fine.Size() || coarse.size() != this->Coarse.Size())
    throw std::invalid_argument("coarse scan: there must be a label for each old voxel and a "
                                "sample for each new one");
  const glm::ivec3 &dims = this->Coarse.dims, &old = this->Fine.dims;
  std::vector<Label> labels(coarse.size(), 0);
  const auto labelAt = [&](const Row& x, const Row& y, const Row& z)
  {
    std::map<Label, double> shares;
    for (std::size_t k = 0; k < z.weights.size(); ++k)
      for (std::size_t j = 0; j < y.weights.size(); ++j)
        for (std::size_t i = 0; i < x.weights.size(); ++i)
        {
          const std::size_t row = (z.first + k) * old.y + y.first + j;
          if (const Label label = fine[row * old.x + x.first + i])
            shares[label] += double(z.weights[k]) * y.weights[j] * x.weights[i];
        }
    Label best = 0;
    double most = 0.0;
    for (const auto& [label, share] : shares)
      if (share > most)
      {
        most = share;
        best = label;
      }
    return best;
  };
  ParallelFor(0, dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i)
            if (const std::size_t at = (k * dims.y + j) * dims.x + i; double(coarse[at]) >= boneHU)
              labels[at] = labelAt(this->Boxes[0][i], this->Boxes[1][j], this->Boxes[2][k]);
    });
  return labels;
}

} // namespace hasp
