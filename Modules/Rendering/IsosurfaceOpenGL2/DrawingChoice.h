#ifndef DrawingChoice_h
#define DrawingChoice_h

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

/// Which of two ways draws an isosurface faster for an eye, by timing its first frames: the cache,
/// or all active cells. What a frame costs that begins with another isovalue or volume is counted
/// apart, for then all cells must be extracted anew. The verdict holds until the pixels or the
/// cells become twice or half as many.
class DrawingChoice
{
public:
  /// What a frame does. Both drawn: the cache first, to be timed, then all cells over it, so that
  /// the picture is complete.
  struct Frame
  {
    bool sample; ///< rays fill the cache
    bool cache, whole;
  };
  /// Forgets what was measured of another scene. cells: all active ones; 0 where not known.
  void Begin(std::size_t pixels, std::size_t cells)
  {
    const auto far = [](std::size_t now, std::size_t then)
    { return now > 0 && then > 0 && (now > 2 * then || then > 2 * now); };
    if (far(pixels, this->Pixels) || far(cells, this->Cells))
      *this = {};
    if (this->Pixels == 0)
      this->Pixels = pixels;
    if (this->Cells == 0)
      this->Cells = cells;
  }
  /// A frame that can be timed. filled: the cache holds what is in view; before that it is not left
  /// alone in a frame at rest. After a change it is, for then it is chosen to save the extraction.
  Frame Next(bool changed, bool filled) const
  {
    const Costs& costs = this->Measured[changed];
    if (costs.whole.times < Enough)
      return { false, false, true };
    if (costs.cache.times < Enough)
      return { true, true, true };
    const bool alone = costs.CacheWins() && (filled || changed);
    return { costs.CacheWins(), alone, !alone };
  }
  /// A pass that is not timed, and drawn in one way: one of a pick, or a second one of a frame.
  Frame Untimed(bool filled) const
  {
    const bool cache = filled && this->Measured[0].Known() && this->Measured[0].CacheWins();
    return { cache, cache, !cache };
  }
  /// What a later frame may ask for, as far as is known.
  Frame MayDraw(bool filled) const
  {
    Frame may{ false, false, !filled };
    for (const Costs& costs : this->Measured)
    {
      may.cache |= !costs.Known() || costs.CacheWins();
      may.whole |= !costs.Known() || !costs.CacheWins();
    }
    may.sample = may.cache;
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
  std::size_t Pixels = 0, Cells = 0;
};

#endif
