#pragma once
#include "vtkHaspSurfaceFile.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace hasp
{

/// Where in a file: "line 12", "byte 84".
struct Place
{
  const char* unit;
  std::uint64_t number;
};

[[noreturn]] void ThrowAt(
  const std::filesystem::path& file, const Place& place, const std::string& what);

/// What the comments and headers of a surface file say that matters.
class SurfaceNotes
{
public:
  /// Looks for SPACE=, for what Hasp writes of a part (PartText.h), and for POINTS= and TRIANGLES=
  /// as it writes them where a format declares no counts.
  void Look(std::string_view text);
  bool lps = false, ras = false, otherSpace = false;
  std::int64_t points = -1, triangles = -1; ///< -1: not said
  PartLabel label;                          ///< of Hasp's own; what no label may hold is not taken

private:
  void TakeLabel(PartLabel said);
};

/// Collects points and faces of any format, holds them to the same rules, and makes the surface.
/// All errors throw std::runtime_error with the file's label. One thread.
class SurfaceBuilder
{
public:
  SurfaceBuilder(const std::filesystem::path& file, const SurfaceReadSettings& settings);

  /// As many are to come: refused beyond the memory limit, else room is made for them. Call once,
  /// when the file is known to be long enough.
  void Expect(std::uint64_t points, std::uint64_t triangles);
  /// Refuses what is not finite or more than 1e6 mm from the origin on any axis.
  void AddPoint(const glm::dvec3& point, const Place& place);
  /// The point of these coordinates: the one there is, or a new one. O(1).
  std::uint32_t Weld(const glm::dvec3& point, const Place& place);
  /// Cut as a fan from its first corner. Corners may name points that are still to come.
  void AddFace(std::span<const std::uint32_t> corners, const Place& place);
  void Warn(const std::string& sentence) { this->Passport.warnings.push_back(sentence); }

  std::size_t PointCount() const { return this->Points.size(); }

  /// Refuses faces that name absent points and a surface without triangles; turns RAS to LPS.
  LoadedSurface Finish(
    const std::string& format, const std::string& encoding, const SurfaceNotes& notes);

private:
  struct Polygon
  {
    std::size_t firstTriangle, triangles;
  };
  void CheckRoom() const; ///< for what is there and what is expected
  void GrowTable();
  std::size_t Slot(const glm::dvec3& point) const;
  void ApplyNotes(const SurfaceNotes& notes);
  void JudgePolygons();
  void Measure();

  const std::filesystem::path File;
  const std::size_t LimitBytes;
  std::uint64_t ExpectedPoints = 0, ExpectedTriangles = 0;
  SurfacePassport Passport;
  std::vector<glm::dvec3> Points;
  std::vector<glm::uvec3> Triangles;
  std::vector<Polygon> Polygons;    ///< of more than three corners
  std::vector<std::uint32_t> Table; ///< of Weld: index + 1 of a point, 0 where there is none
  std::uint64_t Seed;
  std::uint32_t LargestCorner = 0; ///< and where it was named
  Place LargestAt{ "line", 0 };
};

} // namespace hasp
