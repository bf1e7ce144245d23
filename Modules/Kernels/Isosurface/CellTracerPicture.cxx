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

/// body(pixel, first, columns) for each row of a packet that lies in the picture: `columns` pixels
/// from `pixel` on are those of the packet from `first` on.
template <typename Body>
void EachRow(const glm::ivec2& from, const TracedPicture& picture, const Body& body)
{
  const int columns = std::min(PacketSide, picture.size.x - from.x);
  const int rows = std::min(PacketSide, picture.size.y - from.y);
  for (int y = 0; y < rows; ++y)
    body(static_cast<std::size_t>(from.y + y) * picture.size.x + from.x, y * PacketSide, columns);
}

void Write(const CellPixels& pixels, const glm::ivec2& from, TracedPicture& picture)
{
  EachRow(from, picture,
    [&](std::size_t pixel, int first, int columns)
    {
      std::copy_n(pixels.cells + first, columns, &picture.cells[pixel]);
      std::copy_n(pixels.gradients + first, columns, &picture.gradients[pixel]);
      if (picture.places.empty())
        return;
      std::copy_n(pixels.places + first, columns, &picture.places[pixel]);
      std::copy_n(pixels.corners + first, columns, &picture.corners[pixel]);
    });
}

/// Nothing is hit.
void WriteBackground(const glm::ivec2& from, TracedPicture& picture)
{
  EachRow(from, picture,
    [&](std::size_t pixel, int, int columns)
    {
      std::fill_n(&picture.cells[pixel], columns, TracedPicture::Nothing);
      std::fill_n(
        &picture.gradients[pixel], columns, glm::vec4(0.0F, 0.0F, 0.0F, TracedPicture::NoDepth));
    });
}

} // namespace

void CellTracer::TracePicture(const PictureView& view, TracedPicture& picture, bool places) const
{
  if (view.size.x < 0 || view.size.y < 0)
    throw std::invalid_argument("CellTracer: a picture of " + std::to_string(view.size.x) + " x " +
                                std::to_string(view.size.y) + " pixels; both must be >= 0");
  const PictureRays rays(view);
  const std::size_t pixels = static_cast<std::size_t>(view.size.x) * view.size.y;
  picture.size = view.size;
  picture.cells.resize(pixels);
  picture.gradients.resize(pixels);
  if (places)
  {
    picture.places.resize(pixels);
    picture.corners.resize(pixels);
  }
  else // their memory goes, too
  {
    picture.places = std::vector<glm::vec3>();
    picture.corners = std::vector<glm::ivec3>();
  }

  const auto packet = [&](const glm::ivec2& from)
  {
    PacketRays given;
    CellPacket::Rays some = PixelsOfPacket(rays, from, given);
    CellPacket walks;
    some &= this->Embree->Enter(given, walks);
    if (some == 0)
      return WriteBackground(from, picture);
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
