#pragma once
#include "Planning/Plan.h"
#include "vtkHaspVolumeFile.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// A scan, or a surface file's triangles, in memory.
struct ShelfScan
{
  vtkSmartPointer<vtkImageData> image;
  Passport passport; ///< its hash is the plan's name for it
};

/// Scans by their hashes, as plans name them. What was imported is also kept on disk as HASH.nrrd
/// in the planner's own folder, without any text of its file, so that a plan opens again without
/// asking where its scans are and no path need be remembered; the oldest go when there are more
/// than `MostBytes` of them.
///
/// Threads: RENDER, but for the static functions (WORKER: they only touch files).
class ScanShelf : public QObject
{
  Q_OBJECT
public:
  static constexpr std::uintmax_t MostBytes = std::uintmax_t{ 8 } << 30;

  /// `folder`: of kept scans, made when the first is kept; empty: none is kept.
  explicit ScanShelf(std::filesystem::path folder, QObject* parent = nullptr);

  void Put(ShelfScan scan);
  const ShelfScan* Find(const std::string& hash) const; ///< nullptr: not in memory
  /// Of a volume of the plan. nullptr: no such volume, or not in memory.
  const ShelfScan* OfVolume(const Plan& plan, PlanId volume) const;
  /// Those of the plan that are not in memory.
  std::vector<PlanVolume> Missing(const Plan& plan) const;
  /// Frees what the plan does not name.
  void KeepOnly(const Plan& plan);

  const std::filesystem::path& Folder() const { return this->Kept; }
  /// Whether it can be read again from the folder.
  bool IsKept(const std::string& hash) const;

  ///@{
  /// WORKER. Reads a scan with its hash, from anywhere, or from the folder (nullopt: not there, or
  /// not what its name says). Throw as LoadVolume.
  static ShelfScan Read(
    const std::string& path, const VolumeReadSettings& settings, const ProgressFunction& progress);
  static std::optional<ShelfScan> ReadKept(
    const std::filesystem::path& folder, const std::string& hash, const ProgressFunction& progress);
  /// Keeps it, unless it is there, and drops the oldest beyond MostBytes. A full disk is no error:
  /// it is not kept then. WORKER.
  static void Keep(const std::filesystem::path& folder, const ShelfScan& scan);
  ///@}

Q_SIGNALS:
  void Added(const QString& hash);

private:
  std::filesystem::path Kept;
  std::map<std::string, ShelfScan> Scans;
};

} // namespace hasp
