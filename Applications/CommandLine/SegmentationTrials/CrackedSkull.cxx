#include "CrackedSkull.h"

#include "Grid/ParallelFor.h"
#include "Grid/Phantom.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double BoneHU = 226.0;

/// mm from the nearer of two wavy cracks, which part left from right and front from back.
double CrackDistance(const glm::dvec3& p)
{
  const double wave = 0.8 * std::sin(p.y * 0.4) * std::sin(p.z * 0.35);
  const double a = p.x - 3.0 - wave;
  const double b = p.y + 20.0 - 0.3 * p.z - 0.8 * std::sin(p.x * 0.3);
  return std::min(std::abs(a), std::abs(b));
}

} // namespace

CrackedSkull::CrackedSkull(double spacingMm)
{
  PhantomSettings settings;
  settings.noiseHU = 40.0;
  settings.blurMm = glm::dvec3(0.5);
  this->geometry = PhantomGrid(glm::dvec3(spacingMm), settings);
  this->samples = SamplePhantom(this->geometry, settings);
  const glm::ivec3 dims = this->geometry.dims;
  ParallelFor(0, std::int64_t(dims.y) * dims.z, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        for (int i = 0; i < dims.x; ++i)
          if (std::int16_t& sample = this->samples[row * dims.x + i]; sample > 0)
          {
            const double mm =
              CrackDistance(this->geometry.IndexToWorld(glm::dvec3(i, row % dims.y, row / dims.y)));
            sample = static_cast<std::int16_t>(sample * (1.0 - 0.8 * std::exp(-mm * mm / 0.3)));
          }
    });
  this->bone.resize(this->samples.size());
  ThresholdLabels(this->Samples(), BoneHU, 1e6, { this->bone.data(), this->geometry });
  const struct
  {
    Label label;
    glm::dvec3 direction;
  } places[] = { { 2, { 1, 0.8, 0.5 } }, { 3, { -1, 0.8, 0.5 } }, { 4, { 1, -1, 0.5 } },
    { 5, { -1, -0.9, 0.5 } }, { 2, { 0.3, 1, 0.2 } }, { 3, { -0.3, 1, 0.6 } },
    { 4, { 0.4, -0.6, 0.9 } } };
  for (const auto& [label, direction] : places)
  {
    const glm::dvec3 middle = PhantomOuterTable(settings, direction);
    this->strokes.push_back({ label, RasterizeStroke(this->geometry, std::vector{ middle }, 3.0) });
  }
}

} // namespace hasp
