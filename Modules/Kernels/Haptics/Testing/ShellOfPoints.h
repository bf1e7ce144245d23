#pragma once
#include "Haptics/PointArrays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace hasp
{

/// Points as the kernels read them, in the order in which they were added.
class ShellOfPoints
{
public:
  void Add(const glm::dvec3& position, const glm::dvec3& normal)
  {
    this->Points.emplace_back(position, normal);
  }
  std::size_t Count() const { return this->Points.size(); }

  /// Valid until the next call. areas: of each, or one for all.
  ContactPoints Get(float area, const std::vector<float>& areas = {})
  {
    this->Arrays = PointArrays(static_cast<std::uint32_t>(this->Count()), !areas.empty());
    for (std::uint32_t n = 0; n < this->Count(); ++n)
    {
      this->Arrays.Set(n, this->Points[n].first, this->Points[n].second);
      if (!areas.empty())
        this->Arrays[PointArrays::Area][n] = areas[n];
    }
    return this->Arrays.View(0, this->Arrays.Size(), area);
  }

private:
  std::vector<std::pair<glm::vec3, glm::vec3>> Points;
  PointArrays Arrays;
};

/// n points on a ball, each for the same area: z evenly spaced, turned by the golden angle.
inline void AddBall(
  ShellOfPoints& shell, int n, double radius, const glm::dvec3& center = glm::dvec3(0.0))
{
  const double golden = glm::pi<double>() * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / n, across = std::sqrt(1.0 - z * z);
    const glm::dvec3 normal(across * std::cos(golden * i), across * std::sin(golden * i), z);
    shell.Add(center + radius * normal, normal);
  }
}

} // namespace hasp
