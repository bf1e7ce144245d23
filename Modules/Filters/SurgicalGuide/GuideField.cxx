#include "GuideField.h"

#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <limits>
#include <sstream>

namespace hasp
{

namespace
{
constexpr int LeastNodes = 4; // grid points the smallest slot or hole allowed takes from a guide

/// Whether kept bone lies above a point of the working grid's top, along the withdrawal direction.
template <typename T>
bool BoneAbove(const GridView<const T>& ct, const std::vector<std::uint8_t>& keep, double isovalue,
  const glm::dvec3& from, const glm::dvec3& up)
{
  const GridGeometry& g = ct.geometry;
  const double step = 0.5 * std::min({ g.spacing.x, g.spacing.y, g.spacing.z });
  const glm::dvec3 size = glm::dvec3(g.dims) * g.spacing;
  const glm::dvec3 middle = g.IndexToWorld(0.5 * glm::dvec3(g.Cells()));
  const double end = glm::dot(middle - from, up) + 0.5 * glm::length(size);
  for (double t = 0.0; t < end; t += step)
  {
    const auto at = LocateCell(g, g.WorldToIndex(from + t * up));
    if (!at)
      continue;
    const glm::ivec3 nearest = at->cell + glm::ivec3(glm::round(at->local));
    if (TrilinearValue(CellCorners(ct, at->cell), at->local) >= isovalue &&
        keep[ct.Offset(nearest.x, nearest.y, nearest.z)])
      return true;
  }
  return false;
}

/// Turns the distance to bone into the guide's field, column by column from the top.
class Composer
{
public:
  Composer(const GuideFrame& f, const GuideRecipe& r)
    : Frame(f),
      Recipe(r),
      Taken(r.slots.size() + r.holes.size())
  {
  }

  /// `below`: the least distance to bone seen so far from above.
  void Column(std::vector<float>& field, int i, int j, double below)
  {
    const GridGeometry& g = this->Frame.Grid();
    const std::size_t slice = std::size_t(g.dims.x) * g.dims.y;
    for (int k = g.dims.z - 1; k >= 0; --k)
    {
      float& value = field[k * slice + std::size_t(j) * g.dims.x + i];
      below = std::min(below, double(value));
      const double shell = std::max(
        this->Recipe.gapMm - below, double(value) - this->Recipe.gapMm - this->Recipe.thicknessMm);
      // Farther from the shell than its neighbours can tell, the rest makes no difference.
      value = static_cast<float>(
        shell > 3.0 * g.spacing.z ? shell : this->Carve(shell, g.IndexToWorld({ i, j, k })));
    }
  }

  /// Throws if there is no guide, or a slot or hole took next to nothing from it.
  void CheckEachTookSomething() const
  {
    if (this->Body == 0)
      throw NothingLeft();
    for (std::size_t n = 0; n < this->Taken.size(); ++n)
      if (this->Taken[n] < LeastNodes)
      {
        const bool slot = n < this->Recipe.slots.size();
        std::ostringstream text;
        text << "guide: " << (slot ? "slots[" : "holes[")
             << (slot ? n : n - this->Recipe.slots.size()) << "] does not meet the guide";
        throw std::runtime_error(text.str());
      }
  }

private:
  double Carve(double shell, const glm::dvec3& world)
  {
    const double body = std::max(shell, this->Frame.Region(world));
    if (body < 0.0)
      this->Body.fetch_add(1, std::memory_order_relaxed);
    double value = body;
    std::size_t n = 0;
    const auto cut = [&](double distance)
    {
      if (body < 0.0 && distance < 0.0)
        this->Taken[n].fetch_add(1, std::memory_order_relaxed);
      value = std::max(value, -distance);
      ++n;
    };
    for (const GuideSlot& slot : this->Recipe.slots)
      cut(this->Frame.Slot(slot, world));
    for (const GuideHole& hole : this->Recipe.holes)
      cut(GuideFrame::Hole(hole, world));
    return value;
  }

  const GuideFrame& Frame;
  const GuideRecipe& Recipe;
  std::atomic<std::size_t> Body{ 0 };          ///< grid points inside, before slots and holes
  std::vector<std::atomic<std::size_t>> Taken; ///< of these, by each slot, then by each hole
};
} // namespace

std::runtime_error NothingLeft()
{
  return std::runtime_error(
    "guide: nothing is left: no bone faces the withdrawal direction around the landmarks");
}

void ComposeGuideField(std::vector<float>& field, const AnyGridView& ct,
  const std::vector<std::uint8_t>& keep, const GuideFrame& frame, const GuideRecipe& recipe,
  const ProgressFunction& progress)
{
  const GridGeometry& g = frame.Grid();
  Composer composer(frame, recipe);
  const auto row = [&](int j)
  {
    for (int i = 0; i < g.dims.x; ++i)
    {
      const glm::dvec3 top = g.IndexToWorld({ i, j, g.dims.z - 1 });
      const bool blocked = std::visit([&](const auto& view)
        { return BoneAbove(view, keep, recipe.isovalue, top, g.direction[2]); },
        ct);
      composer.Column(field, i, j, blocked ? -1.0 : std::numeric_limits<double>::infinity());
    }
  };
  const int step = std::max(1, g.dims.y / 10); // rows between two reports
  for (int j = 0; j < g.dims.y; j += step)
  {
    ReportProgress(progress, double(j) / g.dims.y);
    ParallelFor(j, std::min(g.dims.y, j + step), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
          row(static_cast<int>(n));
      });
  }
  composer.CheckEachTookSomething();
}

} // namespace hasp
