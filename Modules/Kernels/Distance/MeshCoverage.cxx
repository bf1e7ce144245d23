#include "Distance/MeshCoverage.h"

#include "Grid/ParallelFor.h"
#include "MeshChecks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

/// Where a line along x meets a triangle; turn: +1 where it leaves, -1 where it enters.
struct Crossing
{
  std::int64_t line;
  double x;
  int turn;
};

void Check(const TriangleMesh& mesh, const GridGeometry& target, int linesPerAxis)
{
  target.Validate();
  if (linesPerAxis < 1 || linesPerAxis > 16)
    throw std::invalid_argument(
      "mesh coverage: linesPerAxis is " + std::to_string(linesPerAxis) + ", must be in [1, 16]");
  RequireClosedMesh("mesh coverage", mesh);
}

/// One mesh in the index coordinates of one grid, cut into its slices of voxels.
class Slicer
{
public:
  Slicer(const TriangleMesh& mesh, const GridGeometry& target, int linesPerAxis)
    : Mesh(mesh),
      Target(target),
      N(linesPerAxis)
  {
    this->Points.reserve(mesh.points.size());
    for (const glm::dvec3& p : mesh.points)
      this->Points.push_back(target.WorldToIndex(p));
    this->Sort();
  }

  /// All of slice k: its voxels' shares.
  void Fill(int k, float* slice) const
  {
    std::vector<Crossing> crossings;
    for (std::size_t n = this->Begins[k]; n < this->Begins[k + 1]; ++n)
      this->Cross(k, this->Mesh.triangles[this->Members[n]], crossings);
    std::sort(crossings.begin(), crossings.end(),
      [](const Crossing& a, const Crossing& b)
      { return std::tie(a.line, a.x, a.turn) < std::tie(b.line, b.x, b.turn); });
    const double share = 1.0 / (double(this->N) * this->N);
    for (std::size_t n = 0; n < crossings.size();)
    {
      const std::int64_t line = crossings[n].line;
      float* row = slice + (line / this->N % this->Target.dims.y) * this->Target.dims.x;
      int winding = 0;
      for (; n < crossings.size() && crossings[n].line == line; ++n)
      {
        if (winding != 0)
          this->AddSpan(row, crossings[n - 1].x, crossings[n].x, share);
        winding += crossings[n].turn;
      }
    }
  }

private:
  double LineY(std::int64_t line) const
  {
    return double(line % (std::int64_t(this->N) * this->Target.dims.y) + 0.5) / this->N - 0.5;
  }
  double LineZ(int k, std::int64_t line) const
  {
    return k + double(line / (std::int64_t(this->N) * this->Target.dims.y) + 0.5) / this->N - 0.5;
  }

  /// The slices whose lines a triangle may meet; none: first > last.
  std::pair<int, int> SlicesOf(const glm::uvec3& t) const
  {
    const double a = this->Points[t.x].z, b = this->Points[t.y].z, c = this->Points[t.z].z;
    const double low = std::max(std::min({ a, b, c }), -1.0);
    const double high = std::min(std::max({ a, b, c }), double(this->Target.dims.z));
    return { std::max(0, int(std::floor(low + 0.5))),
      std::min(this->Target.dims.z - 1, int(std::floor(high + 0.5))) };
  }

  /// Triangles of each slice, one list after the other.
  void Sort()
  {
    this->Begins.assign(std::size_t(this->Target.dims.z) + 2, 0);
    for (const glm::uvec3& t : this->Mesh.triangles)
      for (auto [k, last] = this->SlicesOf(t); k <= last; ++k)
        ++this->Begins[std::size_t(k) + 2];
    for (std::size_t k = 2; k < this->Begins.size(); ++k)
      this->Begins[k] += this->Begins[k - 1];
    this->Members.resize(this->Begins.back());
    for (std::size_t n = 0; n < this->Mesh.triangles.size(); ++n)
      for (auto [k, last] = this->SlicesOf(this->Mesh.triangles[n]); k <= last; ++k)
        this->Members[this->Begins[std::size_t(k) + 1]++] = static_cast<std::uint32_t>(n);
  }

  /// How the edge from a to b turns about the line at (y, z), seen along x: +-1 if the edge passes
  /// on the side of larger y. The intersection is computed from the same end whichever triangle
  /// asks, so that two that share the edge agree to the last bit: the turns of a closed mesh cancel
  /// exactly.
  static int Turn(const glm::dvec3& a, const glm::dvec3& b, double y, double z)
  {
    if ((a.z > z) == (b.z > z))
      return 0;
    const bool up = b.z > z;
    const glm::dvec3 &low = up ? a : b, &high = up ? b : a;
    return low.y + (high.y - low.y) * ((z - low.z) / (high.z - low.z)) > y ? (up ? 1 : -1) : 0;
  }

  void Cross(int k, const glm::uvec3& t, std::vector<Crossing>& crossings) const
  {
    const glm::dvec3 &a = this->Points[t.x], &b = this->Points[t.y], &c = this->Points[t.z];
    const double area = (b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z);
    const double left = std::min({ a.x, b.x, c.x }), right = std::max({ a.x, b.x, c.x });
    // Lines at n (v + 1/2) - 1/2: the first at or above the triangle's least, the last below its
    // most.
    const auto range = [this](double least, double most, double begin, std::int64_t count)
    {
      const double top = double(count);
      const auto line = [&](double v) { return (v - begin) * this->N - 0.5; };
      return std::pair{ std::int64_t(std::ceil(std::clamp(line(least) - 1e-6, 0.0, top))),
        std::int64_t(std::floor(std::clamp(line(most) + 1e-6, -1.0, top - 1.0))) };
    };
    const std::int64_t perRow = std::int64_t(this->N) * this->Target.dims.y;
    const auto [y0, y1] =
      range(std::min({ a.y, b.y, c.y }), std::max({ a.y, b.y, c.y }), -0.5, perRow);
    const auto [z0, z1] =
      range(std::min({ a.z, b.z, c.z }), std::max({ a.z, b.z, c.z }), k - 0.5, this->N);
    for (std::int64_t row = z0; row <= z1; ++row)
      for (std::int64_t at = y0; at <= y1; ++at)
      {
        const std::int64_t line = row * perRow + at;
        const double y = this->LineY(line), z = this->LineZ(k, line);
        const int turn = Turn(a, b, y, z) + Turn(b, c, y, z) + Turn(c, a, y, z);
        if (turn == 0)
          continue;
        const double u = ((y - a.y) * (c.z - a.z) - (c.y - a.y) * (z - a.z)) / area;
        const double v = ((b.y - a.y) * (z - a.z) - (y - a.y) * (b.z - a.z)) / area;
        const double x = a.x + u * (b.x - a.x) + v * (c.x - a.x);
        // Seen edge-on the plane says nothing; the triangle is somewhere in its own extent.
        crossings.push_back({ line, x >= left && x <= right ? x : 0.5 * (left + right), turn });
      }
  }

  void AddSpan(float* row, double from, double to, double share) const
  {
    const double end = this->Target.dims.x;
    from = std::clamp(from + 0.5, 0.0, end); // voxel i is [i, i + 1] of these
    to = std::min(to + 0.5, end);
    for (int i = int(from); i < to; ++i)
      row[i] +=
        static_cast<float>(share * (std::min(to, double(i) + 1.0) - std::max(from, double(i))));
  }

  const TriangleMesh& Mesh;
  const GridGeometry& Target;
  int N;
  std::vector<glm::dvec3> Points;
  std::vector<std::size_t> Begins;
  std::vector<std::uint32_t> Members;
};

} // namespace

std::vector<float> MeshCoverage(const TriangleMesh& mesh, const GridGeometry& target,
  int linesPerAxis, const ProgressFunction& progress)
{
  Check(mesh, target, linesPerAxis);
  const Slicer slicer(mesh, target, linesPerAxis);
  std::vector<float> coverage(target.Size());
  const std::size_t slice = std::size_t(target.dims.x) * target.dims.y;
  const std::int64_t step = std::max(1, target.dims.z / 20); // slices between two reports
  for (std::int64_t begin = 0; begin < target.dims.z; begin += step)
  {
    ReportProgress(progress, double(begin) / target.dims.z);
    ParallelFor(begin, std::min<std::int64_t>(target.dims.z, begin + step), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t k = first; k < last; ++k)
          slicer.Fill(static_cast<int>(k), coverage.data() + std::size_t(k) * slice);
      });
  }
  for (float& share : coverage)
    share = std::min(share, 1.0F); // what rounding of sixteen parts has left
  ReportProgress(progress, 1.0);
  return coverage;
}

} // namespace hasp
