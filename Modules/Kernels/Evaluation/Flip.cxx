#include "Evaluation/Flip.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

// Names of constants are the paper's.
constexpr double ColorExponent = 0.7; // q_c
constexpr double Cut = 0.4;           // p_c, a share of the largest colour difference
constexpr double CutValue = 0.95;     // p_t, what it is mapped to
constexpr double EdgeWidth = 0.082;   // w, degrees
constexpr double EdgeExponent = 0.5;  // q_f

/// Contrast sensitivity is sums of a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (Table 1):
/// achromatic; red-green; blue-yellow, which is two.
struct Sensitivity
{
  double a, b;
};
constexpr Sensitivity Channels[4] = { { 1.0, 0.0047 }, { 1.0, 0.0053 }, { 34.1, 0.04 },
  { 13.5, 0.025 } };

/// Linear sRGB to CIE XYZ. glm's matrices are columns.
const glm::dmat3 ToXyz = glm::transpose(glm::dmat3(10135552.0 / 24577794, 8788810.0 / 24577794,
  4435075.0 / 24577794, 2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
  1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
const glm::dmat3 FromXyz = glm::inverse(ToXyz);
const glm::dvec3 White = ToXyz * glm::dvec3(1.0);

double Linear(double s)
{
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// A linear opponent space: lightness, red-green, blue-yellow.
glm::dvec3 Opponent(const glm::dvec3& f)
{
  return { 116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z) };
}
glm::dvec3 YCxCzOf(const glm::dvec3& srgb)
{
  return Opponent(ToXyz * glm::dvec3(Linear(srgb.x), Linear(srgb.y), Linear(srgb.z)) / White);
}
glm::dvec3 RgbOf(const glm::dvec3& c)
{
  const double y = (c.x + 16.0) / 116.0;
  return FromXyz * (glm::dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * White);
}

/// CIELab of linear sRGB, the colour weaker where it is dark (Hunt effect).
glm::dvec3 HuntLab(const glm::dvec3& rgb)
{
  glm::dvec3 f = ToXyz * rgb / White;
  constexpr double delta = 6.0 / 29.0;
  for (int n = 0; n < 3; ++n)
    f[n] =
      f[n] > delta * delta * delta ? std::cbrt(f[n]) : f[n] / (3.0 * delta * delta) + 4.0 / 29.0;
  const glm::dvec3 lab = Opponent(f);
  return { lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z };
}

double ColorDistance(const glm::dvec3& a, const glm::dvec3& b) // HyAB, Eq. 4
{
  return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), ColorExponent);
}

using Filter = std::vector<double>; // 2 r + 1 weights
using Plane = std::vector<float>;

/// The two directions one after the other; beyond the border its pixel goes on.
Plane Filtered(const Plane& in, int width, const Filter& alongX, const Filter& alongY)
{
  const int height = int(in.size()) / width, r = int(alongX.size()) / 2;
  Plane half(in.size()), out(in.size());
  const auto pass = [&](const Plane& from, Plane& to, const Filter& filter, bool vertical)
  {
    const int last = vertical ? height - 1 : width - 1;
    ParallelFor(0, height, 8,
      [&](std::int64_t first, std::int64_t end)
      {
        for (auto y = int(first); y < end; ++y)
          for (int x = 0; x < width; ++x)
          {
            double sum = 0.0;
            for (int k = -r; k <= r; ++k)
            {
              const int at = std::clamp((vertical ? y : x) + k, 0, last);
              sum += filter[k + r] *
                     from[vertical ? std::size_t(at) * width + x : std::size_t(y) * width + at];
            }
            to[std::size_t(y) * width + x] = float(sum);
          }
      });
  };
  pass(in, half, alongX, false);
  pass(half, out, alongY, true);
  return out;
}

struct Filters
{
  Filter channel[4];           ///< of Channels, each of sum 1
  double weight[2];            ///< of the two of blue-yellow, of sum 1
  Filter smooth, slope, curve; ///< a Gaussian and its derivatives

  explicit Filters(double pixelsPerDegree);
};

Filters::Filters(double pixelsPerDegree)
{
  constexpr double pi2 = glm::pi<double>() * glm::pi<double>();
  const int r = int(std::ceil(3.0 * std::sqrt(Channels[2].b / (2.0 * pi2)) * pixelsPerDegree));
  double volume[4];
  for (int c = 0; c < 4; ++c)
  {
    const auto [a, b] = Channels[c];
    double sum = 0.0;
    for (int k = -r; k <= r; ++k)
    {
      this->channel[c].push_back(std::exp(-pi2 * k * k / (pixelsPerDegree * pixelsPerDegree) / b));
      sum += this->channel[c].back();
    }
    for (double& w : this->channel[c])
      w /= sum;
    volume[c] = a * std::sqrt(glm::pi<double>() / b) * sum * sum;
  }
  for (int n = 0; n < 2; ++n)
    this->weight[n] = volume[2 + n] / (volume[2] + volume[3]);

  const double sigma = 0.5 * EdgeWidth * pixelsPerDegree;
  const int reach = int(std::ceil(3.0 * sigma));
  for (int k = -reach; k <= reach; ++k)
  {
    const double g = std::exp(-0.5 * k * k / (sigma * sigma));
    this->smooth.push_back(g);
    this->slope.push_back(-k * g);
    this->curve.push_back((k * k / (sigma * sigma) - 1.0) * g);
  }
  // What is positive adds up to 1, what is negative to -1.
  for (Filter* filter : { &this->smooth, &this->slope, &this->curve })
  {
    double positive = 0.0, negative = 0.0;
    for (const double w : *filter)
      (w > 0.0 ? positive : negative) += std::abs(w);
    for (double& w : *filter)
      w /= w > 0.0 ? positive : std::max(negative, 1e-300); // no 0 / 0 at the middle of a slope
  }
}

/// A picture as it is seen: the colour of each pixel, and its edges and points in [0,1].
struct Seen
{
  std::vector<glm::vec3> lab;
  std::vector<glm::vec2> features;

  Seen(std::span<const glm::vec3> picture, int width, const Filters& filters);
};

Seen::Seen(std::span<const glm::vec3> picture, int width, const Filters& filters)
  : lab(picture.size()),
    features(picture.size())
{
  Plane planes[4], light(picture.size());
  for (Plane& plane : planes)
    plane.resize(picture.size());
  const auto each = [&](const auto& body)
  {
    ParallelFor(0, std::int64_t(picture.size()), 4096,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
          body(std::size_t(n));
      });
  };
  each(
    [&](std::size_t n)
    {
      const glm::dvec3 c = YCxCzOf(glm::dvec3(picture[n]));
      planes[0][n] = float(c.x);
      planes[1][n] = float(c.y);
      planes[2][n] = planes[3][n] = float(c.z);
      light[n] = float((c.x + 16.0) / 116.0);
    });
  for (int c = 0; c < 4; ++c)
    planes[c] = Filtered(planes[c], width, filters.channel[c], filters.channel[c]);
  const Plane dx = Filtered(light, width, filters.slope, filters.smooth);
  const Plane dy = Filtered(light, width, filters.smooth, filters.slope);
  const Plane ddx = Filtered(light, width, filters.curve, filters.smooth);
  const Plane ddy = Filtered(light, width, filters.smooth, filters.curve);
  each(
    [&](std::size_t n)
    {
      const glm::dvec3 blurred(planes[0][n], planes[1][n],
        filters.weight[0] * planes[2][n] + filters.weight[1] * planes[3][n]);
      this->lab[n] = glm::vec3(HuntLab(glm::clamp(RgbOf(blurred), 0.0, 1.0)));
      this->features[n] = { std::hypot(dx[n], dy[n]), std::hypot(ddx[n], ddy[n]) };
    });
}

void Check(std::span<const glm::vec3> reference, std::span<const glm::vec3> test, int width,
  const FlipSettings& settings)
{
  if (reference.size() != test.size() || reference.empty() || width < 1 ||
      reference.size() % std::size_t(width) != 0)
    throw std::invalid_argument("FLIP: pictures of " + std::to_string(reference.size()) + " and " +
                                std::to_string(test.size()) + " pixels in rows of " +
                                std::to_string(width) + "; give two of the same whole rows");
  if (!(settings.pixelsPerDegree >= 1.0 && settings.pixelsPerDegree <= 1000.0))
    throw std::invalid_argument(
      "FLIP: " + std::to_string(settings.pixelsPerDegree) + " pixels a degree; give 1 to 1000");
  for (const auto& picture : { reference, test })
    for (const glm::vec3& pixel : picture)
      for (int c = 0; c < 3; ++c)
        if (!(pixel[c] >= 0.0F && pixel[c] <= 1.0F))
          throw std::invalid_argument(
            "FLIP: a value of " + std::to_string(pixel[c]) + "; give sRGB in [0,1]");
}

} // namespace

std::vector<float> Flip(std::span<const glm::vec3> reference, std::span<const glm::vec3> test,
  int width, const FlipSettings& settings)
{
  Check(reference, test, width, settings);
  const Filters filters(settings.pixelsPerDegree);
  const Seen a(reference, width, filters), b(test, width, filters);
  const double most = ColorDistance(HuntLab({ 0, 1, 0 }), HuntLab({ 0, 0, 1 }));
  std::vector<float> flip(reference.size());
  for (std::size_t n = 0; n < flip.size(); ++n)
  {
    const double distance = ColorDistance(glm::dvec3(a.lab[n]), glm::dvec3(b.lab[n])) / most;
    const double color = distance < Cut
                           ? CutValue / Cut * distance
                           : CutValue + (distance - Cut) / (1.0 - Cut) * (1.0 - CutValue);
    const glm::vec2 features = glm::abs(a.features[n] - b.features[n]);
    const double feature =
      std::pow(std::max(features.x, features.y) / glm::root_two<double>(), EdgeExponent);
    flip[n] = float(std::pow(color, 1.0 - feature)); // Eq. 9
  }
  return flip;
}

} // namespace hasp
