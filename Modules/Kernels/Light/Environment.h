#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace hasp
{

/// Light of all directions in latitude and longitude: linear radiance, red, green and blue, row by
/// row from the top (up), x fastest. Column and row of a direction: see Environment.
struct EnvironmentMap
{
  glm::ivec2 size{ 0 };
  std::vector<glm::vec3> pixels;
};

struct EnvironmentSample
{
  glm::dvec3 direction; ///< unit, towards the light
  glm::vec3 radiance;   ///< that comes from there
  double density;       ///< of such directions, per steradian
};

/// Light from far away, of all directions: constant in each pixel of a map.
///
/// Which pixel is which direction, as maps of Radiance (.hdr) have it: row 0 touches up, the last
/// row touches down, and rows are even in the angle from up. The centre of the map, x = width / 2,
/// looks forward; from there x grows to the right, as one sees it who stands within and has up
/// above; its two ends meet behind. Right is the world's +x made perpendicular to up, but +y where
/// up is within 26 degrees of the x axis (|up.x| > 0.9); forward is up x right. So with up +z,
/// forward is +y; with up +y, forward is -z. turnRadians turns the map about up, right-handed: what
/// lay forward then lies to the left by so much.
///
/// Sampling is in proportion to the largest of the three channels: a row by the sums of rows, a
/// pixel by the sums in its row, then evenly in the pixel's solid angle. Both steps invert
/// cumulative sums, so even points stay even. The sums are doubles, one for every 16 pixels, and
/// the last 16 pixels are added up while sampling: as exact as sums of doubles for any pixel among
/// any others, at 0.5 bytes a pixel. What is less than 2^-32 of its row is below the resolution of
/// points of 32 bits. Within 2^-17 of a pixel's edge samples are moved to there, so that rounding
/// never makes them the neighbour's.
///
/// Threads: all const functions from any thread.
class Environment
{
public:
  /// A map with all pixels alike is as Uniform. O(pixels), and 10 ms for the irradiance. Throws
  /// std::invalid_argument if the size is not in [1, 16384] x [1, 8192] or has another number of
  /// pixels; if a pixel, or what strength makes of it, is negative or not finite; if up is zero; if
  /// up, the turn or the strength is not finite; if strength is negative.
  explicit Environment(EnvironmentMap map, const glm::dvec3& up = { 0, 0, 1 },
    double turnRadians = 0, float strength = 1);
  /// The same from everywhere: no map, no tables. Throws std::invalid_argument if it is negative or
  /// not finite.
  static Environment Uniform(const glm::vec3& radiance);

  /// Of the pixel that the direction lies in. The direction need not be of unit length.
  glm::vec3 Radiance(const glm::dvec3& direction) const;
  /// Is it worth while to sample its light: is it neither black nor the same everywhere?
  bool Samples() const { return !this->RowSums.empty(); }
  /// point: in the unit square; x chooses the column and y the row. Light that is the same
  /// everywhere is sampled evenly over the sphere; where all is black the density is 0. About
  /// 100 ns; 0.5 us on the largest maps, which no cache holds.
  EnvironmentSample Sample(const glm::dvec2& point) const;
  /// With which Sample finds the direction, per steradian: the largest channel of its radiance over
  /// Total(), 0 where that is black. Who has the radiance already can divide for less.
  double Density(const glm::dvec3& direction) const;
  /// What a surface with that unit normal gets when nothing is in the way: the integral of radiance
  /// times cosine, pi times the radiance where that is uniform. From a table of half as many
  /// normals as 128 x 65, bilinear. Wrong by at most 0.1% of Total() / 4 where light changes
  /// smoothly, 0.5% with edges and unlike pixels; and by 2% of what a single small light gives to a
  /// surface that faces it, beside its terminator. Limited to what a float holds. About 70 ns.
  glm::vec3 Irradiance(const glm::dvec3& unitNormal) const;

  ///@{
  /// Two environments that are this one together: of each pixel what is of at most that radiance
  /// (its largest channel), and what is above it. For who treats small bright lights apart.
  Environment UpTo(double radiance) const;
  Environment Above(double radiance) const;
  ///@}

  double Brightest() const { return this->Greatest; } ///< largest channel of any pixel
  /// The integral over the sphere of the largest channel. No channel of a sample's radiance over
  /// its density is greater.
  double Total() const { return this->Sum; }
  /// Of the map, 12 a pixel, and of the tables, about 0.5 a pixel and 60 kB.
  std::size_t Bytes() const;

private:
  Environment() = default;

  template <typename Share>
  Environment Part(const Share& share) const; ///< share(largest channel): of each pixel
  std::size_t PixelOf(const glm::dvec3& direction) const;
  void SumUp();
  void SumPixels();
  /// Columns of Axes: right, forward, up.
  glm::dvec3 ToMap(const glm::dvec3& direction) const { return direction * this->Axes; }

  EnvironmentMap Map; ///< empty where the light is the same everywhere
  glm::vec3 Same{ 0 };
  glm::dmat3 Axes{ 1 };
  double Greatest = 0.0, Sum = 0.0;
  /// Running sums of the rows, weighed by solid angle, from 0; and of each row's pixels, one after
  /// every block of them.
  std::vector<double> RowSums, BlockSums;
  /// The irradiance of a normal n is its even part, from the table over the upper half of normals,
  /// as a share of Sum, and its odd part, half of n * the vector of each channel.
  std::vector<glm::vec3> EvenIrradiance;
  std::array<glm::dvec3, 3> LightVectors{};
};

} // namespace hasp
