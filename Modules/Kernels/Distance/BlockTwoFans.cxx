#include "Distance/BlockContour.h"
#include "HeldShares.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
constexpr double CellShare = 0.00125; ///< of each corner, that centers keep
constexpr double CellSteps = 1.0;     ///< of floats, that parts of the tetrahedron are high

using Triangle = std::array<glm::dvec3, 3>;

/// The triangles of two fans, from the line's points on; the last two join them.
std::vector<Triangle> TrianglesOf(const std::vector<glm::dvec3>& line,
  const std::array<glm::dvec3, 2>& center, std::size_t first, std::size_t last)
{
  std::vector<Triangle> triangles;
  const std::size_t count = line.size();
  for (std::size_t n = 0; n < count; ++n)
    triangles.push_back({ center[n >= first && n < last ? 0 : 1], line[n], line[(n + 1) % count] });
  triangles.push_back({ center[0], line[last], center[1] });
  triangles.push_back({ center[1], line[first], center[0] });
  return triangles;
}

/// What of a tetrahedron's boundary is on one side of the surface, shared between two centers: a
/// path over it, from the line's point where the fans begin to that where they end, parts what is
/// seen from the one from what is seen from the other. The tetrahedra of its triangles and their
/// centers, and of the path and both centers, fill that side if none is turned over.
class SharedSide
{
public:
  SharedSide(const Shell& shell, const std::vector<glm::dvec3>& line, bool inside)
    : Inside(inside),
      Count(line.size()),
      Places(line)
  {
    for (const ShellTriangle& triangle : shell)
      if (triangle.inside == inside)
        this->Triangles.push_back(
          { this->Id(triangle.at[0]), this->Id(triangle.at[1]), this->Id(triangle.at[2]) });
  }

  /// The least height for the best path, mm; negative if there is none.
  double LeastHeight(const std::array<glm::dvec3, 2>& center, std::size_t first, std::size_t last)
  {
    this->Center = center, this->Last = last, this->Most = -std::numeric_limits<double>::max();
    // A part of the line that is the second center's.
    this->Start = this->TriangleAt(last, (last + 1) % this->Count);
    this->Path.assign(1, first);
    if (this->Start != None)
      this->Walk();
    return this->Most;
  }

private:
  static constexpr std::size_t None = ~std::size_t(0);

  std::size_t Id(const glm::dvec3& at)
  {
    const auto found = std::find(this->Places.begin(), this->Places.end(), at);
    const std::size_t id = std::size_t(found - this->Places.begin());
    if (found == this->Places.end())
      this->Places.push_back(at);
    return id;
  }
  static bool Has(const std::array<std::size_t, 3>& t, std::size_t a, std::size_t b)
  {
    return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
  }
  std::size_t TriangleAt(std::size_t a, std::size_t b) const
  {
    for (std::size_t n = 0; n < this->Triangles.size(); ++n)
      if (Has(this->Triangles[n], a, b))
        return n;
    return None;
  }

  /// On from the path's end: to its goal, or over corners of the tetrahedron, each once.
  void Walk()
  {
    const std::size_t end = this->Path.back();
    for (std::size_t next = 0; next < this->Places.size(); ++next)
    {
      const bool known = std::find(this->Path.begin(), this->Path.end(), next) != this->Path.end();
      if (known || (next < this->Count && next != this->Last) ||
          this->TriangleAt(end, next) == None || this->IsOfLine(end, next))
        continue;
      this->Path.push_back(next);
      if (next == this->Last)
        this->Most = std::max(this->Most, this->HeightOfPath());
      else
        this->Walk();
      this->Path.pop_back();
    }
  }
  bool IsOfLine(std::size_t a, std::size_t b) const
  {
    return a < this->Count && b < this->Count &&
           ((a + 1) % this->Count == b || (b + 1) % this->Count == a);
  }
  bool IsOfPath(std::size_t a, std::size_t b) const
  {
    for (std::size_t n = 0; n + 1 < this->Path.size(); ++n)
      if ((this->Path[n] == a && this->Path[n + 1] == b) ||
          (this->Path[n] == b && this->Path[n + 1] == a))
        return true;
    return false;
  }

  double HeightOfPath() const
  {
    std::vector<std::uint8_t> second(this->Triangles.size(), 0);
    std::vector<std::size_t> found{ this->Start };
    second[this->Start] = 1;
    while (!found.empty())
    {
      const auto t = this->Triangles[found.back()];
      found.pop_back();
      for (std::size_t n = 0; n < this->Triangles.size(); ++n)
        for (int e = 0; e < 3; ++e)
          if (!second[n] && Has(this->Triangles[n], t[e], t[(e + 1) % 3]) &&
              !this->IsOfPath(t[e], t[(e + 1) % 3]))
            second[n] = 1, found.push_back(n);
    }
    std::array<Shell, 2> seen;
    for (std::size_t n = 0; n < this->Triangles.size(); ++n)
    {
      const auto& t = this->Triangles[n];
      seen[second[n]].push_back(
        { { this->Places[t[0]], this->Places[t[1]], this->Places[t[2]] }, this->Inside });
      for (int e = 0; e < 3; ++e)
        if (second[n] && this->IsOfPath(t[e], t[(e + 1) % 3]))
          seen[1].push_back({ { this->Places[t[(e + 1) % 3]], this->Places[t[e]], this->Center[0] },
            this->Inside });
    }
    return std::min(
      hasp::LeastHeight(this->Center[0], seen[0]), hasp::LeastHeight(this->Center[1], seen[1]));
  }

  bool Inside;
  std::size_t Count; ///< of the line's points, which are the first places
  std::vector<glm::dvec3> Places;
  std::vector<std::array<std::size_t, 3>> Triangles;
  std::array<glm::dvec3, 2> Center{};
  std::size_t Last = 0, Start = 0;
  std::vector<std::size_t> Path;
  double Most = 0.0;
};
} // namespace

/// A place on each of the creases that come through the tetrahedron's sides.
std::vector<glm::dvec3> BlockContour::CreaseCenters(const Loop& loop) const
{
  const auto& all = loop.places;
  using Crease = std::pair<std::uint32_t, std::uint32_t>;
  // Of a bend on a crease there are two places: both of its faces, one after the other.
  const auto crease = [&](std::size_t n)
  {
    const auto faces = std::minmax({ all[n].face, all[n + 1].face });
    return all[n].at == all[n + 1].at ? Crease(faces) : Crease(0, 0);
  };
  std::vector<Crease> known{ { 0, 0 } };
  std::vector<glm::dvec3> centers;
  for (std::size_t n = 0; n + 1 < all.size(); ++n)
  {
    const Crease here = crease(n);
    if (here.first == here.second || std::find(known.begin(), known.end(), here) != known.end())
      continue;
    known.push_back(here);
    std::vector<FacePlace> places;
    glm::dvec3 start(0.0);
    for (std::size_t p = n; p + 1 < all.size(); ++p)
      if (crease(p) == here)
        places.insert(places.end(), { all[p], all[p + 1] }), start += 2.0 * all[p].at;
    const glm::dvec3 center = FindCorner(
      this->Solid, loop.world, places, start / double(places.size()), this->Limits.tolerance);
    const glm::dvec4 share = KeepInside(Barycentric(loop.world, center), loop.safe, CellShare);
    glm::dvec3 index(0.0);
    for (int c = 0; c < 4; ++c)
      index += share[c] * loop.index[c];
    centers.push_back(index);
  }
  return centers;
}

/// Two fans round two creases, where one would be turned: the best division of the line between
/// them that leaves no part of the tetrahedron turned over.
std::optional<BlockContour::TwoFans> BlockContour::BestTwoFans(const Loop& loop, double most) const
{
  const std::vector<glm::dvec3> centers = this->CreaseCenters(loop);
  std::vector<glm::dvec3> line;
  for (const std::uint32_t point : loop.points)
    line.push_back(this->Points[point]);
  std::optional<TwoFans> best;
  double least = most;
  for (std::size_t i = 0; i < centers.size(); ++i)
    for (std::size_t j = 0; j < centers.size(); ++j)
      for (std::size_t first = 0; first < line.size() && i != j; ++first)
        for (std::size_t last = first + 1; last < line.size(); ++last)
        {
          TwoFans fans{ { centers[i], centers[j] }, first, last, 0.0, 0.0 };
          for (const Triangle& t : TrianglesOf(
                 line, { this->Rounded(centers[i]), this->Rounded(centers[j]) }, first, last))
            if (fans.turned < least)
              fans.turned +=
                this->Turned(t, this->Solid.SampleAt((t[0] + t[1] + t[2]) / 3.0).gradient);
          if (fans.turned >= least)
            continue;
          fans.steps = this->StepsOf(loop, fans);
          if (fans.steps >= CellSteps)
            best = fans, least = fans.turned;
        }
  return best;
}

double BlockContour::StepsOf(const Loop& loop, const TwoFans& fans) const
{
  std::vector<glm::dvec3> line;
  for (const std::uint32_t point : loop.points)
    line.push_back(this->Points[point]);
  double least = std::numeric_limits<double>::max();
  for (const bool inside : { false, true })
  {
    SharedSide side(loop.shell, line, inside);
    least = std::min(
      least, side.LeastHeight({ this->Rounded(fans.center[0]), this->Rounded(fans.center[1]) },
               fans.first, fans.last));
  }
  return least / this->Limits.step;
}

void BlockContour::AddFans(const Loop& loop, const TwoFans& fans)
{
  this->LeastSteps = std::min(this->LeastSteps, fans.steps);
  const std::uint32_t center[] = { this->AddPoint(fans.center[0]), this->AddPoint(fans.center[1]) };
  const std::size_t count = loop.points.size();
  for (std::size_t n = 0; n < count; ++n)
    this->Triangles.emplace_back(center[n >= fans.first && n < fans.last ? 0 : 1], loop.points[n],
      loop.points[(n + 1) % count]);
  this->Triangles.emplace_back(center[0], loop.points[fans.last], center[1]);
  this->Triangles.emplace_back(center[1], loop.points[fans.first], center[0]);
}

} // namespace hasp
