#include "Light/SceneLightCache.h"
#include "Grid/ParallelFor.h"
#include "Light/SceneLightParts.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

using Kind = SceneLightRequest::Kind;

constexpr double Pi = glm::pi<double>();
constexpr float Aged = 16.0F;  // samples that what is kept counts for, after a change elsewhere
constexpr double Bright = 4.0; // times the mean: what is above is the pixels' own
constexpr double Reach = 0.25; // of a changed body's size: light nearer than that is forgotten

void Require(bool condition, const char* what, double value, const char* range)
{
  if (!condition)
    throw std::invalid_argument(
      std::string("SceneLightCache: ") + what + " " + std::to_string(value) + " must be " + range);
}

/// `= {}` would keep its memory.
template <typename T>
void Free(std::vector<T>& values)
{
  values = std::vector<T>();
}

template <typename Body>
void EachTile(const glm::i64vec2& tiles, const Body& body)
{
  ParallelFor(0, tiles.x * tiles.y, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t tile = first; tile < last; ++tile)
        body(tile);
    });
}

std::shared_ptr<const void> SurfaceOf(const LitBody& body)
{
  return body.cells ? std::shared_ptr<const void>(body.cells) : body.mesh;
}

bool SameOwner(const std::weak_ptr<const void>& a, const std::shared_ptr<const void>& b)
{
  return !a.owner_before(b) && !b.owner_before(a);
}

} // namespace

struct SceneLightCache::Seen
{
  struct Body
  {
    std::weak_ptr<const void> surface, material;
    glm::dmat4 bodyToWorld;
    LitScene::Box box;
  };
  std::vector<Body> bodies;
  std::vector<LitLamp> lamps;
  std::weak_ptr<const Environment> environment;
  SceneLightRequest request;
  LightLattice lattice;
};

SceneLightCache::SceneLightCache(const SceneLightSettings& settings) : Settings(settings)
{
  Require(std::has_single_bit(settings.blocks) && settings.blocks >= 64 &&
            settings.blocks <= std::size_t(1) << 24,
    "number of blocks", double(settings.blocks), "a power of two, 64 to 2^24");
  Require(settings.pixelsACorner > 0.0 && std::isfinite(settings.pixelsACorner), "pixels a corner",
    settings.pixelsACorner, "above 0, finite");
  Require(settings.pathsAPixel > 0.0 && settings.pathsAPixel <= 4.0, "paths a pixel",
    settings.pathsAPixel, "above 0, at most 4");
}

SceneLightCache::~SceneLightCache() = default;

std::size_t SceneLightCache::Bytes() const
{
  const auto bytesOf = [](const std::unique_ptr<const Environment>& part)
  { return part ? part->Bytes() : 0; };
  return (this->Blocks ? this->Blocks->Bytes() : 0) +
         (this->Far ? bytesOf(this->Far->soft) + bytesOf(this->Far->bright) : 0) +
         (this->OwnShares.capacity() + this->OwnSums.capacity()) * sizeof(glm::vec4) +
         this->LastDepths.capacity() * sizeof(float);
}

void SceneLightCache::Forget()
{
  this->Fresh = true;
  this->Last.reset();
  if (this->Blocks)
    this->Blocks->Forget();
}

void SceneLightCache::ForgetAround(const LitScene::Box& box, double reach)
{
  if (!(box.low.x <= box.high.x))
    return;
  const LightLattice& lattice = this->Last->lattice;
  this->Blocks->Forget((box.low - reach - lattice.low) / lattice.unit,
    (box.high + reach - lattice.low) / lattice.unit);
}

/// Forgets the light about bodies that are others than before. Has anything changed?
bool SceneLightCache::ForgetChanges(const LitScene& scene, const SceneLightRequest& request)
{
  const auto changed = [&](const LitScene::Box& box)
  {
    this->ForgetAround(box, request.kind == Kind::Traced ? Reach * box.Size() : request.distanceMm);
  };
  bool any = false;
  std::vector<bool> known(scene.Bodies().size(), false);
  for (const Seen::Body& then : this->Last->bodies)
  {
    bool there = false;
    for (std::size_t n = 0; n < known.size() && !there; ++n)
    {
      const LitBody& now = scene.Bodies()[n];
      there =
        !known[n] && then.bodyToWorld == now.bodyToWorld && SameOwner(then.surface, SurfaceOf(now));
      known[n] = known[n] || there;
      any = any || (there && !SameOwner(then.material, now.material));
    }
    if (!there)
      changed(then.box);
    any = any || !there;
  }
  for (std::size_t n = 0; n < known.size(); ++n)
    if (!known[n])
    {
      changed(scene.BoxOf(static_cast<std::uint32_t>(n)));
      any = true;
    }
  return any;
}

/// Holds what is kept against the scene, and forgets what is not true any more.
void SceneLightCache::Watch(const LitScene& scene, const SceneLightRequest& request)
{
  if (!this->Blocks)
    this->Blocks = std::make_unique<LightBlocks>(this->Settings.blocks, LightBlocks::Of::Colors);
  const bool traced = request.kind == Kind::Traced;
  const auto same = [&](const Seen& last)
  {
    if (last.request.kind != request.kind || !last.lattice.Holds(scene.Bounds()))
      return false;
    if (!traced)
      return last.request.distanceMm == request.distanceMm;
    return last.request.paths == request.paths && last.lamps == scene.Lamps() &&
           SameOwner(last.environment, scene.SharedSurroundings());
  };
  if (!this->Last || !same(*this->Last))
  {
    this->Forget();
    this->Last = std::make_unique<Seen>();
    this->Last->lattice = LightLattice::Around(scene.Bounds());
  }
  else
  {
    // Openness does not hang on the environment, but what coats and metals show of it adds up.
    const bool ages = this->ForgetChanges(scene, request) ||
                      !SameOwner(this->Last->environment, scene.SharedSurroundings());
    if (ages && traced)
      this->Blocks->Age(Aged);
    this->Fresh = this->Fresh || ages;
  }
  Seen& last = *this->Last;
  last.request = request;
  last.lamps = scene.Lamps();
  last.environment = scene.SharedSurroundings();
  last.bodies.clear();
  for (std::uint32_t n = 0; n < scene.Bodies().size(); ++n)
  {
    const LitBody& body = scene.Bodies()[n];
    last.bodies.push_back({ SurfaceOf(body), body.material, body.bodyToWorld, scene.BoxOf(n) });
  }
}

/// Tells small bright parts apart where paths are asked for and there are such.
void SceneLightCache::PartEnvironment(const LitScene& scene, const SceneLightRequest& request)
{
  const Environment& whole = scene.Surroundings();
  if (request.kind != Kind::Traced || !whole.Samples())
    return this->Far.reset();
  if (this->Far && SameOwner(this->Far->whole, scene.SharedSurroundings()))
    return;
  this->Far = std::make_unique<Parts>();
  this->Far->whole = scene.SharedSurroundings();
  const double limit = Bright * whole.Total() / (4.0 * Pi);
  if (!(whole.Brightest() > limit))
    return;
  this->Far->bright = std::make_unique<const Environment>(whole.Above(limit));
  this->Far->soft = std::make_unique<const Environment>(whole.UpTo(limit));
}

void SceneLightCache::Light(const LitScene& scene, const PictureView& view,
  const DrawnDepths& drawn, const SceneLightRequest& request, LitPicture& picture)
{
  Require(view.size.x >= 0 && view.size.y >= 0, "least side of the picture",
    std::min(view.size.x, view.size.y), "at least 0");
  const std::size_t pixels = std::size_t(view.size.x) * std::size_t(view.size.y);
  Require(drawn.depths.empty() || drawn.depths.size() == pixels, "number of depths",
    double(drawn.depths.size()), "that of the pixels, or 0");
  Require(request.distanceMm > 0.0, "distance", request.distanceMm, "above 0 mm");
  request.paths.Validate();
  picture.assign(pixels, glm::vec4(0.0F));
  this->RayCount = this->NewPixelCount = 0;
  if (pixels == 0 || scene.Bounds().Size() == 0.0)
    return;
  const bool keeps = request.kind == Kind::Traced || request.kind == Kind::AmbientOcclusion;
  if (keeps)
    this->Watch(scene, request);
  else
  {
    this->Forget();
    this->Blocks.reset();
  }
  const bool stays =
    view == this->LastView && !this->Fresh && std::ranges::equal(drawn.depths, this->LastDepths);
  this->LastView = view;
  if (keeps)
    this->LastDepths.assign(drawn.depths.begin(), drawn.depths.end());
  else
    Free(this->LastDepths);
  this->Fresh = false;
  ++this->Now;
  if (keeps)
    this->Blocks->Advance();
  this->PartEnvironment(scene, request);
  const Environment* bright = this->Far ? this->Far->bright.get() : nullptr;
  const Environment& soft = this->Far && this->Far->soft ? *this->Far->soft : scene.Surroundings();
  const bool reflects = request.kind != Kind::Coverage &&
                        (request.kind == Kind::Traced || scene.Surroundings().Brightest() > 0.0) &&
                        std::any_of(scene.Bodies().begin(), scene.Bodies().end(),
                          [](const LitBody& body) { return !body.material->Diffuse(); });
  if (!keeps || !stays)
    Free(this->OwnShares);
  else if (this->OwnShares.empty())
    this->OwnShares.assign(pixels, glm::vec4(0.0F));
  if (!reflects && !bright)
    Free(this->OwnSums);
  else if (!stays || this->OwnSums.size() != pixels)
    this->OwnSums.assign(pixels, glm::vec4(0.0F));
  if (!stays)
    this->OwnNumber = this->Now << 12U; // points unlike those of other views

  const PictureRays rays(view);
  const ViewPlaces places(
    view, keeps ? this->Last->lattice : LightLattice(), this->Settings.pixelsACorner);
  const PathTracer<SobolSequence> paths(scene, request.paths);
  glm::dvec4 eye = glm::inverse(view.indexToClip) * glm::dvec4(0, 0, -1, 0);
  if (eye.w != 0.0)
    eye /= eye.w;
  else if (glm::dot(glm::dvec3(eye), glm::dvec3(glm::row(view.indexToClip, 2))) < 0.0)
    eye = -eye;
  float least = 0.0F; // light of all kinds, on average
  for (const LitLamp& lamp : scene.Lamps())
    least += std::max({ lamp.color.r, lamp.color.g, lamp.color.b });
  least += static_cast<float>(soft.Total() / (4.0 * Pi));
  const Picture seen{ scene, view, rays, places, paths, drawn, request, eye,
    glm::vec3(least > 0.0F ? 0.25F * least : 1.0F), stays, reflects, soft, bright };

  const glm::i64vec2 tiles = (view.size + Tile::Side - 1) / Tile::Side;
  this->Tiles.resize(std::size_t(tiles.x * tiles.y));
  EachTile(tiles, [&](std::int64_t tile) { this->CastPaths(seen, tile, picture); });
  for (const Tile& tile : this->Tiles) // in order, so that the table is the same with any threads
  {
    this->RayCount += tile.rays;
    this->NewPixelCount += tile.unknown;
    for (const LightBlocks::Key key : tile.missing)
      this->Blocks->Make(key);
  }
  if (!keeps)
    return;
  EachTile(tiles, [&](std::int64_t tile) { this->AddPaths(seen, this->Tiles[tile]); });
  EachTile(tiles, [&](std::int64_t tile) { this->Settle(seen, this->Tiles[tile], picture); });
}

} // namespace hasp
