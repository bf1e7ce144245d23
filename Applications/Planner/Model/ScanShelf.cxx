#include "Model/ScanShelf.h"

#include "Model/KeptFiles.h"
#include "Planning/DurableFile.h"

#include "vtkHaspOutputFile.h"
#include "vtkImageData.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <new>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

fs::path FileOf(const fs::path& folder, const std::string& hash)
{
  return folder / (hash + ".nrrd");
}

/// What a .nrrd does not say of a scan, and no text of its file.
fs::path NoteOf(const fs::path& folder, const std::string& hash)
{
  return folder / (hash + ".json");
}

void WriteNote(const fs::path& folder, const Passport& passport)
{
  const nlohmann::ordered_json note = { { "modality", passport.modality },
    { "hounsfield", passport.hounsfield } };
  WriteDurably(NoteOf(folder, passport.hash), note.dump(1), "a kept scan");
}

void ReadNote(const fs::path& folder, Passport& passport)
{
  const auto note = nlohmann::json::parse(
    ReadWhole(NoteOf(folder, passport.hash), 4096, "a kept scan"), nullptr, false);
  if (note.is_discarded())
    throw std::runtime_error("a kept scan is damaged");
  passport.modality = note.value("modality", "");
  passport.hounsfield = note.value("hounsfield", false);
}
} // namespace

ScanShelf::ScanShelf(fs::path folder, QObject* parent) : QObject(parent), Kept(std::move(folder)) {}

void ScanShelf::Put(ShelfScan scan)
{
  const std::string hash = scan.passport.hash;
  this->Scans.insert_or_assign(hash, std::move(scan));
  Q_EMIT this->Added(QString::fromStdString(hash));
}

const ShelfScan* ScanShelf::Find(const std::string& hash) const
{
  const auto found = this->Scans.find(hash);
  return found == this->Scans.end() ? nullptr : &found->second;
}

const ShelfScan* ScanShelf::OfVolume(const Plan& plan, PlanId volume) const
{
  const auto found = std::find_if(plan.volumes.begin(), plan.volumes.end(),
    [&](const PlanVolume& one) { return one.id == volume; });
  return found == plan.volumes.end() ? nullptr : this->Find(found->hash);
}

std::vector<PlanVolume> ScanShelf::Missing(const Plan& plan) const
{
  std::vector<PlanVolume> missing;
  std::copy_if(plan.volumes.begin(), plan.volumes.end(), std::back_inserter(missing),
    [&](const PlanVolume& one) { return !this->Find(one.hash); });
  return missing;
}

void ScanShelf::KeepOnly(const Plan& plan)
{
  std::erase_if(this->Scans,
    [&](const auto& scan)
    {
      return std::none_of(plan.volumes.begin(), plan.volumes.end(),
        [&](const PlanVolume& one) { return one.hash == scan.first; });
    });
}

bool ScanShelf::IsKept(const std::string& hash) const
{
  std::error_code error; // then it is not
  return !this->Kept.empty() && fs::exists(FileOf(this->Kept, hash), error);
}

ShelfScan ScanShelf::Read(
  const std::string& path, const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  VolumeReadSettings hashed = settings;
  hashed.hash = true;
  LoadedVolume loaded = LoadVolume(OpenVolume(path, hashed, progress), progress);
  return { loaded.image, std::move(loaded.passport) };
}

std::optional<ShelfScan> ScanShelf::ReadKept(
  const fs::path& folder, const std::string& hash, const ProgressFunction& progress)
{
  const fs::path file = FileOf(folder, hash);
  std::error_code error;
  if (folder.empty() || !fs::exists(file, error))
    return std::nullopt;
  try
  {
    ShelfScan scan = Read(file.string(), {}, progress);
    if (scan.passport.hash == hash)
    {
      ReadNote(folder, scan.passport);
      fs::last_write_time(file, fs::file_time_type::clock::now(), error); // it is the newest again
      return scan;
    }
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::bad_alloc&) // no fault of the file's: it stays
  {
    throw;
  }
  catch (const std::exception&) // damaged: as if it were not there
  {
  }
  fs::remove(file, error);
  return std::nullopt;
}

void ScanShelf::Keep(const fs::path& folder, const ShelfScan& scan)
{
  const fs::path file = FileOf(folder, scan.passport.hash);
  std::error_code error;
  if (folder.empty() || fs::exists(file, error))
    return;
  fs::create_directories(folder, error);
  try
  {
    WriteNote(folder, scan.passport); // first: a scan is there when its .nrrd is
    WriteVolume(scan.image, file.string());
    DropOldestFiles(folder, MostBytes);
  }
  catch (const std::exception&) // as the header says
  {
  }
}

} // namespace hasp
