#include "Grid/Phantom.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double DefectLengthMm = 52.0, DefectWidthMm = 28.0, DefectCornerMm = 6.0;

void RequirePositive(double value, const char* name)
{
  if (!(value > 0.0 && std::isfinite(value)))
    throw std::invalid_argument(
      "phantom: " + std::string(name) + " is " + std::to_string(value) + ", must be > 0");
}

void Check(const PhantomSettings& s)
{
  RequirePositive(s.scalpMm, "scalpMm");
  RequirePositive(s.skullMm, "skullMm");
  RequirePositive(s.edgeMm, "edgeMm");
  const double thinnest = std::min({ s.skinRadii.x, s.skinRadii.y, s.skinRadii.z });
  if (!(thinnest - s.scalpMm - s.skullMm >= 30.0))
    throw std::invalid_argument("phantom: the smallest skin radius is " + std::to_string(thinnest) +
                                " mm, must leave 30 mm inside scalp and skull");
  if (!(s.noiseHU >= 0.0 && std::isfinite(s.noiseHU)))
    throw std::invalid_argument(
      "phantom: noiseHU is " + std::to_string(s.noiseHU) + ", must be >= 0");
}

/// 1 - |p/r| scaled by the smallest radius: 0 on the ellipsoid, > 0 inside, 1-Lipschitz because the
/// gradient of |p/r| is at most 1 / smallest radius.
double InsideEllipsoid(const glm::dvec3& p, const glm::dvec3& radii)
{
  return (1.0 - glm::length(p / radii)) * std::min({ radii.x, radii.y, radii.z });
}

/// Minus the signed distance to a box with rounded edges along z and open ends.
double InsideRoundedSlot(const glm::dvec2& p, const glm::dvec2& half, double corner)
{
  const glm::dvec2 q = glm::abs(p) - half + corner;
  const double outside = glm::length(glm::max(q, glm::dvec2(0.0)));
  return corner - outside - std::min(std::max(q.x, q.y), 0.0);
}

/// Everything below is relative to the head's centre.
struct Head
{
  explicit Head(const PhantomSettings& s)
    : settings(s),
      outer(s.skinRadii - s.scalpMm),
      inner(outer - s.skullMm),
      hole(DefectOf(s))
  {
    this->hole.center -= s.center;
    const double ahead = -outer.y + 12.0;
    this->orbit[0] = { -32.0, ahead, -18.0 };
    this->orbit[1] = { 32.0, ahead, -18.0 };
  }
  double Skin(const glm::dvec3& p) const { return InsideEllipsoid(p, this->settings.skinRadii); }
  double Nose(const glm::dvec3& p) const
  {
    return InsideEllipsoid(
      p - glm::dvec3(0.0, -this->outer.y + 18.0, -42.0), glm::dvec3(11.0, 22.0, 17.0));
  }
  double Bone(const glm::dvec3& p) const
  {
    double bone = std::min(InsideEllipsoid(p, this->outer), -InsideEllipsoid(p, this->inner));
    bone = std::min(bone, p.z - this->settings.skullBaseMm);
    bone = std::min(bone, -this->Nose(p));
    for (const glm::dvec3& eye : this->orbit)
      bone = std::min(bone, glm::length(p - eye) - 19.0);
    return this->settings.defect ? std::min(bone, -this->Defect(p)) : bone;
  }
  double Defect(const glm::dvec3& p) const
  {
    const glm::dvec3 d = p - this->hole.center;
    const double slot =
      InsideRoundedSlot({ glm::dot(d, this->hole.along), glm::dot(d, this->hole.across) },
        { 0.5 * DefectLengthMm, 0.5 * DefectWidthMm }, DefectCornerMm);
    return std::min(slot, glm::dot(d, this->hole.outward) + 30.0); // not through the far side
  }

  PhantomSettings settings;
  glm::dvec3 outer, inner;
  glm::dvec3 orbit[2];
  PhantomDefect hole;
};

/// 0 far outside, 1 far inside, 1/2 on the surface: a cubic step of the given width.
double SoftStep(double inside, double width)
{
  const double t = std::clamp(0.5 + inside / width, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Noise that depends on the sample's number alone, so that threads do not matter:
/// splitmix64 twice, then Box-Muller.
double Normal(std::uint64_t seed, std::uint64_t sample)
{
  const auto uniform = [](std::uint64_t x)
  {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return (double((x ^ (x >> 31)) >> 11) + 0.5) * 0x1p-53; // in (0,1)
  };
  const std::uint64_t key = seed * 0xd1342543de82ef95U + 2 * sample;
  return std::sqrt(-2.0 * std::log(uniform(key))) *
         std::cos(glm::two_pi<double>() * uniform(key + 1));
}

double ValueHU(const Head& head, const glm::dvec3& p)
{
  const PhantomSettings& s = head.settings;
  const double body =
    SoftStep(std::min(head.Skin(p), -head.Nose(p)), s.edgeMm) * (s.softHU - s.airHU) + s.airHU;
  return body + SoftStep(head.Bone(p), s.edgeMm) * (s.boneHU - body);
}

} // namespace

AnalyticVolume PhantomBone(const PhantomSettings& settings)
{
  Check(settings);
  return { "phantom bone",
    [head = Head(settings)](const glm::dvec3& p) { return head.Bone(p - head.settings.center); },
    1.0 };
}

glm::dvec3 PhantomOuterTable(const PhantomSettings& settings, const glm::dvec3& direction)
{
  Check(settings);
  const double along = glm::length(direction / (settings.skinRadii - settings.scalpMm));
  if (!(along > 0.0 && std::isfinite(along)))
    throw std::invalid_argument("phantom: the direction has no length");
  return settings.center + direction / along;
}

PhantomDefect DefectOf(const PhantomSettings& settings)
{
  PhantomDefect defect{};
  defect.center = PhantomOuterTable(settings, glm::normalize(glm::dvec3(-0.45, -0.70, 0.55)));
  const glm::dvec3 radii = settings.skinRadii - settings.scalpMm;
  defect.outward = glm::normalize((defect.center - settings.center) / (radii * radii));
  const glm::dvec3 sideways = glm::normalize(glm::cross(defect.outward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(sideways, defect.outward);
  defect.along = glm::normalize(0.8 * sideways + 0.6 * up); // skew: no symmetry hides a flip
  defect.across = glm::cross(defect.outward, defect.along);
  defect.lengthMm = DefectLengthMm;
  defect.widthMm = DefectWidthMm;
  return defect;
}

std::vector<std::int16_t> SamplePhantom(
  const GridGeometry& geometry, const PhantomSettings& settings)
{
  Check(settings);
  geometry.Validate();
  const Head head(settings);
  std::vector<std::int16_t> samples(geometry.Size());
  const auto slices = [&](std::int64_t first, std::int64_t last)
  {
    std::size_t n = static_cast<std::size_t>(first) * geometry.dims.x * geometry.dims.y;
    for (std::int64_t k = first; k < last; ++k)
      for (int j = 0; j < geometry.dims.y; ++j)
        for (int i = 0; i < geometry.dims.x; ++i, ++n)
        {
          double value =
            ValueHU(head, geometry.IndexToWorld({ i, j, double(k) }) - settings.center);
          if (settings.noiseHU > 0.0)
            value += settings.noiseHU * Normal(settings.seed, n);
          samples[n] = static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
        }
  };
  ParallelFor(0, geometry.dims.z, 4, slices);
  return samples;
}

GridGeometry PhantomGrid(const glm::dvec3& spacing, const PhantomSettings& settings)
{
  Check(settings);
  for (int a = 0; a < 3; ++a)
    RequirePositive(spacing[a], "spacing");
  GridGeometry grid;
  grid.spacing = spacing;
  const glm::dvec3 half = settings.skinRadii + 4.0;
  grid.dims = glm::ivec3(glm::ceil(2.0 * half / spacing)) + 1;
  grid.origin = settings.center - 0.5 * spacing * glm::dvec3(grid.dims - 1);
  grid.Validate();
  return grid;
}

} // namespace hasp
