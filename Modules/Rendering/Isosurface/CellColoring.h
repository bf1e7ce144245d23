#ifndef CellColoring_h
#define CellColoring_h

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

/// How scalars colour the surface. Neither of both and no ClusteredCells::colors: they do not.
struct CellColoring
{
  /// RGBA in [0, 1] of the whole surface.
  std::optional<glm::vec4> uniform;
  /// Not empty: the cells' colours are places in this table, floats in [0, 1] bit by bit, to be
  /// interpolated first. RGBA as ClusteredCells::colors.
  std::vector<std::uint32_t> table;
  bool translucent = false;
};

} // namespace hasp

#endif
