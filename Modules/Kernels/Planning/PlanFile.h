#pragma once
#include "Planning/DerivedPart.h"
#include "Planning/PlanHistory.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A plan on disk: a folder, NAME.hasp, with plan.json (the plan, what was made from it, its
/// history) and blobs/SHA256 (label maps, meshes: any bytes, named by their hash).
/// Utilities/Docs/Formats.md is the table. Nothing of a patient is in it but what the user types:
/// scans are named by hash, not by path.
///
/// Damage: plan.json ends with its own hash, and a blob's name is its hash, so that one wrong byte
/// anywhere is found when it is read. Saving: whole or not at all, whatever breaks in between, and
/// it outlasts a power cut. Two programs that change one plan each hold a PlanLock from loading it
/// to saving it; without, the last one stays.
///
/// Needs HASP_ENABLE_JSON and HASP_ENABLE_OPENSSL. Errors: std::runtime_error (disk, damage,
/// syntax), std::invalid_argument (content); they name the file within the folder and the key,
/// never a path or a text of the plan. Any thread; two that change one folder hold a PlanLock each.
namespace hasp
{

/// Holds a plan's folder, which must be there: whoever else asks for it waits until this is gone,
/// at the latest with its program. For as long as it takes to load a plan, change it and save it,
/// never for a calculation. Throws std::runtime_error if the folder cannot be opened. Limit: where
/// the file system knows no locks, as on some network drives, nobody waits.
class PlanLock
{
public:
  explicit PlanLock(const std::filesystem::path& folder);
  ~PlanLock();
  PlanLock(const PlanLock&) = delete;
  PlanLock& operator=(const PlanLock&) = delete;

private:
  int Folder; ///< its descriptor
};

/// What is saved.
struct PlanDocument
{
  PlanHistory history; ///< Current() is the plan
  std::vector<DerivedPart> parts;

  bool operator==(const PlanDocument&) const noexcept = default;
};

/// plan.json as text; equal documents are equal texts. At most 64 MiB.
std::string FormatPlan(const PlanDocument& document);
/// Reads that, and older versions of it. The plan must be the one that its history leads to.
PlanDocument ParsePlan(const std::string& text);

/// Makes the folder if it is not there (its parent must be), and replaces plan.json.
void SavePlan(const std::filesystem::path& folder, const PlanDocument& document);
PlanDocument LoadPlan(const std::filesystem::path& folder);

/// Puts bytes into the folder and returns their name. Before the plan that names them is saved.
std::string WriteBlob(const std::filesystem::path& folder, std::string_view bytes);
std::string ReadBlob(const std::filesystem::path& folder, const std::string& hash);
/// All that the document names, in its history too, each once.
std::vector<std::string> BlobsOf(const PlanDocument& document);
/// Deletes blobs that the document does not name and what interrupted saves left. Under a PlanLock,
/// with the document that was loaded under it.
void RemoveUnusedBlobs(const std::filesystem::path& folder, const PlanDocument& document);

/// Reads everything and says what is damaged or missing, a sentence each; empty if all is sound.
std::vector<std::string> PlanFaults(const std::filesystem::path& folder);

} // namespace hasp
