#include "Studies/CoarseTruth.h"

#include "Studies/SeededShare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double FarMm = 40.0; ///< further than this from others no place is better than another

void Require(bool holds, const char* name, double value, const char* range)
{
  if (!holds)
    throw std::invalid_argument(
      "coarse truth: " + std::string(name) + " is " + std::to_string(value) + ", must be " + range);
}

/// Within a ball of that radius, evenly.
glm::dvec3 AnyError(double mm, std::uint64_t seed, std::uint64_t draw)
{
  for (std::uint64_t n = 1000 * draw;; n += 3)
  {
    const glm::dvec3 p(2.0 * SeededShare(seed, n) - 1.0, 2.0 * SeededShare(seed, n + 1) - 1.0,
      2.0 * SeededShare(seed, n + 2) - 1.0);
    if (glm::length(p) <= 1.0)
      return mm * p;
  }
}

} // namespace

CoarseTruth::CoarseTruth(GridView<const Label> truth, const CoarseTruthSettings& settings)
  : Settings(settings),
    Grid(truth.geometry)
{
  this->Grid.Validate();
  Require(
    settings.cellMm >= 1.0 && settings.cellMm <= 20.0, "cellMm", settings.cellMm, "in [1, 20]");
  Require(
    settings.errorMm >= 0.0 && settings.errorMm <= 20.0, "errorMm", settings.errorMm, "in [0, 20]");
  Require(settings.wrongShare > 0.0 && settings.wrongShare <= 1.0, "wrongShare",
    settings.wrongShare, "in (0, 1]");
  this->VoxelsPerCell =
    glm::max(glm::ivec3(glm::round(settings.cellMm / this->Grid.spacing)), glm::ivec3(1));
  this->Cells = (this->Grid.dims + this->VoxelsPerCell - 1) / this->VoxelsPerCell;
  const std::size_t count = static_cast<std::size_t>(this->Cells.x) * this->Cells.y * this->Cells.z;
  this->Known.assign(count, 0);
  std::map<Label, Mark> marks;
  for (int k = 0; k < this->Grid.dims.z; ++k)
    for (int j = 0; j < this->Grid.dims.y; ++j)
      for (int i = 0; i < this->Grid.dims.x; ++i)
      {
        const Label label = truth(i, j, k);
        if (label == 0)
          continue;
        const std::size_t cell = this->Number(this->CellOf({ i, j, k }));
        Label& known = this->Known[cell];
        known = known == 0 || known == label ? label : Mixed;
        Mark& mark = marks.try_emplace(label, Mark{ label, glm::dvec3(0.0), 0 }).first->second;
        mark.sum += this->Grid.IndexToWorld({ i, j, k });
        ++mark.count;
      }
  std::map<Label, Mark> cells; // means of cells: voxels count only where a label has none
  for (std::size_t n = 0; n < count; ++n)
    if (this->Known[n] != 0 && this->Known[n] != Mixed)
    {
      Mark& mark =
        cells.try_emplace(this->Known[n], Mark{ this->Known[n], glm::dvec3(0.0), 0 }).first->second;
      mark.sum += this->Middle(n);
      ++mark.count;
    }
  for (const auto& [label, mark] : marks)
  {
    const auto known = cells.find(label);
    this->All.push_back(label);
    this->Marks.push_back(known != cells.end() ? known->second : mark);
  }
  if (this->All.empty() || this->All.back() == Mixed)
    throw std::invalid_argument("coarse truth: labels must be in [1, 65534], one voxel at least");
}

glm::ivec3 CoarseTruth::CellOf(const glm::ivec3& voxel) const
{
  return voxel / this->VoxelsPerCell;
}

std::size_t CoarseTruth::Number(const glm::ivec3& cell) const
{
  return (static_cast<std::size_t>(cell.z) * this->Cells.y + cell.y) * this->Cells.x + cell.x;
}

glm::ivec3 CoarseTruth::Place(std::size_t number) const
{
  const std::size_t row = this->Cells.x, slice = row * this->Cells.y;
  return { number % row, number % slice / row, number / slice };
}

glm::dvec3 CoarseTruth::Middle(std::size_t number) const
{
  const glm::ivec3 from = this->Place(number) * this->VoxelsPerCell;
  const glm::ivec3 to = glm::min(from + this->VoxelsPerCell, this->Grid.dims);
  return this->Grid.IndexToWorld(0.5 * glm::dvec3(from + to - 1));
}

double CoarseTruth::NearestOtherMm(std::size_t number) const
{
  const glm::dvec3 cell = this->Grid.spacing * glm::dvec3(this->VoxelsPerCell);
  const glm::ivec3 reach(glm::ceil(FarMm / cell));
  const glm::ivec3 at = this->Place(number);
  double nearest = FarMm;
  for (int k = std::max(at.z - reach.z, 0); k <= std::min(at.z + reach.z, this->Cells.z - 1); ++k)
    for (int j = std::max(at.y - reach.y, 0); j <= std::min(at.y + reach.y, this->Cells.y - 1); ++j)
      for (int i = std::max(at.x - reach.x, 0); i <= std::min(at.x + reach.x, this->Cells.x - 1);
           ++i)
      {
        const Label known = this->Known[this->Number({ i, j, k })];
        if (known != 0 && known != this->Known[number])
          nearest = std::min(nearest, glm::length(cell * glm::dvec3(glm::ivec3(i, j, k) - at)));
      }
  return nearest;
}

glm::dvec3 CoarseTruth::LongWay(std::size_t number) const
{
  const Label label = this->Known[number];
  const glm::dvec3 at = this->Middle(number);
  std::vector<glm::dvec3> ways;
  for (std::size_t n = 0; n < this->Known.size(); ++n)
    if (this->Known[n] == label && glm::distance(this->Middle(n), at) <= FarMm)
      ways.push_back(this->Middle(n) - at);
  glm::dvec3 way(0.57, 0.53, 0.63); // the power method: of the direction of most spread
  for (int round = 0; round < 30; ++round)
  {
    glm::dvec3 next(0.0);
    for (const glm::dvec3& w : ways)
      next += glm::dot(w, way) * w;
    if (!(glm::length(next) > 0.0))
      break;
    way = glm::normalize(next);
  }
  return glm::normalize(way);
}

CoarseHint CoarseTruth::HintAt(
  std::size_t number, const glm::dvec3& place, std::uint64_t draw) const
{
  CoarseHint hint;
  hint.label = this->Known[number];
  // The other cell's near side may be that much nearer than its middle.
  hint.reachMm = std::max(
    this->NearestOtherMm(number) - 0.5 * this->Settings.cellMm, 0.5 * this->Settings.cellMm);
  const double error = std::min(this->Settings.errorMm, 0.5 * hint.reachMm);
  hint.near = place + AnyError(error, this->Settings.seed, draw);
  hint.along = this->LongWay(number);
  return hint;
}

std::vector<CoarseHint> CoarseTruth::Hints() const
{
  std::vector<CoarseHint> hints;
  for (const Mark& mark : this->Marks)
  {
    const glm::dvec3 mean = mark.sum / double(mark.count);
    std::size_t best = this->Known.size();
    double farthest = 0.0, offMiddle = 0.0;
    for (std::size_t n = 0; n < this->Known.size(); ++n)
    {
      if (this->Known[n] != mark.label)
        continue;
      const double away = this->NearestOtherMm(n), off = glm::distance(this->Middle(n), mean);
      if (best == this->Known.size() || away > farthest || (away == farthest && off < offMiddle))
      {
        best = n;
        farthest = away;
        offMiddle = off;
      }
    }
    if (best < this->Known.size())
    {
      hints.push_back(this->HintAt(best, this->Middle(best), mark.label));
      continue;
    }
    CoarseHint small;
    small.label = mark.label;
    small.near = mean;
    small.along = { 1.0, 0.0, 0.0 };
    small.reachMm = 0.25 * this->Settings.cellMm;
    hints.push_back(small);
  }
  return hints;
}

std::optional<CoarseHint> CoarseTruth::LargestError(
  GridView<const Label> result, GridView<const Label> bone, int round) const
{
  if (result.geometry.dims != this->Grid.dims || bone.geometry.dims != this->Grid.dims)
    throw std::invalid_argument("coarse truth: result and bone must be as large as the truth");
  struct Seen
  {
    std::size_t bone = 0, wrong = 0;
    glm::dvec3 sum{ 0.0 };
  };
  std::vector<Seen> seen(this->Known.size());
  for (int k = 0; k < this->Grid.dims.z; ++k)
    for (int j = 0; j < this->Grid.dims.y; ++j)
      for (int i = 0; i < this->Grid.dims.x; ++i)
      {
        const std::size_t cell = this->Number(this->CellOf({ i, j, k }));
        if (bone(i, j, k) == 0 || this->Known[cell] == 0 || this->Known[cell] == Mixed)
          continue;
        ++seen[cell].bone;
        if (result(i, j, k) == this->Known[cell])
          continue;
        ++seen[cell].wrong;
        seen[cell].sum += this->Grid.IndexToWorld({ i, j, k });
      }
  const auto isWrong = [&](std::size_t n)
  { return double(seen[n].wrong) > this->Settings.wrongShare * double(seen[n].bone); };
  std::vector<bool> done(this->Known.size(), false);
  std::size_t largest = 0, worst = 0;
  for (std::size_t start = 0; start < this->Known.size(); ++start)
  {
    if (done[start] || !isWrong(start))
      continue;
    std::vector<std::size_t> region{ start };
    done[start] = true;
    std::size_t wrong = 0, worstHere = start;
    for (std::size_t n = 0; n < region.size(); ++n)
    {
      const std::size_t cell = region[n];
      wrong += seen[cell].wrong;
      if (seen[cell].wrong > seen[worstHere].wrong)
        worstHere = cell;
      const glm::ivec3 at = this->Place(cell);
      const glm::ivec3 low = glm::max(at - 1, 0), high = glm::min(at + 1, this->Cells - 1);
      for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
          for (int i = low.x; i <= high.x; ++i)
          {
            const std::size_t next = this->Number({ i, j, k });
            if (done[next] || !isWrong(next) || this->Known[next] != this->Known[start])
              continue;
            done[next] = true;
            region.push_back(next);
          }
    }
    if (wrong > largest)
    {
      largest = wrong;
      worst = worstHere;
    }
  }
  if (largest == 0)
    return std::nullopt;
  return this->HintAt(worst, seen[worst].sum / double(seen[worst].wrong),
    MaxLabel + static_cast<std::uint64_t>(round));
}

} // namespace hasp
