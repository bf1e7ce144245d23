#ifndef CacheProgress_h
#define CacheProgress_h

#include "Isosurface/RayCache.h"

#include <string>

/// How far the ray cache has come for an eye, and what its frames cost.
class CacheProgress
{
public:
  static constexpr int MostRays = hasp::RaySampler::TilePixels; ///< a tile

  /// How many rays a tile fit into a budget in ms beside the drawing, by what the last frame took;
  /// `fixed` where there is no budget, or nothing is known.
  int RaysFor(double budget, int fixed) const;
  /// So many rays a tile have met this.
  void Sampled(const hasp::RayCache::Frame& frame, int rays, double milliseconds);
  /// Drawn and read back, in so many ms.
  void Drawn(double milliseconds) { this->DrawMilliseconds = milliseconds; }
  /// Does the picture at hand show nothing but the cache?
  void ShowsCache(bool alone) { this->Alone = alone; }
  /// The surface is another one by now.
  void Unfill() { this->FullFrames = this->QuietFrames = 0; }

  /// Have the rays of the last frames met little that the cache did not hold?
  bool Filled() const { return this->FullFrames >= FilledAfter; }
  /// Has the last frame shown the cache alone, and have rays of the last frames found more? One
  /// frame is enough to rest if it had a ray a pixel: the next would meet the same.
  bool Refining() const { return this->Alone && this->QuietFrames < RestsAfter; }
  /// Of the last frame: "; all pixels from the cache, which held 99.98 % of what 3120 rays met".
  /// Half of the rays look for holes, and some ahead of the camera.
  std::string ShareOfCache() const;

private:
  static constexpr int FilledAfter = 4, RestsAfter = 4; // frames
  static constexpr double Full = 0.995;                 // of the hits: 0.5 % are holes
  int FullFrames = 0;
  int QuietFrames = 0; ///< in which nothing more was found
  hasp::RayCache::Frame Last;
  int Rays = 0;
  double SampleMilliseconds = 0.0, DrawMilliseconds = 0.0;
  bool Alone = false;
};

#endif
