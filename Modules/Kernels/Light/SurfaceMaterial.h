#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>

namespace hasp
{

/// How a surface gives light back: a diffuse body under a coat (bone, plastic), or metal.
struct SurfaceMaterial
{
  glm::vec3 albedo{ 0.8F }; ///< share that the body or the metal gives back, each [0, 1]
  float specular = 0.0F;    ///< of the coat, at normal incidence, [0, 1]; plastic: 0.04. 0: no coat
  float roughness = 0.5F;   ///< of coat and metal, [0.03, 1]; its square is GGX's alpha
  float metallic = 0.0F;    ///< [0, 1]: 0 body and coat, 1 metal

  bool operator==(const SurfaceMaterial&) const = default;
};

struct ScatterSample
{
  glm::dvec3 direction{ 0.0 }; ///< world, unit, to where the light would come from
  glm::vec3 weight{ 0.0F };    ///< f cos / density; 0: this sample carries nothing
  double density = 0.0;        ///< per steradian
};

/// A material made ready. Reciprocal, and gives back no more than it gets: at albedo 1 all, within
/// 0.6% at any angle, however rough (GGX with Smith's shadowing, visible normals sampled after
/// Heitz 2018; what one bounce between its facets loses is put back after Kulla and Conty 2017, and
/// the body gets what the coat lets through, both ways). Schlick's Fresnel term.
///
/// Threads: any. A table of 33 angles, made once for a roughness in about 2 ms, where there is coat
/// or metal; none for a diffuse body.
class SurfaceScattering
{
public:
  /// Throws std::invalid_argument on values out of range.
  explicit SurfaceScattering(const SurfaceMaterial& material);
  ~SurfaceScattering();
  SurfaceScattering(SurfaceScattering&&) noexcept;
  SurfaceScattering& operator=(SurfaceScattering&&) noexcept;

  const SurfaceMaterial& Material() const { return this->Given; }
  bool Diffuse() const { return !this->Facets; } ///< neither coat nor metal

  /// The surface at a place. normal: unit, on the viewer's side.
  class At;

private:
  struct Tables;
  SurfaceMaterial Given;
  std::unique_ptr<const Tables> Facets;
  float BodyScale = 0.0F; ///< 1 / (pi (1 - what the coat gives back on average))
};

/// Light from one direction to another at a place, in world directions. It lives no longer than the
/// scattering.
class SurfaceScattering::At
{
public:
  /// towardsEye, normal: unit. albedo takes the material's place.
  At(const SurfaceScattering& scattering, const glm::vec3& albedo, const glm::dvec3& normal,
    const glm::dvec3& towardsEye);

  /// f(towardsEye, direction) times the cosine of direction; 0 below the surface.
  glm::vec3 Evaluate(const glm::dvec3& direction) const;
  /// Of Sample, per steradian.
  double Density(const glm::dvec3& direction) const;
  /// choice in [0, 1), point in the unit square.
  ScatterSample Sample(double choice, const glm::dvec2& point) const;
  /// The share of light from all sides that the body alone gives back to the eye.
  glm::vec3 BodyAlbedo() const;
  ///@{
  /// Of the coat's or the metal's lobe alone: a direction of it, and what it makes of one.
  ScatterSample SampleGloss(const glm::dvec2& point) const;
  ScatterSample Gloss(const glm::dvec3& direction) const;
  ///@}

private:
  glm::vec3 EvaluateLocal(const glm::dvec3& in) const;
  glm::vec3 GlossLocal(const glm::dvec3& in) const; ///< f cos of coat and metal
  double DensityLocal(const glm::dvec3& in) const;
  double GlossDensity(const glm::dvec3& in) const;
  glm::dvec3 GlossDirection(const glm::dvec2& point) const;
  ScatterSample GlossTowards(const glm::dvec3& in) const;
  float CoatAlbedo(double cosine) const;

  const SurfaceScattering* Of;
  glm::vec3 Albedo;
  glm::dmat3 Frame;        ///< columns, local to world
  glm::dvec3 Out;          ///< towards the eye, local
  double GlossShare = 0.0; ///< of samples
};

} // namespace hasp
