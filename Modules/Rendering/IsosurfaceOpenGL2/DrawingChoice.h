#ifndef DrawingChoice_h
#define DrawingChoice_h

#include <algorithm>
#include <limits>
#include <string>

/// Which of two ways draws an isosurface faster, by timing the first frames: the cache, or all
/// active cells. What a frame costs that begins with another isovalue or volume is counted apart,
/// for then all cells must be extracted anew.
class DrawingChoice
{
public:
  /// What a frame is to draw. Both: the cache first, to be timed, then all cells over it, so that
  /// the picture is complete.
  struct Frame
  {
    bool cache, whole;
  };
  /// filled: the cache has once held all that was in view; before that it is not left alone in a
  /// frame at rest. After a change it is, for then it is chosen to save the extraction.
  Frame Next(bool changed, bool filled) const
  {
    const Costs& costs = this->Measured[changed];
    if (costs.whole.times < Enough)
      return { false, true };
    if (costs.cache.times < Enough)
      return { true, true };
    return { costs.CacheWins(), !costs.CacheWins() || !(filled || changed) };
  }
  /// What a later frame may ask for, as far as is known.
  Frame MayDraw(bool filled) const
  {
    Frame may{ false, !filled };
    for (const Costs& costs : this->Measured)
    {
      may.cache |= !costs.Known() || costs.CacheWins();
      may.whole |= !costs.Known() || !costs.CacheWins();
    }
    return may;
  }
  void CacheTook(bool changed, double ms) { this->Measured[changed].cache.Add(ms); }
  void WholeTook(bool changed, double ms) { this->Measured[changed].whole.Add(ms); }
  /// "cache 62.1 ms, all active cells 31.0 ms; after a change 65.0 ms and 44.2 ms".
  std::string Text() const;

private:
  static constexpr int Enough = 2; // the first frame of a way compiles shaders
  struct Cost
  {
    int times = 0;
    double least = std::numeric_limits<double>::infinity();
    void Add(double ms)
    {
      ++this->times;
      this->least = std::min(this->least, ms);
    }
  };
  struct Costs
  {
    Cost cache, whole;
    bool Known() const { return this->cache.times >= Enough && this->whole.times >= Enough; }
    bool CacheWins() const { return this->cache.least < this->whole.least; }
  };
  Costs Measured[2]; ///< at rest, after a change
};

#endif
