#include "FragmentSurfaces.h"

#include "Failure.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VerbWork.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanLists.h"

#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Takes what it finds out of `missing`.
void ReadOne(const Plan& plan, const std::string& file, const std::string& name,
  std::set<PlanId>& missing, PlanSurfaces& surfaces, Session& session)
{
  const LoadedSurface read =
    ReadSurface(file, name, true, session); // warned of when it was entered
  const TriangleMesh mesh = MakeTriangleMesh(read.surface);
  const std::string hash = Try(ExitCode::BadInput, name + ": ", [&] { return SurfaceHash(mesh); });
  bool known = false, used = false;
  for (const PlanSurface& surface : plan.surfaces)
    if (surface.hash == hash)
    {
      known = true;
      if (missing.erase(surface.id) == 0)
        continue;
      surfaces.emplace(surface.id, mesh);
      used = true;
    }
  if (!known)
    throw Failure(ExitCode::BadInput,
      name + " is none of the plan's surfaces: its triangles are others; give the file that the "
             "plan was made on, or enter it: hasp plan --surface");
  if (!used)
    SayWarning(
      session, name + " was given before, or no fragment that takes part is of it; it is not used");
}

} // namespace

const SurfaceSource* SurfaceOf(const Plan& plan, PlanId fragment)
{
  const auto* found = FindPlanObject<PlanFragment>(plan, fragment);
  return found ? std::get_if<SurfaceSource>(&found->source) : nullptr;
}

std::string WithoutSubject(const std::string& text)
{
  const std::string subject = "surface: ";
  return text.starts_with(subject) ? text.substr(subject.size()) : text;
}

PlanSurfaces SurfacesOfFragments(const Plan& plan, const std::vector<PlanId>& fragments,
  const std::vector<std::string>& files, Session& session)
{
  std::set<PlanId> missing;
  for (const PlanId id : fragments)
    if (const SurfaceSource* source = SurfaceOf(plan, id))
      missing.insert(source->surface);
  PlanSurfaces surfaces;
  for (std::size_t n = 0; n < files.size(); ++n)
    ReadOne(
      plan, files[n], "--surface number " + std::to_string(n + 1), missing, surfaces, session);
  std::string list;
  for (const PlanId id : fragments)
    if (const SurfaceSource* source = SurfaceOf(plan, id);
        source && missing.contains(source->surface))
      list += (list.empty() ? "" : ", ") + CalledObject(plan, source->surface) + " of " +
              CalledObject(plan, id);
  if (!list.empty())
    throw Failure(ExitCode::BadInput,
      list + ": not among the files given: no --surface has the triangles that the plan names; "
             "give the file that the plan was made on");
  return surfaces;
}

SurfaceFragment BakeFragment(const Plan& plan, PlanId fragment, const PlanSurfaces& surfaces,
  SurfaceFragmentSettings settings, const FragmentWants& wants, Session& session)
{
  const SurfaceSource& source = *SurfaceOf(plan, fragment);
  settings.thicknessMm = source.thicknessMm;
  settings.behind = source.side == SheetSide::Behind;
  settings.spacingMm = source.spacingMm;
  const std::string called = CalledObject(plan, fragment) + ": ";
  session.progress.Step("measuring " + CalledObject(plan, fragment));
  SurfaceFragment made = Try(ExitCode::BadInput, called,
    [&]
    {
      return BakeSurface(surfaces.at(source.surface), settings, wants,
        [&session](double share) { return session.progress.Share(share); });
    });
  for (const std::string& warning : made.warnings)
    SayWarning(session, called + WithoutSubject(warning));
  return made;
}

} // namespace hasp
