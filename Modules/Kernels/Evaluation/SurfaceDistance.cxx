#include "Evaluation/SurfaceDistance.h"

#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr int LinesPerSide = 5;

/// A cell's surface: its nearest sample, and what no place of it is nearer than.
struct Candidate
{
  double distance, bound;
  glm::dvec3 point;
  glm::ivec3 cell;
};

/// The isosurface within a box of cells. Positions are mm along the grid's own axes.
template <typename T>
class Isosurface
{
public:
  Isosurface(const GridView<const T>& volume, double isovalue, const glm::ivec3& first,
    const glm::ivec3& count)
    : Volume(volume),
      Isovalue(isovalue),
      PerMm(1.0 / volume.geometry.spacing),
      First(first),
      Count(count)
  {
    const std::size_t cells = std::size_t(count.x) * count.y * count.z;
    std::vector<std::vector<glm::dvec3>> slices(count.z);
    this->Start.assign(cells + 1, 0);
    this->Steepest.assign(cells, 0.0);
    ParallelFor(0, count.z, 1,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t k = low; k < high; ++k)
          for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i)
            {
              const std::size_t before = slices[k].size();
              this->SampleCell(first + glm::ivec3(i, j, int(k)), slices[k]);
              const std::size_t cell = (k * count.y + j) * count.x + i;
              this->Start[cell + 1] = slices[k].size() - before;
              if (slices[k].size() > before)
                this->Steepest[cell] = this->SteepestIn(first + glm::ivec3(i, j, int(k)));
            }
      });
    for (std::size_t c = 0; c < cells; ++c)
      this->Start[c + 1] += this->Start[c];
    for (const auto& slice : slices)
      this->Samples.insert(this->Samples.end(), slice.begin(), slice.end());
  }

  /// `candidates`: room to work in.
  std::optional<NearestSurface> Nearest(
    const glm::dvec3& world, double reach, std::vector<Candidate>& candidates) const
  {
    const GridGeometry& g = this->Volume.geometry;
    const glm::dvec3 index = g.WorldToIndex(world), p = index * g.spacing;
    const glm::dvec3 low = glm::dvec3(this->First) * g.spacing - reach;
    const glm::dvec3 high = glm::dvec3(this->First + this->Count) * g.spacing + reach;
    if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high)))
      return std::nullopt; // so far away that cells have no int
    candidates.clear();
    this->FindCandidates(p, reach, candidates);
    std::sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    Candidate best{};
    best.distance = std::numeric_limits<double>::infinity();
    for (const Candidate& c : candidates)
      if (std::max(c.distance - this->Cover(), c.bound) < best.distance)
        if (const Candidate foot = this->Descend(c, p); foot.distance < best.distance)
          best = foot;
    if (!(best.distance <= reach))
      return std::nullopt;
    const glm::dvec3 closest = best.point / g.spacing;
    const glm::dvec3 gradient = g.GradientToWorld(
      TrilinearGradient(this->Corners(best.cell), closest - glm::dvec3(best.cell)));
    const auto value = SampleTrilinear(this->Volume, index);
    return NearestSurface{ value && *value >= this->Isovalue ? -best.distance : best.distance,
      g.IndexToWorld(closest), -gradient / std::max(glm::length(gradient), 1e-300) };
  }

private:
  /// Any point of a cell's surface has a sample of that cell within one line spacing per axis.
  double Cover() const { return glm::length(this->Volume.geometry.spacing) / (LinesPerSide - 1); }

  std::array<double, 8> Corners(const glm::ivec3& cell) const
  {
    return CellCorners(this->Volume, cell);
  }

  /// The crossings of a cell's surface with lines parallel to its edges.
  void SampleCell(const glm::ivec3& cell, std::vector<glm::dvec3>& samples) const
  {
    std::array<double, 8> c = this->Corners(cell);
    int inside = 0;
    for (double& v : c)
    {
      v -= this->Isovalue;
      inside += v >= 0.0;
      if (!std::isfinite(v))
        return; // no surface next to NaN
    }
    if (inside == 0 || inside == 8)
      return;
    for (int axis = 0; axis < 3; ++axis)
      for (int line = 0; line < LinesPerSide * LinesPerSide; ++line)
      {
        glm::dvec3 t(0.0);
        t[(axis + 1) % 3] = double(line % LinesPerSide) / (LinesPerSide - 1);
        t[(axis + 2) % 3] = double(line / LinesPerSide) / (LinesPerSide - 1);
        const double v0 = TrilinearValue(c, t);
        t[axis] = 1.0;
        const double v1 = TrilinearValue(c, t);
        if ((v0 >= 0.0) == (v1 >= 0.0))
          continue;
        t[axis] = v0 / (v0 - v1);
        samples.push_back((glm::dvec3(cell) + t) * this->Volume.geometry.spacing);
      }
  }

  /// At most, what a cell's values change a mm: each partial derivative is a mean of four edges'.
  double SteepestIn(const glm::ivec3& cell) const
  {
    const auto c = this->Corners(cell);
    glm::dvec3 edge(0.0);
    for (int n = 0; n < 8; ++n)
      for (int a = 0; a < 3; ++a)
        if (!(n >> a & 1))
          edge[a] = std::max(edge[a], std::abs(c[n | 1 << a] - c[n]));
    return glm::length(edge / this->Volume.geometry.spacing);
  }

  /// The best sample of every cell, from shells of cells around the point until none can be nearer.
  void FindCandidates(const glm::dvec3& p, double reach, std::vector<Candidate>& candidates) const
  {
    const glm::dvec3 spacing = this->Volume.geometry.spacing;
    const double step = std::min({ spacing.x, spacing.y, spacing.z });
    const glm::ivec3 home(glm::floor(p / spacing));
    double least = std::numeric_limits<double>::infinity();
    for (int ring = 0; (ring - 1) * step <= std::min(reach, least); ++ring)
    {
      const glm::ivec3 low = glm::max(home - ring, this->First);
      const glm::ivec3 high = glm::min(home + ring, this->First + this->Count - 1);
      for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
        {
          const bool face = std::abs(k - home.z) == ring || std::abs(j - home.y) == ring;
          if (low.x > high.x || this->Empty(low.x, high.x, j, k))
            continue;
          for (int i = low.x; i <= high.x; ++i)
            if (face || std::abs(i - home.x) == ring)
              this->BestOfCell({ i, j, k }, p, reach, candidates, least);
        }
    }
  }

  std::size_t Number(const glm::ivec3& cell) const
  {
    const glm::ivec3 at = cell - this->First;
    return (std::size_t(at.z) * this->Count.y + at.y) * this->Count.x + at.x;
  }
  /// No place of the cell's surface is nearer: it is away from the cell's nearest place by what the
  /// value there says, at an angle to the way there of 90 degrees or more, as the cell is convex.
  double LeastDistance(const glm::ivec3& cell, const glm::dvec3& p) const
  {
    const glm::dvec3 spacing = this->Volume.geometry.spacing, low = glm::dvec3(cell) * spacing;
    const glm::dvec3 place = glm::clamp(p, low, low + spacing), way = p - place;
    const double value = TrilinearValue(this->Corners(cell), (place - low) / spacing);
    const double steepest = this->Steepest[this->Number(cell)];
    const double inside = steepest > 1e-100 ? (value - this->Isovalue) / steepest : 0.0;
    return std::sqrt(glm::dot(way, way) + inside * inside) * (1.0 - 1e-6); // less than rounding
  }
  /// No surface in a row of cells.
  bool Empty(int low, int high, int j, int k) const
  {
    return this->Start[this->Number({ low, j, k })] ==
           this->Start[this->Number({ high, j, k }) + 1];
  }

  void BestOfCell(const glm::ivec3& cell, const glm::dvec3& p, double reach,
    std::vector<Candidate>& candidates, double& least) const
  {
    const std::size_t n = this->Number(cell);
    if (this->Start[n] == this->Start[n + 1])
      return;
    const double bound = this->LeastDistance(cell, p);
    if (bound > std::min(reach, least))
      return;
    Candidate best{ std::numeric_limits<double>::infinity(), bound, {}, cell };
    for (std::size_t s = this->Start[n]; s < this->Start[n + 1]; ++s)
    {
      const glm::dvec3 off = this->Samples[s] - p;
      if (const double squared = glm::dot(off, off); squared < best.distance)
      {
        best.distance = squared;
        best.point = this->Samples[s];
      }
    }
    if (!std::isfinite(best.distance))
      return;
    best.distance = std::sqrt(best.distance);
    candidates.push_back(best);
    least = std::min(least, best.distance);
  }

  /// Walks over the surface within the cell while the distance to p falls.
  Candidate Descend(Candidate at, const glm::dvec3& p) const
  {
    const glm::dvec3 spacing = this->Volume.geometry.spacing;
    const auto corners = this->Corners(at.cell);
    const glm::dvec3 low = glm::dvec3(at.cell) * spacing, high = low + spacing;
    double share = 1.0;
    for (int n = 0; n < 100 && share > 0.02; ++n)
    {
      const glm::dvec3 g =
        TrilinearGradient(corners, at.point * this->PerMm - glm::dvec3(at.cell)) * this->PerMm;
      const double squared = glm::dot(g, g);
      if (!(squared > 0.0))
        break;
      const glm::dvec3 target = p - glm::dot(p - at.point, g) / squared * g;
      glm::dvec3 next = glm::clamp(at.point + share * (target - at.point), low, high);
      const bool onSurface = this->PullToSurface(corners, at.cell, low, high, next);
      const double distance = glm::length(next - p);
      if (onSurface && distance < at.distance)
      {
        const bool settled = at.distance - distance < 1e-7;
        at.point = next;
        at.distance = distance;
        if (settled)
          break;
        share = std::min(1.0, 1.5 * share);
      }
      else
        share *= 0.5;
    }
    return at;
  }

  /// Newton steps along the gradient, within the cell; false if they do not arrive.
  bool PullToSurface(const std::array<double, 8>& corners, const glm::ivec3& cell,
    const glm::dvec3& low, const glm::dvec3& high, glm::dvec3& point) const
  {
    for (int n = 0; n < 12; ++n)
    {
      const glm::dvec3 t = point * this->PerMm - glm::dvec3(cell);
      const double v = TrilinearValue(corners, t) - this->Isovalue;
      glm::dvec3 g = TrilinearGradient(corners, t) * this->PerMm;
      for (int a = 0; a < 3; ++a) // a wall that the step would cross takes its component out
        if ((point[a] <= low[a] && v * g[a] > 0.0) || (point[a] >= high[a] && v * g[a] < 0.0))
          g[a] = 0.0;
      const double squared = glm::dot(g, g);
      if (v * v <= 1e-14 * squared)
        return squared > 0.0;
      if (!(squared > 0.0))
        return false;
      point = glm::clamp(point - v / squared * g, low, high);
    }
    return false;
  }

  const GridView<const T>& Volume;
  double Isovalue;
  glm::dvec3 PerMm;               ///< cells
  glm::ivec3 First, Count;        ///< the box of cells looked at
  std::vector<std::size_t> Start; ///< samples of cell n: Start[n] to Start[n + 1]
  std::vector<glm::dvec3> Samples;
  std::vector<double> Steepest; ///< of cells with samples, a mm
};
} // namespace

std::vector<std::optional<NearestSurface>> DistanceToIsosurface(const AnyGridView& volume,
  double isovalue, std::span<const glm::dvec3> points, double reachMm,
  const ProgressFunction& progress)
{
  const GridGeometry& g = GeometryOf(volume);
  g.Validate();
  if (!std::isfinite(isovalue) || !(reachMm > 0.0) || !std::isfinite(reachMm))
    throw std::invalid_argument("surface distance: isovalue and reach must be finite, reach > 0");
  std::vector<std::optional<NearestSurface>> result(points.size());
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  const auto finite = [](const glm::dvec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  for (const glm::dvec3& p : points)
    if (finite(p))
    {
      low = glm::min(low, g.WorldToIndex(p) - reachMm / g.spacing);
      high = glm::max(high, g.WorldToIndex(p) + reachMm / g.spacing);
    }
  low = glm::max(glm::floor(low), glm::dvec3(0.0));
  high = glm::min(glm::ceil(high), glm::dvec3(g.Cells()));
  if (!glm::all(glm::lessThan(low, high)))
    return result;
  const auto measure = [&](const auto& view)
  {
    const Isosurface surface(view, isovalue, glm::ivec3(low), glm::ivec3(high - low));
    const auto count = static_cast<std::int64_t>(points.size());
    const std::int64_t step = std::max<std::int64_t>(1, count / 20); // points between two reports
    for (std::int64_t from = 0; from < count; from += step)
    {
      ReportProgress(progress, double(from) / double(count));
      ParallelFor(from, std::min(count, from + step), 64,
        [&](std::int64_t first, std::int64_t last)
        {
          std::vector<Candidate> candidates;
          for (std::int64_t n = first; n < last; ++n)
            if (finite(points[n]))
              result[n] = surface.Nearest(points[n], reachMm, candidates);
        });
    }
  };
  std::visit(measure, volume);
  ReportProgress(progress, 1.0);
  return result;
}

} // namespace hasp
