#include "EvaluateSide.h"

#include "Failure.h"
#include "Files.h"
#include "FragmentImages.h"
#include "FragmentSurfaces.h"
#include "PlanInput.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VerbWork.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/MeshCheck.h"
#include "PlanRebuild.h"
#include "Planning/DerivedPart.h"
#include "Planning/PlanLists.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

std::shared_ptr<const TriangleMesh> ReadMesh(
  const std::string& path, const std::string& name, Session& session)
{
  const LoadedSurface loaded = ReadSurface(path, name, true, session);
  return Try(ExitCode::BadInput, name + ": ",
    [&] { return std::make_shared<TriangleMesh>(WeldPoints(TrianglesOf(loaded.surface))); });
}

/// The surfaces in a folder, by their names without endings.
std::map<std::string, fs::path> SurfacesIn(const fs::path& folder)
{
  std::map<std::string, fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && IsSurfaceName(entry.path().string()))
      found.emplace(entry.path().stem().string(), entry.path());
  return found;
}

/// The folder that a plan lies in, however its path is written.
fs::path FolderOf(const std::string& plan)
{
  const fs::path whole = fs::absolute(plan).lexically_normal();
  return whole.has_filename() ? whole.parent_path() : whole.parent_path().parent_path();
}

/// A part as a plan keeps it: binary STL as WriteSurface writes it, its hash already held to.
std::shared_ptr<const TriangleMesh> MeshOfStl(const std::string& stl)
{
  TriangleMesh mesh;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50)
  {
    const auto first = std::uint32_t(mesh.points.size());
    for (std::size_t corner = 1; corner < 4; ++corner)
    {
      float place[3];
      std::memcpy(place, stl.data() + at + 12 * corner, sizeof place);
      mesh.points.emplace_back(place[0], place[1], place[2]);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return std::make_shared<TriangleMesh>(WeldPoints(mesh));
}

std::shared_ptr<const TriangleMesh> KeptMesh(const EvaluatedSide& side, PlanId id)
{
  if (!IsOfScan(side.document->history.Current(), id))
    return nullptr; // no part is made of a surface
  const DerivedPart* part = PartInDate(side.document->history.Current(), side.document->parts, id);
  std::error_code error;
  const std::string folder = PlanFolder(side.path);
  if (!part || !fs::exists(fs::path(folder) / "blobs" / part->bytes, error))
    return nullptr;
  return Try(ExitCode::BadInput, "", [&] { return MeshOfStl(ReadBlob(folder, part->bytes)); });
}

std::vector<PlanId> IdsOf(const EvaluatedSide& side)
{
  std::vector<PlanId> ids;
  for (const auto& [key, fragment] : side.fragments)
    ids.push_back(fragment.id);
  return ids;
}

} // namespace

bool IsPlanPath(const std::string& path)
{
  std::error_code error;
  return fs::path(path).extension() == ".json" ||
         fs::is_regular_file(fs::path(path) / "plan.json", error);
}

EvaluatedSide PlanSide(const std::string& path)
{
  EvaluatedSide side{ path, OpenPlan(path), {} };
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

std::optional<EvaluatedSurface> EvaluatedSurfaces::Find(
  const std::string& key, const std::vector<const EvaluatedSide*>& sides, bool required)
{
  const auto place = std::make_pair(sides.front()->path, key);
  if (const auto found = this->Found.find(place); found != this->Found.end())
    return found->second;
  const EvaluatedSide& first = *sides.front();
  const PlanId id = first.fragments.at(key).id;
  std::shared_ptr<const TriangleMesh> mesh = this->Read(key, sides);
  if (!mesh && !required && !this->CanMake(first, id))
    return std::nullopt;
  if (!mesh)
    mesh = this->Make(first, id);
  return Try(ExitCode::BadInput, "",
    [&]
    {
      return this->Found
        .emplace(place, EvaluatedSurface{ std::make_shared<const MeasuredSurface>(*mesh),
                          CheckMesh(*mesh).Closed() })
        .first->second;
    });
}

std::shared_ptr<const TriangleMesh> EvaluatedSurfaces::Read(
  const std::string& key, const std::vector<const EvaluatedSide*>& sides)
{
  const EvaluatedSide& first = *sides.front();
  const PlanId id = first.fragments.at(key).id;
  if (first.fragments.at(key).surface)
    return first.fragments.at(key).surface;
  for (const EvaluatedSide* side : sides)
    if (const auto kept = KeptMesh(*side, side->fragments.at(key).id))
      return kept;
  const auto beside = SurfacesIn(FolderOf(first.path));
  for (const std::string& name : { key, "fragment-" + std::to_string(id) })
    if (const auto found = beside.find(name); found != beside.end())
      return ReadMesh(found->second.string(), "fragment " + std::to_string(id), this->Shared);
  return nullptr;
}

bool EvaluatedSurfaces::CanMake(const EvaluatedSide& side, PlanId id) const
{
  return IsOfScan(side.document->history.Current(), id) ? !this->Volumes.empty()
                                                        : !this->Files.empty();
}

std::shared_ptr<const TriangleMesh> EvaluatedSurfaces::Make(const EvaluatedSide& side, PlanId id)
{
  const Plan& plan = side.document->history.Current();
  const std::string called = CalledObject(plan, id);
  const bool scanned = IsOfScan(plan, id);
  if (!this->CanMake(side, id))
    throw Failure(ExitCode::BadInput,
      called + ": its surface " +
        (scanned ? "has not been made: hasp run keeps it in the plan; or lay fragment-"
                 : "is not at hand: lay it beside the plan as fragment-") +
        std::to_string(id) + (scanned ? ".stl beside the plan" : ".ply") + ", or give its " +
        (scanned ? "scan: --volume" : "file: --surface"));
  if (!scanned)
  {
    if (!this->FilesOf.contains(side.path))
      this->FilesOf[side.path] = SurfacesOfFragments(plan, IdsOf(side), this->Files, this->Shared);
    return BakeFragment(plan, id, this->FilesOf[side.path], {}, { .surface = true }, this->Shared)
      .model.surface;
  }
  const RunImages images =
    ImagesOfFragments(*side.document, side.path, { id }, this->Volumes, this->Shared);
  this->Shared.progress.Step("making " + called);
  return Try(ExitCode::BadInput, "",
    [&] { return std::make_shared<TriangleMesh>(PlanRebuild(plan, images.images).Make(id).mesh); });
}

} // namespace hasp
