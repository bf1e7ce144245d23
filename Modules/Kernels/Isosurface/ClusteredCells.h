#pragma once
#include "Grid/GridView.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

namespace glsl
{
using glm::uvec2;
using glm::uvec3;
using uint = std::uint32_t;
#define HASP_FUNCTION inline
#include "Isosurface/glsl/CellLayout.glsl"
#undef HASP_FUNCTION
} // namespace glsl

/// How corner samples are stored: as the volume has them, lossless.
enum class CornerType
{
  Int16,
  UInt16, ///< also volumes of uint8
  Float32
};

/// The cells that an isosurface crosses, each with its 8 corner samples, in clusters of 8x8x8
/// cells: all that drawing the exact trilinear surface takes; the volume may go (thesis 3.2.2,
/// Paper VI).
///
/// words     Count() cells of Stride() words, laid out as glsl/CellLayout.glsl says; ready for the
/// GPU.
///           Cells of a cluster are neighbours, clusters follow the volume's raster order.
/// clusters  two words each
/// firstCells  where each cluster's cells begin, and at the end Count(); the CPU culls clusters by
/// it Values: corners are inside where corner >= isovalue. Immutable once made; any thread may
/// read.
struct ClusteredCells
{
  GridGeometry geometry;
  float isovalue = 0.0F;
  CornerType cornerType = CornerType::Int16;
  std::vector<std::uint32_t> words;
  std::vector<glm::uvec2> clusters;
  std::vector<std::uint32_t> firstCells{ 0 };

  std::size_t Stride() const
  {
    return this->cornerType == CornerType::Float32 ? glsl::HaspFloatCellWords
                                                   : glsl::HaspIntegerCellWords;
  }
  std::size_t Count() const { return this->words.size() / this->Stride(); }
  std::size_t Bytes() const
  {
    return (this->words.size() + this->firstCells.size()) * sizeof(std::uint32_t) +
           this->clusters.size() * sizeof(glm::uvec2);
  }

  /// The volume cell of active cell n: its corner (0,0,0) is sample Cell(n).
  glm::ivec3 Cell(std::size_t n) const;
  /// Its 8 samples, x fastest, exactly as the volume holds them.
  std::array<float, 8> Corners(std::size_t n) const;
};

} // namespace hasp
