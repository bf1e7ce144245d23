#pragma once
#include "Light/PathTracer.h"

#include <memory>

namespace hasp
{

/// What is to be traced, sample by sample.
struct ProgressiveWork
{
  std::shared_ptr<const LitScene> scene;
  PictureView view; ///< of the world
  PathPictureSettings settings;
  int samples = 256; ///< of a pixel, after which it ends; >= 1
};

/// A path traced picture that becomes better on a thread of its own, and is given up at once when
/// something else is wanted.
///
/// Threads: one owner (RENDER) calls; a WORKER lives from Start till the last sample or Cancel, and
/// uses all cores. Cancel waits for it: for a tile of 16 x 16 pixels a core, some milliseconds.
/// Memory: 112 bytes a pixel while it runs. No thread, no memory before the first Start.
class ProgressivePaths
{
public:
  ProgressivePaths();
  ~ProgressivePaths(); ///< cancels
  ProgressivePaths(const ProgressivePaths&) = delete;
  ProgressivePaths& operator=(const ProgressivePaths&) = delete;

  /// Begins anew; what is under way is cancelled. Throws std::invalid_argument: no scene, samples
  /// out of range, settings as AddPathSample has them.
  void Start(ProgressiveWork work);
  /// Ends the thread; what it found stays to be had.
  void Cancel();
  /// Ends the thread and forgets all.
  void Release();
  /// Returns when there are so many samples, or no more will come.
  void WaitFor(int samples);

  bool Running() const;
  int Samples() const; ///< of what Latest would give
  /// The picture so far, if it has other samples than `picture`; false and untouched else. Throws
  /// what stopped the thread, once.
  bool Latest(PathTracedPicture& picture) const;
  std::size_t Bytes() const;

private:
  struct Shared;
  std::unique_ptr<Shared> Self;
};

} // namespace hasp
