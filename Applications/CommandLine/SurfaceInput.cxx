#include "SurfaceInput.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"

#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

void SayWarnings(const SurfacePassport& passport, const std::string& name, Session& session)
{
  for (const std::string& warning : passport.warnings)
    SayWarning(session, name + ": " + warning);
}

} // namespace

LoadedSurface ReadSurface(
  const std::string& path, const std::string& name, bool quiet, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + name);
  try
  {
    LoadedSurface loaded =
      LoadSurface(path, {}, [&session](double share) { return session.progress.Share(share); });
    if (!quiet)
      SayWarnings(loaded.passport, name, session);
    return loaded;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    const std::string text = SafeText(error);
    throw Failure(ExitCode::BadInput, text.starts_with(name) ? text : name + ": " + text);
  }
}

std::size_t BytesOf(const LoadedSurface& surface)
{
  return std::size_t(1024) * surface.surface->GetActualMemorySize();
}

} // namespace hasp
