#include "Haptics/PointArrays.h"

#include <algorithm>

namespace hasp
{

PointArrays::PointArrays(std::uint32_t count, bool areas)
  : Count(Padded(count)),
    HasAreas(areas),
    Memory(static_cast<float*>(::operator new[](this->Bytes(), std::align_val_t(64))))
{
  float* const memory = this->Memory.get();
  std::fill(memory, memory + 3 * std::size_t(this->Count), ContactPoints::FarAway);
  std::fill(memory + 3 * std::size_t(this->Count), memory + this->Bytes() / sizeof(float), 0.0F);
}

void PointArrays::Set(std::uint32_t n, const glm::vec3& position, const glm::vec3& normal) noexcept
{
  float* at = this->Memory.get() + n;
  for (const float value : { position.x, position.y, position.z, normal.x, normal.y, normal.z })
  {
    *at = value;
    at += this->Count;
  }
}

glm::vec3 PointArrays::Position(std::uint32_t n) const noexcept
{
  const float* at = this->Memory.get() + n;
  return { at[0], at[this->Count], at[2 * std::size_t(this->Count)] };
}

glm::vec3 PointArrays::Normal(std::uint32_t n) const noexcept
{
  const float* at = this->Memory.get() + n + 3 * std::size_t(this->Count);
  return { at[0], at[this->Count], at[2 * std::size_t(this->Count)] };
}

ContactPoints PointArrays::View(std::uint32_t first, std::uint32_t count, float area) const noexcept
{
  const auto column = [&](Column c)
  { return this->Memory.get() + c * std::size_t(this->Count) + first; };
  return { column(X), column(Y), column(Z), column(NormalX), column(NormalY), column(NormalZ),
    this->HasAreas ? column(Area) : nullptr, area, count };
}

} // namespace hasp
