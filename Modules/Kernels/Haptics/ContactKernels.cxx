#include "Haptics/ContactForce.h"

#include "Grid/Stopwatch.h"
#if HASP_WITH_HIGHWAY
#include "Haptics/ContactForceLanes.h"
#endif

#include <algorithm>
#include <limits>

namespace hasp
{
namespace
{

constexpr double TrialMilliseconds = 5.0;

/// A wall in the middle of a small map, and points close to it, half of them behind it.
class Trial
{
public:
  Trial()
  {
    using View = DistanceMapView<std::int16_t>;
    const int blocks = Blocks * Blocks * Blocks;
    this->FirstSample.resize(blocks);
    this->Samples.resize(static_cast<std::size_t>(blocks) * View::BrickSamples);
    for (int b = 0, s = 0; b < blocks; ++b)
    {
      this->FirstSample[b] = s;
      const int low = b / (Blocks * Blocks) * View::Side;
      for (int n = 0; n < View::BrickSamples; ++n)
        this->Samples[s++] =
          static_cast<std::int16_t>(1000 * (std::min(n / View::Slice, View::Side) + low - Wall));
    }
    this->Map.samples = this->Samples.data();
    this->Map.firstSample = this->FirstSample.data();
    this->Map.blocks = glm::ivec3(Blocks);
    this->Map.last = glm::vec3(Blocks * View::Side);
    this->Map.mmPerStep = 1e-3F;
    this->Map.rangeMm = 32.0F;

    std::uint32_t random = 1;
    for (int n = 0; n < Points; ++n)
    {
      random = random * 1664525U + 1013904223U;
      const float share = static_cast<float>(random >> 8) / static_cast<float>(1 << 24);
      this->X[n] = 1.0F + static_cast<float>(n % 64) * 0.45F;
      this->Y[n] = 1.0F + static_cast<float>(n / 64) * 1.8F;
      this->Z[n] = Wall - 0.5F + share;
      this->Down[n] = -1.0F;
    }
    this->Shell = { this->X, this->Y, this->Z, this->None, this->None, this->Down, nullptr, 1.0F,
      Points };
  }

  double Milliseconds(const ContactKernels& kernels) const
  {
    const Stopwatch watch;
    ContactSums sums;
    kernels[ContactTerms::Matrix](this->Shell, {}, this->Map, {}, sums);
    return watch.Milliseconds();
  }

private:
  static constexpr int Blocks = 4, Points = 1024;
  static constexpr float Wall = 16.0F;

  std::vector<std::int16_t> Samples;
  std::vector<std::int32_t> FirstSample;
  alignas(64) float X[Points], Y[Points], Z[Points], None[Points] = {}, Down[Points];
  DistanceMapView<std::int16_t> Map;
  ContactPoints Shell;
};

ContactKernels TakeFastest()
{
  std::vector<ContactKernels> kernels = AllContactKernels();
  const auto trial = std::make_unique<const Trial>();
  std::vector<double> least(kernels.size(), std::numeric_limits<double>::infinity());
  const Stopwatch watch;
  do // in turns, so that a busy moment hits all
    for (std::size_t n = 0; n < kernels.size(); ++n)
      least[n] = std::min(least[n], trial->Milliseconds(kernels[n]));
  while (watch.Milliseconds() < TrialMilliseconds);
  return kernels[std::min_element(least.begin(), least.end()) - least.begin()];
}

} // namespace

std::vector<ContactKernels> AllContactKernels()
{
  std::vector<ContactKernels> kernels = { ScalarContactKernels() };
#if HASP_WITH_HIGHWAY
  const std::vector<ContactKernels> lanes = LanesContactKernels();
  kernels.insert(kernels.end(), lanes.begin(), lanes.end());
#endif
  return kernels;
}

const ContactKernels& FastestContactKernels()
{
  static const ContactKernels fastest = TakeFastest();
  return fastest;
}

} // namespace hasp
