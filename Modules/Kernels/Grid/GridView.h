#pragma once
#include "Grid/GridGeometry.h"

#include <cstdint>
#include <variant>

namespace hasp
{

/// A volume that somebody else owns: a pointer to dims.x*dims.y*dims.z samples, x fastest, and
/// where they lie. Copying a view copies no samples. Use GridView<const T> to read.
template <typename T>
struct GridView
{
  T* data = nullptr;
  GridGeometry geometry;

  std::size_t Offset(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * geometry.dims.y + j) * geometry.dims.x + i;
  }
  T& operator()(int i, int j, int k) const { return data[Offset(i, j, k)]; }
};

/// The sample types every kernel reads. Anything else is converted at the door (CommonVolume).
using AnyGridView = std::variant<GridView<const std::int16_t>, GridView<const std::uint16_t>,
  GridView<const std::uint8_t>, GridView<const float>>;

inline const GridGeometry& GeometryOf(const AnyGridView& grid)
{
  return std::visit([](const auto& view) -> const GridGeometry& { return view.geometry; }, grid);
}

} // namespace hasp
