#pragma once
#include "Studies/SeededShare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace hasp
{

/// Chance that depends on nothing but the seed and how often it was asked.
class SeededDice
{
public:
  explicit SeededDice(std::uint64_t seed) : Seed(seed) {}
  double Share() { return SeededShare(this->Seed, this->Asked++); }
  double In(double least, double most) { return least + (most - least) * this->Share(); }
  double Normal()
  {
    const double size = std::sqrt(-2.0 * std::log(this->Share()));
    return size * std::cos(glm::two_pi<double>() * this->Share());
  }
  glm::dvec3 Direction()
  {
    const double x = this->Normal(), y = this->Normal(), z = this->Normal();
    return glm::normalize(glm::dvec3(x, y, z));
  }

private:
  std::uint64_t Seed, Asked = 0;
};

} // namespace hasp
