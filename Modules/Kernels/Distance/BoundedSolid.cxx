#include "Distance/BoundedSolid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;

constexpr double BorderShare = 0.125; ///< of a cell
constexpr double Shrink = 1e-6;       ///< of a cell

double Finite(double value)
{
  return std::isnan(value) ? 0.0 : std::clamp(value, -1e30, 1e30);
}
} // namespace

BoundedSolid::BoundedSolid(const ImplicitSolid& solid, const GridGeometry& grid)
  : Solid(solid),
    Grid(grid),
    Smallest(std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z })),
    Scale(1.0 / std::max(solid.Steepness(), 1.0)),
    Low(BorderShare * grid.spacing),
    High((glm::dvec3(grid.Cells()) - BorderShare) * grid.spacing)
{
}

Sample BoundedSolid::Level(Sample sample) const noexcept
{
  sample.value = Finite(this->Scale * sample.value);
  sample.gradient *= this->Scale;
  return sample;
}

Sample BoundedSolid::Border(const glm::dvec3& world) const noexcept
{
  const glm::dvec3 local = (world - this->Grid.origin) * this->Grid.direction;
  Sample most{ -1e30, {}, 0 };
  for (int a = 0; a < 3; ++a)
    for (const bool high : { false, true })
    {
      const double value = high ? local[a] - this->High[a] : this->Low[a] - local[a];
      if (value > most.value)
        most = { value, (high ? 1.0 : -1.0) * this->Grid.direction[a],
          this->Solid.Faces() + 2 * a + high };
    }
  return most;
}

double BoundedSolid::At(const glm::dvec3& world) const noexcept
{
  return std::max(Finite(this->Scale * this->Solid.At(world)), this->Border(world).value) +
         Shrink * this->Smallest;
}

Sample BoundedSolid::SampleAt(const glm::dvec3& world) const noexcept
{
  Sample sample = this->Level(this->Solid.SampleAt(world));
  const Sample border = this->Border(world);
  if (border.value > sample.value)
    sample = border;
  sample.value += Shrink * this->Smallest;
  return sample;
}

Sample BoundedSolid::FaceAt(std::uint32_t face, const glm::dvec3& world) const noexcept
{
  Sample sample{};
  if (face < this->Solid.Faces())
    sample = this->Level(this->Solid.FaceAt(face, world));
  else
  {
    const std::uint32_t side = face - this->Solid.Faces();
    const int a = int(side / 2);
    const double local = glm::dot(world - this->Grid.origin, this->Grid.direction[a]);
    sample = { side % 2 ? local - this->High[a] : this->Low[a] - local,
      (side % 2 ? 1.0 : -1.0) * this->Grid.direction[a], face };
  }
  sample.value += Shrink * this->Smallest;
  return sample;
}

} // namespace hasp
