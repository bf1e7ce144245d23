#include "RunSegments.h"

#include "Failure.h"
#include "RunParts.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/Sha256.h"
#include "vtkPolyData.h"

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <map>
#include <sstream>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Some of a mesh's triangles, from the first.
TriangleMesh Slice(const TriangleMesh& mesh, std::size_t first, std::size_t count)
{
  if (first + count > mesh.triangles.size())
    throw Failure(
      ExitCode::FailedCheck, "a transplant's file has fewer triangles than its segments");
  TriangleMesh slice;
  std::map<std::uint32_t, std::uint32_t> numbers;
  const auto numberOf = [&](std::uint32_t point)
  {
    const auto [at, isNew] = numbers.emplace(point, std::uint32_t(slice.points.size()));
    if (isNew)
      slice.points.push_back(mesh.points[point]);
    return at->second;
  };
  for (std::size_t n = first; n < first + count; ++n)
  {
    const glm::uvec3& t = mesh.triangles[n];
    slice.triangles.push_back({ numberOf(t.x), numberOf(t.y), numberOf(t.z) });
  }
  return slice;
}
} // namespace

std::string ReadWholeFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!(bytes << file.rdbuf()))
    throw Failure(ExitCode::WrongUse, "a part cannot be read back as it was written");
  return bytes.str();
}

void WriteSegments(const Plan& plan, PlanId object, const TriangleMesh& mesh,
  nlohmann::ordered_json& part, const PartLabel& label, const fs::path& folder)
{
  const auto write = [&](Json& segment, const std::string& key, const std::string& name,
                       const TriangleMesh& surface, std::size_t n)
  {
    const std::string path = (folder / name).string();
    WriteSurface(MakePolyData(surface), path,
      { .name = "segment " + std::to_string(n + 1), .hash = label.hash });
    segment[key] = { { "file", name }, { "sha256", Sha256(ReadWholeFile(path)) } };
  };
  std::size_t first = 0;
  for (std::size_t n = 0; n < part["segments"].size(); ++n)
  {
    Json& segment = part["segments"][n];
    const auto count = segment.at("triangles").get<std::size_t>();
    TriangleMesh surface = Slice(mesh, first, count);
    first += count;
    const std::string number = "segment-" + std::to_string(n + 1);
    write(segment, "in_defect", NameOfPart(plan, object, "-" + number), surface, n);
    const auto p = segment.at("position_mm").get<std::array<double, 3>>();
    const auto q = segment.at("orientation").get<std::array<double, 4>>();
    const PlanPose donorToDefect{ { p[0], p[1], p[2] }, { q[0], q[1], q[2], q[3] } };
    for (glm::dvec3& point : surface.points)
      point = donorToDefect.PlaceBack(point);
    write(segment, "on_donor", NameOfPart(plan, object, "-donor-" + number), surface, n);
  }
}

} // namespace hasp
