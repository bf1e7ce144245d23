#include "Light/SkyModel.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Pi = std::numbers::pi;
const glm::dvec3 Luminance(0.2126, 0.7152, 0.0722);
const glm::dvec3 SunWavelengths(0.610, 0.550, 0.465); // micrometres

void Require(bool within, const std::string& name, double value, const std::string& range)
{
  if (!within)
    throw std::invalid_argument(
      "sky: " + name + " is " + std::to_string(value) + "; it lies in " + range);
}

void RequireSettings(const SkySettings& s, int height)
{
  // Not a number compares false.
  Require(s.sunElevation >= 0 && s.sunElevation <= Pi / 2, "the elevation of the sun",
    s.sunElevation, "[0, pi/2] radians");
  Require(std::isfinite(s.sunAzimuth), "the azimuth of the sun", s.sunAzimuth, "finite radians");
  Require(s.turbidity >= 2 && s.turbidity <= 10, "turbidity", s.turbidity, "[2, 10]");
  for (int c = 0; c < 3; ++c)
    Require(s.ground[c] >= 0 && s.ground[c] <= 1, "a channel of the ground", s.ground[c], "[0, 1]");
  Require(s.sunShare >= 0 && s.sunShare <= 1, "the share of the sun", s.sunShare, "[0, 1]");
  Require(s.sunHalfAngle >= 0.002 && s.sunHalfAngle <= 0.5, "the half angle of the sun",
    s.sunHalfAngle, "[0.002, 0.5] radians");
  Require(height >= 16 && height <= 8192 && height % 2 == 0, "the height of the map", height,
    "[16, 8192] and is even");
}

/// Perez' five parameters of a sky of the turbidity, for one of x, y and Y.
struct Perez
{
  double a, b, c, d, e;

  /// cosine: of the angle from the zenith, > 0; angle: from the sun.
  double operator()(double cosine, double angle) const
  {
    const double towards = std::cos(angle);
    return (1 + this->a * std::exp(this->b / cosine)) *
           (1 + this->c * std::exp(this->d * angle) + this->e * towards * towards);
  }
};

/// The model of the paper's appendix A.2. Its luminance is that over the zenith's.
class Sky
{
public:
  Sky(double turbidity, double sunFromZenith)
    : X(Linear(turbidity, { -0.0193, -0.0665, -0.0004, -0.0641, -0.0033 },
        { -0.2592, 0.0008, 0.2125, -0.8989, 0.0452 })),
      Y(Linear(turbidity, { -0.0167, -0.0950, -0.0079, -0.0441, -0.0109 },
        { -0.2608, 0.0092, 0.2102, -1.6537, 0.0529 })),
      Brightness(Linear(turbidity, { 0.1787, -0.3554, -0.0227, 0.1206, -0.0670 },
        { -1.4630, 0.4275, 5.3251, -2.5771, 0.3703 }))
  {
    const double s = sunFromZenith, t = turbidity;
    const double x = (((0.00166 * s - 0.00375) * s + 0.00209) * s) * t * t +
                     (((-0.02903 * s + 0.06377) * s - 0.03202) * s + 0.00394) * t +
                     (((0.11693 * s - 0.21196) * s + 0.06052) * s + 0.25886);
    const double y = (((0.00275 * s - 0.00610) * s + 0.00317) * s) * t * t +
                     (((-0.04214 * s + 0.08970) * s - 0.04153) * s + 0.00516) * t +
                     (((0.15346 * s - 0.26756) * s + 0.06670) * s + 0.26688);
    this->Zenith = { x / this->X(1, s), y / this->Y(1, s), 1 / this->Brightness(1, s) };
  }
  /// Linear sRGB, not negative.
  glm::dvec3 Colour(double cosine, double angle) const
  {
    const double x = this->Zenith.x * this->X(cosine, angle);
    const double y = this->Zenith.y * this->Y(cosine, angle);
    const double luminance = this->Zenith.z * this->Brightness(cosine, angle);
    const glm::dvec3 xyz(x, y, std::max(0.0, 1 - x - y));
    const glm::dmat3 toRgb(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259,
      -0.4985314, 0.0415560, 1.0572252);
    return glm::max(toRgb * (xyz * (luminance / y)), 0.0);
  }

private:
  static Perez Linear(double turbidity, const Perez& slope, const Perez& at0)
  {
    return { slope.a * turbidity + at0.a, slope.b * turbidity + at0.b, slope.c * turbidity + at0.c,
      slope.d * turbidity + at0.d, slope.e * turbidity + at0.e };
  }

  Perez X, Y, Brightness;
  glm::dvec3 Zenith;
};

/// The paper's appendix A.1, of luminance 1: what the air leaves of white at its wavelengths.
glm::dvec3 SunColour(double turbidity, double sunFromZenith)
{
  const double degrees = sunFromZenith * 180 / Pi;
  const double airMass =
    1 / (std::max(0.0, std::cos(sunFromZenith)) + 0.15 * std::pow(93.885 - degrees, -1.253));
  const double aerosol = 0.04608 * turbidity - 0.04586;
  const glm::dvec3 depth = 0.008735 * glm::pow(SunWavelengths, glm::dvec3(-4.08)) +
                           aerosol * glm::pow(SunWavelengths, glm::dvec3(-1.3));
  const glm::dvec3 left = glm::exp(-depth * airMass);
  return left / glm::dot(left, Luminance);
}

/// Angles and weights of a map's pixels.
struct Grid
{
  int height;

  int Rows() const { return this->height / 2; } // above the horizon
  int Columns() const { return 2 * this->height; }
  double Size() const { return Pi / this->height; }
  double Azimuth(double column) const { return this->Size() * column - Pi; }
  /// What a pixel of radiance 1 gives to a plane that faces up: the integral over it of the cosine.
  double Irradiance(int row) const
  {
    return std::sin((2 * row + 1) * this->Size()) * std::sin(this->Size()) / 2 * this->Size();
  }
};

glm::dvec3 Direction(double azimuth, double cosine)
{
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return { std::sin(azimuth) * sine, std::cos(azimuth) * sine, cosine };
}

/// The angle between unit vectors, which the arc cosine has not where it is small.
double AngleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return 2 * std::asin(std::min(1.0, glm::length(a - b) / 2));
}

/// Rows of the upper half; the luminance of their irradiance is as asked.
std::vector<glm::vec3> DrawSky(
  const Grid& grid, const SkySettings& settings, const glm::dvec3& sun, double irradiance)
{
  const Sky sky(settings.turbidity, Pi / 2 - settings.sunElevation);
  std::vector<glm::vec3> pixels;
  pixels.reserve(std::size_t(2) * grid.height * grid.height); // for the ground, too
  double sum = 0.0;
  for (int row = 0; row < grid.Rows(); ++row)
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const double cosine = std::cos(grid.Size() * (row + 0.5));
      const glm::dvec3 towards = Direction(grid.Azimuth(column + 0.5), cosine);
      const glm::dvec3 colour = sky.Colour(cosine, AngleBetween(towards, sun));
      sum += glm::dot(colour, Luminance) * grid.Irradiance(row);
      pixels.emplace_back(colour);
    }
  for (glm::vec3& pixel : pixels)
    pixel *= irradiance / sum;
  return pixels;
}

/// The part of a pixel that the disc covers, from points a quarter of its half angle apart. They
/// are even in the angle from up: even in solid angle, the first would miss a small disc at the
/// zenith.
double Covered(const Grid& grid, int column, int row, const glm::dvec3& sun, double halfAngle)
{
  const double size = grid.Size(), apart = halfAngle / 4, chord = 2 * std::sin(halfAngle / 2);
  const double widest = std::sin(size * (row + 1));
  const int down = std::max(4, static_cast<int>(std::ceil(size / apart)));
  const int across = std::max(4, static_cast<int>(std::ceil(size * widest / apart)));
  double inside = 0.0, all = 0.0;
  for (int j = 0; j < down; ++j)
  {
    const double fromUp = size * (row + (j + 0.5) / down), weight = std::sin(fromUp);
    for (int i = 0; i < across; ++i)
    {
      const auto point = Direction(grid.Azimuth(column + (i + 0.5) / across), std::cos(fromUp));
      inside += glm::length(point - sun) < chord ? weight : 0.0;
      all += weight;
    }
  }
  return inside / all;
}

struct SunPixel
{
  int column, row;
  double covered;
};

/// The pixels of the upper half that the disc covers in part or in whole.
std::vector<SunPixel> SunPixels(
  const Grid& grid, const SkySettings& settings, const glm::dvec3& sun)
{
  const double size = grid.Size(), halfAngle = settings.sunHalfAngle;
  std::vector<SunPixel> pixels;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    // A pixel's corners are less than its size from its middle.
    if (std::abs((row + 0.5) * size - (Pi / 2 - settings.sunElevation)) > halfAngle + size)
      continue;
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const double cosine = std::cos(size * (row + 0.5));
      const double angle = AngleBetween(Direction(grid.Azimuth(column + 0.5), cosine), sun);
      if (angle > halfAngle + size)
        continue;
      const double covered =
        angle < halfAngle - size ? 1.0 : Covered(grid, column, row, sun, halfAngle);
      if (covered > 0)
        pixels.push_back({ column, row, covered });
    }
  }
  return pixels;
}

} // namespace

EnvironmentMap MakeSky(const SkySettings& settings, int height)
{
  RequireSettings(settings, height);
  const Grid grid{ height };
  const glm::dvec3 sun = Direction(settings.sunAzimuth, std::sin(settings.sunElevation));
  EnvironmentMap map{ { 2 * height, height },
    DrawSky(grid, settings, sun, Pi * (1 - settings.sunShare)) };

  const auto sunPixels = SunPixels(grid, settings, sun);
  double sum = 0.0;
  for (const SunPixel& pixel : sunPixels)
    sum += pixel.covered * grid.Irradiance(pixel.row);
  const glm::dvec3 brightness =
    SunColour(settings.turbidity, Pi / 2 - settings.sunElevation) * (Pi * settings.sunShare / sum);
  for (const SunPixel& pixel : sunPixels)
    map.pixels[std::size_t(pixel.row) * grid.Columns() + pixel.column] +=
      brightness * pixel.covered;

  glm::dvec3 irradiance(0);
  for (std::size_t i = 0; i < map.pixels.size(); ++i)
    irradiance += glm::dvec3(map.pixels[i]) * grid.Irradiance(static_cast<int>(i / grid.Columns()));
  map.pixels.resize(
    std::size_t(2) * height * height, glm::dvec3(settings.ground) * irradiance / Pi);
  return map;
}

} // namespace hasp
