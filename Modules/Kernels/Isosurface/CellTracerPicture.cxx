#include "Grid/ParallelFor.h"
#include "Isosurface/CellTracer.h"
#include "Isosurface/CellTracerScene.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr int TileSide = 16;  // pixels: one piece of work
constexpr int PacketSide = 4; // rays of a packet lie close together

/// Depth of a place in a window, [0,1].
float WindowDepth(const glm::dmat4& indexToClip, const glm::dvec3& place)
{
  const glm::dvec4 clip = indexToClip * glm::dvec4(place, 1.0);
  return static_cast<float>(std::clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0));
}

} // namespace

void CellTracer::TracePicture(const PictureView& view, TracedPicture& picture) const
{
  if (view.size.x < 0 || view.size.y < 0)
    throw std::invalid_argument("CellTracer: a picture of " + std::to_string(view.size.x) + " x " +
                                std::to_string(view.size.y) + " pixels; both must be >= 0");
  const PictureRays rays(view);
  const std::size_t pixels = static_cast<std::size_t>(view.size.x) * view.size.y;
  picture.size = view.size;
  picture.cells.assign(pixels, TracedPicture::Nothing);
  picture.places.assign(pixels, glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));
  picture.gradients.assign(pixels, glm::vec4(0.0F));

  const auto packet = [&](const glm::ivec2& from)
  {
    CellWalkRay walks[Scene::PacketSize];
    CellWalkEntry entries[Scene::PacketSize];
    bool any = false;
    for (int n = 0; n < Scene::PacketSize; ++n)
    {
      const glm::ivec2 at = from + glm::ivec2(n % PacketSide, n / PacketSide);
      CellRay ray;
      const bool meets = at.x < view.size.x && at.y < view.size.y &&
                         rays.Of(glm::dvec2(at) + 0.5, ray) &&
                         this->Embree->Enter(ray, walks[n], entries[n]);
      if (!meets)
        walks[n].inverse[3] = -1.0; // begins after its end
      any |= meets;
    }
    if (!any)
      return;
    this->Embree->Nearest(walks);
    for (int n = 0; n < Scene::PacketSize; ++n)
    {
      if (!walks[n].Hit())
        continue;
      const glm::ivec2 at = from + glm::ivec2(n % PacketSide, n / PacketSide);
      const CellHit hit = this->Embree->HitOf(walks[n], entries[n]);
      const std::size_t pixel = static_cast<std::size_t>(at.y) * view.size.x + at.x;
      picture.cells[pixel] = hit.number;
      picture.places[pixel] = { hit.local, WindowDepth(view.indexToClip, hit.Position()) };
      picture.gradients[pixel] = { hit.gradient, 0.0F };
    }
  };
  const glm::ivec2 tiles = (view.size + TileSide - 1) / TileSide;
  const auto tile = [&](std::int64_t first, std::int64_t last)
  {
    for (std::int64_t t = first; t < last; ++t)
    {
      const glm::ivec2 from = TileSide * glm::ivec2(t % tiles.x, t / tiles.x);
      for (int y = from.y; y < std::min(from.y + TileSide, view.size.y); y += PacketSide)
        for (int x = from.x; x < std::min(from.x + TileSide, view.size.x); x += PacketSide)
          packet({ x, y });
    }
  };
  ParallelFor(0, static_cast<std::int64_t>(tiles.x) * tiles.y, 1, tile);
}

} // namespace hasp
