#pragma once
#include "Haptics/ContactPoints.h"

#include <cstddef>
#include <memory>
#include <new>

namespace hasp
{

/// The memory behind ContactPoints: positions and normals, and areas where each point has its own.
/// Every array is 64-byte aligned. All points start FarAway. Takes memory at construction only.
class PointArrays
{
public:
  enum Column
  {
    X,
    Y,
    Z,
    NormalX,
    NormalY,
    NormalZ,
    Area,
    Columns
  };
  PointArrays() = default;
  /// `count` is rounded up to whole vectors.
  PointArrays(std::uint32_t count, bool areas);

  static std::uint32_t Padded(std::uint32_t count)
  {
    return (count + ContactPoints::Lanes - 1) / ContactPoints::Lanes * ContactPoints::Lanes;
  }
  float* operator[](Column column) noexcept
  {
    return this->Memory.get() + column * std::size_t(this->Count);
  }
  std::uint32_t Size() const noexcept { return this->Count; }
  std::size_t Bytes() const noexcept
  {
    return sizeof(float) * this->Count * (this->HasAreas ? Columns : Area);
  }
  void Set(std::uint32_t n, const glm::vec3& position, const glm::vec3& normal) noexcept;
  glm::vec3 Position(std::uint32_t n) const noexcept;
  glm::vec3 Normal(std::uint32_t n) const noexcept;
  /// `count` points from `first` on, both whole vectors.
  ContactPoints View(std::uint32_t first, std::uint32_t count, float area) const noexcept;

private:
  struct Free
  {
    void operator()(float* memory) const noexcept
    {
      ::operator delete[](memory, std::align_val_t(64));
    }
  };
  std::uint32_t Count = 0;
  bool HasAreas = false;
  std::unique_ptr<float[], Free> Memory;
};

} // namespace hasp
