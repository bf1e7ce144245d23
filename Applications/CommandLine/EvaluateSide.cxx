#include "EvaluateSide.h"

#include "Failure.h"
#include "Files.h"
#include "FragmentSurfaces.h"
#include "PlanInput.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/MeshCheck.h"
#include "Planning/DerivedPart.h"
#include "Planning/PlanLists.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace hasp
{
namespace fs = std::filesystem;

std::shared_ptr<const TriangleMesh> ReadMesh(
  const std::string& path, const std::string& name, Session& session)
{
  const LoadedSurface loaded = ReadSurface(path, name, true, session);
  return Try(ExitCode::BadInput, name + ": ",
    [&] { return std::make_shared<TriangleMesh>(WeldPoints(TrianglesOf(loaded.surface))); });
}

std::map<std::string, std::filesystem::path> SurfacesIn(const std::filesystem::path& folder)
{
  std::map<std::string, std::filesystem::path> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && IsSurfaceName(entry.path().string()))
      found.emplace(entry.path().stem().string(), entry.path());
  return found;
}

bool IsPlanPath(const std::string& path)
{
  std::error_code error;
  return fs::path(path).extension() == ".json" ||
         fs::is_regular_file(fs::path(path) / "plan.json", error);
}

EvaluatedSide PlanSide(const std::string& path)
{
  return PlanSide(path, OpenPlan(path));
}

EvaluatedSide PlanSide(const std::string& folder, PlanDocument document)
{
  EvaluatedSide side{ folder, std::move(document), {} };
  const Plan& plan = side.document->history.Current();
  std::map<std::string, int> names;
  for (const PlanFragment& fragment : plan.fragments)
    ++names[fragment.name];
  for (const PlanFragment& fragment : plan.fragments)
    if (fragment.state == FragmentState::Kept && !IsDivided(plan, fragment.id))
    {
      const bool named = !fragment.name.empty() && names[fragment.name] == 1;
      const PlanPose& pose = fragment.scanToPlanned;
      side
        .fragments[named ? fragment.name : std::string("#").append(std::to_string(fragment.id))] = {
        fragment.id, fragment.locked, { pose.position, pose.orientation }
      };
    }
  if (side.fragments.empty())
    throw Failure(ExitCode::BadInput, "the plan: it has no fragment to be evaluated");
  return side;
}

EvaluatedSide ReadSide(const std::string& path, Session& session)
{
  RequireInput(path);
  if (IsPlanPath(path))
    return PlanSide(path);
  EvaluatedSide side{ path, std::nullopt, {} };
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    for (const auto& [name, file] : SurfacesIn(path))
      side.fragments[name].surface =
        ReadMesh(file.string(), "surface " + std::to_string(side.fragments.size()), session);
    if (side.fragments.empty())
      throw Failure(
        ExitCode::BadInput, FileLabel(path) + ": there is neither a plan nor a surface in it");
    return side;
  }
  if (!IsSurfaceName(path))
    throw Failure(ExitCode::WrongUse, FileLabel(path) +
                                        ": neither a plan nor a surface: .json, .stl, .3mf, .ply, "
                                        ".obj or .vtp");
  side.fragments[fs::path(path).stem().string()].surface = ReadMesh(path, "the surface", session);
  return side;
}

std::string ReferenceOf(const EvaluatedSide& side, const std::string& wanted)
{
  std::string found;
  int locked = 0;
  for (const auto& [key, fragment] : side.fragments)
  {
    if (!wanted.empty() &&
        (key == wanted || (fragment.id != 0 && std::to_string(fragment.id) == wanted)))
      return key;
    if (wanted.empty() && fragment.locked)
    {
      ++locked;
      found = key;
    }
  }
  if (!wanted.empty())
    throw Failure(ExitCode::WrongUse, "--reference: no fragment of " +
                                        std::string(side.document ? "the plan" : "these surfaces") +
                                        " has that name or id; hasp plan --show lists a plan's");
  return locked == 1 ? found : "";
}

std::vector<std::string> KeysOf(const EvaluatedSide& side)
{
  std::vector<std::string> keys;
  for (const auto& [key, fragment] : side.fragments)
    keys.push_back(key);
  std::stable_sort(keys.begin(), keys.end(),
    [&](const std::string& a, const std::string& b)
    { return side.fragments.at(a).id < side.fragments.at(b).id; });
  return keys;
}

bool IsOneBone(const EvaluatedSide& a, PlanId ofA, const EvaluatedSide& b, PlanId ofB)
{
  const auto madeOf = [](const EvaluatedSide& side, PlanId id)
  {
    const Plan& plan = side.document->history.Current();
    std::multiset<std::string> hashes; // ids may differ
    SurfaceSource sheet;
    if (const SurfaceSource* source = SurfaceOf(plan, id))
    {
      hashes.insert(FindPlanObject<PlanSurface>(plan, source->surface)->hash);
      sheet = *source;
      sheet.surface = 0;
    }
    else
      for (const PartInput& input : PartInputs(plan, id))
        hashes.insert(input.hash);
    return std::pair(hashes, sheet);
  };
  return madeOf(a, ofA) == madeOf(b, ofB);
}

} // namespace hasp
