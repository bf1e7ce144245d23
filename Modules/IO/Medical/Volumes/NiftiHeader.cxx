#include "Volumes/NiftiHeader.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hasp
{
namespace
{

/// One field of the header, out of its bytes.
struct FieldReader
{
  std::string_view bytes;
  bool swap;

  template <typename Stored, typename Value>
  void Field(std::size_t at, Value& value) const
  {
    char raw[sizeof(Stored)];
    std::memcpy(raw, this->bytes.data() + at, sizeof(raw));
    if (this->swap)
      std::reverse(raw, raw + sizeof(raw));
    Stored stored;
    std::memcpy(&stored, raw, sizeof(raw));
    value = static_cast<Value>(stored);
  }
};

/// And into them.
struct FieldWriter
{
  std::string& bytes;

  template <typename Stored, typename Value>
  void Field(std::size_t at, const Value& value) const
  {
    const auto stored = static_cast<Stored>(value);
    std::memcpy(this->bytes.data() + at, &stored, sizeof(stored));
  }
};

template <typename Stored, typename Codec, typename Values>
void Array(const Codec& codec, std::size_t at, Values& values)
{
  for (auto& value : values)
  {
    codec.template Field<Stored>(at, value);
    at += sizeof(Stored);
  }
}

// Offsets of nifti1.h and nifti2.h. Header is const for writing.
template <typename Codec, typename Header>
void EachField(const Codec& c, Header& h)
{
  if (h.version == 1)
  {
    Array<std::int16_t>(c, 40, h.dim);
    c.template Field<std::int16_t>(70, h.datatype);
    c.template Field<std::int16_t>(72, h.bitpix);
    Array<float>(c, 76, h.pixdim);
    c.template Field<float>(108, h.voxOffset);
    c.template Field<float>(112, h.slope);
    c.template Field<float>(116, h.intercept);
    c.template Field<std::uint8_t>(123, h.units);
    c.template Field<std::int16_t>(252, h.qformCode);
    c.template Field<std::int16_t>(254, h.sformCode);
    Array<float>(c, 256, h.quatern);
    Array<float>(c, 268, h.qoffset);
    Array<float>(c, 280, h.srow);
    return;
  }
  c.template Field<std::int16_t>(12, h.datatype);
  c.template Field<std::int16_t>(14, h.bitpix);
  Array<std::int64_t>(c, 16, h.dim);
  Array<double>(c, 104, h.pixdim);
  c.template Field<std::int64_t>(168, h.voxOffset);
  c.template Field<double>(176, h.slope);
  c.template Field<double>(184, h.intercept);
  c.template Field<std::int32_t>(344, h.qformCode);
  c.template Field<std::int32_t>(348, h.sformCode);
  Array<double>(c, 352, h.quatern);
  Array<double>(c, 376, h.qoffset);
  Array<double>(c, 400, h.srow);
  c.template Field<std::int32_t>(500, h.units);
}

constexpr std::size_t MagicAt[] = { 0, 344, 4 };
const std::string Magic[] = { {}, { "n+1\0", 4 }, { "n+2\0\r\n\x1a\n", 8 } };

std::int32_t SizeField(std::string_view start, bool swap)
{
  std::int32_t size = 0;
  FieldReader{ start, swap }.Field<std::int32_t>(0, size);
  return size;
}

} // namespace

int NiftiVersion(std::string_view start)
{
  if (start.size() < 4)
    return 0;
  for (const bool swap : { false, true })
    for (const int version : { 1, 2 })
      if (SizeField(start, swap) == std::int32_t(NiftiHeaderBytes[version]))
        return version;
  return 0;
}

NiftiHeader DecodeNiftiHeader(std::string_view bytes)
{
  NiftiHeader header;
  header.version = NiftiVersion(bytes);
  header.bigEndian = SizeField(bytes, false) != std::int32_t(NiftiHeaderBytes[header.version]);
  EachField(FieldReader{ bytes, header.bigEndian }, header);
  header.singleFile =
    bytes.substr(MagicAt[header.version], 4) == Magic[header.version].substr(0, 4);
  return header;
}

std::string EncodeNiftiHeader(const NiftiHeader& from)
{
  NiftiHeader header = from;
  const std::size_t size = NiftiHeaderBytes[header.version];
  header.voxOffset = static_cast<double>(size + 4);
  std::string bytes(size + 4, '\0');
  const FieldWriter writer{ bytes };
  writer.Field<std::int32_t>(0, size);
  EachField(writer, header);
  bytes.replace(MagicAt[header.version], Magic[header.version].size(), Magic[header.version]);
  return bytes;
}

NiftiAffine SformOf(const NiftiHeader& h)
{
  NiftiAffine affine;
  for (int row = 0; row < 3; ++row)
  {
    for (int a = 0; a < 3; ++a)
      affine.matrix[a][row] = h.srow[4 * row + a];
    affine.shift[row] = h.srow[4 * row + 3];
  }
  return affine;
}

NiftiAffine QformOf(const NiftiHeader& h)
{
  double b = h.quatern[0], c = h.quatern[1], d = h.quatern[2];
  double a = 1.0 - (b * b + c * c + d * d);
  if (a < 1e-7) // a half turn, within float32: the specification scales b, c and d
  {
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length;
    c /= length;
    d /= length;
    a = 0.0;
  }
  a = std::sqrt(a);
  NiftiAffine affine;
  affine.matrix[0] = { a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c) };
  affine.matrix[1] = { 2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b) };
  affine.matrix[2] = { 2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c };
  for (int axis = 0; axis < 3; ++axis)
  {
    affine.matrix[axis] *= h.pixdim[1 + axis] * (axis == 2 && h.pixdim[0] < 0.0 ? -1.0 : 1.0);
    affine.shift[axis] = h.qoffset[axis];
  }
  return affine;
}

NiftiHeader NiftiFor(const GridGeometry& g, bool& flipX, bool& flipY)
{
  // The third axis needs no turning: qfac stands for it, so that turning x alone, y alone or both
  // reaches each of the quaternion's four parts.
  glm::dmat3 rotation(1.0);
  double best = -2.0, qfac = 1.0;
  for (int turn = 0; turn < 4; ++turn)
  {
    glm::dmat3 r = g.direction;
    for (int a = 0; a < 3; ++a) // LPS to RAS
      r[a] = glm::dvec3(-r[a].x, -r[a].y, r[a].z) * (a < 2 && (turn & (1 << a)) ? -1.0 : 1.0);
    const double handed = glm::determinant(r) < 0.0 ? -1.0 : 1.0;
    r[2] *= handed;
    const double trace = r[0][0] + r[1][1] + r[2][2];
    if (trace <= best + 1e-6) // a tie keeps the fewer turns
      continue;
    best = trace;
    qfac = handed;
    rotation = r;
    flipX = turn & 1;
    flipY = turn & 2;
  }
  const double a = 0.5 * std::sqrt(1.0 + best);
  const glm::dvec3 last(g.dims - 1);
  const glm::dvec3 first = g.IndexToWorld({ flipX ? last.x : 0.0, flipY ? last.y : 0.0, 0.0 });
  const double shift[3] = { -first.x, -first.y, first.z };
  NiftiHeader h;
  h.dim[0] = 3;
  std::fill(h.dim + 4, h.dim + 8, 1);
  h.pixdim[0] = qfac;
  h.quatern[0] = (rotation[1][2] - rotation[2][1]) / (4.0 * a);
  h.quatern[1] = (rotation[2][0] - rotation[0][2]) / (4.0 * a);
  h.quatern[2] = (rotation[0][1] - rotation[1][0]) / (4.0 * a);
  for (int n = 0; n < 3; ++n)
  {
    h.dim[1 + n] = g.dims[n];
    h.pixdim[1 + n] = g.spacing[n];
    h.qoffset[n] = shift[n];
    for (int axis = 0; axis < 3; ++axis)
      h.srow[4 * n + axis] = rotation[axis][n] * g.spacing[axis] * (axis == 2 ? qfac : 1.0);
    h.srow[4 * n + 3] = shift[n];
  }
  h.slope = 1.0;
  h.qformCode = h.sformCode = 1; // NIFTI_XFORM_SCANNER_ANAT
  h.units = 2;                   // NIFTI_UNITS_MM
  return h;
}

} // namespace hasp
