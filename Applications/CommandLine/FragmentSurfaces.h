#pragma once
#include "Grid/TriangleMesh.h"
#include "Planning/Plan.h"
#include "SurfaceFragment.h"

#include <map>
#include <string>
#include <vector>

namespace hasp
{

struct Session;

/// A plan's surfaces, by their ids, as their files have them.
using PlanSurfaces = std::map<PlanId, TriangleMesh>;

/// The surfaces of fragments of a plan, found among the files by their hashes; fragments of scans
/// are passed over. Files are told by their places in the command line.
/// Throws Failure: BadInput, with the fragments whose surface no file is, and where a file is none
/// of the plan's surfaces.
PlanSurfaces SurfacesOfFragments(const Plan& plan, const std::vector<PlanId>& fragments,
  const std::vector<std::string>& files, Session& session);

/// A fragment that is a surface as the plan has it measured: closed, or a sheet of its thickness.
/// Its warnings are said.
///
/// settings   thickness, side and spacing are the plan's
/// Throws Failure: BadInput, with the fragment's id.
SurfaceFragment BakeFragment(const Plan& plan, PlanId fragment, const PlanSurfaces& surfaces,
  SurfaceFragmentSettings settings, const FragmentWants& wants, Session& session);

/// What a fragment is of; nullptr: no surface.
const SurfaceSource* SurfaceOf(const Plan& plan, PlanId fragment);

/// The text without the "surface: " that it begins with: who asks has named the surface.
std::string WithoutSubject(const std::string& text);

} // namespace hasp
