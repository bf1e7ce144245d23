#include "Cells/CellFile.h"
#include "Files/AtomicFile.h"
#include "Files/FileBytes.h"
#include "Files/FileError.h"
#include "vtkHaspCellFile.h"

#include "Isosurface/ValidateCells.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace hasp
{
namespace
{

static_assert(std::endian::native == std::endian::little, "the file is as memory is");

constexpr std::size_t Piece = std::size_t(1) << 20; ///< bytes between two reports of progress

std::uint32_t Checksum(std::uint32_t before, const void* bytes, std::size_t size)
{
  return static_cast<std::uint32_t>(
    crc32(before, static_cast<const Bytef*>(bytes), static_cast<uInt>(size)));
}

std::uint32_t HeadChecksum(const CellFileHead& head)
{
  return Checksum(0, &head, offsetof(CellFileHead, headChecksum));
}

/// f(values, how many the head declares) for what follows the head, in the order of the file.
template <typename Head, typename Cells, typename F>
void ForEachPart(Head& head, Cells& cells, const F& f)
{
  f(cells.clusters, head.clusters);
  f(cells.corners, head.corners);
  f(cells.levels, head.levels);
  f(cells.labels, head.labels);
  f(cells.colors, head.colors);
  f(cells.firstColors, head.firstColors);
}

/// Part [from, to] of the whole.
ProgressFunction Share(const ProgressFunction& whole, double from, double to)
{
  if (!whole)
    return {};
  return [whole, from, to](double share) { return whole(from + share * (to - from)); };
}

CellFileHead HeadOf(const ClusteredCells& cells)
{
  CellFileHead head{};
  std::memcpy(head.magic, CellFileHead::Magic, sizeof head.magic);
  head.version = CellFileHead::Version;
  head.bytes = sizeof head;
  const GridGeometry& g = cells.geometry;
  for (int a = 0; a < 3; ++a)
  {
    head.dims[a] = g.dims[a];
    head.origin[a] = g.origin[a];
    head.spacing[a] = g.spacing[a];
    for (int world = 0; world < 3; ++world)
      head.direction[3 * a + world] = g.direction[a][world];
  }
  head.isovalue = cells.isovalue;
  head.cornerType = static_cast<std::uint32_t>(cells.cornerType);
  head.precision = static_cast<std::uint32_t>(cells.precision);
  head.cells = cells.count;
  ForEachPart(head, cells, [](const auto& values, std::uint64_t& count) { count = values.size(); });
  return head;
}

/// Room for what the head declares; what the numbers mean is for ValidateCells to ask.
ClusteredCells CellsOf(const CellFileHead& head)
{
  ClusteredCells cells;
  GridGeometry& g = cells.geometry;
  for (int a = 0; a < 3; ++a)
  {
    g.dims[a] = head.dims[a];
    g.origin[a] = head.origin[a];
    g.spacing[a] = head.spacing[a];
    for (int world = 0; world < 3; ++world)
      g.direction[a][world] = head.direction[3 * a + world];
  }
  cells.isovalue = head.isovalue;
  cells.cornerType = static_cast<CornerType>(head.cornerType);
  cells.precision = static_cast<CellPrecision>(head.precision);
  cells.count = head.cells;
  ForEachPart(head, cells, [](auto& values, std::uint64_t count) { values.resize(count); });
  return cells;
}

CellFileHead ReadHead(FileBytes& file)
{
  CellFileHead head;
  if (file.Peek(sizeof head.magic) !=
      std::string_view(CellFileHead::Magic, sizeof CellFileHead::Magic))
    ThrowIsNoCells(file.File());
  file.Read(&head, sizeof head);
  if (head.version != CellFileHead::Version)
    ThrowFileError(file.File(), "is of version " + std::to_string(head.version) +
                                  " of the format, version 1 is read; make it again from the "
                                  "volume");
  if (head.headChecksum != HeadChecksum(head) || head.bytes != sizeof head)
    ThrowFileError(file.File(), "its head is damaged: the checksum differs. Copy it again");
  return head;
}

/// Before memory is taken.
void CheckSizes(const FileBytes& file, const CellFileHead& head, std::size_t limitBytes)
{
  std::uint64_t declared = 0;
  bool tooLong = false;
  const ClusteredCells none;
  ForEachPart(head, none,
    [&](const auto& values, std::uint64_t count)
    {
      tooLong = tooLong || count > file.Left() / sizeof(values[0]); // and so no sum can overflow
      declared += tooLong ? 0 : count * sizeof(values[0]);
    });
  if (tooLong || declared > file.Left())
    ThrowFileError(file.File(), "declares more cells than its " + std::to_string(file.Size()) +
                                  " bytes hold: it is cut off or damaged. Copy it again");
  if (declared < file.Left())
    ThrowFileError(file.File(), "holds " + std::to_string(file.Left() - declared) +
                                  " bytes more than it declares: it is damaged. Copy it again");
  if (declared > limitBytes)
    ThrowFileError(file.File(), "its cells take " + std::to_string(declared) +
                                  " bytes, the limit is " + std::to_string(limitBytes) +
                                  "; raise it");
}

std::uint32_t ReadBody(FileBytes& file, CellFileHead& head, ClusteredCells& cells)
{
  std::uint32_t sum = 0;
  ForEachPart(head, cells,
    [&](auto& values, std::uint64_t)
    {
      auto* bytes = reinterpret_cast<char*>(values.data());
      for (std::size_t left = values.size() * sizeof(values[0]); left > 0;)
      {
        const std::size_t size = std::min(left, Piece);
        file.Read(bytes, size);
        sum = Checksum(sum, bytes, size);
        bytes += size;
        left -= size;
      }
    });
  return sum;
}

/// f(bytes, size) for pieces of all that follows the head.
template <typename F>
void ForEachPiece(
  CellFileHead& head, const ClusteredCells& cells, const ProgressFunction& progress, const F& f)
{
  std::size_t done = 0;
  const std::size_t all = std::max<std::size_t>(cells.Bytes(), 1);
  ForEachPart(head, cells,
    [&](const auto& values, std::uint64_t)
    {
      const auto* bytes = reinterpret_cast<const char*>(values.data());
      for (std::size_t left = values.size() * sizeof(values[0]); left > 0;)
      {
        ReportProgress(progress, double(done) / double(all));
        const std::size_t size = std::min(left, Piece);
        f(bytes, size);
        bytes += size;
        left -= size;
        done += size;
      }
    });
}

} // namespace

bool IsCellFileName(const std::string& path)
{
  return LowerExtension(std::filesystem::u8path(path)) == ".hcells";
}

void ThrowIsNoCells(const std::filesystem::path& file)
{
  ThrowFileError(file,
    "holds no active cells: it does not begin as they do. If it is a volume, give it its own "
    "ending back (.mha, .nrrd and so on); hasp cells makes active cells of it");
}

void RefuseCells(const std::string& path, const std::string& wanted)
{
  const std::filesystem::path name = std::filesystem::u8path(path);
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) // a pipe would wait
    return;
  char start[sizeof CellFileHead::Magic] = {};
  std::ifstream(name, std::ios::binary).read(start, sizeof start);
  if (std::memcmp(start, CellFileHead::Magic, sizeof start) != 0)
    return;
  const std::string then = IsCellFileName(path)
                             ? "hasp render draws them, hasp info describes them"
                             : "rename it to end in .hcells, and hasp render draws them";
  ThrowFileError(name, "holds active cells of an isosurface, no " + wanted + ": " + then +
                         "; for all else give the volume they were made of");
}

std::shared_ptr<const ClusteredCells> LoadCells(
  const std::string& path, const CellReadSettings& settings, const ProgressFunction& progress)
{
  const std::filesystem::path name = std::filesystem::u8path(path);
  FileBytes file(name, Share(progress, 0.0, 0.5));
  CellFileHead head = ReadHead(file);
  CheckSizes(file, head, settings.memoryLimitBytes);
  auto cells = std::make_shared<ClusteredCells>(CellsOf(head));
  if (ReadBody(file, head, *cells) != head.bodyChecksum)
    ThrowFileError(name, "its cells are damaged: the checksum differs. Copy it again");
  try
  {
    ValidateCells(*cells, Share(progress, 0.5, 1.0));
  }
  catch (const std::invalid_argument& fault)
  {
    ThrowFileError(name, std::string(fault.what()) + ". Make it again from the volume");
  }
  return cells;
}

void WriteCells(
  const ClusteredCells& cells, const std::string& path, const ProgressFunction& progress)
{
  const std::filesystem::path name = std::filesystem::u8path(path);
  if (!IsCellFileName(path))
    ThrowFileError(name, "active cells are written as .hcells; give the name this ending");
  ValidateCells(cells, Share(progress, 0.0, 0.4));
  CellFileHead head = HeadOf(cells);
  ForEachPiece(head, cells, Share(progress, 0.4, 0.6),
    [&](const char* bytes, std::size_t size)
    { head.bodyChecksum = Checksum(head.bodyChecksum, bytes, size); });
  head.headChecksum = HeadChecksum(head);
  AtomicFile output(name);
  output.Write(&head, sizeof head);
  ForEachPiece(head, cells, Share(progress, 0.6, 1.0),
    [&](const char* bytes, std::size_t size) { output.Write(bytes, size); });
  output.Commit();
  if (progress)
    progress(1.0); // it is written: too late to cancel
}

} // namespace hasp
