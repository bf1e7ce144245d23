#include "CellsText.h"

#include "Isosurface/ClusteredCells.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <sstream>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

const char* SampleType(const ClusteredCells& cells)
{
  return cells.cornerType == CornerType::Float32 ? "float32"
         : cells.cornerType == CornerType::Int16 ? "int16"
                                                 : "uint16 or uint8";
}

bool IsCompact(const ClusteredCells& cells)
{
  return cells.precision == CellPrecision::Compact;
}

double PerCell(const ClusteredCells& cells)
{
  return cells.Count() == 0 ? 0.0 : double(cells.Bytes()) / double(cells.Count());
}

double MeshShare(const ClusteredCells& cells)
{
  return cells.Count() == 0 ? 0.0 : double(cells.Bytes()) / double(CellMeshBytes(cells.Count()));
}

std::string Figure(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// What the same surface would take as a mesh.
std::string MeshText(const ClusteredCells& cells)
{
  if (cells.Count() == 0)
    return "no surface";
  const std::size_t mesh = CellMeshBytes(cells.Count());
  return "as compact indexed triangles the surface takes " + std::to_string(mesh) + " bytes, " +
         Figure("%.1f", double(mesh) / double(cells.Bytes())) + " times as many";
}

template <typename Vector>
std::string Three(const Vector& v, const char* between)
{
  std::ostringstream text;
  text << v.x << between << v.y << between << v.z;
  return text.str();
}

template <typename Vector>
Json ThreeJson(const Vector& v)
{
  return { v.x, v.y, v.z };
}

} // namespace

std::size_t CellMeshBytes(std::size_t cells)
{
  return cells * (3 * 2 + 2 + 2 * 3 * 4);
}

std::string CellsText(const ClusteredCells& cells)
{
  const GridGeometry& g = cells.geometry;
  std::ostringstream text;
  text << "cells       " << cells.Count() << "\nclusters    " << cells.clusters.size()
       << "\nbytes       " << cells.Bytes() << ", " << Figure("%.2f", PerCell(cells))
       << " a cell\nmesh        " << MeshText(cells) << "\nisovalue    " << cells.isovalue
       << "\nprecision   "
       << (IsCompact(cells) ? "compact: 8 bits a corner, the sign exact"
                            : "exact: corners are the volume's samples")
       << "\nsamples     " << Three(g.dims, " x ") << ", " << SampleType(cells) << "\nspacing     "
       << Three(g.spacing, " x ") << " mm\norigin      " << Three(g.origin, ", ")
       << " mm (patient LPS)";
  for (int axis = 0; axis < 3; ++axis)
    text << "\n"
         << "ijk"[axis] << " axis      " << Three(g.direction[axis] + 0.0, ", ");
  text << "\nattributes  " << (cells.labels.empty() ? "no labels" : "labels") << ", "
       << (cells.colors.empty() ? "no colours" : "colours") << "\n";
  return text.str();
}

Json CellsJson(const ClusteredCells& cells)
{
  const GridGeometry& g = cells.geometry;
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({ g.direction[0][row], g.direction[1][row], g.direction[2][row] });
  return { { "cells", cells.Count() }, { "clusters", cells.clusters.size() },
    { "bytes", cells.Bytes() }, { "bytes_per_cell", PerCell(cells) },
    { "mesh_share", MeshShare(cells) }, { "isovalue", cells.isovalue },
    { "precision", IsCompact(cells) ? "compact" : "exact" }, { "sample_type", SampleType(cells) },
    { "dims", ThreeJson(g.dims) }, { "spacing_mm", ThreeJson(g.spacing) },
    { "origin_mm", ThreeJson(g.origin) }, { "direction", rows },
    { "labels", !cells.labels.empty() }, { "colors", !cells.colors.empty() } };
}

} // namespace hasp
