#pragma once
// Private to CellTracer and LightCache.
#include <glm/vec2.hpp>

#include <cstdint>

namespace hasp
{

/// Neighbouring numbers become unlike (Wellons' lowbias32).
inline std::uint32_t HashOf(std::uint32_t v)
{
  v = (v ^ v >> 16U) * 0x7FEB352DU;
  v = (v ^ v >> 15U) * 0x846CA68BU;
  return v ^ v >> 16U;
}

/// Points of the unit square that fill it evenly, shifted by the seed: Roberts' R2 sequence, whose
/// steps are the inverse powers of the plastic number. Sequences of one seed and several numbers
/// fill it evenly together, too, for each starts steps further that are not R2's: the first and the
/// third of R4.
class EvenPoints
{
public:
  explicit EvenPoints(std::uint32_t seed, std::uint32_t number = 0)
    : At(glm::uvec2(HashOf(2 * seed), HashOf(2 * seed + 1)) +
         number * glm::uvec2(3679390609U, 2700274806U)) // 2^32 times 0.8567 and 0.6287; wraps
  {
  }
  glm::dvec2 Next()
  {
    this->At += glm::uvec2(3242174889U, 2447445414U); // 2^32 times 0.7549 and 0.5698; wraps
    return (glm::dvec2(this->At) + 0.5) / 4294967296.0;
  }

private:
  glm::uvec2 At;
};

} // namespace hasp
