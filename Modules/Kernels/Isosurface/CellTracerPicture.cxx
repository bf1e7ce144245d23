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

constexpr int TileSide = 16; // pixels: one piece of work
constexpr int PacketSide = CellPacket::Side;

/// What a picture has where nothing is hit.
const CellPixels& Background()
{
  static const CellPixels pixels = []
  {
    CellPixels none{};
    for (int n = 0; n < CellPacket::Size; ++n)
    {
      none.gradients[n].w = TracedPicture::NoDepth;
      none.cells[n] = TracedPicture::Nothing;
    }
    return none;
  }();
  return pixels;
}

/// Writes the pixels of a packet that lie in the picture.
void Write(const CellPixels& pixels, const glm::ivec2& from, TracedPicture& picture)
{
  const int columns = std::min(PacketSide, picture.size.x - from.x);
  const int rows = std::min(PacketSide, picture.size.y - from.y);
  for (int y = 0; y < rows; ++y)
  {
    const int first = y * PacketSide;
    const std::size_t pixel = static_cast<std::size_t>(from.y + y) * picture.size.x + from.x;
    std::copy_n(pixels.cells + first, columns, &picture.cells[pixel]);
    std::copy_n(pixels.gradients + first, columns, &picture.gradients[pixel]);
    std::copy_n(pixels.places + first, columns, &picture.places[pixel]);
  }
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
  picture.cells.resize(pixels);
  picture.gradients.resize(pixels);
  picture.places.resize(pixels);

  const auto packet = [&](const glm::ivec2& from)
  {
    PacketRays given;
    CellPacket::Rays some = PixelsOfPacket(rays, from, given);
    CellPacket walks;
    some &= this->Embree->Enter(given, walks);
    if (some == 0)
      return Write(Background(), from, picture);
    this->Embree->Nearest(some, walks);
    CellPixels found;
    this->Embree->PixelsOf(walks, some, view.indexToClip, found);
    Write(found, from, picture);
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
