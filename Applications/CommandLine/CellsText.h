#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hasp
{

struct ClusteredCells;

/// What active cells are, a line a fact: numbers, bytes, precision, place.
std::string CellsText(const ClusteredCells& cells);

/// The same. "mesh_share" is their bytes over those of an indexed mesh of the same surface as
/// CellMeshBytes counts them.
nlohmann::ordered_json CellsJson(const ClusteredCells& cells);

/// Bytes of an indexed mesh of a closed surface that crosses so many cells, as small as is usual:
/// three 16-bit coordinates and an octahedral normal for each vertex, of which there is about one a
/// cell, and three 32-bit indices for each of two triangles.
std::size_t CellMeshBytes(std::size_t cells);

} // namespace hasp
