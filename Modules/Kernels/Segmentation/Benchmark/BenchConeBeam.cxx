// Error against time of CorrectConeBeam: shading left in soft tissue and bone, how well the best
// single threshold then parts bone from the rest, and seconds; beside the plain way, division by a
// masked Gaussian blur of all that is the patient. Head phantom with the cone-beam model.
// Usage: BenchKernelConeBeam [voxel size, mm, default 1]
#include "../Testing/ConeBeamTruth.h"
#include "Grid/ParallelFor.h"
#include "Segmentation/ConeBeam.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace
{

using hasp::testing::ConeBeamCase;

constexpr double InsideAbove = -100.0;

/// Of all threads of this process: machines are shared.
double CpuSeconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// Three running means along each axis: within 3 % of a Gaussian, and O(1) a voxel.
void Blur(const hasp::GridGeometry& grid, double sigmaMm, std::vector<float>& values)
{
  const std::int64_t steps[3] = { 1, grid.dims.x, std::int64_t(grid.dims.x) * grid.dims.y };
  for (int a = 0; a < 3; ++a)
  {
    const int size = grid.dims[a], other = grid.dims[a == 0 ? 1 : 0];
    const std::int64_t otherStep = steps[a == 0 ? 1 : 0], third = a == 2 ? 1 : 2;
    const int reach = static_cast<int>(
      std::round(0.5 * (std::sqrt(4.0 * std::pow(sigmaMm / grid.spacing[a], 2.0) + 1.0) - 1.0)));
    hasp::ParallelFor(0, std::int64_t(other) * grid.dims[third], 64,
      [&](std::int64_t first, std::int64_t last)
      {
        std::vector<double> sums(size + 1);
        for (std::int64_t n = first; n < last; ++n)
        {
          float* line = &values[n % other * otherStep + n / other * steps[third]];
          for (int pass = 0; pass < 3; ++pass)
          {
            for (int i = 0; i < size; ++i)
              sums[i + 1] = sums[i] + line[i * steps[a]];
            for (int i = 0; i < size; ++i)
              line[i * steps[a]] =
                float((sums[std::min(i + reach, size - 1) + 1] - sums[std::max(i - reach, 0)]) /
                      (2 * reach + 1));
          }
        }
      });
  }
}

/// The rival, told what ours has to find out: the level of air.
std::vector<float> DivideByBlur(const ConeBeamCase& at, double sigmaMm)
{
  std::vector<float> values(at.grey.size()), weights(at.grey.size());
  for (std::size_t n = 0; n < values.size(); ++n)
    if (at.grey[n] > InsideAbove)
    {
      values[n] = float(at.grey[n] - at.Air());
      weights[n] = 1.0F;
    }
  std::vector<float> corrected = values;
  Blur(at.geometry, sigmaMm, values);
  Blur(at.geometry, sigmaMm, weights);
  const float typical = float(at.settings.coneBeam.scale * (at.settings.softHU + 1000.0));
  for (std::size_t n = 0; n < corrected.size(); ++n)
    corrected[n] = at.grey[n] > InsideAbove
                     ? float(at.Air()) + corrected[n] * typical * weights[n] / values[n]
                     : float(at.grey[n]);
  return corrected;
}

template <typename T>
void Print(const char* what, const ConeBeamCase& at, const std::vector<T>& grey, double seconds)
{
  const hasp::testing::ShadingLeft left = hasp::testing::MeasureShading(at, grey);
  const hasp::testing::BestThreshold best = hasp::testing::FindBestThreshold(at, grey);
  std::printf("  %-32s soft %6.3f %%  bone %6.3f %%  Dice %.4f at %6.0f  %7.3f s CPU\n", what,
    100.0 * left.soft, 100.0 * left.bone, best.dice, best.level, seconds);
}

/// What the phantom's model has not: grey above soft tissue's is nearer to it, most at one height.
void FlattenContrast(const ConeBeamCase& at, std::vector<std::int16_t>& grey)
{
  const hasp::ConeBeamModel& model = at.settings.coneBeam;
  const std::size_t slice = std::size_t(at.geometry.dims.x) * at.geometry.dims.y;
  for (std::size_t n = 0; n < grey.size(); ++n)
  {
    const glm::ivec3 index(
      n % at.geometry.dims.x, n / at.geometry.dims.x % at.geometry.dims.y, n / slice);
    const glm::dvec3 off = at.geometry.IndexToWorld(index) - at.settings.center;
    const double out = std::min(std::hypot(off.x, off.y) / model.cupRadiusMm, 1.0);
    const double soft =
      model.scale * (at.settings.softHU + 1000.0) * (1.0 - model.cupping * (1.0 - out * out)) +
      at.Air();
    const double share = 1.0 - 0.5 * std::exp(-0.5 * std::pow((off.z + 60.0) / 25.0, 2.0));
    if (grey[n] > soft)
      grey[n] = std::int16_t(std::round(soft + share * (grey[n] - soft)));
  }
}

void Compare(const char* name, const ConeBeamCase& at)
{
  std::printf(
    "%s, %d x %d x %d\n", name, at.geometry.dims.x, at.geometry.dims.y, at.geometry.dims.z);
  hasp::PhantomSettings even = at.settings;
  even.coneBeam.cupping = 0.0;
  const auto most =
    hasp::testing::FindBestThreshold(at, hasp::SamplePhantom(at.geometry, even)); // same noise
  std::printf(
    "  %-61s Dice %.4f at %6.0f\n", "no cupping: what noise leaves", most.dice, most.level);
  Print("as it is", at, at.grey, 0.0);
  std::vector<float> corrected(at.grey.size());
  for (const double contrastMm : { 0.0, 10.0, 25.0 })
    for (const double fieldMm : { 30.0, 60.0, 120.0 })
    {
      if (contrastMm > 0.0 && fieldMm != 60.0)
        continue;
      const double start = CpuSeconds();
      hasp::CorrectConeBeam(at.View(),
        { .fieldMm = fieldMm, .contrastMm = contrastMm, .insideAbove = InsideAbove },
        { corrected.data(), at.geometry });
      const double seconds = CpuSeconds() - start;
      char what[64];
      std::snprintf(what, sizeof what, "ours, field %g mm, contrast %g mm", fieldMm, contrastMm);
      Print(what, at, corrected, seconds);
    }
  for (const double sigmaMm : { 15.0, 30.0, 60.0 })
  {
    const double start = CpuSeconds();
    const std::vector<float> divided = DivideByBlur(at, sigmaMm);
    const double seconds = CpuSeconds() - start;
    char what[64];
    std::snprintf(what, sizeof what, "masked Gaussian, sigma %g mm", sigmaMm);
    Print(what, at, divided, seconds);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const double mm = argc > 1 ? std::atof(argv[1]) : 1.0;
  if (!(mm >= 0.2 && mm <= 5.0))
  {
    std::fprintf(stderr, "voxel size: 0.2 to 5 mm\n");
    return 1;
  }
  hasp::PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.4);
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(mm), settings);
  Compare("head, no noise", { settings, grid });
  settings.noiseHU = 40.0;
  Compare("head, noise 40", { settings, grid });
  settings.coneBeam.cupping = 0.25;
  settings.noiseHU = 80.0;
  Compare("head, cupping 0.25, noise 80", { settings, grid });
  settings.coneBeam.cupping = 0.12;
  settings.noiseHU = 40.0;
  settings.metal.on = true;
  Compare("head, metal, noise 40", { settings, grid });
  settings.metal.on = false;
  settings.fieldRadiusMm = 60.0;
  Compare("head, field of view cut at 60 mm, noise 40", { settings, grid });
  settings.fieldRadiusMm = 0.0;
  ConeBeamCase flat(settings, grid);
  FlattenContrast(flat, flat.grey);
  FlattenContrast(flat, flat.quiet);
  Compare("head, half of bone's contrast lost at the jaws, noise 40", flat);
  return 0;
}
