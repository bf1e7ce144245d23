#include "Planning/PlanFile.h"

#include "Planning/DurableFile.h"
#include "Planning/PlanJson.h"
#include "Planning/PlanMigration.h"
#include "Planning/Sha256.h"
#include "Planning/ValueChecks.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <stdexcept>
#include <system_error>

namespace hasp
{

namespace
{
namespace fs = std::filesystem;

constexpr const char* Subject = "plan";
constexpr const char* PlanName = "plan.json";
constexpr std::string_view Format = "hasp-plan-";
constexpr std::size_t MostText = 64U << 20U;
constexpr std::size_t MostBlob = std::size_t(16) << 30U;

// A file is BODY Before HASH After, where the hash is of BODY: each byte is hashed or compared.
constexpr std::string_view Before = ",\n  \"sha256\": \"", After = "\"\n}\n", End = "\n}\n";

std::string Seal(std::string text)
{
  text.resize(text.size() - End.size());
  const std::string hash = Sha256(text);
  return text.append(Before).append(hash).append(After);
}

void CheckSeal(std::string_view text)
{
  const std::size_t tail = Before.size() + 64 + After.size();
  if (text.size() > tail)
  {
    const std::string_view body = text.substr(0, text.size() - tail);
    std::string sound(Before);
    if (text.substr(body.size()) == sound.append(Sha256(body)).append(After))
      return;
  }
  throw std::runtime_error("plan.json is damaged, or was changed by something else than Hasp: its "
                           "hash is of other bytes. Take it from a backup");
}

std::string BlobSubject(const std::string& hash)
{
  return "blobs/" + hash.substr(0, 12);
}
} // namespace

PlanLock::PlanLock(const fs::path& folder)
  : Folder(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  if (this->Folder < 0)
    throw std::runtime_error(
      "the plan's folder cannot be opened: " + std::generic_category().message(errno));
  while (flock(this->Folder, LOCK_EX) != 0 && errno == EINTR)
  {
  }
}

PlanLock::~PlanLock()
{
  close(this->Folder);
}

std::string FormatPlan(const PlanDocument& document)
{
  Json parts = Json::array();
  for (const DerivedPart& part : document.parts)
    parts.push_back(PartToJson(part));
  const Json json = { { "format",
                        std::string(Format) + std::to_string(PlanMigrations().size() + 1) },
    { "plan", PlanToJson(document.history.Current()) }, { "parts", std::move(parts) },
    { "history", HistoryToJson(document.history) } };
  std::string text = Seal(FormatJson(json, Subject));
  if (text.size() > MostText)
    throw std::runtime_error("plan.json would have " + std::to_string(text.size()) +
                             " bytes, at most " + std::to_string(MostText) + " can be read");
  return text;
}

PlanDocument ParsePlan(const std::string& text)
{
  CheckSeal(text);
  Json json = ParseJson(text, Subject);
  const std::size_t version = ReadFormatVersion(
    StrictJson(json, Subject, "", { "format", "plan", "parts", "history", "sha256" }),
    std::string(Format));
  MigratePlanFile(json, version, PlanMigrations());
  const StrictJson file(json, Subject, "", { "format", "plan", "parts", "history", "sha256" });
  PlanDocument document{ HistoryFromJson(file.Get("history")), {} };
  if (PlanFromJson(file.Get("plan"), "plan") != document.history.Current())
    file.Fail("plan", "is not the one that its history leads to");
  for (const Json& part : file.List("parts"))
    document.parts.push_back(PartFromJson(part, ListKey("parts", document.parts.size())));
  return document;
}

void SavePlan(const fs::path& folder, const PlanDocument& document)
{
  const std::string text = FormatPlan(document);
  MakeFolderDurably(folder, "the plan's folder");
  WriteDurably(folder / PlanName, text, PlanName);
}

PlanDocument LoadPlan(const fs::path& folder)
{
  return ParsePlan(ReadWhole(folder / PlanName, MostText, PlanName));
}

std::string WriteBlob(const fs::path& folder, std::string_view bytes)
{
  std::string hash = Sha256(bytes);
  MakeFolderDurably(folder, "the plan's folder");
  MakeFolderDurably(folder / "blobs", "blobs");
  WriteDurably(folder / "blobs" / hash, bytes, BlobSubject(hash));
  return hash;
}

std::string ReadBlob(const fs::path& folder, const std::string& hash)
{
  ValueChecks("blob").Hash("name", hash); // a name and not a way to some other file
  std::string bytes = ReadWhole(folder / "blobs" / hash, MostBlob, BlobSubject(hash));
  if (Sha256(bytes) != hash)
    throw std::runtime_error(
      BlobSubject(hash) + " is damaged: its bytes are not those that it was named by");
  return bytes;
}

std::vector<std::string> BlobsOf(const PlanDocument& document)
{
  std::set<std::string> blobs;
  const auto ofSegmentation = [&](const PlanSegmentation& s)
  {
    if (!s.labels.empty())
      blobs.insert(s.labels);
  };
  for (const PlanSegmentation& segmentation : document.history.Start().segmentations)
    ofSegmentation(segmentation);
  for (const PlanStep& step : document.history.Steps())
    for (const PlanEdit& edit : step.edits)
      if (const auto* added = std::get_if<AddObject<PlanSegmentation>>(&edit))
        ofSegmentation(added->object);
      else if (const auto* changed = std::get_if<ChangeObject<PlanSegmentation>>(&edit))
        ofSegmentation(changed->object);
  for (const DerivedPart& part : document.parts)
  {
    blobs.insert(part.bytes);
    if (!part.report.empty())
      blobs.insert(part.report);
  }
  return { blobs.begin(), blobs.end() };
}

void RemoveUnusedBlobs(const fs::path& folder, const PlanDocument& document)
{
  const std::vector<std::string> list = BlobsOf(document);
  const std::set<std::string> named(list.begin(), list.end());
  std::vector<fs::path> unused;
  for (const fs::path& at : { folder, folder / "blobs" })
    if (fs::is_directory(at))
      for (const fs::directory_entry& entry : fs::directory_iterator(at))
      {
        const std::string name = entry.path().filename().string();
        const bool blob = at != folder && name.size() == 64 && !named.contains(name);
        if (entry.is_regular_file() && (blob || name.starts_with(TemporaryBegin)))
          unused.push_back(entry.path());
      }
  for (const fs::path& path : unused)
    if (std::error_code error; !fs::remove(path, error))
      throw std::runtime_error("an unused blob cannot be removed: " + error.message());
}

std::vector<std::string> PlanFaults(const fs::path& folder)
{
  std::vector<std::string> faults;
  try
  {
    for (const std::string& blob : BlobsOf(LoadPlan(folder)))
      try
      {
        ReadBlob(folder, blob);
      }
      catch (const std::exception& error)
      {
        faults.push_back(error.what());
      }
  }
  catch (const std::exception& error)
  {
    faults.push_back(error.what());
  }
  return faults;
}

} // namespace hasp
