#include "Light/SurfaceMaterial.h"
#include "Isosurface/Hemisphere.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Pi = glm::pi<double>();
constexpr int Angles = 32; // of the table, and one; even in the cosine's root, for grazing ones
                           // change most

void Require(bool condition, const char* what, double value, const char* range)
{
  if (!condition)
    throw std::invalid_argument(std::string("SurfaceMaterial: ") + what + " " +
                                std::to_string(value) + " must be in " + range);
}

/// GGX of one roughness, around z.
struct Ggx
{
  double alpha;

  explicit Ggx(double roughness) : alpha(roughness * roughness) {}

  /// Facets of that normal, per steradian. Written so that alpha 1e-3 loses nothing.
  double Facets(double cosine) const
  {
    const double sine2 = std::max(0.0, 1.0 - cosine * cosine), a2 = this->alpha * this->alpha;
    const double t = sine2 + cosine * cosine * a2;
    return a2 / (Pi * t * t);
  }
  double Lambda(double cosine) const
  {
    const double c2 = cosine * cosine, tangent2 = (1.0 - c2) / std::max(c2, 1e-300);
    return 0.5 * (std::sqrt(1.0 + this->alpha * this->alpha * std::max(0.0, tangent2)) - 1.0);
  }
  double Seen(double cosine) const { return 1.0 / (1.0 + this->Lambda(cosine)); }
  double SeenBoth(double a, double b) const
  {
    return 1.0 / (1.0 + this->Lambda(a) + this->Lambda(b));
  }

  /// A normal among those that `out` sees (Heitz 2018, listing 1).
  glm::dvec3 SeenNormal(const glm::dvec3& out, const glm::dvec2& point) const
  {
    const glm::dvec3 stretched =
      glm::normalize(glm::dvec3(this->alpha * out.x, this->alpha * out.y, out.z));
    const double across = stretched.x * stretched.x + stretched.y * stretched.y;
    const glm::dvec3 first = across > 0.0
                               ? glm::dvec3(-stretched.y, stretched.x, 0.0) / std::sqrt(across)
                               : glm::dvec3(1, 0, 0);
    const glm::dvec3 second = glm::cross(stretched, first);
    const double r = std::sqrt(point.x), turn = 2.0 * Pi * point.y;
    const double a = r * std::cos(turn), s = 0.5 * (1.0 + stretched.z);
    const double b = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - a * a)) + s * (r * std::sin(turn));
    const glm::dvec3 n =
      a * first + b * second + std::sqrt(std::max(0.0, 1.0 - a * a - b * b)) * stretched;
    return glm::normalize(glm::dvec3(this->alpha * n.x, this->alpha * n.y, std::max(1e-12, n.z)));
  }
};

double Grazing(double cosine)
{
  const double m = std::clamp(1.0 - cosine, 0.0, 1.0);
  return m * m * m * m * m;
}

} // namespace

/// What facets of one roughness give back, by the angle: f0 flat(cosine) + grazing(cosine), from a
/// single bounce; and the averages over cosine-weighted angles.
struct SurfaceScattering::Tables
{
  Ggx facets;
  std::array<float, Angles + 1> flat, grazing, coat;
  double average = 0.0; ///< of flat + grazing
  double coatAgain = 0.0, coatAverage = 0.0;

  Tables(double roughness, double specular) : facets(roughness)
  {
    constexpr int Side = 32;
    for (int angle = 0; angle <= Angles; ++angle)
    {
      const double root = double(angle) / Angles, cosine = std::max(1e-4, root * root);
      const glm::dvec3 out(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      double a = 0.0, b = 0.0;
      for (int n = 0; n < Side * Side; ++n)
      {
        const glm::dvec2 point((n % Side + 0.5) / Side, (n / Side + 0.5) / Side);
        const glm::dvec3 normal = this->facets.SeenNormal(out, point);
        const double met = glm::dot(out, normal);
        const double in = 2.0 * met * normal.z - cosine;
        if (!(in > 0.0))
          continue;
        const double share = this->facets.SeenBoth(cosine, in) / this->facets.Seen(cosine);
        a += share * (1.0 - Grazing(met));
        b += share * Grazing(met);
      }
      this->flat[angle] = static_cast<float>(a / (Side * Side));
      this->grazing[angle] = static_cast<float>(b / (Side * Side));
    }
    this->average = Average([&](int n) { return double(this->flat[n] + this->grazing[n]); });
    this->coatAgain = this->Again(specular);
    for (int n = 0; n <= Angles; ++n)
      this->coat[n] = static_cast<float>(
        std::clamp(specular * this->flat[n] + this->grazing[n] * (specular > 0.0 ? 1.0 : 0.0) +
                     this->coatAgain * (1.0 - this->flat[n] - this->grazing[n]),
          0.0, 1.0));
    this->coatAverage = Average([&](int n) { return double(this->coat[n]); });
  }

  /// 2 times the integral of a function of the angle, linear between the table's, times the cosine.
  template <typename F>
  static double Average(const F& f)
  {
    double sum = 0.0; // of 4 f(r) r^3 dr, r the cosine's root
    for (int n = 0; n < Angles; ++n)
    {
      const double r0 = double(n) / Angles, r1 = double(n + 1) / Angles;
      const double slope = (f(n + 1) - f(n)) / (r1 - r0), start = f(n) - slope * r0;
      sum += start * (std::pow(r1, 4) - std::pow(r0, 4)) +
             0.8 * slope * (std::pow(r1, 5) - std::pow(r0, 5));
    }
    return sum;
  }
  static float At(const std::array<float, Angles + 1>& table, double cosine)
  {
    const double place = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * Angles;
    const int n = std::min(static_cast<int>(place), Angles - 1);
    const auto part = static_cast<float>(place - n);
    return table[n] + part * (table[n + 1] - table[n]);
  }
  /// The share of what the first bounce loses that comes back, for a reflectance at normal
  /// incidence.
  double Again(double f0) const
  {
    const double mean = (1.0 + 20.0 * f0) / 21.0; // Schlick's, over all angles
    return f0 > 0.0 ? mean * mean * this->average / (1.0 - mean * (1.0 - this->average)) : 0.0;
  }
  double Lost(double cosine) const
  {
    return std::max(0.0, 1.0 - double(At(this->flat, cosine)) - double(At(this->grazing, cosine)));
  }
  /// f of what bounces again between the facets, at reflectance 1.
  double LostBoth(double out, double in) const
  {
    return this->Lost(out) * this->Lost(in) / (Pi * std::max(1e-9, 1.0 - this->average));
  }
};

SurfaceScattering::SurfaceScattering(const SurfaceMaterial& material) : Given(material)
{
  for (int c = 0; c < 3; ++c)
    Require(material.albedo[c] >= 0.0F && material.albedo[c] <= 1.0F, "albedo", material.albedo[c],
      "[0, 1]");
  Require(material.specular >= 0.0F && material.specular <= 1.0F, "specular", material.specular,
    "[0, 1]");
  Require(material.roughness >= 0.03F && material.roughness <= 1.0F, "roughness",
    material.roughness, "[0.03, 1]");
  Require(material.metallic >= 0.0F && material.metallic <= 1.0F, "metallic", material.metallic,
    "[0, 1]");
  double coat = 0.0;
  if (material.specular > 0.0F || material.metallic > 0.0F)
  {
    this->Facets = std::make_unique<const Tables>(material.roughness, material.specular);
    coat = this->Facets->coatAverage;
  }
  this->BodyScale = coat < 1.0 ? static_cast<float>(1.0 / (Pi * (1.0 - coat))) : 0.0F;
}

SurfaceScattering::~SurfaceScattering() = default;
SurfaceScattering::SurfaceScattering(SurfaceScattering&&) noexcept = default;
SurfaceScattering& SurfaceScattering::operator=(SurfaceScattering&&) noexcept = default;

SurfaceScattering::At::At(const SurfaceScattering& scattering, const glm::vec3& albedo,
  const glm::dvec3& normal, const glm::dvec3& towardsEye)
  : Of(&scattering),
    Albedo(albedo),
    Frame(FrameAround(normal))
{
  this->Out = glm::transpose(this->Frame) * towardsEye;
  this->Out.z = std::max(this->Out.z, 1e-4); // a shading normal may look past the edge
  this->Out = glm::normalize(this->Out);
  if (!scattering.Facets)
    return;
  const SurfaceMaterial& m = scattering.Given;
  const float brightest = std::max({ albedo.r, albedo.g, albedo.b });
  const float coat = this->CoatAlbedo(this->Out.z);
  const double gloss = glm::mix(coat, std::max(brightest, 0.05F), m.metallic);
  const double body = (1.0F - m.metallic) * brightest * (1.0F - coat);
  // What bounces between facets leaves as from a body.
  const double once = gloss * (1.0 - scattering.Facets->Lost(this->Out.z));
  this->GlossShare = std::clamp(once / std::max(1e-9, gloss + body), 0.1, 0.9);
}

float SurfaceScattering::At::CoatAlbedo(double cosine) const
{
  return Tables::At(this->Of->Facets->coat, cosine);
}

glm::vec3 SurfaceScattering::At::BodyAlbedo() const
{
  if (!this->Of->Facets)
    return this->Albedo;
  return (1.0F - this->Of->Given.metallic) * (1.0F - this->CoatAlbedo(this->Out.z)) * this->Albedo;
}

glm::vec3 SurfaceScattering::At::GlossLocal(const glm::dvec3& in) const
{
  const Tables& tables = *this->Of->Facets;
  const SurfaceMaterial& m = this->Of->Given;
  const glm::dvec3 normal = glm::normalize(this->Out + in);
  const double met = glm::dot(this->Out, normal), grazing = Grazing(met);
  const double once = tables.facets.Facets(normal.z) * tables.facets.SeenBoth(this->Out.z, in.z) /
                      (4.0 * this->Out.z * in.z);
  const double again = tables.LostBoth(this->Out.z, in.z);
  glm::dvec3 f(0.0);
  if (m.metallic < 1.0F && m.specular > 0.0F)
    f += (1.0 - m.metallic) *
         ((m.specular + (1.0 - m.specular) * grazing) * once + tables.coatAgain * again);
  if (m.metallic > 0.0F)
    for (int c = 0; c < 3; ++c)
      f[c] += m.metallic * ((this->Albedo[c] + (1.0 - this->Albedo[c]) * grazing) * once +
                             tables.Again(this->Albedo[c]) * again);
  return glm::vec3(f * in.z);
}

glm::vec3 SurfaceScattering::At::EvaluateLocal(const glm::dvec3& in) const
{
  if (!(in.z > 0.0))
    return glm::vec3(0.0F);
  const auto cosine = static_cast<float>(in.z);
  if (!this->Of->Facets)
    return this->Albedo * (this->Of->BodyScale * cosine);
  const float body = (1.0F - this->Of->Given.metallic) * this->Of->BodyScale *
                     (1.0F - this->CoatAlbedo(this->Out.z)) * (1.0F - this->CoatAlbedo(in.z));
  return this->Albedo * (body * cosine) + this->GlossLocal(in);
}

double SurfaceScattering::At::GlossDensity(const glm::dvec3& in) const
{
  const Ggx& facets = this->Of->Facets->facets;
  const glm::dvec3 normal = glm::normalize(this->Out + in);
  return facets.Facets(normal.z) * facets.Seen(this->Out.z) / (4.0 * this->Out.z);
}

double SurfaceScattering::At::DensityLocal(const glm::dvec3& in) const
{
  if (!(in.z > 0.0))
    return 0.0;
  const double body = in.z / Pi;
  return this->GlossShare > 0.0
           ? this->GlossShare * this->GlossDensity(in) + (1.0 - this->GlossShare) * body
           : body;
}

glm::vec3 SurfaceScattering::At::Evaluate(const glm::dvec3& direction) const
{
  return this->EvaluateLocal(glm::transpose(this->Frame) * direction);
}

double SurfaceScattering::At::Density(const glm::dvec3& direction) const
{
  return this->DensityLocal(glm::transpose(this->Frame) * direction);
}

glm::dvec3 SurfaceScattering::At::GlossDirection(const glm::dvec2& point) const
{
  const glm::dvec3 normal = this->Of->Facets->facets.SeenNormal(this->Out, point);
  return 2.0 * glm::dot(this->Out, normal) * normal - this->Out;
}

ScatterSample SurfaceScattering::At::Sample(double choice, const glm::dvec2& point) const
{
  const glm::dvec3 in =
    choice < this->GlossShare ? this->GlossDirection(point) : CosineWeighted(point);
  ScatterSample sample;
  sample.direction = this->Frame * in;
  if (!this->Of->Facets) // what cancels is left out, so that no rounding is left
  {
    sample.density = in.z / Pi;
    sample.weight = in.z > 0.0 ? this->Albedo : glm::vec3(0.0F);
    return sample;
  }
  sample.density = this->DensityLocal(in);
  if (sample.density > 0.0)
    sample.weight = this->EvaluateLocal(in) / static_cast<float>(sample.density);
  return sample;
}

ScatterSample SurfaceScattering::At::GlossTowards(const glm::dvec3& in) const
{
  ScatterSample sample;
  sample.direction = this->Frame * in;
  if (!this->Of->Facets || !(in.z > 0.0))
    return sample;
  sample.density = this->GlossDensity(in);
  if (sample.density > 0.0)
    sample.weight = this->GlossLocal(in) / static_cast<float>(sample.density);
  return sample;
}

ScatterSample SurfaceScattering::At::SampleGloss(const glm::dvec2& point) const
{
  return this->Of->Facets ? this->GlossTowards(this->GlossDirection(point)) : ScatterSample();
}

ScatterSample SurfaceScattering::At::Gloss(const glm::dvec3& direction) const
{
  return this->GlossTowards(glm::transpose(this->Frame) * direction);
}

} // namespace hasp
