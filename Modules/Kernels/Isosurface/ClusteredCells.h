#pragma once
#include "Grid/GridView.h"

#include <glm/integer.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

namespace glsl
{
using glm::bitCount;
using glm::max;
using glm::min;
using glm::uvec2;
using glm::uvec3;
using uint = std::uint32_t;
#define HASP_FUNCTION inline
#include "Isosurface/glsl/CellLayout.glsl"
#undef HASP_FUNCTION
} // namespace glsl

/// What the volume's samples are.
enum class CornerType
{
  Int16,
  UInt16, ///< also volumes of uint8
  Float32
};

enum class CellPrecision
{
  Exact,  ///< corners are the volume's samples, bit for bit
  Compact ///< 8 bits a corner: CompactLevels; the sign of sample - isovalue is exact
};

/// Up to 8x8x8 neighbouring cells: which are active and where their corners are. The words that
/// glsl/CellLayout.glsl describes, seen from C++.
struct CellCluster
{
  std::array<std::uint64_t, 8> active{};        ///< a word a slice z; bit y << 3 | x
  std::array<std::uint16_t, 8> cornersBefore{}; ///< corner slices 1..8
  std::uint32_t firstWord = 0;                  ///< of its corners in ClusteredCells::corners
  std::uint32_t firstCell = 0;                  ///< number of its first active cell
  glm::uvec2 place{ 0 };                        ///< origin, width and base, packed

  glm::ivec3 Origin() const { return glm::ivec3(glsl::HaspClusterOrigin(this->place)); }
  int Width() const { return static_cast<int>(glsl::HaspCornerWidth(this->place)); }
  std::uint16_t Base() const
  {
    return static_cast<std::uint16_t>(glsl::HaspCornerBase(this->place));
  }
  int CellCount() const;
  /// Corners stored. At most 729.
  int CornerCount() const;
  bool Active(const glm::ivec3& inCluster) const
  {
    return this->active[inCluster.z] >> (inCluster.y << 3 | inCluster.x) & 1;
  }
  bool operator==(const CellCluster&) const = default;
  /// The cells that touch corner slice z, 0..8, or-ed.
  std::uint64_t TouchSlice(int z) const
  {
    return (z > 0 ? this->active[z - 1] : 0) | (z < 8 ? this->active[z] : 0);
  }
};
static_assert(sizeof(CellCluster) == glsl::HaspClusterWords * sizeof(std::uint32_t));

/// The cells that an isosurface crosses, with their corner samples, in clusters of 8x8x8 cells: all
/// that drawing the exact trilinear surface takes; the volume may go (thesis 3.2.2, Paper VI).
///
/// The paper stores 8 corners a cell. Here a corner is stored once a cluster, and its place follows
/// from the cells' bits: 4 to 5 bytes a cell of an int16 CT in place of 20.
///
/// clusters   in the volume's raster order, each with at least one active cell
/// corners    the bits of all clusters' corners, each cluster from a word of its own; two words of
///            padding at the end, so that a pair of corners can be read in one go
/// levels     Compact only: what each of the 128 magnitudes stands for, see CompactLevels
/// labels     empty, or one a cell (AddLabels)
/// colors     empty, or RGBA, 8 bits each, red lowest, one a stored corner (AddColors);
/// firstColors  then also where each cluster's colours begin
/// Corners are inside where corner >= isovalue. Immutable once made; any thread may read.
struct ClusteredCells
{
  GridGeometry geometry;
  float isovalue = 0.0F;
  CornerType cornerType = CornerType::Int16;
  CellPrecision precision = CellPrecision::Exact;
  std::size_t count = 0; ///< active cells
  std::vector<CellCluster> clusters;
  std::vector<std::uint32_t> corners;
  std::vector<float> levels;
  std::vector<std::uint16_t> labels;
  std::vector<std::uint32_t> colors;
  std::vector<std::uint32_t> firstColors;

  std::size_t Count() const { return this->count; }
  /// Of everything, attributes included.
  std::size_t Bytes() const;

  /// The cluster that active cell n belongs to. O(log clusters).
  std::size_t ClusterOf(std::size_t n) const;
  /// The volume cell of active cell n: its corner (0,0,0) is sample Cell(n). O(log clusters).
  glm::ivec3 Cell(std::size_t n) const;
  /// The number of the active cell at this place; nothing if it is not active. O(log clusters).
  std::optional<std::size_t> Find(const glm::ivec3& cell) const;
  /// Its 8 samples minus the isovalue, x fastest, as drawing and ray tracing see them: the
  /// subtraction is done in float. inCluster must be active.
  std::array<float, 8> CornersFromIsovalue(
    const CellCluster& cluster, const glm::ivec3& inCluster) const;
  /// The sample that a stored corner of the cluster is; Exact only.
  float SampleOf(const CellCluster& cluster, std::uint32_t stored) const;
  /// The 8 samples of active cell n, exactly as the volume holds them. Throws std::logic_error if
  /// the cells are Compact: they do not know.
  std::array<float, 8> Corners(std::size_t n) const;
};

/// The levels of compact cells (CompactCells) for samples that lie up to `range` from the isovalue:
/// the magnitude m stands for c (exp(h (m + 1/2)) - 1) with c = range / 1000 and h = ln(1001) /
/// 128, so steps grow with the distance from the isovalue and every magnitude is known to
/// within 2.7 % + c / 40. Where the surface crosses an edge it moves by less than 0.0135 voxel +
/// what c does; about 0.004 RMS. The law is one for the whole volume: neighbouring clusters agree
/// on the corners they share. 128 values, ascending, all > 0. Throws std::invalid_argument unless
/// range is finite and > 0.
std::vector<float> CompactLevels(double range);

} // namespace hasp
