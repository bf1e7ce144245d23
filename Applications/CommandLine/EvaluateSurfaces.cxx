#include "EvaluateSide.h"

#include "Failure.h"
#include "FragmentImages.h"
#include "FragmentSurfaces.h"
#include "PlanInput.h"
#include "Session.h"
#include "VerbWork.h"

#include "Evaluation/MeshCheck.h"
#include "PlanRebuild.h"
#include "Planning/DerivedPart.h"
#include "Planning/PlanLists.h"

#include <cstring>
#include <filesystem>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

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
