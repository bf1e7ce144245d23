// Errors of the distance transforms, in voxels: over 27 sub-voxel centres and random orientations;
// of what lies 0, 2 and 5 voxels outside; and of scans. Not a test. Usage:
// BenchKernelDistanceErrors
#include "Distance/AntiAliasedEuclidean.h"
#include "Distance/ChamferDistance.h"
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Testing/AnalyticCoverage.h"

#include <cstdio>
#include <functional>
#include <random>
#include <string>

namespace
{

using Field = std::vector<float>;

struct Family
{
  std::string name;
  int samples; ///< per axis
  std::function<hasp::AnalyticVolume(const glm::dvec3& center, const glm::dvec3& axis)> make;
};

hasp::AnalyticVolume Capsule(
  const glm::dvec3& center, const glm::dvec3& axis, double half, double radius)
{
  return { "capsule",
    [=](const glm::dvec3& p)
    {
      const double t = glm::clamp(glm::dot(p - center, axis), -half, half);
      return radius - glm::distance(p, center + t * axis);
    },
    1 };
}

const Family Families[] = {
  { "sphere R 12.3", 44,
    [](const glm::dvec3& c, const glm::dvec3&) { return hasp::AnalyticSphere(c, 12.3); } },
  { "torus 26/12", 92,
    [](const glm::dvec3& c, const glm::dvec3& a) { return hasp::AnalyticTorus(c, a, 26, 12); } },
  { "capsule 12/12", 64,
    [](const glm::dvec3& c, const glm::dvec3& a) { return Capsule(c, a, 12, 12); } },
};

/// Sums of squares over many fields.
struct Sum
{
  double squares = 0, most = 0;
  std::size_t count = 0;

  void Add(double error)
  {
    this->squares += error * error;
    this->most = std::max(this->most, std::abs(error));
    ++this->count;
  }
  double Rms() const { return std::sqrt(this->squares / double(this->count)); }
};

hasp::GridGeometry Cube(int n)
{
  return { glm::ivec3(n), glm::dvec3(-0.5 * (n - 1)), glm::dvec3(1), glm::dmat3(1) };
}

/// Calls use(shape, coverage) for 27 centres, a third of a voxel apart, each turned another way.
template <typename F>
void ForCentres(const Family& family, F&& use)
{
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  for (int n = 0; n < 27; ++n)
  {
    const glm::dvec3 center = glm::dvec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1) / 3.0 + 0.05;
    const double x = any(random), y = any(random), z = any(random);
    const auto shape = family.make(center, glm::normalize(glm::dvec3(x, y, z)));
    use(shape, hasp::AnalyticCoverage(shape, Cube(family.samples)));
  }
}

void AddWithin(const Field& distance, const hasp::AnalyticVolume& shape,
  const hasp::GridGeometry& grid, double within, Sum& sum)
{
  const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
  for (std::size_t v = 0; v < distance.size(); ++v)
  {
    const double truth =
      -shape.value(grid.IndexToWorld(glm::dvec3(v % row, v / row % grid.dims.y, v / slice)));
    if (std::abs(truth) <= within)
      sum.Add(distance[v] - truth);
  }
}

/// Where the field crosses `offset` along grid lines, by linear interpolation: how far that is from
/// where the offset surface is.
void AddContour(const Field& distance, const hasp::AnalyticVolume& shape,
  const hasp::GridGeometry& grid, double offset, Sum& sum)
{
  const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
  for (std::size_t v = 0; v < distance.size(); ++v)
  {
    const glm::ivec3 p(v % row, v / row % grid.dims.y, v / slice);
    const std::size_t strides[] = { 1, row, slice };
    for (int a = 0; a < 3; ++a)
    {
      if (p[a] + 1 >= grid.dims[a])
        continue;
      const double low = distance[v] - offset, high = distance[v + strides[a]] - offset;
      if ((low < 0) == (high < 0))
        continue;
      glm::dvec3 at(p);
      at[a] += low / (low - high);
      sum.Add(-shape.value(grid.IndexToWorld(at)) - offset);
    }
  }
}

/// Coverage as it is made of a mask or a scan: 4^3 samples of a voxel, inside or not. Shares below
/// those of one sample are none: exact coverage has voxels that the surface hardly touches, and
/// <3,4,5> takes half a voxel for all of them.
Field SampledCoverage(const hasp::AnalyticVolume& shape, const hasp::GridGeometry& grid)
{
  Field coverage = hasp::AnalyticCoverage(shape, grid);
  for (std::size_t v = 0; v < coverage.size(); ++v)
  {
    if (coverage[v] == 0.0F || coverage[v] == 1.0F)
      continue;
    const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
    const glm::dvec3 p(v % row, v / row % grid.dims.y, v / slice);
    int inside = 0;
    for (int s = 0; s < 64; ++s)
      inside += shape.value(grid.IndexToWorld(
                  p + (glm::dvec3(s % 4, s / 4 % 4, s / 16) + 0.5) / 4.0 - 0.5)) > 0.0;
    coverage[v] = static_cast<float>(inside) / 64.0F;
  }
  return coverage;
}

void ReportBand()
{
  std::printf(
    "guides' transform within 3 voxels, 27 centres\n%-16s %9s %9s\n", "shape", "rms", "max");
  for (const Family& family : Families)
  {
    Sum sum;
    const auto grid = Cube(family.samples);
    ForCentres(family, [&](const auto& shape, const Field& coverage)
      { AddWithin(hasp::CoverageDistanceBand(grid, coverage), shape, grid, 3, sum); });
    std::printf("%-16s %9.4f %9.4f\n", family.name.c_str(), sum.Rms(), sum.most);
  }
}

void ReportOffsets()
{
  std::printf("\ncontours of coverage by 4^3 samples, rms off the surface, 27 centres\n%-16s %7s "
              "%10s %10s %8s %10s %10s\n",
    "shape", "offset", "<3,4,5> aa", "binary", "ratio", "euclid aa", "guides'");
  for (const Family& family : Families)
  {
    const double offsets[] = { 0, 2, 5 };
    Sum sums[3][4];
    const auto grid = Cube(family.samples);
    ForCentres(family,
      [&](const auto& shape, const Field&)
      {
        const Field coverage = SampledCoverage(shape, grid);
        Field binary(coverage);
        for (float& c : binary)
          c = c >= 0.5F ? 1.0F : 0.0F;
        const Field fields[] = { hasp::ChamferDistance(grid, coverage),
          hasp::ChamferDistance(grid, binary), hasp::AntiAliasedEuclideanDistance(grid, coverage),
          hasp::CoverageDistance(grid, coverage) };
        for (int o = 0; o < 3; ++o)
          for (int f = 0; f < 4; ++f)
            AddContour(fields[f], shape, grid, offsets[o], sums[o][f]);
      });
    for (int o = 0; o < 3; ++o)
      std::printf("%-16s %7.0f %10.4f %10.4f %8.3f %10.4f %10.4f\n", family.name.c_str(),
        offsets[o], sums[o][0].Rms(), sums[o][1].Rms(), sums[o][0].Rms() / sums[o][1].Rms(),
        sums[o][2].Rms(), sums[o][3].Rms());
  }
}

/// What a scanner makes of coverage: blurred along each axis by sigma voxels, and noisy.
Field Scanned(Field image, int n, double sigma, double noise)
{
  for (std::size_t stride = 1; stride < image.size(); stride *= n)
  {
    Field blurred(image.size(), 0.0F);
    for (std::size_t v = 0; v < image.size(); ++v)
    {
      double sum = 0, weights = 0;
      for (int d = -4; d <= 4; ++d)
        if (const int at = int(v / stride % n) + d; at >= 0 && at < n)
        {
          const double w = std::exp(-0.5 * d * d / (sigma * sigma));
          weights += w;
          sum += w * image[v + d * std::ptrdiff_t(stride)];
        }
      blurred[v] = static_cast<float>(sum / weights);
    }
    image.swap(blurred);
  }
  std::mt19937 random(11);
  std::normal_distribution<double> any(0, noise);
  for (float& v : image)
    v += static_cast<float>(noise > 0 ? any(random) : 0.0);
  return image;
}

void ReportScans()
{
  std::printf(
    "\nscans, a blur of 0.8 voxel, within 3 voxels: rms, max; the blur alone draws a sphere "
    "in by 0.64 / R\n%-16s %6s %17s %17s %17s %17s\n",
    "shape", "noise", "<3,4,5> aa", "euclid aa", "guides', coverage", "guides', grey");
  const glm::dvec3 off(0.31, -0.22, 0.43);
  const hasp::AnalyticVolume shapes[] = { hasp::AnalyticSphere(off, 40.3),
    hasp::AnalyticSphere(off, 80.3),
    hasp::AnalyticTorus(off, glm::normalize(glm::dvec3(1, 2, 2)), 40, 16) };
  const char* names[] = { "sphere R 40.3", "sphere R 80.3", "torus 40/16" };
  const int samples[] = { 96, 176, 128 };
  for (int s = 0; s < 3; ++s)
    for (const double noise : { 0.0, 0.03 })
    {
      const int n = samples[s];
      const auto grid = Cube(n);
      const Field scan = Scanned(hasp::AnalyticCoverage(shapes[s], grid), n, 0.8, noise);
      const hasp::GridView<const float> image{ scan.data(), grid };
      hasp::CoverageSettings settings;
      settings.isovalue = 0.5;
      settings.samplesPerAxis = 6;
      const Field coverage = hasp::Coverage(image, grid, settings);
      std::printf("%-16s %5.0f%%", names[s], 100 * noise);
      for (const Field& field :
        { hasp::ChamferDistance(grid, coverage), hasp::AntiAliasedEuclideanDistance(grid, coverage),
          hasp::CoverageDistanceBand(grid, coverage), hasp::GreyDistance(image, 0.5) })
      {
        const auto e = hasp::ErrorOf(field, shapes[s], grid, 3);
        std::printf("  %7.4f %7.4f", e.rms, e.most);
      }
      std::printf("\n");
    }
}

} // namespace

int main()
{
  ReportBand();
  ReportOffsets();
  ReportScans();
}
