#include "Studies/FractureCaseMaker.h"
#include "Studies/SeededShare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Some places of what is named, in the order of memory.
std::vector<glm::dvec3> PlacesOf(
  const GridGeometry& grid, std::span<const std::uint8_t> named, std::size_t most)
{
  const auto count = static_cast<std::size_t>(
    std::count_if(named.begin(), named.end(), [](std::uint8_t value) { return value != 0; }));
  const std::size_t each = std::max<std::size_t>(1, count / most);
  std::vector<glm::dvec3> places;
  std::size_t seen = 0;
  for (std::size_t v = 0; v < named.size(); ++v)
    if (named[v] != 0 && seen++ % each == 0)
    {
      const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
      places.push_back(grid.IndexToWorld(glm::dvec3(v % row, v % slice / row, v / slice)));
    }
  return places;
}

/// Where pieces are: of 64 drawn places the one farthest from the others, with much bone around.
class PlaceChooser
{
public:
  PlaceChooser(const std::vector<glm::dvec3>& places, double radius, std::uint64_t seed)
    : Places(places),
      Radius(radius),
      Seed(seed)
  {
  }
  glm::dvec3 Next(const std::vector<glm::dvec3>& chosen)
  {
    glm::dvec3 best = this->Places[0];
    double most = -1.0;
    for (int trial = 0; trial < 64; ++trial)
    {
      const double share = SeededShare(this->Seed + 13, this->Drawn++);
      const glm::dvec3& place = this->Places[std::size_t(share * double(this->Places.size()))];
      double apart = 3.0 * this->Radius;
      for (const glm::dvec3& other : chosen)
        apart = std::min(apart, glm::distance(place, other));
      const double worth = apart * std::sqrt(this->Around(place));
      if (worth > most)
      {
        most = worth;
        best = place;
      }
    }
    return best;
  }

private:
  double Around(const glm::dvec3& place) const
  {
    return double(std::count_if(this->Places.begin(), this->Places.end(),
      [&](const glm::dvec3& other) { return glm::distance(place, other) < this->Radius; }));
  }

  const std::vector<glm::dvec3>& Places;
  double Radius;
  std::uint64_t Seed, Drawn = 0;
};

/// A patch: four faces around the way out of the bone, and one towards its middle.
FracturePiece Patch(
  const glm::dvec3& place, const glm::dvec3& middle, double radius, std::uint64_t seed, int number)
{
  std::uint64_t drawn = 0;
  const auto share = [&] { return SeededShare(seed + 29, 1000 * std::uint64_t(number) + drawn++); };
  glm::dvec3 out = place - middle;
  out = glm::length(out) > 1e-6 ? glm::normalize(out) : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 any = std::abs(out.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(out, any)), v = glm::cross(out, u);
  const double turn = 1.57 * share();
  FracturePiece piece{ "piece " + std::to_string(number + 1), 0, {}, {} };
  const auto add = [&](const glm::dvec3& point, const glm::dvec3& outward)
  {
    FractureFace face;
    face.point = point;
    face.outward = glm::normalize(outward);
    face.seed = 1000 * seed + 10 * std::uint64_t(number) + piece.faces.size();
    piece.faces.push_back(face);
  };
  for (int side = 0; side < 4; ++side)
  {
    const double angle = turn + 1.5707963267948966 * side + 0.5 * (share() - 0.5);
    const glm::dvec3 way = std::cos(angle) * u + std::sin(angle) * v;
    add(place + radius * (0.75 + 0.25 * share()) * way, way + 0.4 * (share() - 0.5) * out);
  }
  add(place - radius * out, -out + 0.2 * (share() - 0.5) * u);
  return piece;
}

} // namespace

FractureSettings ScatteredPieces(
  const GridGeometry& geometry, std::span<const std::uint8_t> named, int count, std::uint64_t seed)
{
  if (count < 1 || count > 20)
    throw std::invalid_argument(
      "scattered pieces: count is " + std::to_string(count) + ", must be in [1, 20]");
  if (named.size() != geometry.Size())
    throw std::invalid_argument("scattered pieces: named must have one value a voxel");
  const std::vector<glm::dvec3> places = PlacesOf(geometry, named, 8000);
  if (places.empty())
    throw std::invalid_argument("scattered pieces: nothing is named, must hold one voxel at least");
  glm::dvec3 low(1e300), high(-1e300), middle(0.0);
  for (const glm::dvec3& place : places)
  {
    low = glm::min(low, place);
    high = glm::max(high, place);
    middle += place / double(places.size());
  }
  const double radius = std::clamp(0.075 * glm::distance(low, high), 4.0, 30.0);
  FractureSettings settings;
  settings.scanner.seed = seed;
  settings.scanner.blurMm = glm::dvec3(0.5);
  settings.axis = 0.5 * (low + high);
  PlaceChooser chooser(places, radius, seed);
  std::vector<glm::dvec3> chosen;
  for (int n = 0; n < count; ++n)
  {
    chosen.push_back(chooser.Next(chosen));
    settings.pieces.push_back(Patch(chosen.back(), middle, radius, seed, n));
  }
  return settings;
}

} // namespace hasp
