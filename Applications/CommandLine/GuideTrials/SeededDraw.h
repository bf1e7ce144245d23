#pragma once
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace hasp
{

/// Numbers from a seed, the same everywhere: std's distributions are not.
class Draw
{
public:
  explicit Draw(std::uint32_t seed) : Random(seed) {}
  double From(double least, double most)
  {
    return least + (most - least) * (double(this->Random()) / 4294967295.0);
  }
  std::size_t Below(std::size_t count) { return this->Random() % count; }
  glm::dvec3 Direction()
  {
    const double z = this->From(-1.0, 1.0), turn = this->From(0.0, 6.283185307179586);
    const double r = std::sqrt(1.0 - z * z);
    return { r * std::cos(turn), r * std::sin(turn), z };
  }

private:
  std::mt19937 Random;
};

} // namespace hasp
