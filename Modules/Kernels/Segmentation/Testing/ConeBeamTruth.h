#pragma once
#include "Grid/GridView.h"
#include "Grid/Phantom.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hasp::testing
{

/// A phantom as a CT would have it, without noise, and as a cone-beam scanner has it.
struct ConeBeamCase
{
  PhantomSettings settings;
  GridGeometry geometry;
  std::vector<std::int16_t> truth, grey, quiet; ///< quiet: grey without noise

  ConeBeamCase(const PhantomSettings& coneBeam, const GridGeometry& grid)
    : settings(coneBeam),
      geometry(grid)
  {
    settings.coneBeam.on = true;
    PhantomSettings plain = settings;
    plain.coneBeam.on = false;
    plain.noiseHU = 0.0;
    plain.metal.on = false;
    plain.fieldRadiusMm = 0.0;
    this->truth = SamplePhantom(grid, plain);
    this->grey = SamplePhantom(grid, settings);
    PhantomSettings noiseless = settings;
    noiseless.noiseHU = 0.0;
    this->quiet = SamplePhantom(grid, noiseless);
  }
  AnyGridView View() const
  {
    return GridView<const std::int16_t>{ this->grey.data(), this->geometry };
  }
  double Air() const
  {
    return this->settings.coneBeam.scale * -1000.0 + this->settings.coneBeam.offset;
  }
  bool InField(std::size_t n) const
  {
    const glm::ivec3 at(n % this->geometry.dims.x,
      n / this->geometry.dims.x % this->geometry.dims.y,
      n / this->geometry.dims.x / this->geometry.dims.y);
    const glm::dvec3 off = this->geometry.IndexToWorld(at) - this->settings.center;
    return !(this->settings.fieldRadiusMm > 0.0) ||
           std::hypot(off.x, off.y) <= this->settings.fieldRadiusMm;
  }
};

/// What shading is left, of the samples without noise: the share by which
/// (grey - air) / (HU + 1000) differs from its mean in soft tissue, root mean square.
struct ShadingLeft
{
  double soft = 0.0; ///< where the truth is soft tissue and nothing else
  double bone = 0.0; ///< where the truth is compact bone, diploe or marrow and nothing else
};

/// The gain that made `corrected` of `at.grey` is put to at.quiet.
template <typename T>
ShadingLeft MeasureShading(const ConeBeamCase& at, const std::vector<T>& corrected)
{
  const PhantomSettings& s = at.settings;
  double sum[2] = {}, squares[2] = {}, count[2] = {};
  for (std::size_t n = 0; n < corrected.size(); ++n)
  {
    const double hu = at.truth[n], noisy = at.grey[n] - at.Air();
    const bool soft = hu == s.softHU;
    if (!(soft || hu == s.boneHU || hu == s.diploeHU || hu == s.jawMarrowHU) || !at.InField(n) ||
        noisy < 0.5 * s.coneBeam.scale * (s.softHU + 1000.0)) // noise threw it out of the patient
      continue;
    const double gain = (double(corrected[n]) - at.Air()) / noisy;
    const double ratio = gain * (at.quiet[n] - at.Air()) / (hu + 1000.0);
    sum[!soft] += ratio;
    squares[!soft] += ratio * ratio;
    count[!soft] += 1.0;
  }
  const double mean = sum[0] / count[0];
  const auto rms = [&](int t)
  {
    const double square = squares[t] / count[t] - 2.0 * mean * sum[t] / count[t] + mean * mean;
    return std::sqrt(std::max(square, 0.0)) / mean;
  };
  return { rms(0), rms(1) };
}

/// How well the best single threshold parts bone (truth >= 226 HU) from the rest.
struct BestThreshold
{
  double dice = 0.0, level = 0.0;
};

template <typename T>
BestThreshold FindBestThreshold(const ConeBeamCase& at, const std::vector<T>& grey)
{
  constexpr int bins = 6000;
  constexpr double low = -1000.0, width = 1.0;
  std::vector<double> bone(bins), rest(bins);
  double all = 0.0;
  for (std::size_t n = 0; n < grey.size(); ++n)
  {
    if (!at.InField(n))
      continue;
    const int bin = static_cast<int>(std::clamp((double(grey[n]) - low) / width, 0.0, bins - 1.0));
    const bool is = at.truth[n] >= 226;
    (is ? bone : rest)[bin] += 1.0;
    all += is;
  }
  BestThreshold best;
  double right = 0.0, wrong = 0.0;
  for (int b = bins - 1; b >= 0; --b)
  {
    right += bone[b];
    wrong += rest[b];
    const double dice = 2.0 * right / (right + wrong + all);
    if (dice > best.dice)
      best = { dice, low + b * width };
  }
  return best;
}

} // namespace hasp::testing
