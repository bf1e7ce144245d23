#include "Isosurface/RaySampler.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{

namespace
{

constexpr int PredictedShare = 4;             // of the rays of an eye
constexpr std::uint32_t ForgottenAfter = 256; // calls

/// A well-mixed number (Wellons 2018, lowbias32).
std::uint32_t Hash(std::uint32_t n)
{
  n = (n ^ n >> 16) * 0x7FEB352DU;
  n = (n ^ n >> 15) * 0x846CA68BU;
  return n ^ n >> 16;
}

/// Point n of the R2 sequence, shifted, in [0,1)^2. In whole numbers, which wrap: no digits are
/// lost however large n is.
glm::dvec2 SpreadPoint(std::uint32_t n, std::uint32_t shift)
{
  constexpr double unit = 1.0 / 4294967296.0;
  return { (3242174889U * n + shift) * unit, (2447445414U * n + Hash(shift)) * unit };
}

/// How many pixels a voxel spans at a place: the widest of the three axes.
class VoxelPixels
{
public:
  explicit VoxelPixels(const PictureView& view) : W(glm::row(view.indexToClip, 3))
  {
    for (int a = 0; a < 3; ++a)
    {
      const glm::dvec2 step = glm::dvec2(view.indexToClip[a]) * 0.5 * glm::dvec2(view.size);
      this->AtW1 = std::max(this->AtW1, glm::length(step));
    }
  }
  float At(const glm::dvec3& place) const
  {
    return static_cast<float>(this->AtW1 / std::abs(glm::dot(this->W, glm::dvec4(place, 1.0))));
  }

private:
  glm::dvec4 W;
  double AtW1 = 0.0;
};

} // namespace

struct RaySampler::Tile
{
  std::vector<SampledHit> hits;
  std::int64_t rays = 0;
  float misses = 0.0F;
};

RaySampler::Tile RaySampler::SampleTile(const RayCaster& caster, const PictureRays& rays,
  const SampledEye& eye, const glm::ivec2& place, int count, const Memory& memory,
  float misses) const
{
  const glm::ivec2 from = place * TileSide, to = glm::min(from + TileSide, eye.view.size);
  const std::uint32_t shift = Hash(std::uint32_t(place.x) | std::uint32_t(place.y) << 16);
  std::vector<glm::ivec2> holes;
  if (!eye.depth.empty())
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x)
        if (eye.depth[std::size_t(y) * eye.view.size.x + x] >= 1.0F)
          holes.emplace_back(x, y);
  // One ray is kept for holes where none found anything: what is there may change. If there is no
  // other, the rest of the tile has its turns, too.
  const int least = count > 1 || memory.frames % 2 == 0 ? std::min(1, count) : 0;
  const int width = to.x - from.x, area = width * (to.y - from.y);
  const int whole = count >= area ? area : 0; // rays through the middles of all pixels
  count -= whole;
  const int intoHoles =
    holes.empty() || count == 0 ? 0 : std::max(least, int(0.5F * count * (1.0F - misses)));

  const VoxelPixels pixels(eye.view);
  Tile tile;
  tile.misses = misses;
  const auto meets = [&](const glm::dvec2& at, bool inHole)
  {
    CellRay ray;
    if (!rays.Of(at, ray))
      return true; // there is none that could miss
    ++tile.rays;
    const auto hit = caster.CastInIndex(ray.origin, ray.direction, ray.tMin, ray.tMax);
    if (hit)
      tile.hits.push_back({ hit->cell, pixels.At(glm::dvec3(hit->cell) + hit->local), inHole });
    return hit.has_value();
  };
  for (int n = 0; n < whole; ++n)
  {
    const glm::ivec2 pixel = from + glm::ivec2(n % width, n / width);
    const std::size_t at = std::size_t(pixel.y) * eye.view.size.x + pixel.x;
    meets(glm::dvec2(pixel) + 0.5, !eye.depth.empty() && eye.depth[at] >= 1.0F);
  }
  int missed = 0;
  for (int n = 0; n < count; ++n)
  {
    const bool aimed = n < intoHoles;
    const std::uint32_t number = memory.cast + std::uint32_t(n);
    const glm::dvec2 spread = glm::dvec2(from) + glm::dvec2(to - from) * SpreadPoint(number, shift);
    const bool met =
      meets(aimed ? glm::dvec2(holes[Hash(number ^ shift) % holes.size()]) + 0.5 : spread, aimed);
    missed += aimed && !met;
  }
  if (intoHoles > 0)
    tile.misses += 0.5F * (float(missed) / float(intoHoles) - tile.misses);
  return tile;
}

void RaySampler::SampleEye(
  const RayCaster& caster, const SampledEye& eye, int count, Memory& memory, Frame& frame) const
{
  const glm::ivec2& size = eye.view.size;
  if (size.x < 0 || size.y < 0 ||
      (!eye.depth.empty() && eye.depth.size() != std::size_t(size.x) * std::size_t(size.y)))
    throw std::invalid_argument("RaySampler: a picture's depth has not its size");
  const PictureRays rays(eye.view);
  const glm::ivec2 tiles = (size + TileSide - 1) / TileSide;
  std::vector<Tile> sampled(std::size_t(tiles.x) * tiles.y);
  std::vector<float>& misses = memory.misses;
  misses.resize(sampled.size());
  ParallelFor(0, std::int64_t(sampled.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        sampled[n] = this->SampleTile(
          caster, rays, eye, glm::ivec2(n % tiles.x, n / tiles.x), count, memory, misses[n]);
    });
  for (std::size_t n = 0; n < sampled.size(); ++n)
  {
    misses[n] = sampled[n].misses;
    frame.rays += sampled[n].rays;
    frame.hits.insert(frame.hits.end(), sampled[n].hits.begin(), sampled[n].hits.end());
  }
  memory.cast += std::uint32_t(count);
  ++memory.frames;
  memory.sampled = this->Now;
}

RaySampler::Frame RaySampler::Sample(const RayCaster& caster, std::span<const SampledEye> eyes,
  std::span<const PictureView> predicted, int count)
{
  Frame frame;
  ++this->Now;
  std::erase_if(this->Eyes,
    [this](const auto& eye) { return this->Now - eye.second.sampled > ForgottenAfter; });
  for (const SampledEye& eye : eyes)
    this->SampleEye(caster, eye, count, this->Eyes[eye.number], frame);
  const int share = (count + PredictedShare - 1) / PredictedShare;
  this->Predictions.resize(std::max(this->Predictions.size(), predicted.size()));
  for (std::size_t n = 0; n < predicted.size(); ++n)
    this->SampleEye(caster, { predicted[n], {}, 0 }, share, this->Predictions[n], frame);
  return frame;
}

} // namespace hasp
