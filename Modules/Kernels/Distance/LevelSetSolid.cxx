#include "Distance/LevelSetSolid.h"

#include "Distance/SolidShapes.h"
#include "Grid/ParallelFor.h"
#include "LevelSetCells.h"
#include "SolidChecks.h"

#include <mutex>

namespace hasp
{

namespace
{
using Leaf = openvdb::FloatTree::LeafNodeType;

constexpr double SteepestMmPerMm = 3.0;
constexpr int Side = static_cast<int>(Leaf::DIM);

/// What a level set holds: how steep it is, and where it is negative.
class Survey
{
public:
  Survey(const openvdb::FloatGrid& grid, const glm::dvec3& spacing) : Grid(grid), Spacing(spacing)
  {
    std::vector<const Leaf*> leaves;
    grid.tree().getNodes(leaves);
    ParallelFor(0, std::int64_t(leaves.size()), 64,
      [&](std::int64_t first, std::int64_t last)
      {
        Facts facts;
        const LevelSetCells cells(grid);
        for (std::int64_t n = first; n < last; ++n)
          this->LookAt(*leaves[n], cells, facts);
        const std::lock_guard lock(this->Mutex);
        this->All.Add(facts);
      });
    const LevelSetCells cells(grid);
    auto tile = grid.tree().cbeginValueAll();
    for (tile.setMaxDepth(openvdb::FloatTree::ValueAllCIter::LEAF_DEPTH - 1); tile; ++tile)
      if (*tile < 0.0F) // tiles outside have the background's value, or one of these beside them
        this->LookAt(tile.getBoundingBox(), cells);
  }

  struct Facts
  {
    glm::ivec3 low{ std::numeric_limits<int>::max() }, high{ std::numeric_limits<int>::min() };
    double steepest = 0.0; ///< mm a mm; infinite where a value is not finite

    void Include(const glm::ivec3& p)
    {
      this->low = glm::min(this->low, p);
      this->high = glm::max(this->high, p);
    }
    void Add(const Facts& other)
    {
      this->low = glm::min(this->low, other.low);
      this->high = glm::max(this->high, other.high);
      this->steepest = std::max(this->steepest, other.steepest);
    }
  };
  const Facts& Found() const { return this->All; }

private:
  /// All cells with a corner in a leaf.
  void LookAt(const Leaf& leaf, const LevelSetCells& cells, Facts& facts) const
  {
    const openvdb::Coord& o = leaf.origin();
    for (int x = -1; x < Side; ++x)
      for (int y = -1; y < Side; ++y)
        for (int z = -1; z < Side; ++z)
        {
          const glm::ivec3 cell(o.x() + x, o.y() + y, o.z() + z);
          const auto corners = cells.Corners(cell);
          facts.steepest = std::max(facts.steepest, this->SteepestOf(corners));
          if (corners[0] < 0.0)
            facts.Include(cell);
        }
  }

  /// A tile inside: its faces, at every leaf's corner, since neighbours are leaves or tiles.
  void LookAt(const openvdb::CoordBBox& box, const LevelSetCells& cells)
  {
    const glm::ivec3 low(box.min().x(), box.min().y(), box.min().z());
    const glm::ivec3 high(box.max().x(), box.max().y(), box.max().z());
    this->All.Include(low);
    this->All.Include(high);
    for (int axis = 0; axis < 3; ++axis)
      for (const int at : { low[axis] - 1, high[axis] })
      {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::ivec3 cell;
        cell[axis] = at;
        for (cell[u] = low[u]; cell[u] <= high[u]; cell[u] += Side)
          for (cell[v] = low[v]; cell[v] <= high[v]; cell[v] += Side)
            this->All.steepest =
              std::max(this->All.steepest, this->SteepestOf(cells.Corners(cell)));
      }
  }

  /// The most that a cell's trilinear polynomial changes: each component is a mean of four edges'.
  double SteepestOf(const std::array<double, 8>& c) const
  {
    if (!std::isfinite(c[0] + c[1] + c[2] + c[3] + c[4] + c[5] + c[6] + c[7]))
      return std::numeric_limits<double>::infinity();
    glm::dvec3 edge(0.0);
    for (int n = 0; n < 8; ++n)
      for (int a = 0; a < 3; ++a)
        if (!(n >> a & 1))
          edge[a] = std::max(edge[a], std::abs(c[n | 1 << a] - c[n]));
    return glm::length(edge / this->Spacing);
  }

  const openvdb::FloatGrid& Grid;
  glm::dvec3 Spacing;
  std::mutex Mutex;
  Facts All;
};

class LevelSetSolid : public ImplicitSolid
{
public:
  LevelSetSolid(openvdb::FloatGrid::ConstPtr grid, const LevelSetFrame& frame, SolidPointer around,
    double steepness)
    : Grid(std::move(grid)),
      Frame(frame),
      Around(std::move(around)),
      Steep(std::max(1.0, steepness))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const LevelSetCells cells(*this->Grid);
    const auto [cell, local] = cells.Locate(this->Frame.Index(x));
    return std::max(TrilinearValue(cells.Corners(cell), local), this->Around->At(x));
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const LevelSetCells cells(*this->Grid);
    const auto [cell, local] = cells.Locate(this->Frame.Index(x));
    const auto corners = cells.Corners(cell);
    const Sample around = this->Around->SampleAt(x);
    if (const double value = TrilinearValue(corners, local); !(value < around.value))
      return { value, TrilinearGradient(corners, local) * this->Frame.toIndex, 0 };
    return { around.value, around.gradient, 0 };
  }
  Sample FaceAt(std::uint32_t, const glm::dvec3& x) const noexcept override
  {
    return this->SampleAt(x);
  }
  std::uint32_t Faces() const noexcept override { return 1; }
  Box Bounds() const noexcept override { return this->Around->Bounds(); }
  double Steepness() const noexcept override { return this->Steep; }

private:
  openvdb::FloatGrid::ConstPtr Grid;
  LevelSetFrame Frame;
  SolidPointer Around; ///< the box of what is inside
  double Steep;
};

/// Columns of a grid's frame as lengths and directions.
struct Axes
{
  glm::dvec3 spacing;
  glm::dmat3 direction;
};
Axes AxesOf(const LevelSetFrame& frame)
{
  Axes axes{};
  for (int a = 0; a < 3; ++a)
  {
    axes.spacing[a] = glm::length(frame.toWorld[a]);
    axes.direction[a] = frame.toWorld[a] / axes.spacing[a];
  }
  for (int a = 0; a < 3; ++a)
    if (const double dot = glm::dot(axes.direction[a], axes.direction[(a + 1) % 3]);
        !(std::abs(dot) <= 1e-4))
      throw std::invalid_argument("level set solid: two of the grid's axes have the dot product " +
                                  SolidNumber(dot) + "; it must be 0 within 1e-4: resample it");
  return axes;
}
} // namespace

SolidPointer MakeLevelSetSolid(openvdb::FloatGrid::ConstPtr levelSet)
{
  if (!levelSet || levelSet->getGridClass() != openvdb::GRID_LEVEL_SET)
    throw std::invalid_argument(levelSet
                                  ? "level set solid: the grid's class is no level set; give "
                                    "one of distances, as LevelSetOf makes it"
                                  : "level set solid: no grid; give one");
  const LevelSetFrame frame(*levelSet);
  const auto [spacing, direction] = AxesOf(frame);
  const double background = levelSet->background(), diagonal = glm::length(spacing);
  if (!(background >= 0.999 * diagonal && std::isfinite(background)))
    throw std::invalid_argument("level set solid: a background of " + SolidNumber(background) +
                                " mm; it must be finite and at least a voxel's diagonal, " +
                                SolidNumber(diagonal) + " mm: make a wider band");
  levelSet->tree().readNonresidentBuffers(); // of a file: not while someone asks
  const Survey survey(*levelSet, spacing);
  const Survey::Facts& found = survey.Found();
  if (!(found.steepest <= SteepestMmPerMm))
    throw std::invalid_argument("level set solid: the values change by " +
                                SolidNumber(found.steepest) +
                                " mm a mm; at most 3, and finite: give distances in mm, and a band "
                                "without holes");
  if (found.low.x > found.high.x)
    throw std::invalid_argument("level set solid: nothing is inside; leave the part out");
  const glm::dvec3 low(found.low), high(found.high);
  SolidPointer around = MakeBox(frame.origin + frame.toWorld * (0.5 * (low + high)), direction,
    (0.5 * (high - low) + 2.0) * spacing);
  return std::make_shared<LevelSetSolid>(
    std::move(levelSet), frame, std::move(around), found.steepest);
}

} // namespace hasp
