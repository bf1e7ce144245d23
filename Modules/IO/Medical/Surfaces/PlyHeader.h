#pragma once
#include "Surfaces/SurfaceBuilder.h"

#include <cstdint>
#include <vector>

namespace hasp
{

class FileBytes;

enum class PlyType
{
  Int8,
  Uint8,
  Int16,
  Uint16,
  Int32,
  Uint32,
  Float32,
  Float64
};
std::size_t PlyBytes(PlyType type);

enum class PlyEncoding
{
  Text,
  LittleEndian,
  BigEndian
};

/// What a property is to us.
enum class PlyRole
{
  Other,
  X,
  Y,
  Z,
  Corners
};

struct PlyProperty
{
  PlyRole role;
  PlyType type;
  bool list;
  PlyType countType; ///< of a list
};

struct PlyElement
{
  enum Kind
  {
    Other,
    Vertex,
    Face
  } kind;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

/// A header that has been found good: one vertex element with x, y and z and one face element with
/// a list of corners, no count of which the rest of the file is too short for.
struct PlyHeader
{
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  SurfaceNotes notes;
};

/// Reads up to and with end_header. Throws std::runtime_error with the line.
PlyHeader ReadPlyHeader(FileBytes& bytes);

} // namespace hasp
