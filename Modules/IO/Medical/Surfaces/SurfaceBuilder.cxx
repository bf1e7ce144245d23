#include "Surfaces/SurfaceBuilder.h"
#include "Files/FileError.h"
#include "Surfaces/TrianglePolyData.h"

#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace hasp
{
namespace
{

constexpr double FarthestMm = 1e6; // a kilometre: no patient, and no wrong unit either
constexpr std::size_t MostPoints = std::numeric_limits<std::int32_t>::max(), // VTK's small cells
  MostTriangles = MostPoints / 3;
// With the table of Weld, at most half full.
constexpr double BytesPerPoint = sizeof(glm::dvec3) + 2 * sizeof(std::uint32_t),
                 BytesPerTriangle = sizeof(glm::uvec3);

std::uint64_t Mix(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL; // the finalizer of SplitMix64
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

} // namespace

void ThrowAt(const std::filesystem::path& file, const Place& place, const std::string& what)
{
  ThrowFileError(file, std::string(place.unit) + " " + std::to_string(place.number) + ": " + what);
}

SurfaceBuilder::SurfaceBuilder(
  const std::filesystem::path& file, const SurfaceReadSettings& settings)
  : File(file),
    LimitBytes(settings.memoryLimitBytes),
    Seed((std::uint64_t(std::random_device()()) << 32) | 1) // no file can be made to collide
{
}

void SurfaceBuilder::CheckRoom() const
{
  const double points = std::max(double(this->ExpectedPoints), double(this->Points.size()));
  const double triangles =
    std::max(double(this->ExpectedTriangles), double(this->Triangles.size()));
  if (points > double(MostPoints) || triangles > double(MostTriangles))
    ThrowFileError(this->File, "has " + Text(points) + " points and " + Text(triangles) +
                                 " triangles; at most " + std::to_string(MostPoints) + " and " +
                                 std::to_string(MostTriangles) + " are read. Split it");
  const double bytes = points * BytesPerPoint + triangles * BytesPerTriangle;
  if (bytes > double(this->LimitBytes))
    ThrowFileError(this->File, "has " + Text(points) + " points and " + Text(triangles) +
                                 " triangles or more, " + Text(bytes / (1 << 20)) +
                                 " MiB; the memory limit is " +
                                 Text(double(this->LimitBytes) / (1 << 20)) +
                                 " MiB. Make the surface coarser, or raise memoryLimitBytes");
}

void SurfaceBuilder::Expect(std::uint64_t points, std::uint64_t triangles)
{
  this->ExpectedPoints = points;
  this->ExpectedTriangles = triangles;
  this->CheckRoom();
  this->Points.reserve(points);
  this->Triangles.reserve(triangles);
}

void SurfaceBuilder::AddPoint(const glm::dvec3& point, const Place& place)
{
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(point[a]) <= FarthestMm))
      ThrowAt(this->File, place,
        std::string("a point has the ") + "xyz"[a] + " coordinate " + Text(point[a]) +
          ", which is no number or a kilometre away; write the surface again, in mm");
  this->Points.push_back(point);
  if (this->Points.size() > this->ExpectedPoints)
    this->CheckRoom();
}

std::size_t SurfaceBuilder::Slot(const glm::dvec3& point) const
{
  std::uint64_t hash = this->Seed;
  for (int a = 0; a < 3; ++a)
    hash = Mix(hash ^ std::bit_cast<std::uint64_t>(point[a] + 0.0)); // -0 lies where 0 does
  std::size_t slot = hash & (this->Table.size() - 1);
  while (this->Table[slot] != 0 && this->Points[this->Table[slot] - 1] != point)
    slot = (slot + 1) & (this->Table.size() - 1);
  return slot;
}

void SurfaceBuilder::GrowTable()
{
  this->Table.assign(std::max<std::size_t>(1024, 2 * this->Table.size()), 0);
  for (std::size_t n = 0; n < this->Points.size(); ++n)
    this->Table[this->Slot(this->Points[n])] = static_cast<std::uint32_t>(n + 1);
}

std::uint32_t SurfaceBuilder::Weld(const glm::dvec3& point, const Place& place)
{
  if (2 * (this->Points.size() + 1) > this->Table.size())
    this->GrowTable();
  const std::size_t slot = this->Slot(point);
  if (this->Table[slot] == 0)
  {
    this->AddPoint(point, place);
    this->Table[slot] = static_cast<std::uint32_t>(this->Points.size());
  }
  return this->Table[slot] - 1;
}

void SurfaceBuilder::AddFace(std::span<const std::uint32_t> corners, const Place& place)
{
  if (corners.size() < 3)
    ThrowAt(this->File, place,
      "a face has " + std::to_string(corners.size()) +
        " corners, it must have 3 or more; write the surface again");
  for (const std::uint32_t corner : corners)
    if (corner >= this->LargestCorner)
    {
      this->LargestCorner = corner;
      this->LargestAt = place;
    }
  if (corners.size() > 3)
    this->Polygons.push_back({ this->Triangles.size(), corners.size() - 2 });
  for (std::size_t n = 2; n < corners.size(); ++n)
  {
    this->Triangles.emplace_back(corners[0], corners[n - 1], corners[n]);
    if (this->Triangles.size() > this->ExpectedTriangles)
      this->CheckRoom();
  }
}

void SurfaceBuilder::ApplyNotes(const SurfaceNotes& notes)
{
  const auto differs = [](std::int64_t said, std::size_t there)
  { return said >= 0 && static_cast<std::uint64_t>(said) != there; };
  if (differs(notes.points, this->Points.size()) ||
      differs(notes.triangles, this->Triangles.size()))
    ThrowFileError(this->File, "says it has " + std::to_string(notes.points) + " points and " +
                                 std::to_string(notes.triangles) + " triangles, " +
                                 std::to_string(this->Points.size()) + " and " +
                                 std::to_string(this->Triangles.size()) +
                                 " are there: it is cut off or was changed. Copy it again");
  if (notes.lps && notes.ras)
    ThrowFileError(this->File,
      "says that it is in LPS and that it is in RAS; left and right cannot "
      "be told. Write it again");
  this->Passport.space = notes.lps ? "LPS" : notes.ras ? "RAS" : "";
  if (notes.ras)
    for (glm::dvec3& point : this->Points)
      point = { 0.0 - point.x, 0.0 - point.y, point.z }; // 0 stays 0, not -0
  if (notes.otherSpace && this->Passport.space.empty())
    this->Warn("the file names a coordinate system that is neither LPS nor RAS; LPS is taken");
  else if (this->Passport.space.empty())
    this->Warn("the file does not say its coordinate system, so LPS is taken; if its program uses "
               "RAS, left and right and front and back are exchanged");
}

void SurfaceBuilder::JudgePolygons()
{
  std::size_t uneven = 0;
  for (const Polygon& polygon : this->Polygons)
  {
    const std::span fan(this->Triangles.data() + polygon.firstTriangle, polygon.triangles);
    const auto at = [&](std::size_t n) // corner n of the polygon
    {
      return this->Points[n == 0 ? fan[0].x : n == 1 ? fan[0].y : fan[n - 2].z];
    };
    const std::size_t corners = fan.size() + 2;
    glm::dvec3 twiceArea(0.0);
    for (const glm::uvec3& t : fan)
      twiceArea +=
        glm::cross(this->Points[t.y] - this->Points[t.x], this->Points[t.z] - this->Points[t.x]);
    const double area = glm::length(twiceArea);
    const glm::dvec3 normal = area > 0.0 ? twiceArea / area : glm::dvec3(0.0);
    // A thousandth of its size is what 32-bit coordinates and rounded decimals leave.
    const double flatMm = 1e-3 * std::sqrt(area), turnMm2 = -1e-6 * area;
    bool even = area > 0.0;
    for (std::size_t n = 0; n < corners && even; ++n)
    {
      const glm::dvec3 a = at(n), b = at((n + 1) % corners), c = at((n + 2) % corners);
      even = std::abs(glm::dot(a - at(0), normal)) <= flatMm &&
             glm::dot(glm::cross(b - a, c - b), normal) >= turnMm2;
    }
    for (std::size_t n = 0; n < fan.size() && even; ++n) // a star turns one way, too
      even = glm::dot(glm::cross(at(n + 1) - at(0), at(n + 2) - at(0)), normal) >= turnMm2;
    uneven += !even;
  }
  this->Passport.cutPolygons = this->Polygons.size();
  if (uneven > 0)
    this->Warn(std::to_string(uneven) + " of " + std::to_string(this->Polygons.size()) +
               " faces with more than three corners are not flat and convex; cut as fans, their "
               "triangles may overlap. Triangulate the surface in the program that made it");
}

void SurfaceBuilder::Measure()
{
  SurfacePassport& passport = this->Passport;
  passport.minimum = passport.maximum = this->Points[this->Triangles.front().x];
  for (const glm::uvec3& t : this->Triangles)
  {
    const glm::dvec3 &a = this->Points[t.x], &b = this->Points[t.y], &c = this->Points[t.z];
    passport.minimum = glm::min(passport.minimum, glm::min(a, glm::min(b, c)));
    passport.maximum = glm::max(passport.maximum, glm::max(a, glm::max(b, c)));
    passport.degenerate +=
      t.x == t.y || t.y == t.z || t.z == t.x || !(glm::length(glm::cross(b - a, c - a)) > 0.0);
  }
  const glm::dvec3 extent = passport.maximum - passport.minimum;
  const double largest = std::max({ extent.x, extent.y, extent.z });
  if (largest < 2.0)
    this->Warn("the surface is " + Text(largest) +
               " mm in its largest extent; if it is written in metres or inches, convert it to mm");
  if (largest > 5000.0)
    this->Warn("the surface is " + Text(largest) +
               " mm in its largest extent; if it is not written in mm, convert it");
}

LoadedSurface SurfaceBuilder::Finish(
  const std::string& format, const std::string& encoding, const SurfaceNotes& notes)
{
  if (this->Triangles.empty())
    ThrowFileError(this->File, "holds no triangles; there is nothing to read");
  if (this->LargestCorner >= this->Points.size())
    ThrowAt(this->File, this->LargestAt,
      "a face names point " + std::to_string(std::uint64_t(this->LargestCorner) + 1) +
        " (counted from 1), the file has " + std::to_string(this->Points.size()) +
        ": it is cut off or damaged. Copy it again");
  this->Table = {};
  this->ApplyNotes(notes);
  this->JudgePolygons();
  this->Measure();
  LoadedSurface loaded{ std::move(this->Passport),
    TrianglePolyData(this->Points, this->Triangles) };
  loaded.passport.format = format;
  loaded.passport.encoding = encoding;
  loaded.passport.points = this->Points.size();
  loaded.passport.triangles = this->Triangles.size();
  loaded.passport.coordinateType = CoordinateType(loaded.surface);
  loaded.passport.label = notes.label;
  if (notes.label.doesNotHold)
    loaded.passport.warnings.push_back("the file says that this part DOES NOT HOLD: it was kept "
                                       "although its certificate is red");
  return loaded;
}

} // namespace hasp
