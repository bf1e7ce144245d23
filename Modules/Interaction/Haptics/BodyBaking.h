#ifndef BodyBaking_h
#define BodyBaking_h

#include "Distance/BodyDistance.h"
#include "Grid/GridView.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/DynamicPointShell.h"
#include "Haptics/HapticScene.h"
#include "Haptics/PointShell.h"

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <variant>

namespace hasp
{

/// A volume that somebody owns, and the isovalue of the surface that counts.
struct BakedVolume
{
  AnyGridView grid;
  std::shared_ptr<const void> owner;
  double isovalue = 0.0;
};

struct BakingJob
{
  std::variant<BakedVolume, TriangleMesh> body;
  glm::dvec3 origin{ 0.0 }; ///< of the body's axes, in the coordinates of its data
  bool map = false;         ///< can be touched
  bool shell = false;       ///< can touch
  bool dynamic = false;     ///< touches by points drawn where it touches: volumes alone
  double spacingMm = 0.0;   ///< of the distance; 0: BodyDistanceSettings'
  int points = 16'384;      ///< of a static shell
};

struct BakedBody
{
  std::shared_ptr<const DistanceMap> map;
  std::shared_ptr<const PointShell> shell;
  std::shared_ptr<const DynamicShellSource> dynamic;
};

/// Makes a body's map and shell on a WORKER of its own, so that RENDER waits for nothing.
///
/// Threads: RENDER, or whoever owns it; the job runs on a thread of this, which takes no signals
/// and ends with it or with the job. Cancelled when it is deleted: within a batch of work,
/// milliseconds. Cost: about 1 us of CPU time a sample of the body's grid, on all cores; the first
/// shell of a process 5 ms (FastestContactKernels).
class BodyBaking
{
public:
  explicit BodyBaking(BakingJob job);
  ~BodyBaking();
  BodyBaking(const BodyBaking&) = delete;
  BodyBaking& operator=(const BodyBaking&) = delete;

  bool Done() const;
  double Progress() const noexcept { return this->Share.load(std::memory_order_relaxed); }
  /// Once, after Done. Throws what the job threw.
  BakedBody Take() { return this->Result.get(); }

private:
  BakedBody Bake(const BakingJob& job);

  std::atomic<bool> Cancel{ false };
  std::atomic<double> Share{ 0.0 };
  std::future<BakedBody> Result;
};

} // namespace hasp

#endif
