#include "Isosurface/SharedLight.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

void SharedLight::Keep(const PictureView& view, const TracedPicture& picture,
  const PictureLight& light, const PictureLightSettings& settings)
{
  this->Settings = settings;
  this->Size = view.size;
  this->IndexToClip = view.indexToClip;
  this->Eye = glm::inverse(view.indexToClip) * glm::dvec4(0, 0, -1, 0);
  if (this->Eye.w != 0.0)
    this->Eye /= this->Eye.w;
  this->DepthRow = glm::row(view.indexToClip, 2);
  this->WRow = glm::row(view.indexToClip, 3);
  const glm::dvec3 w(this->WRow), depth(this->DepthRow);
  this->Along = SameSurfaceVoxels * glm::normalize(glm::dot(w, w) > 0.0 ? w : depth);
  this->Pixels.resize(light.size());
  ParallelFor(0, static_cast<std::int64_t>(light.size()), 16'384,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        this->Pixels[n] = { picture.gradients[n].w, light[n] };
    });
}

bool SharedLight::IsOf(const PictureLightSettings& settings) const
{
  constexpr double rounding = 1e-5; // mappers read lights in float, in the coordinates of a view
  const std::optional<glm::dvec4>&now = settings.light, &then = this->Settings.light;
  const bool same =
    now && then ? glm::length(*now - *then) <= rounding * glm::length(*now) : !now && !then;
  return same && settings.ambientDistanceMm == this->Settings.ambientDistanceMm;
}

std::optional<glm::u8vec2> SharedLight::At(const CellHit& hit) const
{
  const glm::dvec3 place = hit.Position(), direction = place * this->Eye.w - glm::dvec3(this->Eye);
  if ((glm::dot(glm::dvec3(hit.gradient), direction) < 0.0) != hit.fromInside)
    return std::nullopt;
  const glm::dvec4 clip = this->IndexToClip * glm::dvec4(place, 1.0);
  const glm::dvec2 pixel = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * glm::dvec2(this->Size) - 0.5;
  if (!(clip.w > 0.0 && pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < this->Size.x - 1 &&
        pixel.y < this->Size.y - 1))
    return std::nullopt;
  const double device = clip.z / clip.w;
  const double change =
    glm::dot(glm::dvec3(this->DepthRow) - device * glm::dvec3(this->WRow), this->Along);
  const auto depth = static_cast<float>(0.5 * device + 0.5),
             tolerance = static_cast<float>(std::abs(0.5 * change / clip.w));
  const glm::ivec2 corner(pixel);
  const glm::vec2 share(pixel - glm::dvec2(corner));
  const Pixel* lower = &this->Pixels[static_cast<std::size_t>(corner.y) * this->Size.x + corner.x];
  const Pixel* upper = lower + this->Size.x;
  for (const Pixel* at : { lower, lower + 1, upper, upper + 1 })
    if (at->light.y != lower->light.y || !(std::abs(at->depth - depth) <= tolerance))
      return std::nullopt;
  const auto mix = [&](const auto& of)
  {
    const auto row = [&](const Pixel* at) { return of(at[0]) + share.x * (of(at[1]) - of(at[0])); };
    return row(lower) + share.y * (row(upper) - row(lower));
  };
  constexpr auto closer = static_cast<float>(OwnSurfaceVoxels / SameSurfaceVoxels);
  if (!(std::abs(mix([](const Pixel& of) { return of.depth; }) - depth) <= closer * tolerance))
    return std::nullopt;
  const float open = mix([](const Pixel& of) { return float(of.light.x); });
  return glm::u8vec2(static_cast<std::uint8_t>(open + 0.5F), lower->light.y);
}

} // namespace hasp
