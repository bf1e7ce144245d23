#include "Evaluation/Dice.h"

#include "Evaluation/BestMatch.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

using LabelView = GridView<const std::uint16_t>;
constexpr std::size_t AllLabels = 65536;

void CheckGrids(const GridGeometry& truth, const GridGeometry& result)
{
  truth.Validate();
  result.Validate();
  if (truth.dims != result.dims)
    throw std::invalid_argument(
      "the truth and the result must have as many voxels along each axis");
  const double near = 0.01 * std::min({ truth.spacing.x, truth.spacing.y, truth.spacing.z });
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 index =
      glm::dvec3(truth.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const double away = glm::distance(truth.IndexToWorld(index), result.IndexToWorld(index));
    if (!(away <= near))
      throw std::invalid_argument(
        "the truth and the result lie " + std::to_string(away) + " mm apart, must be on one grid");
  }
}

/// Slices that are worked on between two looks at progress, each into a slot of its own, so that
/// what is added up does not depend on the threads.
constexpr int SlicesAtOnce = 16;

template <typename Slot, typename Body, typename Fold>
void ForEachSlice(int slices, const ProgressFunction& progress, const Slot& empty, const Body& body,
  const Fold& fold)
{
  for (int first = 0; first < slices; first += SlicesAtOnce)
  {
    ReportProgress(progress, double(first) / slices);
    const int last = std::min(first + SlicesAtOnce, slices);
    std::vector<Slot> slots(last - first, empty);
    ParallelFor(first, last, 1,
      [&](std::int64_t k, std::int64_t) { body(static_cast<int>(k), slots[k - first]); });
    for (const Slot& slot : slots)
      fold(slot);
  }
  ReportProgress(progress, 1.0);
}

/// Voxels of each pair of labels {truth, result} that there is.
using PairCounts = std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t>;

PairCounts CountPairs(LabelView truth, LabelView result, const ProgressFunction& progress)
{
  const glm::ivec3& dims = truth.geometry.dims;
  const std::size_t slice = static_cast<std::size_t>(dims.x) * dims.y;
  PairCounts sum;
  ForEachSlice(
    dims.z, progress, PairCounts(),
    [&](int k, PairCounts& counts)
    {
      const std::uint16_t *a = truth.data + k * slice, *b = result.data + k * slice;
      for (std::size_t from = 0, to = 0; from < slice; from = to) // runs are long
      {
        while (to < slice && a[to] == a[from] && b[to] == b[from])
          ++to;
        counts[{ a[from], b[from] }] += to - from;
      }
    },
    [&](const PairCounts& counts)
    {
      for (const auto& [pair, voxels] : counts)
        sum[pair] += voxels;
    });
  return sum;
}

/// Voxels of each label of both maps, 0 included.
struct Totals
{
  explicit Totals(const PairCounts& pairs)
  {
    for (const auto& [pair, voxels] : pairs)
    {
      truth[pair.first] += voxels;
      result[pair.second] += voxels;
    }
  }
  std::map<std::uint16_t, std::size_t> truth, result;
};

LabelDice PairOf(
  std::uint16_t truth, std::uint16_t result, const PairCounts& pairs, const Totals& totals)
{
  LabelDice dice;
  dice.truth = truth;
  dice.truthVoxels = totals.truth.at(truth);
  const auto found = result == 0 ? totals.result.end() : totals.result.find(result);
  if (found == totals.result.end())
    return dice;
  dice.result = result;
  dice.resultVoxels = found->second;
  const auto shared = pairs.find({ truth, result });
  dice.sharedVoxels = shared == pairs.end() ? 0 : shared->second;
  return dice;
}

std::vector<std::uint16_t> LabelsOf(const std::map<std::uint16_t, std::size_t>& totals)
{
  std::vector<std::uint16_t> labels;
  for (const auto& [label, voxels] : totals)
    if (label != 0)
      labels.push_back(label);
  return labels;
}

std::vector<LabelDice> Pair(const PairCounts& pairs, const Totals& totals, LabelPairing pairing)
{
  const std::vector<std::uint16_t> rows = LabelsOf(totals.truth), columns = LabelsOf(totals.result);
  if (rows.empty())
    throw std::invalid_argument("the truth has no label, must have one voxel > 0 at least");
  std::vector<LabelDice> labels;
  if (pairing == LabelPairing::SameNumber)
  {
    for (const std::uint16_t label : rows)
      labels.push_back(PairOf(label, label, pairs, totals));
    return labels;
  }
  constexpr std::size_t most = 2048;
  if (std::max(rows.size(), columns.size()) > most)
    throw std::invalid_argument("the truth has " + std::to_string(rows.size()) +
                                " labels and the result " + std::to_string(columns.size()) +
                                ", at most 2048 of each can be matched; pair them by number");
  std::vector<double> scores;
  for (const std::uint16_t row : rows)
    for (const std::uint16_t column : columns)
      scores.push_back(PairOf(row, column, pairs, totals).Dice());
  const std::vector<std::size_t> match = BestMatch(rows.size(), columns.size(), scores);
  for (std::size_t row = 0; row < rows.size(); ++row)
    labels.push_back(
      PairOf(rows[row], match[row] < columns.size() ? columns[match[row]] : 0, pairs, totals));
  return labels;
}

/// Steps to all voxels within the tolerance, the nearest first.
std::vector<glm::ivec3> StepsWithin(const glm::dvec3& spacing, double toleranceMm)
{
  constexpr double most = 1 << 20;
  const glm::dvec3 reach = toleranceMm * (1.0 + 1e-9) / spacing;
  const glm::dvec3 box = 2.0 * reach + 1.0;
  if (!(toleranceMm >= 0.0 && box.x * box.y * box.z <= most))
    throw std::invalid_argument("toleranceMm is " + std::to_string(toleranceMm) +
                                ", must be >= 0 and reach at most 2^20 voxels");
  const glm::ivec3 far(reach);
  const double limit = toleranceMm * toleranceMm * (1.0 + 2e-9);
  std::vector<std::pair<double, glm::ivec3>> steps;
  for (int k = -far.z; k <= far.z; ++k)
    for (int j = -far.y; j <= far.y; ++j)
      for (int i = -far.x; i <= far.x; ++i)
      {
        const glm::dvec3 way = spacing * glm::dvec3(i, j, k);
        if (glm::dot(way, way) <= limit)
          steps.emplace_back(glm::dot(way, way), glm::ivec3(i, j, k));
      }
  std::stable_sort(
    steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<glm::ivec3> sorted;
  for (const auto& [squared, step] : steps)
    sorted.push_back(step);
  return sorted;
}

/// Faces of a voxel along each axis that another label lies behind.
glm::ivec3 OpenFaces(LabelView labels, const glm::ivec3& at)
{
  const glm::ivec3& dims = labels.geometry.dims;
  const std::uint16_t* voxel = labels.data + labels.Offset(at.x, at.y, at.z);
  const std::array<std::ptrdiff_t, 3> step{ 1, dims.x, std::ptrdiff_t(dims.x) * dims.y };
  glm::ivec3 faces(0);
  for (int a = 0; a < 3; ++a)
  {
    faces[a] += at[a] > 0 && voxel[-step[a]] != *voxel;
    faces[a] += at[a] + 1 < dims[a] && voxel[step[a]] != *voxel;
  }
  return faces;
}

bool IsSurfaceOf(LabelView labels, const glm::ivec3& at, std::uint16_t label)
{
  return labels(at.x, at.y, at.z) == label && OpenFaces(labels, at) != glm::ivec3(0);
}

/// Faces along each axis: counts, so that no order of adding matters.
struct FaceCounts
{
  std::array<std::size_t, 3> all{}, near{};

  void Add(const glm::ivec3& faces, bool isNear)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->all[a] += faces[a];
      this->near[a] += isNear ? faces[a] : 0;
    }
  }
  void Add(const FaceCounts& other)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->all[a] += other.all[a];
      this->near[a] += other.near[a];
    }
  }
};

double AreaMm2(const std::array<std::size_t, 3>& faces, const glm::dvec3& spacing)
{
  return double(faces[0]) * spacing.y * spacing.z + double(faces[1]) * spacing.x * spacing.z +
         double(faces[2]) * spacing.x * spacing.y;
}

/// Which pair a label belongs to, and its partner in the other map.
struct Partners
{
  std::vector<std::uint16_t> other = std::vector<std::uint16_t>(AllLabels, 0);
  std::vector<std::uint32_t> pair = std::vector<std::uint32_t>(AllLabels, NoPair);
  static constexpr std::uint32_t NoPair = 0xffffffffU;
};

/// Adds the surfaces of one map in a slice, near to the other's or not.
void AddSlice(LabelView map, LabelView other, const Partners& partners,
  const std::vector<glm::ivec3>& steps, int k, std::vector<FaceCounts>& counts)
{
  const glm::ivec3& dims = map.geometry.dims;
  for (int j = 0; j < dims.y; ++j)
    for (int i = 0; i < dims.x; ++i)
    {
      const std::uint16_t label = map(i, j, k);
      if (label == 0 || partners.pair[label] == Partners::NoPair)
        continue;
      const glm::ivec3 at(i, j, k), faces = OpenFaces(map, at);
      if (faces == glm::ivec3(0))
        continue;
      const std::uint16_t partner = partners.other[label];
      const bool near = partner != 0 && std::any_of(steps.begin(), steps.end(),
                                          [&](const glm::ivec3& step)
                                          {
                                            const glm::ivec3 to = at + step;
                                            return to.x >= 0 && to.y >= 0 && to.z >= 0 &&
                                                   to.x < dims.x && to.y < dims.y &&
                                                   to.z < dims.z && IsSurfaceOf(other, to, partner);
                                          });
      counts[partners.pair[label]].Add(faces, near);
    }
}

std::vector<FaceCounts> CountFaces(LabelView map, LabelView other, const Partners& partners,
  const std::vector<glm::ivec3>& steps, std::size_t pairs, const ProgressFunction& progress)
{
  std::vector<FaceCounts> sum(pairs);
  ForEachSlice(
    map.geometry.dims.z, progress, std::vector<FaceCounts>(pairs),
    [&](int k, std::vector<FaceCounts>& counts)
    { AddSlice(map, other, partners, steps, k, counts); },
    [&](const std::vector<FaceCounts>& counts)
    {
      for (std::size_t n = 0; n < pairs; ++n)
        sum[n].Add(counts[n]);
    });
  return sum;
}

void MeasureSurfaces(LabelView truth, LabelView result, const std::vector<glm::ivec3>& steps,
  std::vector<LabelDice>& labels, const ProgressFunction& progress)
{
  Partners ofTruth, ofResult;
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    ofTruth.pair[labels[n].truth] = static_cast<std::uint32_t>(n);
    ofTruth.other[labels[n].truth] = labels[n].result;
    if (labels[n].result == 0)
      continue;
    ofResult.pair[labels[n].result] = static_cast<std::uint32_t>(n);
    ofResult.other[labels[n].result] = labels[n].truth;
  }
  const std::vector<FaceCounts> truthFaces =
    CountFaces(truth, result, ofTruth, steps, labels.size(), PartOf(progress, 0.0, 0.5));
  const std::vector<FaceCounts> resultFaces =
    CountFaces(result, truth, ofResult, steps, labels.size(), PartOf(progress, 0.5, 1.0));
  const glm::dvec3& spacing = truth.geometry.spacing;
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    labels[n].truthAreaMm2 = AreaMm2(truthFaces[n].all, spacing);
    labels[n].truthNearMm2 = AreaMm2(truthFaces[n].near, spacing);
    labels[n].resultAreaMm2 = AreaMm2(resultFaces[n].all, spacing);
    labels[n].resultNearMm2 = AreaMm2(resultFaces[n].near, spacing);
  }
}

} // namespace

double LabelDice::Dice() const
{
  const std::size_t both = this->truthVoxels + this->resultVoxels;
  return both == 0 ? 1.0 : 2.0 * double(this->sharedVoxels) / double(both);
}

double LabelDice::SurfaceDice() const
{
  const double area = this->truthAreaMm2 + this->resultAreaMm2;
  if (area == 0.0)
    return this->Dice() == 1.0 ? 1.0 : 0.0;
  return (this->truthNearMm2 + this->resultNearMm2) / area;
}

const LabelDice& SegmentationDice::Worst() const
{
  return *std::min_element(this->labels.begin(), this->labels.end(),
    [](const LabelDice& a, const LabelDice& b) { return a.Dice() < b.Dice(); });
}

const LabelDice& SegmentationDice::WorstSurface() const
{
  return *std::min_element(this->labels.begin(), this->labels.end(),
    [](const LabelDice& a, const LabelDice& b) { return a.SurfaceDice() < b.SurfaceDice(); });
}

SegmentationDice CompareLabels(
  LabelView truth, LabelView result, const DiceSettings& settings, const ProgressFunction& progress)
{
  CheckGrids(truth.geometry, result.geometry);
  const std::vector<glm::ivec3> steps = StepsWithin(truth.geometry.spacing, settings.toleranceMm);
  const PairCounts pairs = CountPairs(truth, result, PartOf(progress, 0.0, 0.2));
  const Totals totals(pairs);
  SegmentationDice dice;
  dice.labels = Pair(pairs, totals, settings.pairing);
  for (const auto& [label, voxels] : totals.result)
    if (label != 0 && std::none_of(dice.labels.begin(), dice.labels.end(),
                        [label = label](const LabelDice& d) { return d.result == label; }))
      dice.strayVoxels += voxels;
  MeasureSurfaces(truth, result, steps, dice.labels, PartOf(progress, 0.2, 1.0));
  return dice;
}

} // namespace hasp
