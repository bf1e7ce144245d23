#pragma once
#include <glm/vec3.hpp>

#include <cstdint>

namespace hasp
{

/// Deterministic, in [0, 1).
class Dice
{
public:
  explicit Dice(std::uint32_t seed) : State(seed) {}
  double operator()()
  {
    this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }
  glm::dvec3 InBox(double half)
  {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return half * (2.0 * glm::dvec3(x, y, z) - 1.0);
  }

private:
  std::uint64_t State;
};

} // namespace hasp
