#include "CacheProgress.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

int CacheProgress::RaysFor(double budget, int fixed) const
{
  if (budget == 0.0 || this->Rays == 0 || !(this->SampleMilliseconds > 0.0))
    return fixed;
  // Rounded up: a frame has a fixed part, and one ray would stay one.
  const double fit =
    std::ceil((budget - this->DrawMilliseconds) / this->SampleMilliseconds * this->Rays);
  return static_cast<int>(std::clamp(fit, 1.0, double(MostRays)));
}

void CacheProgress::Sampled(const hasp::RayCache::Frame& frame, int rays, double milliseconds)
{
  this->Last = frame;
  this->Rays = rays;
  this->SampleMilliseconds = milliseconds;
  const int quiet = rays >= MostRays ? RestsAfter : this->QuietFrames + 1;
  this->QuietFrames = frame.Refining() ? 0 : std::min(quiet, RestsAfter);
  if (frame.hits == 0)
    return; // says nothing of how full the cache is
  const bool full = double(frame.known) >= Full * double(frame.hits);
  this->FullFrames = full ? std::min(this->FullFrames + 1, FilledAfter) : 0;
}

std::string CacheProgress::ShareOfCache() const
{
  if (!this->Alone)
    return "; no pixel from the cache";
  if (this->Last.hits == 0)
    return "; no ray met a surface";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "; all pixels from the cache, which held "
       << 100.0 * double(this->Last.known) / double(this->Last.hits) << " % of what "
       << this->Last.hits << " rays met";
  return text.str();
}
