#include "Conversion.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

constexpr double FarthestMm = 1e-4; // STL's float32 keeps that up to a metre from the origin

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

LoadedSurface Read(const std::string& path, Session& session)
{
  return LoadSurface(path, {},
    [&session](double share)
    {
      session.progress.Share(share);
      return true;
    });
}

LoadedSurface ReadInput(const std::string& path, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + FileLabel(path));
  try
  {
    return Read(path, session);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, SafeText(error));
  }
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
      what, { "corners lie up to " + Number(shift) +
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

std::string Describe(const SurfacePassport& passport)
{
  return passport.format + ", " + passport.encoding + ", " + std::to_string(passport.triangles) +
         " triangles";
}

} // namespace

void ConvertSurface(const ConvertOptions& options, Session& session)
{
  const LoadedSurface surface = ReadInput(options.volume.input, session);
  for (const std::string& warning : surface.passport.warnings)
    SayWarning(session, warning);
  SurfacePassport written;
  std::size_t bytes = 0;
  double shift = 0.0;
  session.progress.Step("writing " + FileLabel(options.output));
  try
  {
    WriteInspected(
      options.output, [&](const std::string& name) { Write(surface, name); },
      [&](const std::string& name)
      {
        session.progress.Step("reading it back");
        const LoadedSurface back = Read(name, session);
        written = back.passport;
        bytes = BytesOf(name);
        shift = Compare(surface, back);
      });
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  session.progress.Wipe();
  if (!session.json)
    std::cout << "read        " << Describe(surface.passport) << "\nwrote       "
              << Describe(written) << ", " << bytes << " bytes\ncompared    every triangle, "
              << "corners within " << Number(shift) << " mm\n";
  session.result["read"] = { { "format", surface.passport.format },
    { "triangles", surface.passport.triangles } };
  session.result["written"] = { { "format", written.format }, { "triangles", written.triangles },
    { "bytes", bytes } };
  session.result["compared"] = { { "identical", shift == 0.0 }, { "position_mm", shift } };
}

} // namespace hasp
