#pragma once
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"
#include "Planning/Plan.h"

#include <QObject>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

struct Planner;

/// Triangles of a plan's surfaces by their hashes, as ScanShelf has scans: in memory while their
/// plan is there, and kept on disk as HASH.ply in the planner's own folder, without any text of
/// their files; the oldest go when there are more than `MostBytes` of them. What is put here is
/// shown by the scene. One a planner. Threads: RENDER, but for the static functions (WORKER).
class SurfaceShelf : public QObject
{
  Q_OBJECT
public:
  using Mesh = std::shared_ptr<const TriangleMesh>;
  static constexpr std::uintmax_t MostBytes = std::uintmax_t{ 2 } << 30;

  /// The planner's; made at the first call.
  static SurfaceShelf& Of(Planner& planner);

  void Put(const std::string& hash, Mesh mesh);
  Mesh Find(const std::string& hash) const; ///< nullptr: not in memory
  /// Those of the plan that are not in memory.
  std::vector<PlanSurface> Missing(const Plan& plan) const;
  /// Frees what the plan does not name, here and in the scene; done by itself for another plan.
  void KeepOnly(const Plan& plan);

  std::filesystem::path Folder() const;
  bool IsKept(const std::string& hash) const;

  ///@{
  /// WORKER. Keeps triangles, unless they are there, and drops the oldest beyond MostBytes; a full
  /// disk is no error: they are not kept then.
  static void Keep(
    const std::filesystem::path& folder, const std::string& hash, const TriangleMesh& mesh);
  /// nullptr: not there, or not what its name says. Throws Cancelled.
  static Mesh ReadKept(
    const std::filesystem::path& folder, const std::string& hash, const ProgressFunction& progress);
  ///@}

Q_SIGNALS:
  void Added();

private:
  explicit SurfaceShelf(Planner& planner);

  Planner& With;
  std::map<std::string, Mesh> Meshes;
};

} // namespace hasp
