#include "Conversion.h"

#include "Failure.h"
#include "Files.h"
#include "PartFormats.h"
#include "Session.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspSurfaceFile.h"

#include <cstdio>
#include <iostream>
#include <new>

namespace hasp
{
namespace
{

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

LoadedSurface ReadInput(const std::string& path, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + FileLabel(path));
  try
  {
    return LoadSurface(path, {},
      [&session](double share)
      {
        session.progress.Share(share);
        return true;
      });
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
  session.progress.Step("writing " + FileLabel(options.output));
  const auto [written, bytes, shift] = CopySurface(surface, options.output, session);
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
