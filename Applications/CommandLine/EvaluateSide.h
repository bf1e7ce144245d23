#pragma once
#include "Evaluation/SurfaceDifference.h"
#include "FragmentSurfaces.h"
#include "Grid/RigidPose.h"
#include "Grid/TriangleMesh.h"
#include "Planning/PlanFile.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What `hasp evaluate` compares: plans, surfaces, or folders of surfaces.
namespace hasp
{

struct Session;

/// A fragment by its key: of a plan its name, if that is no other's, else "#ID"; of a surface the
/// name of its file. Keys are the user's words: texts say them with --show-names alone.
struct EvaluatedFragment
{
  PlanId id = 0; ///< 0: of no plan
  bool locked = false;
  RigidPose scanToPlanned;                       ///< of a plan
  std::shared_ptr<const TriangleMesh> surface{}; ///< of a file, where that puts it
};

struct EvaluatedSide
{
  std::string path;
  std::optional<PlanDocument> document; ///< of a plan
  std::map<std::string, EvaluatedFragment> fragments;
};

/// A folder that is a plan's, or a .json file.
bool IsPlanPath(const std::string& path);

/// The kept fragments of a plan that are not cut into pieces; a surface; all surfaces of a folder.
/// Throws Failure: BadInput, also where there are none.
EvaluatedSide ReadSide(const std::string& path, Session& session);
EvaluatedSide PlanSide(const std::string& path);
/// Of a plan that is open; `folder`: where its blobs are.
EvaluatedSide PlanSide(const std::string& folder, PlanDocument document);

/// The key that a user means by a name or an id. Throws Failure: WrongUse if there is none. Empty
/// for an empty text, unless exactly one fragment is locked.
std::string ReferenceOf(const EvaluatedSide& side, const std::string& wanted);

/// A surface, ready to be measured; `closed`: it encloses a body.
struct EvaluatedSurface
{
  std::shared_ptr<const MeasuredSurface> measured;
  bool closed = false;
};

/// A surface file as one mesh. name: what errors call it. Throws Failure: BadInput.
std::shared_ptr<const TriangleMesh> ReadMesh(
  const std::string& path, const std::string& name, Session& session);

/// The surfaces in a folder, by their names without endings.
std::map<std::string, std::filesystem::path> SurfacesIn(const std::filesystem::path& folder);

/// Where fragments' surfaces come from, each read or made once.
class EvaluatedSurfaces
{
public:
  /// `volumes`, `surfaces`: files that the plans' own scans and surfaces are found among.
  EvaluatedSurfaces(
    std::vector<std::string> volumes, std::vector<std::string> surfaces, Session& session)
    : Volumes(std::move(volumes)),
      Files(std::move(surfaces)),
      Shared(session)
  {
  }

  /// In the scan. Of a plan: as `hasp run` kept it in one of the plans, which must make it of the
  /// same; as it lies beside them, "fragment-ID.stl" or the key's name; else made of --volume, or
  /// of --surface. Throws Failure: BadInput.
  std::shared_ptr<const MeasuredSurface> Of(
    const std::string& key, const std::vector<const EvaluatedSide*>& sides)
  {
    return this->At(key, sides).measured;
  }
  EvaluatedSurface At(const std::string& key, const std::vector<const EvaluatedSide*>& sides)
  {
    return *this->Find(key, sides, true);
  }
  /// The same; nothing where there is none to be had.
  std::optional<EvaluatedSurface> AtHand(
    const std::string& key, const std::vector<const EvaluatedSide*>& sides)
  {
    return this->Find(key, sides, false);
  }

private:
  std::optional<EvaluatedSurface> Find(
    const std::string& key, const std::vector<const EvaluatedSide*>& sides, bool required);
  std::shared_ptr<const TriangleMesh> Read(
    const std::string& key, const std::vector<const EvaluatedSide*>& sides);
  bool CanMake(const EvaluatedSide& side, PlanId id) const;
  std::shared_ptr<const TriangleMesh> Make(const EvaluatedSide& side, PlanId id);

  std::vector<std::string> Volumes, Files;
  std::map<std::pair<std::string, std::string>, EvaluatedSurface> Found; ///< by path and key
  std::map<std::string, PlanSurfaces> FilesOf;                           ///< by the plan's path
  Session& Shared;
};

/// Of all fragments, in the order of their ids, else of their names.
std::vector<std::string> KeysOf(const EvaluatedSide& side);

/// Whether both plans make the fragment of the same bone.
bool IsOneBone(const EvaluatedSide& a, PlanId ofA, const EvaluatedSide& b, PlanId ofB);

} // namespace hasp
