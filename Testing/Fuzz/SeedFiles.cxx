#include "SeedFiles.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <glm/geometric.hpp>

#if HASP_WITH_LIBARCHIVE
#include <archive.h>
#include <archive_entry.h>
#endif

#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

GridGeometry SmallGrid()
{
  GridGeometry grid;
  grid.dims = { 9, 7, 5 };
  grid.origin = { -31.5, 12.25, 100.5 };
  grid.spacing = { 0.5, 0.75, 1.25 };
  const glm::dvec3 row = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 column = glm::normalize(glm::cross(glm::dvec3(0.1, 0.4, 1.0), row));
  grid.direction = glm::dmat3(row, column, glm::cross(row, column));
  return grid;
}

template <typename T>
vtkSmartPointer<vtkImageData> SmallImage()
{
  const GridGeometry grid = SmallGrid();
  std::vector<T> samples(grid.Size());
  for (std::size_t n = 0; n < samples.size(); ++n)
    samples[n] = static_cast<T>(n % 251);
  return MakeImage(grid, samples);
}

} // namespace

void MakeVolumeSeeds(const std::filesystem::path& folder, const std::string& fileName)
{
  WriteVolume(SmallImage<std::int16_t>(), folder / ("int16-" + fileName));
  WriteVolume(SmallImage<std::uint16_t>(), folder / ("uint16-" + fileName));
  WriteVolume(SmallImage<std::uint8_t>(), folder / ("uint8-" + fileName));
  WriteVolume(SmallImage<float>(), folder / ("float32-" + fileName));
}

void MakeSegmentationSeeds(const std::filesystem::path& folder)
{
  WriteSegmentation(
    SmallImage<std::uint8_t>(), { { 1, "one", {} }, { 7, "seven", {} } }, folder / "a.seg.nrrd");
  // Two layers, raw, as 3D Slicer writes them.
  std::ofstream(folder / "b.seg.nrrd", std::ios::binary)
    << "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
       "sizes: 2 4 3 2\nspace directions: none (0.5,0,0) (0,0.75,0) (0,0,2)\n"
       "kinds: list domain domain domain\nencoding: raw\nspace origin: (-3,4,5.5)\n"
       "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment1_ID:=b\n"
       "Segment1_LabelValue:=1\nSegment1_Layer:=1\n\n"
    << std::string("\1\0\0\1", 4) << std::string(44, '\0');
}

namespace
{

constexpr const char* TextStl =
  "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
  "vertex 10 0 0\nvertex 0 20 0\nendloop\nendfacet\nfacet normal 1 0 0\n"
  "outer loop\nvertex 0 0 0\nvertex 0 20 0\nvertex 0 0 30.125\n"
  "endloop\nendfacet\nendsolid t\n";
constexpr const char* TextPly =
  "ply\nformat ascii 1.0\ncomment SPACE=RAS\nelement vertex 4\nproperty double x\n"
  "property double y\nproperty double z\nproperty uchar red\nelement face 2\n"
  "property list uchar int vertex_indices\nend_header\n0 0 0 1\n10 0 0 2\n0 20 0 3\n"
  "0 0 30.125 4\n3 0 1 2\n4 0 1 2 3\n";
constexpr const char* TextObj =
  "# SPACE=RAS\no a\nv 0 0 0\nv 10 0 0\nv 0 20 0\nv 0 0 30.125\nvt 0 0\nvn 0 0 1\n"
  "f 1/1/1 2/1/1 3/1/1\nf -1 -2 -3 \\\n-4\nusemtl m\nf 1//1 2//1 4//1\n";

vtkSmartPointer<vtkPolyData> SmallSurface()
{
  return MakePolyData({ { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 20, 0 }, { 0, 0, 30.125 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } });
}

} // namespace

void MakeSurfaceSeeds(const std::filesystem::path& folder, const std::string& fileName)
{
  const std::string ending = std::filesystem::path(fileName).extension();
  if (ending == ".vtp")
  {
    for (const bool appended : { true, false })
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetFileName((folder / (appended ? "appended.vtp" : "inline.vtp")).c_str());
      writer->SetInputData(SmallSurface());
      appended ? writer->SetDataModeToAppended() : writer->SetDataModeToAscii();
      if (writer->Write() != 1)
        throw std::runtime_error("the seed surface cannot be written");
    }
    return;
  }
  WriteSurface(SmallSurface(), folder / ("binary" + ending));
  if (ending == ".3mf")
    return; // has no text form
  const char* text = ending == ".stl" ? TextStl : ending == ".ply" ? TextPly : TextObj;
  std::ofstream(folder / ("text" + ending), std::ios::binary) << text;
}

#if HASP_WITH_LIBARCHIVE
namespace
{

constexpr const char* PropertyList = R"(<?xml version="1.0" encoding="UTF-8"?>
<plist version="1.0"><dict>
  <key>matrix</key><dict>
    <key>dtype</key><string>int16</string>
    <key>filename</key><string>matrix.dat</string>
    <key>shape</key><array><integer>5</integer><integer>7</integer><integer>9</integer></array>
  </dict>
  <key>modality</key><string>CT</string>
  <key>orientation</key><integer>1</integer>
  <key>spacing</key><array><real>0.5</real><real>0.75</real><real>1.25</real></array>
</dict></plist>)";

void AddEntry(archive* to, const std::string& name, const std::string& bytes)
{
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(
    archive_entry_new(), archive_entry_free);
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
  if (archive_write_header(to, entry.get()) != ARCHIVE_OK ||
      archive_write_data(to, bytes.data(), bytes.size()) != la_ssize_t(bytes.size()))
    throw std::runtime_error("the seed archive cannot be written");
}

} // namespace

/// Packed, and plain: faults in a gzipped file rarely get past its checksum.
void MakeInvesaliusSeeds(const std::filesystem::path& folder)
{
  for (const bool packed : { true, false })
  {
    const std::unique_ptr<archive, int (*)(archive*)> to(archive_write_new(), archive_write_free);
    if (packed)
      archive_write_add_filter_gzip(to.get());
    archive_write_set_format_gnutar(to.get());
    archive_write_set_bytes_in_last_block(to.get(), 1);
    archive_write_open_filename(to.get(), (folder / (packed ? "gzip.inv3" : "tar.inv3")).c_str());
    AddEntry(to.get(), "t/main.plist", PropertyList);
    AddEntry(to.get(), "t/matrix.dat", std::string(std::size_t(2) * 5 * 7 * 9, '\1'));
    if (archive_write_close(to.get()) != ARCHIVE_OK)
      throw std::runtime_error("the seed archive cannot be written");
  }
}
#endif

} // namespace hasp
