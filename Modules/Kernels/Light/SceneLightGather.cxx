// What the pixels of a picture say of their light, tile by tile.
#include "Isosurface/Hemisphere.h"
#include "Light/LampLight.h"
#include "Light/SceneLightParts.h"

#include <cmath>

namespace hasp
{

namespace
{

using Kind = SceneLightRequest::Kind;

// Samples, as ColorMean counts.
constexpr float Few = 3.0F; // below this a pixel casts FirstPaths
constexpr double FirstPaths = 2.0;
constexpr float Settled = 256.0F;   // of its own, and then a pixel at rest casts no more
constexpr double RestPaths = 4.0;   // that it casts until then
constexpr float FewAtRest = 24.0F;  // below this what the picture itself adds is waited for
constexpr float KeptAtRest = 24.0F; // what lattices know counts for beside a pixel's own samples
constexpr float Plenty = 2048.0F;   // and above this no more paths are cast

std::uint32_t SeedOf(std::size_t pixel)
{
  return HashOf(static_cast<std::uint32_t>(pixel) ^ 0x3C6EF372U);
}

/// At rest what a pixel found by itself counts more and more: it is not blurred.
glm::vec3 WithOwn(const ColorMean& kept, const glm::vec4& own)
{
  const float share = kept.samples > 0.0F ? KeptAtRest : 0.0F;
  return share + own.a > 0.0F ? (share * kept.color + glm::vec3(own)) / (share + own.a)
                              : kept.color;
}

/// Pixel n of a tile in Morton order: as LightCache's.
glm::ivec2 InTile(int n)
{
  const auto even = [](int v) { return (v & 1) | (v >> 1 & 2) | (v >> 2 & 4) | (v >> 3 & 8); };
  return { even(n), even(n >> 1) };
}

} // namespace

std::optional<LitHit> SceneLightCache::Picture::HitOf(std::size_t pixel) const
{
  const glm::dvec2 centre(double(pixel % std::size_t(this->view.size.x)) + 0.5,
    double(pixel / std::size_t(this->view.size.x)) + 0.5);
  CellRay ray;
  const std::span<const float> depths = this->drawn.depths;
  if ((!depths.empty() && !(depths[pixel] < 1.0F)) || !this->rays.Of(centre, ray))
    return std::nullopt;
  const double length = glm::length(ray.direction);
  double from = ray.tMin * length, to = ray.tMax * length;
  const glm::dvec3 direction = ray.direction / length;
  if (!depths.empty())
  {
    const auto placeOf = [&](const glm::dvec2& at, double depth)
    {
      const glm::dvec2 device = 2.0 * at / glm::dvec2(this->view.size) - 1.0;
      const glm::dvec4 place = this->rays.GetToIndex() * glm::dvec4(device, 2.0 * depth - 1.0, 1.0);
      return glm::dvec3(place) / place.w;
    };
    // Depth buffers have 24 bits; drawing and rays agree to some thousandths of a voxel.
    constexpr double Step = 4.0 / 16777216.0;
    const double depth = depths[pixel];
    const glm::dvec3 place = placeOf(centre, depth);
    const double at = glm::dot(place - ray.origin, direction);
    double around = std::max(glm::distance(placeOf(centre, std::min(1.0, depth + Step)), place),
                      glm::distance(placeOf(centre, std::max(0.0, depth - Step)), place)) +
                    1e-5 * this->scene.Bounds().Size();
    if (this->drawn.slackPixels > 0.0)
      around += this->drawn.slackPixels *
                glm::distance(placeOf(centre + glm::dvec2(1.0, 0.0), depth), place);
    from = std::max(from, at - around);
    to = std::min(to, at + around);
  }
  return this->scene.Trace(ray.origin, direction, from, to);
}

glm::vec3 SceneLightCache::Picture::Share(
  const LitHit& hit, SobolSequence& points, Tile& tile) const
{
  if (this->Traced())
  {
    const PathSample sample = this->paths.WhiteRadiance(hit, points, &this->soft);
    tile.rays += sample.rays;
    return sample.radiance / this->Reference(hit.shading);
  }
  ++tile.rays;
  const glm::dvec3 direction = CosineAround(hit.normal, points.Next());
  return glm::vec3(
    this->scene.OccludedFrom(hit, direction, this->request.distanceMm) ? 0.0F : 1.0F);
}

glm::vec3 SceneLightCache::Picture::White(
  const LitHit& hit, SobolSequence& points, Tile& tile) const
{
  if (!this->bright)
    return glm::vec3(0.0F);
  const EnvironmentSample sample = this->bright->Sample(points.Next());
  const double cosine = glm::dot(sample.direction, hit.shading);
  if (!(sample.density > 0.0 && cosine > 0.0 && glm::dot(sample.direction, hit.normal) > 0.0))
    return glm::vec3(0.0F);
  ++tile.rays;
  if (this->scene.OccludedFrom(hit, sample.direction))
    return glm::vec3(0.0F);
  return glm::vec3(glm::dvec3(sample.radiance) * (cosine / (sample.density * glm::pi<double>())));
}

glm::vec3 SceneLightCache::Picture::Lamps(const LitHit& hit, Tile& tile) const
{
  static const SurfaceScattering white({ glm::vec3(1.0F) });
  const SurfaceScattering::At at(white, glm::vec3(1.0F), hit.shading, hit.shading);
  glm::vec3 light(0.0F);
  for (const LitLamp& lamp : this->scene.Lamps())
    light += LampRadiance(this->scene, lamp, hit, at, this->request.shadows, tile.rays);
  return light;
}

/// What a pixel's own rays say of it: direct light of the environment's bright parts, and gloss.
glm::vec3 SceneLightCache::PixelsOwn(const Picture& seen, const LitHit& hit,
  const glm::dvec3& towardsEye, std::size_t pixel, Tile& tile, LightBlockFinder& finder)
{
  const SurfaceScattering::At at(
    seen.scene.Scattering(hit.body), hit.albedo, hit.shading, towardsEye);
  SobolSequence points(HashOf(static_cast<std::uint32_t>(pixel)),
    this->OwnNumber + static_cast<std::uint32_t>(this->OwnSums[pixel].a));
  glm::vec3 light(0.0F);
  if (seen.bright)
    light += at.BodyAlbedo() * seen.White(hit, points, tile);
  if (seen.reflects && !seen.scene.Scattering(hit.body).Diffuse())
    light += this->Gloss(seen, hit, at, points, tile, finder);
  return light;
}

/// The coat's or metal's own light: one ray towards the environment's bright places and one along
/// the lobe, weighted against each other.
glm::vec3 SceneLightCache::Gloss(const Picture& seen, const LitHit& hit,
  const SurfaceScattering::At& at, SobolSequence& points, Tile& tile, LightBlockFinder& finder)
{
  const Environment& far = seen.scene.Surroundings();
  glm::vec3 light(0.0F);
  if (far.Samples())
  {
    const EnvironmentSample sample = far.Sample(points.Next());
    const ScatterSample gloss = at.Gloss(sample.direction);
    if (sample.density > 0.0 && glm::dot(sample.direction, hit.normal) > 0.0 && gloss.density > 0.0)
    {
      ++tile.rays;
      if (!seen.scene.OccludedFrom(hit, sample.direction))
        light += gloss.weight * glm::vec3(glm::dvec3(sample.radiance) *
                                          (gloss.density / (gloss.density + sample.density)));
    }
  }
  const ScatterSample gloss = at.SampleGloss(points.Next());
  if (!(gloss.density > 0.0) || !(glm::dot(gloss.direction, hit.normal) > 0.0))
    return light;
  ++tile.rays;
  if (const auto met = seen.scene.TraceFrom(hit, gloss.direction))
  {
    if (!seen.Traced() || seen.request.paths.bounces < 2) // a reflection is a second surface
      return light;
    const LightPlace place = seen.places.At(met->position, met->normal);
    const ColorMean known = Known(*this->Blocks, finder, place).Mean(*this->Blocks);
    glm::vec3 white(0.0F);
    if (known.samples > 0.0F)
      white = known.color * seen.Reference(met->shading) + seen.White(*met, points, tile);
    else // out of sight, so nobody keeps its light
    {
      const PathSample sample = seen.paths.WhiteRadiance(*met, points);
      tile.rays += sample.rays;
      white = sample.radiance;
    }
    return light + gloss.weight * met->albedo * (white + seen.Lamps(*met, tile));
  }
  const double weight =
    far.Samples() ? gloss.density / (gloss.density + far.Density(gloss.direction)) : 1.0;
  return light + gloss.weight * far.Radiance(gloss.direction) * static_cast<float>(weight);
}

/// A hit's light, as far as it is known before the frame's paths are added, and paths to know more.
void SceneLightCache::Gather(const Picture& seen, const LitHit& hit, std::size_t pixel, Tile& tile,
  LightBlockFinder& finder, LitPicture& picture)
{
  const Kind kind = seen.request.kind;
  if (kind == Kind::Coverage)
  {
    picture[pixel] = { 0.0F, 0.0F, 0.0F, 1.0F };
    return;
  }
  const glm::dvec3 towardsEye = seen.TowardsEye(hit);
  const SurfaceScattering& material = seen.scene.Scattering(hit.body);
  const SurfaceScattering::At at(material, hit.albedo, hit.shading, towardsEye);
  glm::vec3 lamps(0.0F);
  for (const LitLamp& lamp : seen.scene.Lamps())
    lamps += LampRadiance(seen.scene, lamp, hit, at, seen.request.shadows, tile.rays);
  glm::vec3 base = seen.scene.Bodies()[hit.body].glow;
  if (kind != Kind::AmbientOcclusion)
    base += lamps;
  if (!this->OwnSums.empty())
  {
    glm::vec4& sum = this->OwnSums[pixel];
    sum += glm::vec4(this->PixelsOwn(seen, hit, towardsEye, pixel, tile, finder), 1.0F);
    base += glm::vec3(sum) / sum.w;
  }
  const glm::vec3 body = at.BodyAlbedo();
  picture[pixel] = glm::vec4(base, 1.0F);
  if (kind == Kind::Lamps)
  {
    picture[pixel] += glm::vec4(body * seen.Open(hit.shading), 0.0F);
    return;
  }
  const glm::vec3 factor = kind == Kind::Traced ? body * seen.Reference(hit.shading)
                                                : lamps + body * seen.Open(hit.shading);
  const LightPlace place = seen.places.At(hit.position, hit.normal);
  const Known known(*this->Blocks, finder, place);
  const ColorMean mean = known.Mean(*this->Blocks);
  tile.unknown += mean.samples == 0.0F;
  glm::vec4* own = this->OwnShares.empty() ? nullptr : &this->OwnShares[pixel];
  if (own)
    tile.due = own->a < Settled ? RestPaths : 0.0;
  else
    tile.due += mean.samples < Few      ? FirstPaths
                : mean.samples < Plenty ? this->Settings.pathsAPixel
                                        : 0.0;
  const int paths = static_cast<int>(tile.due);
  tile.due -= paths;
  for (int n = 0; n < paths; ++n)
  {
    SobolSequence points = own ? SobolSequence(SeedOf(pixel), static_cast<std::uint32_t>(own->a))
                               : SobolSequence(tile.seed, tile.points++);
    const glm::vec3 share = seen.Share(hit, points, tile);
    tile.samples.push_back({ place, share });
    if (own)
      *own += glm::vec4(share, 1.0F);
  }
  if (paths > 0 && !known.fine.whole)
    this->Blocks->ListMissing(finder, place, tile.missing);
  if (paths > 0 && !known.coarse.whole)
    this->Blocks->ListMissing(finder, place.Coarser(), tile.missing);
  if (mean.samples < (own ? FewAtRest : Few))
    tile.doubtful.push_back({ place, factor, static_cast<std::uint32_t>(pixel) });
  else
    picture[pixel] += glm::vec4(factor * (own ? WithOwn(mean, *own) : mean.color), 0.0F);
}

void SceneLightCache::CastPaths(const Picture& seen, std::int64_t number, LitPicture& picture)
{
  Tile& tile = this->Tiles[number];
  tile.Begin(static_cast<std::uint32_t>(number));
  LightBlockFinder finder(this->Blocks.get());
  const glm::ivec2& size = seen.view.size;
  const int wide = (size.x + Tile::Side - 1) / Tile::Side;
  const glm::ivec2 from = Tile::Side * glm::ivec2(number % wide, number / wide);
  for (int n = 0; n < Tile::Side * Tile::Side; ++n)
  {
    const glm::ivec2 at = from + InTile(n);
    if (at.x >= size.x || at.y >= size.y)
      continue;
    const std::size_t pixel = std::size_t(at.y) * size.x + at.x;
    if (const auto hit = seen.HitOf(pixel))
      this->Gather(seen, *hit, pixel, tile, finder, picture);
  }
}

/// Adds a tile's paths to both lattices.
void SceneLightCache::AddPaths(const Picture& seen, const Tile& tile)
{
  LightBlockFinder finder(this->Blocks.get());
  std::uint32_t random = HashOf(tile.seed ^ this->Now);
  for (const Tile::Sample& sample : tile.samples)
  {
    const Known at(*this->Blocks, finder, sample.place);
    random = HashOf(random + 1);
    const float round =
      seen.Traced() ? static_cast<float>(random >> 8U) / 16777216.0F : 0.0F; // 0 and 1 are whole
    this->Blocks->AddColor(at.fine, sample.share, round);
    this->Blocks->AddColor(at.coarse, sample.share, round);
  }
}

/// The light of the pixels that knew too little before this frame.
void SceneLightCache::Settle(const Picture& seen, Tile& tile, LitPicture& picture)
{
  LightBlockFinder finder(this->Blocks.get());
  for (const Tile::Doubtful& one : tile.doubtful)
  {
    ColorMean mean = Known(*this->Blocks, finder, one.place).Mean(*this->Blocks);
    if (mean.samples == 0.0F) // the table is too small for this picture: a path of its own
      if (const auto hit = seen.HitOf(one.pixel))
      {
        SobolSequence points(tile.seed, tile.points++);
        mean.color = seen.Share(*hit, points, tile);
      }
    if (!this->OwnShares.empty())
      mean.color = WithOwn(mean, this->OwnShares[one.pixel]);
    picture[one.pixel] += glm::vec4(one.factor * mean.color, 0.0F);
  }
}

} // namespace hasp
