#pragma once
#include "Isosurface/CellTracer.h"
#include "Light/Environment.h"
#include "Light/SurfaceMaterial.h"
#include "Light/TriangleTracer.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace hasp
{

/// Something that takes light and gives it back: clustered cells, or a mesh; one of the two.
struct LitBody
{
  std::shared_ptr<const CellTracer> cells;
  std::shared_ptr<const TriangleTracer> mesh;
  glm::dmat4 bodyToWorld{ 1.0 }; ///< rigid, or with a scale; no shear needed, none refused
  std::shared_ptr<const SurfaceScattering> material;
  glm::vec3 glow{ 0.0F }; ///< radiance that the eye alone sees of it, and no other body: a mark
};

/// A lamp without extent, as VTK's: a white body that faces it has radiance `color` at distance 1
/// of the attenuation 1.
struct LitLamp
{
  glm::dvec4 place{ 0.0, 0.0, 1.0, 0.0 }; ///< w 0: the world direction towards it; 1: its place, mm
  glm::vec3 color{ 1.0F };
  glm::vec3 attenuation{ 1.0F, 0.0F, 0.0F }; ///< constant, linear, quadratic, of w 1
  glm::dvec3 axis{ 0.0 };                    ///< of a spot, unit, away from the lamp
  double leastCosine = -1.0, exponent = 0.0; ///< of a spot: its cone, and how it falls off
  float shadow = 1.0F; ///< share of its light that what lies between takes away, [0, 1]

  bool operator==(const LitLamp&) const = default;
};

/// Where a ray meets the scene.
struct LitHit
{
  double t;            ///< of the ray
  std::uint32_t body;  ///< which of the scene's
  glm::dvec3 position; ///< world, mm
  glm::dvec3 normal;   ///< of the surface, unit, world, on the side the ray came from
  glm::dvec3 shading;  ///< the normal to shade with: a mesh's own where it has them
  glm::vec3 albedo;
  CellHit cell;         ///< of cells
  TriangleHit triangle; ///< of a mesh
};

/// All that shares one light: bodies, lamps, and what comes from far away. Immutable once made.
///
/// A ray that leaves a surface of cells has its first root divided out; one that leaves a mesh
/// starts by 1e-6 of the mesh's size off it. Other bodies are met from 1e-9 of the scene's size on.
/// So nothing shades itself, and nothing leaks through walls thicker than that.
///
/// Threads: all const functions from any. Cost of a ray: those of the bodies whose boxes it meets;
/// boxes are asked one after the other, so some hundred bodies are many.
class LitScene
{
public:
  /// Some microseconds a body and 0.1 us a cluster: what is dear is shared, so that a moved body
  /// costs no tree. Throws std::invalid_argument: a body without surface or with both, or without
  /// material, a matrix that cannot be inverted, a lamp without direction, with a w that is neither
  /// 0 nor 1, with colours or attenuations below 0 or a shadow out of range, no environment.
  LitScene(std::vector<LitBody> bodies, std::vector<LitLamp> lamps,
    std::shared_ptr<const Environment> environment);

  std::optional<LitHit> Trace(const glm::dvec3& origin, const glm::dvec3& direction,
    double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity()) const;
  ///@{
  /// From a hit, on the side its ray came from. direction: unit.
  std::optional<LitHit> TraceFrom(const LitHit& hit, const glm::dvec3& direction) const;
  bool OccludedFrom(const LitHit& hit, const glm::dvec3& direction,
    double distanceMm = std::numeric_limits<double>::infinity()) const;
  ///@}

  const std::vector<LitBody>& Bodies() const { return this->Given; }
  const std::vector<LitLamp>& Lamps() const { return this->GivenLamps; }
  const Environment& Surroundings() const { return *this->Far; }
  const std::shared_ptr<const Environment>& SharedSurroundings() const { return this->Far; }
  const SurfaceScattering& Scattering(std::uint32_t body) const
  {
    return *this->Given[body].material;
  }

  ///@{
  /// World box of a body and of all; low above high where there is nothing.
  struct Box
  {
    glm::dvec3 low{ std::numeric_limits<double>::infinity() },
      high{ -std::numeric_limits<double>::infinity() };
    double Size() const; ///< its diagonal; 0 if empty
  };
  const Box& BoxOf(std::uint32_t body) const { return this->Boxes[body]; }
  const Box& Bounds() const { return this->All; }
  ///@}

private:
  struct Way; // a ray in the world and what is asked of it
  struct Frame
  {
    glm::dmat4 toBody;
    glm::dmat3 directionToBody, normalToWorld;
  };
  struct Local;
  Local LocalTo(std::uint32_t body, const Way& way) const;
  glm::dvec3 AlongIn(std::uint32_t body, const Way& way) const; ///< all that a way off cells needs
  bool Blocks(std::uint32_t number, const Way& way) const;
  bool Enters(std::uint32_t body, const Way& way) const;
  std::optional<LitHit> Nearest(Way way) const;
  bool Any(const Way& way) const;
  LitHit HitOfCells(std::uint32_t body, const Way& way, const CellHit& hit) const;
  LitHit HitOfMesh(std::uint32_t body, const Way& way, const TriangleHit& hit) const;

  std::vector<LitBody> Given;
  std::vector<LitLamp> GivenLamps;
  std::shared_ptr<const Environment> Far;
  std::vector<Frame> Frames;
  std::vector<Box> Boxes;
  Box All;
  double Apart = 0.0; ///< from where on other bodies are met
};

} // namespace hasp
