#include "PartFormats.h"

#include "Conversion.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <functional>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr double FarthestMm = 1e-4; // STL's float32 keeps that up to a metre from the origin

/// Gone when it is not needed any more, whatever happens.
class AsideFile
{
public:
  AsideFile(const std::string& beside, const std::string& bytes)
    : Path((fs::u8path(beside).parent_path() / (".hasp-part-" + std::to_string(getpid()) + ".stl"))
             .string())
  {
    WriteFile(this->Path, bytes);
  }
  ~AsideFile()
  {
    std::error_code error;
    fs::remove(fs::u8path(this->Path), error);
  }
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  const std::string Path;
};

LoadedSurface Read(const std::string& path, Session& session)
{
  return LoadSurface(path, {}, [&session](double share) { return session.progress.Share(share); });
}

/// Largest distance of corners that belong together, mm.
double LargestShift(const TriangleMesh& a, const TriangleMesh& b)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < a.triangles.size(); ++n)
    for (int corner = 0; corner < 3; ++corner)
      largest = std::max(
        largest, glm::distance(a.points[a.triangles[n][corner]], b.points[b.triangles[n][corner]]));
  return largest;
}

/// The largest shift; throws Failure: FailedCheck.
double Compare(const LoadedSurface& surface, const LoadedSurface& back)
{
  const TriangleMesh before = MakeTriangleMesh(surface.surface),
                     after = MakeTriangleMesh(back.surface);
  const std::string what = "what was written is not what was read and was not kept";
  if (before.triangles.size() != after.triangles.size())
    throw FailedCheck(what, { "it has " + std::to_string(after.triangles.size()) +
                              " triangles, not " + std::to_string(before.triangles.size()) });
  const double shift = LargestShift(before, after);
  if (!(shift <= FarthestMm))
    throw FailedCheck(
      what, { "corners lie up to " + Line("%.3g", shift) +
              " mm from their place; .ply and .obj keep more digits than .stl and .3mf" });
  return shift;
}

/// The triangles of one piece, with the points that are theirs, in their order.
vtkSmartPointer<vtkPolyData> PieceOf(const TriangleMesh& mesh, const SurfacePiece& piece)
{
  TriangleMesh part;
  const auto first = mesh.triangles.begin() + std::ptrdiff_t(piece.firstTriangle);
  part.triangles.assign(first, first + std::ptrdiff_t(piece.triangles));
  std::vector<glm::uint> number(mesh.points.size());
  for (const glm::uvec3& t : part.triangles)
    number[t.x] = number[t.y] = number[t.z] = 1;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] != 0)
    {
      number[n] = static_cast<glm::uint>(part.points.size());
      part.points.push_back(mesh.points[n]);
    }
  for (glm::uvec3& t : part.triangles)
    t = { number[t.x], number[t.y], number[t.z] };
  return MakePolyData(part);
}

/// With what the file says of the part; objects stay objects where the format has them.
void Write(const LoadedSurface& surface, const std::string& name)
{
  const SurfacePassport& passport = surface.passport;
  if (passport.pieces.empty() || !name.ends_with(".3mf"))
    return WriteSurface(surface.surface, name, passport.label);
  const TriangleMesh mesh = MakeTriangleMesh(surface.surface);
  std::vector<vtkSmartPointer<vtkPolyData>> kept;
  std::vector<NamedSurface> objects;
  for (const SurfacePiece& piece : passport.pieces)
  {
    kept.push_back(PieceOf(mesh, piece));
    objects.push_back({ IsPartName(piece.name) ? piece.name : "", kept.back() });
  }
  WriteSurfaces(objects, name, passport.label);
}

/// Calls visit(object) for each object of run.json that says a file of the run and its hash: those
/// that WriteParts puts there, and nothing of what kept reports say.
void ForEachFile(Json& run, const std::function<void(Json&)>& visit)
{
  for (Json& part : run.at("parts"))
  {
    visit(part);
    if (part.contains("planned"))
      visit(part["planned"]);
    if (part.at("kind") == "transplant")
      for (Json& segment : part.at("segments"))
        for (const char* where : { "in_defect", "on_donor" })
          visit(segment.at(where));
  }
}

} // namespace

std::size_t BytesOf(const std::string& path)
{
  std::error_code ignored;
  if (!fs::is_directory(path, ignored))
    return fs::file_size(path, ignored);
  std::size_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(path, ignored))
    bytes += entry.file_size(ignored);
  return bytes;
}

const std::vector<std::string>& PartEndings()
{
  static const std::vector<std::string> endings{ ".stl", ".3mf", ".ply", ".obj" };
  return endings;
}

void AddFormatOption(CLI::App& verb, std::string& format)
{
  std::vector<std::string> formats;
  for (const std::string& ending : PartEndings())
    formats.push_back(ending.substr(1));
  verb.add_option("--format", format, "Of the parts' files")
    ->check(CLI::IsMember(formats))
    ->capture_default_str();
}

SurfaceCopy CopySurface(const LoadedSurface& surface, const std::string& to, Session& session)
{
  SurfaceCopy copy;
  const auto inspect = [&](const std::string& name)
  {
    session.progress.Step("reading it back");
    const LoadedSurface back = Read(name, session);
    copy = { back.passport, BytesOf(name), Compare(surface, back) };
  };
  Try(ExitCode::WrongUse, "",
    [&]
    {
      WriteInspected(
        to, [&](const std::string& name) { Write(surface, name); }, inspect);
    });
  return copy;
}

void WriteStlAs(const std::string& stl, const std::string& to, Session& session)
{
  if (to.ends_with(".stl"))
    return WriteFile(to, stl);
  const AsideFile aside(to, stl);
  CopySurface(Try(ExitCode::BadInput, "", [&] { return Read(aside.Path, session); }), to, session);
}

std::string RunInFormat(
  std::string run, const std::string& format, const std::filesystem::path& folder, Session& session)
{
  if (format == "stl")
    return run;
  Json json = Json::parse(run);
  ForEachFile(json,
    [&](Json& part)
    {
      const fs::path stl = folder / part["file"].get<std::string>();
      const std::string file = fs::path(stl).replace_extension(format).string();
      CopySurface(Read(stl.string(), session), file, session);
      fs::remove(stl);
      part["file"] = fs::u8path(file).filename().string();
      part["sha256"] = HashOfFile(file);
    });
  return json.dump(2) + "\n";
}

} // namespace hasp
