#include "Isosurface/LightCache.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/EvenPoints.h"
#include "Isosurface/LightBlocks.h"
#include "Isosurface/LightView.h"
#include "Isosurface/SharedLight.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

namespace
{

constexpr int TileSide = 16; // pixels

// Samples, as LightMean counts. Measured on a noisy head: more of Few costs rays and brings little.
constexpr float Few = 4.0F; // below this a pixel casts FirstRays
constexpr double FirstRays = 3.0;
constexpr float Coarse = 24.0F; // what the coarser lattice counts for where the finer knows nothing
constexpr float Enough = 256.0F;  // and above this the finer one is alone
constexpr float Settled = 256.0F; // and above this a view that stays casts no more than others
constexpr float Plenty = 4096.0F; // and above this no more rays are cast

void Require(bool condition, const char* what, double value, const char* range)
{
  if (!condition)
    throw std::invalid_argument(
      std::string("LightCache: ") + what + " " + std::to_string(value) + " must be " + range);
}

std::uint8_t ToByte(float share)
{
  return static_cast<std::uint8_t>(255.0F * share + 0.5F);
}

/// Pixel n of a tile in Morton order: pixels that follow each other lie close together, so rays
/// that follow each other share lattice corners and an even sequence covers their hemisphere
/// evenly.
glm::ivec2 InTile(int n)
{
  const auto even = [](int v) { return (v & 1) | (v >> 1 & 2) | (v >> 2 & 4) | (v >> 3 & 8); };
  return { even(n), even(n >> 1) };
}

/// body(pixel) for each of a tile's pixels that met something.
template <typename Body>
void EachHit(const TracedPicture& picture, std::int64_t tile, const Body& body)
{
  const int wide = (picture.size.x + TileSide - 1) / TileSide;
  const glm::ivec2 from = TileSide * glm::ivec2(tile % wide, tile / wide);
  for (int n = 0; n < TileSide * TileSide; ++n)
  {
    const glm::ivec2 at = from + InTile(n);
    if (at.x >= picture.size.x || at.y >= picture.size.y)
      continue;
    const std::size_t pixel = static_cast<std::size_t>(at.y) * picture.size.x + at.x;
    if (picture.cells[pixel] != TracedPicture::Nothing)
      body(pixel);
  }
}

/// body(tile) on all cores.
template <typename Body>
void EachTile(const TracedPicture& picture, const Body& body)
{
  const glm::i64vec2 tiles = (picture.size + TileSide - 1) / TileSide;
  ParallelFor(0, tiles.x * tiles.y, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t tile = first; tile < last; ++tile)
        body(tile);
    });
}

/// A place on the surface and where both lattices keep its light.
struct LitPlace
{
  LightPlace place;
  LightSpot fine, coarse;

  LitPlace() = default;
  LitPlace(const LightBlocks& blocks, LightBlocks::Finder& finder, const LightPlace& found)
    : place(found),
      fine(blocks.Find(finder, found)),
      coarse(blocks.Find(finder, found.Coarser()))
  {
  }

  /// What both say. No samples: nothing is known.
  LightMean Known(const LightBlocks& blocks) const
  {
    const LightMean finer = blocks.Mean(this->fine);
    if (finer.samples >= Enough)
      return finer;
    const LightMean coarser = blocks.Mean(this->coarse);
    if (coarser.samples == 0.0F)
      return finer;
    const float share = Coarse * (1.0F - finer.samples / Enough);
    return { (finer.samples * finer.open + share * coarser.open) / (finer.samples + share),
      std::max(finer.samples, 1e-6F) };
  }
};

} // namespace

/// What the pixels of a tile have to say in a frame. The vectors keep their memory.
struct LightCache::Tile
{
  struct Sample // there may be one a pixel, so it is small: its corners are found again
  {
    LightPlace place;
    std::uint8_t rays, open;
  };
  std::vector<Sample> samples;
  std::vector<std::uint32_t> doubtful; ///< pixels looked up once the frame's rays are added
  std::vector<LightBlocks::Key> missing;
  std::int64_t rays = 0;
  EvenPoints directions{ 0 };
  double due = 0.0; ///< rays, from frame to frame; the whole part is cast

  void Begin(std::uint32_t number, std::uint32_t picture)
  {
    this->samples.clear();
    this->doubtful.clear();
    this->missing.clear();
    this->rays = 0;
    this->directions = EvenPoints(number, picture);
  }
};

/// A call of Light.
struct LightCache::Picture
{
  const LightView& view;
  const CellTracer& tracer;
  const TracedPicture& picture;
  const PictureLightSettings& settings;
  bool stays;                  ///< one of the last two showed the same view
  const SharedLight* otherEye; ///< null: nothing is taken from one
  std::atomic<std::int64_t>& sharedPixels;
};

/// Hits one after the other: many see the light at once, and what is known of the first arrives
/// from memory while the others are looked for.
struct LightCache::Group
{
  static constexpr std::size_t Size = CellTracer::PacketSize;
  std::size_t count = 0, pixels[Size];
  CellHit hits[Size];
  LitPlace places[Size];
};

LightCache::LightCache(const LightCacheSettings& settings) : Settings(settings)
{
  Require(std::has_single_bit(settings.blocks) && settings.blocks >= 64 &&
            settings.blocks <= std::size_t(1) << 24,
    "number of blocks", double(settings.blocks), "a power of two, 64 to 2^24");
  Require(settings.pixelsACorner > 0.0 && std::isfinite(settings.pixelsACorner), "pixels a corner",
    settings.pixelsACorner, "above 0, finite");
  Require(settings.raysAPixel > 0.0 && settings.raysAPixel <= 4.0, "rays a pixel",
    settings.raysAPixel, "above 0, at most 4");
}

LightCache::~LightCache() = default;

void LightCache::Forget()
{
  this->LastViews = {};
  this->FirstEye.reset();
  if (this->Blocks)
    this->Blocks->Forget();
}

void LightCache::Forget(const glm::ivec3& low, const glm::ivec3& high)
{
  this->LastViews = {};
  this->FirstEye.reset();
  if (!this->Blocks)
    return;
  // A sample shapes the cells at both sides of it.
  const double unit = LightView::UnitOf(this->Geometry);
  const glm::dvec3& spacing = this->Geometry.spacing;
  this->Blocks->Forget((glm::dvec3(low - 1) * spacing - this->Distance) / unit,
    (glm::dvec3(high + 1) * spacing + this->Distance) / unit);
}

std::size_t LightCache::SharedBytes() const
{
  return this->FirstEye ? this->FirstEye->Bytes() : 0;
}

std::size_t LightCache::Bytes() const
{
  return this->Blocks ? this->Blocks->Bytes() : 0;
}

/// distance: of ambient occlusion, if that is asked for.
void LightCache::Watch(const ClusteredCells& cells, const std::optional<double>& distance)
{
  if (distance && !this->Blocks)
    this->Blocks = std::make_unique<LightBlocks>(this->Settings.blocks);
  const GridGeometry &now = cells.geometry, &then = this->Geometry;
  const double reach = distance.value_or(this->Distance);
  if (cells.isovalue == this->Isovalue && reach == this->Distance && now.dims == then.dims &&
      now.spacing == then.spacing)
    return;
  this->Forget();
  this->Geometry = now;
  this->Isovalue = cells.isovalue;
  this->Distance = reach;
}

/// The light of a tile's pixels, as far as it is known before the frame's rays are added.
void LightCache::CastRays(const Picture& seen, std::int64_t number, PictureLight& light)
{
  Tile* tile = seen.settings.ambientDistanceMm ? &this->Tiles[number] : nullptr;
  if (tile)
    tile->Begin(static_cast<std::uint32_t>(number), this->Now);
  LightBlocks::Finder finder(this->Blocks.get());
  Group group;
  std::int64_t shared = 0;
  const auto finish = [&]
  {
    if (seen.settings.light && group.count > 0)
    {
      const std::uint32_t sees =
        seen.tracer.Sees({ group.hits, group.count }, *seen.settings.light);
      for (std::size_t n = 0; n < group.count; ++n)
        light[group.pixels[n]].y = sees >> n & 1U ? 255 : 0;
    }
    for (std::size_t n = 0; tile && n < group.count; ++n)
      light[group.pixels[n]].x = ToByte(this->Gather(seen, group, n, *tile, finder));
    group.count = 0;
  };
  EachHit(seen.picture, number,
    [&](std::size_t pixel)
    {
      const CellHit& hit = group.hits[group.count] = seen.view.HitOf(pixel);
      if (seen.otherEye)
        if (const auto same = seen.otherEye->At(hit))
        {
          light[pixel] = *same;
          ++shared;
          return;
        }
      if (tile)
        group.places[group.count] = { *this->Blocks, finder, seen.view.PlaceOf(hit) };
      group.pixels[group.count] = pixel;
      if (++group.count == Group::Size)
        finish();
    });
  finish();
  seen.sharedPixels += shared;
}

/// To be cast for a pixel that knows so many samples.
double LightCache::RaysFor(float samples, bool stays) const
{
  if (samples < Few || (stays && samples < Settled))
    return FirstRays;
  return samples < Plenty ? this->Settings.raysAPixel : 0.0;
}

/// What is known of the openness of a group's hit n, and rays to know more.
float LightCache::Gather(
  const Picture& seen, const Group& group, std::size_t n, Tile& tile, LightBlocks::Finder& finder)
{
  const LitPlace& at = group.places[n];
  const LightMean known = at.Known(*this->Blocks);
  if (known.samples < Few)
    tile.doubtful.push_back(static_cast<std::uint32_t>(group.pixels[n]));
  tile.due += this->RaysFor(known.samples, seen.stays);
  const int rays = static_cast<int>(tile.due);
  tile.due -= rays;
  if (rays == 0)
    return known.open;
  int open = 0;
  for (int ray = 0; ray < rays; ++ray)
    open += seen.tracer.Open(group.hits[n], tile.directions.Next(), this->Distance);
  tile.rays += rays;
  tile.samples.push_back(
    { at.place, static_cast<std::uint8_t>(rays), static_cast<std::uint8_t>(open) });
  if (!at.fine.whole)
    this->Blocks->ListMissing(finder, at.place, tile.missing);
  if (!at.coarse.whole)
    this->Blocks->ListMissing(finder, at.place.Coarser(), tile.missing);
  return known.open;
}

/// Adds a tile's rays to both lattices.
void LightCache::AddRays(const Tile& tile)
{
  LightBlocks::Finder finder(this->Blocks.get());
  for (const Tile::Sample& sample : tile.samples)
  {
    const LitPlace at(*this->Blocks, finder, sample.place);
    this->Blocks->Add(at.fine, sample.rays, sample.open);
    this->Blocks->Add(at.coarse, sample.rays, sample.open);
  }
}

/// The light of the pixels that knew too little before this frame.
void LightCache::Settle(const Picture& seen, const Tile& tile, PictureLight& light)
{
  LightBlocks::Finder finder(this->Blocks.get());
  for (const std::uint32_t pixel : tile.doubtful)
  {
    const CellHit hit = seen.view.HitOf(pixel);
    const LightMean known =
      LitPlace(*this->Blocks, finder, seen.view.PlaceOf(hit)).Known(*this->Blocks);
    // Nothing after all: the table is too small for this picture.
    const float open = known.samples > 0.0F ? known.open
                                            : seen.tracer.AmbientOcclusion(hit,
                                                { static_cast<int>(FirstRays), this->Distance },
                                                pixel + 0x9E3779B9U * this->Now);
    light[pixel].x = ToByte(open);
  }
}

void LightCache::Light(const CellTracer& tracer, const PictureView& view,
  const TracedPicture& picture, const PictureLightSettings& settings, PictureLight& light)
{
  if (picture.size != view.size)
    throw std::invalid_argument("LightCache: a picture of " + std::to_string(picture.size.x) +
                                " x " + std::to_string(picture.size.y) + " pixels for a view of " +
                                std::to_string(view.size.x) + " x " + std::to_string(view.size.y));
  if (settings.light)
  {
    const double length = glm::length(*settings.light);
    Require(length > 0.0 && std::isfinite(length), "length of the light's direction or place",
      length, "above 0, finite");
  }
  if (settings.ambientDistanceMm)
    Require(
      *settings.ambientDistanceMm > 0.0, "distance", *settings.ambientDistanceMm, "above 0 mm");
  light.assign(picture.cells.size(), glm::u8vec2(255));
  this->RayCount = this->SharedPixelCount = 0;
  if (tracer.Cells().clusters.empty())
    return;
  this->Watch(tracer.Cells(), settings.ambientDistanceMm);
  const LightView from(tracer, view, picture, this->Settings.pixelsACorner);
  const bool second =
    settings.eye == LightEye::Second && this->FirstEye && this->FirstEye->IsOf(settings);
  std::atomic<std::int64_t> sharedPixels = 0;
  const Picture seen{ from, tracer, picture, settings,
    view == this->LastViews[0] || view == this->LastViews[1],
    second ? this->FirstEye.get() : nullptr, sharedPixels };
  this->LastViews = { view, std::move(this->LastViews[0]) };
  const auto cast = [&](std::int64_t tile) { this->CastRays(seen, tile, light); };
  if (!settings.ambientDistanceMm)
  {
    EachTile(picture, cast);
    return this->Share(seen, view, light);
  }

  const glm::ivec2 tiles = (view.size + TileSide - 1) / TileSide;
  this->Tiles.resize(static_cast<std::size_t>(tiles.x) * tiles.y);
  ++this->Now;
  this->Blocks->Advance();
  EachTile(picture, cast);
  for (const Tile& tile : this->Tiles) // in order, so that the table is the same with any threads
  {
    this->RayCount += tile.rays;
    for (const LightBlocks::Key key : tile.missing)
      this->Blocks->Make(key);
  }
  EachTile(picture, [&](std::int64_t tile) { this->AddRays(this->Tiles[tile]); });
  EachTile(picture, [&](std::int64_t tile) { this->Settle(seen, this->Tiles[tile], light); });
  this->Share(seen, view, light);
}

/// Keeps what the eye to come may take; nothing where there is one eye.
void LightCache::Share(const Picture& seen, const PictureView& view, const PictureLight& light)
{
  this->SharedPixelCount = seen.sharedPixels;
  if (seen.settings.eye == LightEye::Alone)
    this->FirstEye.reset();
  if (seen.settings.eye != LightEye::First)
    return;
  if (!this->FirstEye)
    this->FirstEye = std::make_unique<SharedLight>();
  this->FirstEye->Keep(view, seen.picture, light, seen.settings);
}

} // namespace hasp
