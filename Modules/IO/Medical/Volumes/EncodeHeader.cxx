#include "Volumes/EncodeHeader.h"
#include "Volumes/NiftiHeader.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

namespace hasp
{
namespace
{

std::ostringstream ExactText()
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10); // reads back bit by bit
  return text;
}

/// Largest distance of a corner from where it should be, after float32, mm.
double WorstCorner(const NiftiHeader& header, const GridGeometry& geometry, bool flipX, bool flipY)
{
  const NiftiAffine stored = SformOf(DecodeNiftiHeader(EncodeNiftiHeader(header)));
  double worst = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 last(geometry.dims - 1);
    const glm::dvec3 at(corner & 1 ? last.x : 0.0, corner & 2 ? last.y : 0.0,
      corner & 4 ? last.z : 0.0); // in the order of the file
    const glm::dvec3 index(flipX ? last.x - at.x : at.x, flipY ? last.y - at.y : at.y, at.z);
    const glm::dvec3 world = geometry.IndexToWorld(index);
    const glm::dvec3 ras = stored.matrix * at + stored.shift;
    worst = std::max(worst, glm::length(world - glm::dvec3(-ras.x, -ras.y, ras.z)));
  }
  return worst;
}

} // namespace

std::size_t BytesOf(SampleType type)
{
  constexpr std::size_t bytes[] = { 2, 2, 1, 4 };
  return bytes[static_cast<int>(type)];
}

VolumeHeader EncodeMetaImage(const GridGeometry& g, SampleType type)
{
  constexpr const char* types[] = { "MET_SHORT", "MET_USHORT", "MET_UCHAR", "MET_FLOAT" };
  std::ostringstream header = ExactText();
  const auto three = [&](const char* key, const auto& v)
  { header << key << " = " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = False\nTransformMatrix =";
  for (int a = 0; a < 3; ++a)
    for (int row = 0; row < 3; ++row)
      header << " " << g.direction[a][row];
  header << "\n";
  three("Offset", g.origin);
  three("ElementSpacing", g.spacing);
  three("DimSize", g.dims);
  header << "ElementType = " << types[static_cast<int>(type)] << "\nElementDataFile = LOCAL\n";
  return { header.str() };
}

VolumeHeader EncodeNrrd(
  const GridGeometry& g, SampleType type, bool compressed, const std::string& more)
{
  constexpr const char* types[] = { "int16", "uint16", "uint8", "float" };
  std::ostringstream header = ExactText();
  const auto vector = [&](const glm::dvec3& v)
  { header << " (" << v.x << "," << v.y << "," << v.z << ")"; };
  header << "NRRD0005\ntype: " << types[static_cast<int>(type)]
         << "\ndimension: 3\nspace: left-posterior-superior\nsizes: " << g.dims.x << " " << g.dims.y
         << " " << g.dims.z << "\nspace directions:";
  for (int a = 0; a < 3; ++a)
    vector(g.direction[a] * g.spacing[a]);
  header << "\nkinds: domain domain domain\nendian: little\nencoding: "
         << (compressed ? "gzip" : "raw") << "\nspace origin:";
  vector(g.origin);
  header << "\n" << more << "\n";
  return { header.str() };
}

VolumeHeader EncodeNifti(const GridGeometry& g, SampleType type)
{
  VolumeHeader header;
  NiftiHeader nifti = NiftiFor(g, header.flipX, header.flipY);
  constexpr int datatypes[] = { 4, 512, 2, 16 };
  nifti.datatype = datatypes[static_cast<int>(type)];
  nifti.bitpix = static_cast<int>(8 * BytesOf(type));
  const bool large = std::max({ g.dims.x, g.dims.y, g.dims.z }) > 32767;
  if (large || !(WorstCorner(nifti, g, header.flipX, header.flipY) <= 1e-4))
    nifti.version = 2;
  header.bytes = EncodeNiftiHeader(nifti);
  return header;
}

} // namespace hasp
