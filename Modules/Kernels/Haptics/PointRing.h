#pragma once
#include "Haptics/PointArrays.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// A ring of points, taken and given back 16 at a time. HAPTIC; takes memory when it is made.
class PointRing
{
public:
  static constexpr std::uint32_t ChunkPoints = ContactPoints::Lanes;
  static constexpr std::int32_t None = -1;

  /// 16 points that belong together.
  struct Chunk
  {
    std::int32_t next = None; ///< of the same owner, older
    float fade = 0.0F;        ///< share of a point's area, in [0, 1]
    std::uint8_t alive = 0;   ///< points of the 16
    bool used = false;
    bool moved = false;    ///< to the present surface, from another
    bool leaving = false;  ///< fades out
    bool replaced = false; ///< of another surface, moved here: leaves when there are new ones
  };

  explicit PointRing(std::uint32_t points);

  std::uint32_t Chunks() const noexcept { return static_cast<std::uint32_t>(this->All.size()); }
  std::uint32_t Used() const noexcept { return this->UsedCount; }
  Chunk& operator[](std::int32_t chunk) noexcept { return this->All[chunk]; }
  /// The next chunk round the ring that is free; None if none is.
  std::int32_t Take() noexcept;
  /// Its points go far away.
  void GiveBack(std::int32_t chunk) noexcept;

  void SetPoint(std::int32_t chunk, std::uint32_t n, const glm::vec3& position,
    const glm::vec3& normal) noexcept
  {
    this->Arrays.Set(chunk * ChunkPoints + n, position, normal);
  }
  glm::vec3 Position(std::int32_t chunk, std::uint32_t n) const noexcept
  {
    return this->Arrays.Position(chunk * ChunkPoints + n);
  }
  bool Alive(std::int32_t chunk, std::uint32_t n) const noexcept
  {
    return this->Position(chunk, n).x != ContactPoints::FarAway;
  }
  void Kill(std::int32_t chunk, std::uint32_t n) noexcept;
  /// Of each of the chunk's points.
  void SetArea(std::int32_t chunk, float mm2) noexcept;
  /// All, the dead ones far away; none if no chunk is used.
  ContactPoints Points() const noexcept
  {
    return this->Arrays.View(0, this->UsedCount == 0 ? 0 : this->Arrays.Size(), 0.0F);
  }
  std::size_t Bytes() const noexcept
  {
    return this->Arrays.Bytes() + this->All.size() * sizeof(Chunk);
  }

private:
  static std::size_t FirstOf(std::int32_t chunk) noexcept
  {
    return static_cast<std::size_t>(chunk) * ChunkPoints;
  }

  PointArrays Arrays;
  std::vector<Chunk> All;
  std::uint32_t Head = 0, UsedCount = 0;
};

} // namespace hasp
