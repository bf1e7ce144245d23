#include "FragmentPieces.h"

#include "BoneSolid.h"
#include "Distance/KeptGrid.h"
#include "Distance/TetrahedraContour.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double BinMm = 1.5;

glm::dvec3 Middle(const TriangleMesh& mesh, std::size_t triangle)
{
  const glm::uvec3& t = mesh.triangles[triangle];
  return (mesh.points[t.x] + mesh.points[t.y] + mesh.points[t.z]) / 3.0;
}

/// Whether the line along x through a place passes through a triangle, and how far on.
bool Passes(const TriangleMesh& mesh, const glm::uvec3& t, const glm::dvec3& from)
{
  const glm::dvec3 a = mesh.points[t.x] - from, b = mesh.points[t.y] - from,
                   c = mesh.points[t.z] - from;
  const double u = b.y * c.z - b.z * c.y, v = c.y * a.z - c.z * a.y, w = a.y * b.z - a.z * b.y;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0))
    return false;
  const double area = u + v + w;
  return area != 0.0 && (u * a.x + v * b.x + w * c.x) / area > 0.0;
}

/// Points that no triangle uses are left out.
TriangleMesh Extract(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
  std::vector<std::uint32_t>& newId)
{
  constexpr std::uint32_t None = ~0U;
  newId.resize(mesh.points.size(), None);
  TriangleMesh part;
  for (const std::uint32_t n : triangles)
  {
    glm::uvec3 t = mesh.triangles[n];
    for (int c = 0; c < 3; ++c)
    {
      std::uint32_t& id = newId[t[c]];
      if (id == None)
      {
        id = std::uint32_t(part.points.size());
        part.points.push_back(mesh.points[t[c]]);
      }
      t[c] = id;
    }
    part.triangles.push_back(t);
  }
  for (const std::uint32_t n : triangles) // for the next part
    for (int c = 0; c < 3; ++c)
      newId[mesh.triangles[n][c]] = None;
  return part;
}

/// The piece around each hollow; itself for the others. Of pieces around it the innermost is the
/// one whose wall comes first.
std::vector<std::uint32_t> OwnerOfPieces(const TriangleMesh& mesh, const MeshPieces& pieces)
{
  std::vector<std::uint32_t> owner(pieces.volume.size());
  std::iota(owner.begin(), owner.end(), 0U);
  std::vector<std::uint32_t> sample(owner.size(), ~0U); // a triangle of each
  for (std::uint32_t n = 0; n < pieces.pieceOfTriangle.size(); ++n)
    sample[pieces.pieceOfTriangle[n]] = n;
  if (std::all_of(pieces.volume.begin(), pieces.volume.end(), [](double v) { return v > 0.0; }))
    return owner;
  const MeshRays rays(mesh);
  for (std::uint32_t p = 0; p < owner.size(); ++p)
  {
    if (pieces.volume[p] > 0.0)
      continue;
    // Off all points and edges, which lie at places of the grid.
    const glm::dvec3 from = Middle(mesh, sample[p]) + glm::dvec3(0.0, 3.1e-7, 1.7e-7);
    std::vector<std::uint32_t> crossings(owner.size(), 0);
    for (const std::uint32_t hit : rays.Hits(from))
      ++crossings[pieces.pieceOfTriangle[hit]];
    owner[p] = ~0U;
    for (std::uint32_t around = 0; around < owner.size(); ++around)
      if (pieces.volume[around] > 0.0 && crossings[around] % 2 == 1 &&
          (owner[p] == ~0U || pieces.volume[around] < pieces.volume[owner[p]]))
        owner[p] = around;
  }
  return owner;
}

/// Of a closed mesh: the mean of its tetrahedra with one place.
glm::dvec3 CenterOf(const TriangleMesh& mesh)
{
  const glm::dvec3 o = mesh.points.front();
  glm::dvec3 sum(0.0);
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 a = mesh.points[t.x] - o, b = mesh.points[t.y] - o, c = mesh.points[t.z] - o;
    const double six = glm::dot(a, glm::cross(b, c));
    volume += six;
    sum += six * (a + b + c) / 4.0;
  }
  return o + sum / volume;
}
} // namespace

MeshRays::MeshRays(const TriangleMesh& mesh) : Mesh(mesh), Low(1e30), Bins(0)
{
  glm::dvec2 high(-1e30);
  for (const glm::dvec3& p : mesh.points)
  {
    this->Low = glm::min(this->Low, glm::dvec2(p.y, p.z));
    high = glm::max(high, glm::dvec2(p.y, p.z));
  }
  if (mesh.points.empty())
    return;
  this->Bins = glm::ivec2((high - this->Low) / BinMm) + 1;
  this->Triangles.resize(std::size_t(this->Bins.x) * this->Bins.y);
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n)
  {
    const glm::uvec3& t = mesh.triangles[n];
    const auto across = [&](std::uint32_t p)
    { return glm::dvec2(mesh.points[p].y, mesh.points[p].z); };
    const glm::dvec2 a = across(t.x), b = across(t.y), c = across(t.z);
    const glm::ivec2 first((glm::min(a, glm::min(b, c)) - this->Low) / BinMm),
      last((glm::max(a, glm::max(b, c)) - this->Low) / BinMm);
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        this->Triangles[std::size_t(y) * this->Bins.x + x].push_back(n);
  }
}

std::vector<std::uint32_t> MeshRays::Hits(const glm::dvec3& from) const
{
  const glm::dvec2 at = (glm::dvec2(from.y, from.z) - this->Low) / BinMm;
  std::vector<std::uint32_t> hits;
  if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < this->Bins.x && at.y < this->Bins.y))
    return hits;
  for (const std::uint32_t n :
    this->Triangles[std::size_t(at.y) * this->Bins.x + std::size_t(at.x)])
    if (Passes(this->Mesh, this->Mesh.triangles[n], from))
      hits.push_back(n);
  return hits;
}

double VolumeOf(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3& o = mesh.points[mesh.triangles.front().x]; // near: keeps the sum accurate
    volume +=
      glm::dot(mesh.points[t.x] - o, glm::cross(mesh.points[t.y] - o, mesh.points[t.z] - o)) / 6.0;
  }
  return volume;
}

std::vector<BoneFragment> FragmentsOf(const TriangleMesh& mesh, double crumbBelowMm3)
{
  const MeshPieces pieces = FindPieces(mesh);
  const std::vector<std::uint32_t> owner = OwnerOfPieces(mesh, pieces);
  std::vector<std::vector<std::uint32_t>> triangles(pieces.volume.size());
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n)
    if (const std::uint32_t around = owner[pieces.pieceOfTriangle[n]]; around != ~0U)
      triangles[around].push_back(n);
  std::vector<BoneFragment> fragments;
  std::vector<std::uint32_t> newId;
  for (const auto& part : triangles)
  {
    if (part.empty())
      continue;
    BoneFragment fragment;
    fragment.mesh = Extract(mesh, part, newId);
    fragment.volumeMm3 = VolumeOf(fragment.mesh);
    fragment.center = CenterOf(fragment.mesh);
    fragment.crumb = fragment.volumeMm3 < crumbBelowMm3;
    fragments.push_back(std::move(fragment));
  }
  std::stable_sort(fragments.begin(), fragments.end(),
    [](const BoneFragment& a, const BoneFragment& b) { return a.volumeMm3 > b.volumeMm3; });
  for (std::size_t n = 0; n < fragments.size(); ++n)
    fragments[n].number = int(n) + 1;
  return fragments;
}

std::pair<std::size_t, double> NearestFragment(
  std::span<const BoneFragment> fragments, std::span<const MeshRays> rays, const glm::dvec3& place)
{
  std::size_t found = 0;
  double least = 1e30;
  for (std::size_t f = 0; f < fragments.size() && least > 0.0; ++f)
  {
    double away = 1e30;
    if (rays[f].Hits(place + glm::dvec3(0.0, 3.1e-7, 1.7e-7)).size() % 2 == 1)
      away = 0.0;
    else
      for (const glm::dvec3& p : fragments[f].mesh.points)
        away = std::min(away, glm::distance(p, place));
    if (away < least)
      least = away, found = f;
  }
  return { found, least };
}

void CheckResected(
  const GridGeometry& ct, std::span<const std::uint8_t> bone, std::span<const glm::dvec3> places)
{
  if (places.empty())
    return;
  const auto [first, last] = KeptRange(ct.dims, bone);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    const glm::dvec3 at = ct.WorldToIndex(places[n]),
                     off = glm::max(glm::dvec3(first) - at, at - glm::dvec3(last)) * ct.spacing;
    // Bone reaches out from its samples by less than a step.
    const glm::dvec3 away = glm::max(off - ct.spacing, glm::dvec3(0.0));
    if (glm::length(away) > FarthestSeedMm)
      throw std::runtime_error("cuts: resected[" + std::to_string(n) + "] is over " +
                               std::to_string(int(glm::length(away))) +
                               " mm from the bone that is cut, must be within " +
                               std::to_string(int(FarthestSeedMm)) + " mm");
  }
}

void MarkResected(std::vector<BoneFragment>& fragments, std::span<const glm::dvec3> places)
{
  std::vector<MeshRays> rays;
  if (!places.empty())
    for (const BoneFragment& fragment : fragments)
      rays.emplace_back(fragment.mesh);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    const auto [found, away] = NearestFragment(fragments, rays, places[n]);
    if (!(away <= FarthestSeedMm))
    {
      std::ostringstream text;
      text << "cuts: resected[" << n << "] is " << away << " mm from all fragments, must be within "
           << FarthestSeedMm << " mm";
      throw std::runtime_error(text.str());
    }
    fragments[found].resected = true;
  }
}

bool HasFace(const TriangleMesh& piece, const CutTool& tool, int side, double toleranceMm)
{
  const glm::dvec3 half = tool.blade.Half();
  const glm::dvec3 outward = -double(side) * tool.blade.Axes()[2]; // of the piece
  for (std::size_t n = 0; n < piece.triangles.size(); ++n)
  {
    const glm::dvec3 at = tool.blade.Local(Middle(piece, n));
    if (std::abs(at.z - side * half.z) > toleranceMm || std::abs(at.x) > half.x ||
        std::abs(at.y) > half.y)
      continue;
    const glm::uvec3& t = piece.triangles[n];
    const glm::dvec3 &a = piece.points[t.x], &b = piece.points[t.y], &c = piece.points[t.z];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::dvec3 within(at.x, at.y, side * (half.z - toleranceMm));
    if (glm::dot(normal, outward) > 0.999 * glm::length(normal) &&
        tool.Takes(tool.blade.World(within)))
      return true;
  }
  return false;
}

} // namespace hasp
