#include "Isosurface/LightCache.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/EvenPoints.h"
#include "Isosurface/LightBlocks.h"
#include "Isosurface/LightView.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr int TileSide = 16; // pixels

// Samples, as LightMean counts. Measured on a noisy head: more of either costs rays and brings
// little.
constexpr float Few = 5.0F; // below this a pixel casts FirstRays
constexpr double FirstRays = 3.0;
constexpr float Coarse = 8.0F;  // what the coarser lattice counts for where the finer knows nothing
constexpr float Enough = 16.0F; // and above this the finer one is alone
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

/// What both lattices say of a place. No samples: nothing is known.
LightMean Known(const LightBlocks& blocks, LightBlocks::Finder& finder, const LightPlace& place)
{
  const LightMean fine = blocks.Mean(finder, place);
  if (fine.samples >= Enough)
    return fine;
  const LightMean coarse = blocks.Mean(finder, place.Coarser());
  if (coarse.samples == 0.0F)
    return fine;
  const float share = Coarse * (1.0F - fine.samples / Enough);
  return { (fine.samples * fine.open + share * coarse.open) / (fine.samples + share),
    std::max(fine.samples, 1e-6F) };
}

/// Hits one after the other, of which many see the light at once.
class Shadows
{
public:
  Shadows(const CellTracer& tracer, const std::optional<glm::dvec4>& from, PictureLight& pixels)
    : Tracer(tracer),
      From(from),
      Pixels(pixels)
  {
  }
  void Add(const CellHit& hit, std::size_t pixel)
  {
    if (!this->From)
      return;
    this->Hits[this->Count] = hit;
    this->Places[this->Count++] = pixel;
    if (this->Count == CellTracer::PacketSize)
      this->Finish();
  }
  void Finish()
  {
    if (this->Count == 0)
      return;
    const std::uint32_t seen = this->Tracer.Sees({ this->Hits, this->Count }, *this->From);
    for (std::size_t n = 0; n < this->Count; ++n)
      this->Pixels[this->Places[n]].y = seen >> n & 1U ? 255 : 0;
    this->Count = 0;
  }

private:
  const CellTracer& Tracer;
  const std::optional<glm::dvec4>& From;
  PictureLight& Pixels;
  CellHit Hits[CellTracer::PacketSize];
  std::size_t Places[CellTracer::PacketSize], Count = 0;
};

} // namespace

struct LightCache::TileHit
{
  std::size_t pixel;
  CellHit hit;
  LightPlace place;
};

/// What the pixels of a tile have to say in a frame. The vectors keep their memory.
struct LightCache::Tile
{
  struct Sample
  {
    LightPlace place;
    int rays, open;
  };
  struct Doubtful
  {
    std::size_t pixel;
    LightPlace place;
  };
  std::vector<TileHit> hits;
  std::vector<Sample> samples;
  std::vector<Doubtful> doubtful; ///< whose light is looked up once the frame's rays are added
  std::vector<LightBlocks::Key> missing;
  std::int64_t rays = 0;
  /// Both go on from frame to frame: what a place gathers is even over its hemisphere.
  std::optional<EvenPoints> directions;
  double due = 0.0; ///< rays; the whole part is cast

  void Begin(std::uint32_t number)
  {
    this->hits.clear();
    this->samples.clear();
    this->doubtful.clear();
    this->missing.clear();
    this->rays = 0;
    if (!this->directions)
      this->directions.emplace(number);
  }
};

/// A call of Light.
struct LightCache::Picture
{
  const LightView& view;
  const CellTracer& tracer;
  const TracedPicture& picture;
  const PictureLightSettings& settings;
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
  if (this->Blocks)
    this->Blocks->Forget();
}

void LightCache::Forget(const glm::ivec3& low, const glm::ivec3& high)
{
  if (!this->Blocks)
    return;
  // A sample shapes the cells at both sides of it.
  const double unit = LightView::UnitOf(this->Geometry);
  const glm::dvec3& spacing = this->Geometry.spacing;
  this->Blocks->Forget((glm::dvec3(low - 1) * spacing - this->Distance) / unit,
    (glm::dvec3(high + 1) * spacing + this->Distance) / unit);
}

std::size_t LightCache::Bytes() const
{
  return this->Blocks ? this->Blocks->Bytes() : 0;
}

void LightCache::Watch(const ClusteredCells& cells, double distance)
{
  if (!this->Blocks)
    this->Blocks = std::make_unique<LightBlocks>(this->Settings.blocks);
  const GridGeometry &now = cells.geometry, &then = this->Geometry;
  if (cells.isovalue == this->Isovalue && distance == this->Distance && now.dims == then.dims &&
      now.spacing == then.spacing)
    return;
  this->Forget();
  this->Geometry = now;
  this->Isovalue = cells.isovalue;
  this->Distance = distance;
}

/// The light of a tile's pixels, as far as it is known before the frame's rays are added.
void LightCache::CastRays(const Picture& seen, std::int64_t number, PictureLight& light)
{
  const PictureLightSettings& settings = seen.settings;
  Tile* tile = settings.ambientDistanceMm ? &this->Tiles[number] : nullptr;
  if (tile)
    tile->Begin(static_cast<std::uint32_t>(number));
  LightBlocks::Finder finder(this->Blocks.get());
  Shadows shadows(seen.tracer, settings.light, light);
  EachHit(seen.picture, number,
    [&](std::size_t pixel)
    {
      const CellHit hit = seen.view.HitOf(pixel);
      shadows.Add(hit, pixel);
      if (!tile)
        return;
      const LightPlace place = seen.view.PlaceOf(hit);
      this->Blocks->Expect(finder, place);
      this->Blocks->Expect(finder, place.Coarser());
      tile->hits.push_back({ pixel, hit, place });
    });
  shadows.Finish();
  if (tile)
    for (const TileHit& hit : tile->hits)
      light[hit.pixel].x = ToByte(this->Gather(seen, hit, *tile, finder));
}

/// What is known of a hit's openness, and rays to know more.
float LightCache::Gather(
  const Picture& seen, const TileHit& hit, Tile& tile, LightBlocks::Finder& finder)
{
  const auto& [pixel, found, place] = hit;
  const LightMean known = Known(*this->Blocks, finder, place);
  if (known.samples < Few)
    tile.doubtful.push_back({ pixel, place });
  tile.due += known.samples < Few      ? FirstRays
              : known.samples < Plenty ? this->Settings.raysAPixel
                                       : 0.0;
  const int rays = static_cast<int>(tile.due);
  tile.due -= rays;
  if (rays == 0)
    return known.open;
  int open = 0;
  for (int n = 0; n < rays; ++n)
    open += seen.tracer.Open(found, tile.directions->Next(), this->Distance);
  tile.rays += rays;
  tile.samples.push_back({ place, rays, open });
  this->Blocks->ListMissing(finder, place, tile.missing);
  this->Blocks->ListMissing(finder, place.Coarser(), tile.missing);
  return known.open;
}

/// The light of the pixels that knew too little before this frame.
void LightCache::Settle(const Picture& seen, const Tile& tile, PictureLight& light)
{
  LightBlocks::Finder finder(this->Blocks.get());
  for (const Tile::Doubtful& one : tile.doubtful)
  {
    const LightMean known = Known(*this->Blocks, finder, one.place);
    // Nothing after all: the table is too small for this picture.
    const float open = known.samples > 0.0F
                         ? known.open
                         : seen.tracer.AmbientOcclusion(seen.view.HitOf(one.pixel),
                             { static_cast<int>(FirstRays), this->Distance },
                             static_cast<std::uint32_t>(one.pixel) + 0x9E3779B9U * this->Now);
    light[one.pixel].x = ToByte(open);
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
  this->RayCount = 0;
  if (tracer.Cells().clusters.empty())
    return;
  const LightView from(tracer, view, picture, this->Settings.pixelsACorner);
  const Picture seen{ from, tracer, picture, settings };
  const auto cast = [&](std::int64_t tile) { this->CastRays(seen, tile, light); };
  if (!settings.ambientDistanceMm)
    return EachTile(picture, cast);

  this->Watch(tracer.Cells(), *settings.ambientDistanceMm);
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
  EachTile(picture,
    [&](std::int64_t tile)
    {
      LightBlocks::Finder finder(this->Blocks.get());
      for (const Tile::Sample& sample : this->Tiles[tile].samples)
      {
        this->Blocks->Expect(finder, sample.place);
        this->Blocks->Expect(finder, sample.place.Coarser());
      }
      for (const Tile::Sample& sample : this->Tiles[tile].samples)
      {
        this->Blocks->Add(finder, sample.place, sample.rays, sample.open);
        this->Blocks->Add(finder, sample.place.Coarser(), sample.rays, sample.open);
      }
    });
  EachTile(picture, [&](std::int64_t tile) { this->Settle(seen, this->Tiles[tile], light); });
}

} // namespace hasp
