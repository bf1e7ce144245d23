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

constexpr double FarMm = 40.0;   ///< further than this from others no place is better than another
constexpr double WayMm = 16.0;   ///< of a way, to each side: half a long stroke
constexpr double ThickMm = 11.5; ///< so far from others the thickest brush may go

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
  this->Bone.assign(count, 0);
  std::map<Label, Mark> marks;
  for (int k = 0; k < this->Grid.dims.z; ++k)
    for (int j = 0; j < this->Grid.dims.y; ++j)
      for (int i = 0; i < this->Grid.dims.x; ++i)
      {
        const Label label = truth(i, j, k);
        if (label == 0)
          continue;
        const std::size_t cell = this->Number(this->CellOf({ i, j, k }));
        ++this->Bone[cell];
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

glm::dvec3 CoarseTruth::LongWay(
  std::size_t number, double withinMm, const std::vector<std::size_t>& cells) const
{
  const glm::dvec3 at = this->Middle(number);
  std::vector<glm::dvec3> ways;
  for (const std::size_t n : cells)
    if (glm::distance(this->Middle(n), at) <= withinMm)
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

std::vector<std::size_t> CoarseTruth::Follow(
  std::size_t number, const glm::dvec3& along, double leastMm) const
{
  std::vector<std::size_t> way;
  glm::dvec3 forward = along;
  for (std::size_t at = number;;)
  {
    const glm::ivec3 place = this->Place(at);
    const glm::ivec3 low = glm::max(place - 1, 0), high = glm::min(place + 1, this->Cells - 1);
    std::size_t best = at;
    double straightest = 0.5; // no sharper turn than 60 degrees
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
        {
          const std::size_t next = this->Number({ i, j, k });
          if (next == at || this->Known[next] != this->Known[number])
            continue;
          const double straight =
            glm::dot(glm::normalize(this->Middle(next) - this->Middle(at)), forward);
          if (straight <= straightest || this->NearestOtherMm(next) < leastMm)
            continue;
          straightest = straight;
          best = next;
        }
    if (best == at || glm::distance(this->Middle(best), this->Middle(number)) > WayMm)
      return way;
    // Bones are round: the way goes on where it led.
    forward = glm::normalize(forward + glm::normalize(this->Middle(best) - this->Middle(at)));
    way.push_back(best);
    at = best;
  }
}

CoarseHint CoarseTruth::HintAt(
  std::size_t number, const glm::dvec3& place, const glm::dvec3& along, std::uint64_t draw) const
{
  const double away = this->NearestOtherMm(number);
  CoarseHint hint;
  hint.label = this->Known[number];
  // The other cell's near side may be that much nearer than its middle.
  hint.reachMm = std::max(away - 0.5 * this->Settings.cellMm, 0.5 * this->Settings.cellMm);
  const double most = std::min(this->Settings.errorMm, 0.5 * hint.reachMm);
  const glm::dvec3 error = AnyError(most, this->Settings.seed, draw);
  hint.near = place + error;
  hint.along = along;
  const double least = std::min(away, ThickMm);
  std::vector<std::size_t> back = this->Follow(number, -along, least);
  for (auto n = back.rbegin(); n != back.rend(); ++n)
    hint.way.push_back(this->Middle(*n) + error);
  hint.way.push_back(this->Middle(number) + error);
  for (const std::size_t n : this->Follow(number, along, least))
    hint.way.push_back(this->Middle(n) + error);
  return hint;
}

/// Of the cells that are as far from others as any can be, about, the one in whose neighbourhood
/// most of the fragment's bone is: nobody draws on a splinter.
std::size_t CoarseTruth::SolidCell(const Mark& mark) const
{
  std::vector<std::pair<std::size_t, double>> cells;
  double farthest = 0.0;
  for (std::size_t n = 0; n < this->Known.size(); ++n)
    if (this->Known[n] == mark.label)
    {
      cells.emplace_back(n, this->NearestOtherMm(n));
      farthest = std::max(farthest, cells.back().second);
    }
  std::size_t best = this->Known.size();
  std::uint64_t most = 0;
  for (const auto& [n, away] : cells)
  {
    if (away < 0.8 * farthest)
      continue;
    std::uint64_t bone = 0;
    const glm::ivec3 at = this->Place(n);
    const glm::ivec3 low = glm::max(at - 2, 0), high = glm::min(at + 2, this->Cells - 1);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (const std::size_t near = this->Number({ i, j, k }); this->Known[near] == mark.label)
            bone += this->Bone[near];
    if (bone > most)
    {
      most = bone;
      best = n;
    }
  }
  return best;
}

std::vector<CoarseHint> CoarseTruth::Hints() const
{
  std::vector<CoarseHint> hints;
  for (const Mark& mark : this->Marks)
  {
    const std::size_t best = this->SolidCell(mark);
    if (best < this->Known.size())
    {
      std::vector<std::size_t> cells;
      for (std::size_t n = 0; n < this->Known.size(); ++n)
        if (this->Known[n] == mark.label)
          cells.push_back(n);
      hints.push_back(
        this->HintAt(best, this->Middle(best), this->LongWay(best, FarMm, cells), mark.label));
      continue;
    }
    CoarseHint small;
    small.label = mark.label;
    small.near = mark.sum / double(mark.count);
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
  std::size_t largest = 0;
  std::vector<std::size_t> worstRegion;
  for (std::size_t start = 0; start < this->Known.size(); ++start)
  {
    if (done[start] || !isWrong(start))
      continue;
    std::vector<std::size_t> region{ start };
    done[start] = true;
    std::size_t wrong = 0;
    for (std::size_t n = 0; n < region.size(); ++n)
    {
      const std::size_t cell = region[n];
      wrong += seen[cell].wrong;
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
      worstRegion = std::move(region);
    }
  }
  if (largest == 0)
    return std::nullopt;
  // In the middle of what is wrong, where the brush may be thickest; of such cells the worst.
  std::size_t worst = worstRegion[0];
  double farthest = 0.0;
  for (const std::size_t n : worstRegion)
  {
    const double away = std::min(this->NearestOtherMm(n), ThickMm);
    if (away < farthest || (away == farthest && seen[n].wrong <= seen[worst].wrong))
      continue;
    farthest = away;
    worst = n;
  }
  return this->HintAt(worst, seen[worst].sum / double(seen[worst].wrong),
    this->LongWay(worst, WayMm, worstRegion), MaxLabel + static_cast<std::uint64_t>(round));
}

} // namespace hasp
