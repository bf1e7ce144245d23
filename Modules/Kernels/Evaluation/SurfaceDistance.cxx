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

/// The isosurface within a box of cells. Positions are mm along the grid's own axes.
template <typename T>
class Isosurface
{
public:
  Isosurface(const GridView<const T>& volume, double isovalue, const glm::ivec3& first,
    const glm::ivec3& count)
    : Volume(volume),
      Isovalue(isovalue),
      First(first),
      Count(count)
  {
    const std::size_t cells = std::size_t(count.x) * count.y * count.z;
    std::vector<std::vector<glm::dvec3>> slices(count.z);
    this->Start.assign(cells + 1, 0);
    ParallelFor(0, count.z, 1,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t k = low; k < high; ++k)
          for (int j = 0; j < count.y; ++j)
            for (int i = 0; i < count.x; ++i)
            {
              const std::size_t before = slices[k].size();
              this->SampleCell(first + glm::ivec3(i, j, int(k)), slices[k]);
              this->Start[(k * count.y + j) * count.x + i + 1] = slices[k].size() - before;
            }
      });
    for (std::size_t c = 0; c < cells; ++c)
      this->Start[c + 1] += this->Start[c];
    for (const auto& slice : slices)
      this->Samples.insert(this->Samples.end(), slice.begin(), slice.end());
  }

  std::optional<NearestSurface> Nearest(const glm::dvec3& world, double reach) const
  {
    const GridGeometry& g = this->Volume.geometry;
    const glm::dvec3 index = g.WorldToIndex(world), p = index * g.spacing;
    const glm::dvec3 low = glm::dvec3(this->First) * g.spacing - reach;
    const glm::dvec3 high = glm::dvec3(this->First + this->Count) * g.spacing + reach;
    if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high)))
      return std::nullopt; // so far away that cells have no int
    std::vector<Candidate> candidates;
    const double least = this->FindCandidates(p, reach, candidates);
    std::sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    Candidate best{ std::numeric_limits<double>::infinity(), {}, {} };
    for (const Candidate& c : candidates)
      if (c.distance <= least + this->Cover() && this->BoxDistance(c.cell, p) < best.distance)
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
  struct Candidate
  {
    double distance;
    glm::dvec3 point;
    glm::ivec3 cell;
  };

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

  /// The best sample of every cell, from shells of cells around the point until none can be nearer.
  double FindCandidates(const glm::dvec3& p, double reach, std::vector<Candidate>& candidates) const
  {
    const glm::dvec3 spacing = this->Volume.geometry.spacing;
    const double step = std::min({ spacing.x, spacing.y, spacing.z });
    const glm::ivec3 home(glm::floor(p / spacing));
    double least = std::numeric_limits<double>::infinity();
    for (int ring = 0; (ring - 1) * step <= std::min(reach, least) + this->Cover(); ++ring)
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
    return least;
  }

  std::size_t Number(const glm::ivec3& cell) const
  {
    const glm::ivec3 at = cell - this->First;
    return (std::size_t(at.z) * this->Count.y + at.y) * this->Count.x + at.x;
  }
  double BoxDistance(const glm::ivec3& cell, const glm::dvec3& p) const
  {
    const glm::dvec3 spacing = this->Volume.geometry.spacing, low = glm::dvec3(cell) * spacing;
    return glm::length(glm::max(glm::max(low - p, p - low - spacing), glm::dvec3(0.0)));
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
    if (this->BoxDistance(cell, p) > std::min(reach, least + this->Cover()))
      return; // even its box is too far
    Candidate best{ std::numeric_limits<double>::infinity(), {}, cell };
    for (std::size_t s = this->Start[n]; s < this->Start[n + 1]; ++s)
      if (const double d = glm::length(this->Samples[s] - p); d < best.distance)
      {
        best.distance = d;
        best.point = this->Samples[s];
      }
    if (!std::isfinite(best.distance))
      return;
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
        TrilinearGradient(corners, at.point / spacing - glm::dvec3(at.cell)) / spacing;
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
    const glm::dvec3 spacing = this->Volume.geometry.spacing;
    for (int n = 0; n < 12; ++n)
    {
      const glm::dvec3 t = point / spacing - glm::dvec3(cell);
      const double v = TrilinearValue(corners, t) - this->Isovalue;
      glm::dvec3 g = TrilinearGradient(corners, t) / spacing;
      for (int a = 0; a < 3; ++a) // a wall that the step would cross takes its component out
        if ((point[a] <= low[a] && v * g[a] > 0.0) || (point[a] >= high[a] && v * g[a] < 0.0))
          g[a] = 0.0;
      const double squared = glm::dot(g, g);
      if (std::abs(v) <= 1e-7 * std::sqrt(squared))
        return squared > 0.0;
      if (!(squared > 0.0))
        return false;
      point = glm::clamp(point - v / squared * g, low, high);
    }
    return false;
  }

  const GridView<const T>& Volume;
  double Isovalue;
  glm::ivec3 First, Count;        ///< the box of cells looked at
  std::vector<std::size_t> Start; ///< samples of cell n: Start[n] to Start[n + 1]
  std::vector<glm::dvec3> Samples;
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
          for (std::int64_t n = first; n < last; ++n)
            if (finite(points[n]))
              result[n] = surface.Nearest(points[n], reachMm);
        });
    }
  };
  std::visit(measure, volume);
  ReportProgress(progress, 1.0);
  return result;
}

} // namespace hasp
