#include "Light/LitScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

LitScene::Box BoxOfCells(const ClusteredCells& cells, const glm::dmat4& bodyToWorld)
{
  LitScene::Box box;
  glm::ivec3 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  for (const CellCluster& cluster : cells.clusters)
  {
    low = glm::min(low, cluster.Origin());
    high = glm::max(high, cluster.Origin() + 8);
  }
  if (cells.clusters.empty())
    return box;
  high = glm::min(high, cells.geometry.Cells());
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 index(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
    const glm::dvec3 world(bodyToWorld * glm::dvec4(cells.geometry.IndexToWorld(index), 1.0));
    box.low = glm::min(box.low, world);
    box.high = glm::max(box.high, world);
  }
  return box;
}

LitScene::Box BoxOfMesh(const TriangleTracer& mesh, const glm::dmat4& bodyToWorld)
{
  LitScene::Box box;
  if (mesh.Mesh().mesh.triangles.empty())
    return box;
  const glm::dvec3 &low = mesh.Low(), &high = mesh.High();
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 corner(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
    const glm::dvec3 world(bodyToWorld * glm::dvec4(corner, 1.0));
    box.low = glm::min(box.low, world);
    box.high = glm::max(box.high, world);
  }
  return box;
}

glm::dvec3 UnitOr(const glm::dvec3& v, const glm::dvec3& other)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : other;
}

void Check(const LitLamp& lamp, std::size_t number)
{
  const double size = glm::length(lamp.place), w = lamp.place.w;
  const glm::vec3 &color = lamp.color, &reach = lamp.attenuation;
  if (!(std::isfinite(size) && ((w == 0.0 && size > 0.0) || w == 1.0)) ||
      !std::isfinite(color.r + color.g + color.b) || std::min({ color.r, color.g, color.b }) < 0.0F)
    throw std::invalid_argument("LitScene: lamp " + std::to_string(number) +
                                " needs a finite direction that is not 0 (w 0, not " +
                                std::to_string(w) +
                                ") or place (w 1), and a finite colour of at least 0");
  if (!(lamp.shadow >= 0.0F && lamp.shadow <= 1.0F))
    throw std::invalid_argument("LitScene: lamp " + std::to_string(number) + " has a shadow of " +
                                std::to_string(lamp.shadow) + "; it must be in [0, 1]");
  if (!(std::isfinite(reach.x + reach.y + reach.z) && reach.x + reach.y + reach.z > 0.0F) ||
      std::min({ reach.x, reach.y, reach.z }) < 0.0F)
    throw std::invalid_argument("LitScene: lamp " + std::to_string(number) +
                                " needs finite attenuations of at least 0, not all 0");
}

} // namespace

double LitScene::Box::Size() const
{
  return this->low.x <= this->high.x ? glm::length(this->high - this->low) : 0.0;
}

/// A ray in the world, and the hit that it leaves.
struct LitScene::Way
{
  const glm::dvec3 &origin, &direction;
  double tMin, tMax;
  const LitHit* from;
  bool fromInBody(std::uint32_t body) const { return this->from && this->from->body == body; }
};

LitScene::LitScene(std::vector<LitBody> bodies, std::vector<LitLamp> lamps,
  std::shared_ptr<const Environment> environment)
  : Given(std::move(bodies)),
    GivenLamps(std::move(lamps)),
    Far(std::move(environment))
{
  if (!this->Far)
    throw std::invalid_argument(
      "LitScene: an environment is needed; Environment::Uniform of black for none");
  for (std::size_t n = 0; n < this->GivenLamps.size(); ++n)
    Check(this->GivenLamps[n], n);
  for (std::size_t n = 0; n < this->Given.size(); ++n)
  {
    const LitBody& body = this->Given[n];
    const std::string called = "LitScene: body " + std::to_string(n);
    if (bool(body.cells) == bool(body.mesh))
      throw std::invalid_argument(called + " must have either cells or a mesh");
    if (!body.material)
      throw std::invalid_argument(called + " has no material");
    const glm::dmat3 turn(body.bodyToWorld);
    const double volume = glm::determinant(turn);
    if (!(std::isfinite(volume + glm::length(body.bodyToWorld[3])) && volume != 0.0))
      throw std::invalid_argument(called + " has a matrix that cannot be inverted");
    this->Frames.push_back(
      { glm::inverse(body.bodyToWorld), glm::inverse(turn), glm::transpose(glm::inverse(turn)) });
    this->Boxes.push_back(body.cells ? BoxOfCells(body.cells->Cells(), body.bodyToWorld)
                                     : BoxOfMesh(*body.mesh, body.bodyToWorld));
    this->All.low = glm::min(this->All.low, this->Boxes.back().low);
    this->All.high = glm::max(this->All.high, this->Boxes.back().high);
  }
  this->Apart = 1e-9 * this->All.Size();
}

bool LitScene::Enters(std::uint32_t body, const Way& way) const
{
  const Box& box = this->Boxes[body];
  const glm::dvec3 u = (box.low - way.origin) / way.direction,
                   v = (box.high - way.origin) / way.direction;
  double from = way.tMin, to = way.tMax;
  for (int a = 0; a < 3; ++a)
  {
    if (way.direction[a] == 0.0) // 0 / 0 within a face
    {
      if (way.origin[a] < box.low[a] || way.origin[a] > box.high[a])
        return false;
      continue;
    }
    from = std::max(from, std::min(u[a], v[a]));
    to = std::min(to, std::max(u[a], v[a]));
  }
  const double slack = 1e-9 * (std::abs(from) + std::abs(to)); // boxes of turned bodies are rounded
  return from <= to + slack && box.low.x <= box.high.x;
}

LitHit LitScene::HitOfCells(std::uint32_t body, const Way& way, const CellHit& cell) const
{
  LitHit hit{};
  hit.t = cell.t;
  hit.body = body;
  hit.cell = cell;
  const LitBody& of = this->Given[body];
  hit.position = glm::dvec3(
    of.bodyToWorld * glm::dvec4(of.cells->Cells().geometry.IndexToWorld(cell.Position()), 1.0));
  const glm::dvec3 normal = this->Frames[body].normalToWorld * of.cells->Outwards(cell);
  hit.normal = UnitOr(normal, -glm::normalize(way.direction));
  hit.shading = hit.normal;
  hit.albedo = of.material->Material().albedo;
  return hit;
}

LitHit LitScene::HitOfMesh(std::uint32_t body, const Way& way, const TriangleHit& triangle) const
{
  LitHit hit{};
  hit.t = triangle.t;
  hit.body = body;
  hit.triangle = triangle;
  const LitBody& of = this->Given[body];
  hit.position = way.origin + triangle.t * way.direction;
  const glm::dmat3& toWorld = this->Frames[body].normalToWorld;
  const auto facing = [&](const glm::dvec3& n)
  { return glm::dot(n, way.direction) > 0.0 ? -n : n; };
  hit.normal =
    facing(UnitOr(toWorld * of.mesh->Normal(triangle.triangle), -glm::normalize(way.direction)));
  const glm::dvec3 smooth = UnitOr(toWorld * of.mesh->ShadingNormal(triangle), hit.normal);
  hit.shading = glm::dot(smooth, hit.normal) < 0.0 ? -smooth : smooth;
  hit.albedo = of.mesh->Color(triangle).value_or(of.material->Material().albedo);
  return hit;
}

/// In a body's coordinates; a way that leaves its mesh starts a little off it.
struct LitScene::Local
{
  glm::dvec3 origin, along;
  double tMin;

  CellRay InCells(const LitBody& body, double tMax) const
  {
    const GridGeometry& g = body.cells->Cells().geometry;
    return { g.WorldToIndex(this->origin), glm::transpose(g.direction) * this->along / g.spacing,
      this->tMin, tMax };
  }
};

glm::dvec3 LitScene::AlongIn(std::uint32_t body, const Way& way) const
{
  return this->Frames[body].directionToBody * way.direction;
}

LitScene::Local LitScene::LocalTo(std::uint32_t body, const Way& way) const
{
  const Frame& frame = this->Frames[body];
  Local local{ glm::dvec3(frame.toBody * glm::dvec4(way.origin, 1.0)), this->AlongIn(body, way),
    way.tMin };
  if (const auto& mesh = this->Given[body].mesh; mesh && way.fromInBody(body))
  {
    local.origin += mesh->Clearance() * glm::normalize(frame.directionToBody * way.from->normal);
    local.tMin = 0.0;
  }
  return local;
}

std::optional<LitHit> LitScene::Nearest(Way way) const
{
  std::optional<LitHit> nearest;
  const auto take = [&](const LitHit& hit)
  {
    nearest = hit;
    way.tMax = hit.t;
  };
  for (std::uint32_t n = 0; n < this->Given.size(); ++n)
  {
    if (!way.fromInBody(n) && !this->Enters(n, way))
      continue;
    const LitBody& body = this->Given[n];
    if (body.mesh)
    {
      const Local local = this->LocalTo(n, way);
      const auto hit = body.mesh->Trace(local.origin, local.along, local.tMin, way.tMax);
      if (hit && (!nearest || hit->t < nearest->t))
        take(this->HitOfMesh(n, way, *hit));
      continue;
    }
    const auto hit = way.fromInBody(n)
                       ? body.cells->TraceFrom(way.from->cell, this->AlongIn(n, way), way.tMax)
                       : body.cells->Trace(this->LocalTo(n, way).InCells(body, way.tMax));
    if (hit && (!nearest || hit->t < nearest->t))
      take(this->HitOfCells(n, way, *hit));
  }
  return nearest;
}

bool LitScene::Blocks(std::uint32_t number, const Way& way) const
{
  const LitBody& body = this->Given[number];
  if (body.cells && way.fromInBody(number))
    return body.cells->OccludedFrom(way.from->cell, this->AlongIn(number, way), way.tMax);
  const Local local = this->LocalTo(number, way);
  return body.mesh ? body.mesh->Occluded(local.origin, local.along, local.tMin, way.tMax)
                   : body.cells->Occluded(local.InCells(body, way.tMax));
}

bool LitScene::Any(const Way& way) const
{
  for (std::uint32_t n = 0; n < this->Given.size(); ++n)
    if ((way.fromInBody(n) || this->Enters(n, way)) && this->Blocks(n, way))
      return true;
  return false;
}

std::optional<LitHit> LitScene::Trace(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const
{
  return this->Nearest({ origin, direction, tMin, tMax, nullptr });
}

std::optional<LitHit> LitScene::TraceFrom(const LitHit& hit, const glm::dvec3& direction) const
{
  return this->Nearest({ hit.position, direction, this->Apart, Infinity, &hit });
}

bool LitScene::OccludedFrom(const LitHit& hit, const glm::dvec3& direction, double distanceMm) const
{
  return this->Any({ hit.position, direction, this->Apart, distanceMm, &hit });
}

} // namespace hasp
