#include "Haptics/PointRing.h"

#include <algorithm>

namespace hasp
{

PointRing::PointRing(std::uint32_t points)
  : Arrays(points, true),
    All(this->Arrays.Size() / ChunkPoints)
{
}

std::int32_t PointRing::Take() noexcept
{
  if (this->UsedCount == this->Chunks())
    return None;
  while (this->All[this->Head].used)
    this->Head = (this->Head + 1) % this->Chunks();
  const auto taken = static_cast<std::int32_t>(this->Head);
  this->Head = (this->Head + 1) % this->Chunks();
  this->All[taken] = Chunk();
  this->All[taken].used = true;
  ++this->UsedCount;
  return taken;
}

void PointRing::GiveBack(std::int32_t chunk) noexcept
{
  for (int column = 0; column < PointArrays::Columns; ++column)
    std::fill_n(this->Arrays[PointArrays::Column(column)] + FirstOf(chunk), ChunkPoints,
      column <= PointArrays::Z ? ContactPoints::FarAway : 0.0F);
  this->All[chunk].used = false;
  --this->UsedCount;
}

void PointRing::Kill(std::int32_t chunk, std::uint32_t n) noexcept
{
  this->SetPoint(chunk, n, glm::vec3(ContactPoints::FarAway), glm::vec3(0.0F));
}

void PointRing::SetArea(std::int32_t chunk, float mm2) noexcept
{
  std::fill_n(this->Arrays[PointArrays::Area] + FirstOf(chunk), ChunkPoints, mm2);
}

} // namespace hasp
