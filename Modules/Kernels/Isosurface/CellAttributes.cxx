#include "Isosurface/CellAttributes.h"
#include "Grid/ParallelFor.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace hasp
{

namespace
{

constexpr std::int64_t Grain = 64; // clusters

void CheckGeometry(
  const ClusteredCells& cells, const GridGeometry& given, const char* function, const char* what)
{
  const GridGeometry& own = cells.geometry;
  if (own.dims == given.dims && own.origin == given.origin && own.spacing == given.spacing &&
      own.direction == given.direction)
    return;
  const auto text = [](const GridGeometry& g)
  {
    return std::to_string(g.dims.x) + " x " + std::to_string(g.dims.y) + " x " +
           std::to_string(g.dims.z) + " samples from (" + std::to_string(g.origin.x) + ", " +
           std::to_string(g.origin.y) + ", " + std::to_string(g.origin.z) + ") mm";
  };
  throw std::invalid_argument(std::string(function) + ": the " + what + " have another geometry (" +
                              text(given) + ") than the cells (" + text(own) +
                              "): resample them to the volume's grid first");
}

/// The most frequent of up to eight labels, the smaller of two; 0 if there is none.
std::uint16_t MostFrequent(std::span<std::uint16_t> labels)
{
  std::sort(labels.begin(), labels.end());
  std::uint16_t best = 0;
  std::ptrdiff_t mostTimes = 0;
  for (auto run = labels.begin(); run != labels.end();)
  {
    const auto end = std::upper_bound(run, labels.end(), *run);
    if (end - run > mostTimes)
    {
      mostTimes = end - run;
      best = *run;
    }
    run = end;
  }
  return best;
}

template <typename T>
std::uint16_t LabelOfCell(const ClusteredCells& cells, const GridView<const T>& labels,
  const CellCluster& cluster, const glm::ivec3& inCluster)
{
  const std::array<float, 8> corners = cells.CornersFromIsovalue(cluster, inCluster);
  const glm::ivec3 cell = cluster.Origin() + inCluster;
  std::array<std::uint16_t, 8> found{};
  std::size_t count = 0;
  for (int c = 0; c < 8; ++c)
  {
    if (!(corners[c] >= 0.0F))
      continue;
    const T label = labels(cell.x + (c & 1), cell.y + (c >> 1 & 1), cell.z + (c >> 2));
    if (label < 0)
      throw std::invalid_argument(
        "AddLabels: label " + std::to_string(label) + " is negative; labels are 0 to 65535");
    if (label != 0)
      found[count++] = static_cast<std::uint16_t>(label);
  }
  return MostFrequent({ found.data(), count });
}

/// f(cell in the cluster) for each active one, in their order.
template <typename F>
void ForEachCell(const CellCluster& cluster, const F& f)
{
  for (int z = 0; z < 8; ++z)
    for (std::uint64_t left = cluster.active[z]; left != 0; left &= left - 1)
    {
      const int place = std::countr_zero(left);
      f(glm::ivec3(place & 7, place >> 3, z));
    }
}

/// Of the active cells of these clusters, one after the other.
std::vector<std::uint16_t> LabelsOfClusters(
  const ClusteredCells& cells, const AnyGridView& labels, std::span<const std::uint32_t> clusters)
{
  std::vector<std::size_t> first{ 0 }; // of each, in the result
  for (const std::uint32_t c : clusters)
    first.push_back(first.back() + cells.clusters[c].CellCount());
  std::vector<std::uint16_t> result(first.back());
  const auto label = [&]<typename T>(const GridView<const T>& view)
  {
    if constexpr (std::is_same_v<T, float>)
      throw std::invalid_argument(
        "AddLabels: labels are floats; cast them to whole numbers, 0 to 65535");
    else
      ParallelFor(0, static_cast<std::int64_t>(clusters.size()), Grain,
        [&](std::int64_t from, std::int64_t to)
        {
          for (std::int64_t c = from; c < to; ++c)
          {
            const CellCluster& cluster = cells.clusters[clusters[c]];
            std::size_t n = first[c];
            ForEachCell(cluster, [&](const glm::ivec3& cell)
              { result[n++] = LabelOfCell(cells, view, cluster, cell); });
          }
        });
  };
  std::visit(label, labels);
  return result;
}

/// f(corner in the cluster, 0..8 each) for each stored one, in their order.
template <typename F>
void ForEachStoredCorner(const CellCluster& cluster, const F& f)
{
  for (int z = 0; z <= 8; ++z)
  {
    const std::uint64_t touching = cluster.TouchSlice(z);
    const auto row = [&](int y) { return touching >> 8 * y & 0xFF; };
    for (int y = 0; y <= 8; ++y)
    {
      const std::uint64_t cells = (y < 8 ? row(y) : 0) | (y > 0 ? row(y - 1) : 0);
      for (std::uint64_t left = cells | cells << 1; left != 0; left &= left - 1)
        f(glm::ivec3(std::countr_zero(left), y, z));
    }
  }
}

/// The number of each cluster's first stored corner; one more entry with the count of all.
std::vector<std::uint32_t> FirstCorners(const ClusteredCells& cells)
{
  std::vector<std::uint64_t> first{ 0 };
  first.reserve(cells.clusters.size() + 1);
  for (const CellCluster& cluster : cells.clusters)
    first.push_back(first.back() + cluster.CornerCount());
  if (first.back() > 0xFFFFFFFFU)
    throw std::invalid_argument(
      "AddColors: " + std::to_string(first.back()) + " corners; 32 bits number at most 4294967295");
  return { first.begin(), first.end() };
}

/// f(number of the stored corner, sample) for each, all threads.
template <typename F>
void ForEachCornerSample(
  const ClusteredCells& cells, const std::vector<std::uint32_t>& first, const F& f)
{
  const glm::i64vec3 dims(cells.geometry.dims);
  const auto count = static_cast<std::int64_t>(cells.clusters.size());
  ParallelFor(0, count, Grain,
    [&](std::int64_t from, std::int64_t to)
    {
      for (std::int64_t c = from; c < to; ++c)
      {
        const CellCluster& cluster = cells.clusters[c];
        const glm::i64vec3 origin(cluster.Origin());
        std::size_t number = first[c];
        ForEachStoredCorner(cluster,
          [&](const glm::ivec3& corner)
          {
            const glm::i64vec3 at = origin + glm::i64vec3(corner);
            f(number++, (at.z * dims.y + at.y) * dims.x + at.x);
          });
      }
    });
}

void SetColors(
  ClusteredCells& cells, std::vector<std::uint32_t> first, std::vector<std::uint32_t> colors)
{
  first.pop_back();
  cells.firstColors = std::move(first);
  cells.colors = std::move(colors);
}

} // namespace

void AddLabels(ClusteredCells& cells, const AnyGridView& labels)
{
  CheckGeometry(cells, GeometryOf(labels), "AddLabels", "labels");
  std::vector<std::uint32_t> all(cells.clusters.size());
  std::iota(all.begin(), all.end(), 0U);
  cells.labels = LabelsOfClusters(cells, labels, all);
}

CellRange UpdateLabels(
  ClusteredCells& cells, const AnyGridView& labels, const glm::ivec3& low, const glm::ivec3& high)
{
  CheckGeometry(cells, GeometryOf(labels), "UpdateLabels", "labels");
  if (cells.labels.size() != cells.Count())
    throw std::invalid_argument("UpdateLabels: the cells have no labels yet: AddLabels first");
  std::vector<std::uint32_t> touched;
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
  {
    const glm::ivec3 first = cells.clusters[c].Origin(), last = first + 8; // samples
    if (glm::all(glm::lessThanEqual(first, high)) && glm::all(glm::greaterThanEqual(last, low)))
      touched.push_back(static_cast<std::uint32_t>(c));
  }
  const std::vector<std::uint16_t> now = LabelsOfClusters(cells, labels, touched);
  CellRange changed{ cells.Count(), 0 };
  std::size_t n = 0;
  for (const std::uint32_t c : touched)
  {
    const std::size_t from = cells.clusters[c].firstCell;
    const std::size_t end = from + cells.clusters[c].CellCount();
    for (std::size_t cell = from; cell < end; ++cell, ++n)
      if (std::exchange(cells.labels[cell], now[n]) != now[n])
      {
        changed.first = std::min(changed.first, cell);
        changed.end = cell + 1;
      }
  }
  return changed.Empty() ? CellRange{} : changed;
}

std::vector<std::int64_t> SamplesOfCorners(const ClusteredCells& cells)
{
  const std::vector<std::uint32_t> first = FirstCorners(cells);
  std::vector<std::int64_t> samples(first.back());
  ForEachCornerSample(
    cells, first, [&](std::size_t corner, std::int64_t sample) { samples[corner] = sample; });
  return samples;
}

void AddColors(ClusteredCells& cells, const ColorFunction& colorOf)
{
  std::vector<std::uint32_t> first = FirstCorners(cells), colors(first.back());
  const std::vector<std::int64_t> samples = SamplesOfCorners(cells);
  colorOf(samples, colors);
  SetColors(cells, std::move(first), std::move(colors));
}

void AddColors(ClusteredCells& cells, const GridView<const std::uint32_t>& colors)
{
  CheckGeometry(cells, colors.geometry, "AddColors", "colours");
  std::vector<std::uint32_t> first = FirstCorners(cells), result(first.back());
  ForEachCornerSample(cells, first,
    [&](std::size_t corner, std::int64_t sample) { result[corner] = colors.data[sample]; });
  SetColors(cells, std::move(first), std::move(result));
}

} // namespace hasp
