#include "Files/FileError.h"
#include "Surfaces/SurfaceFormat.h"
#include "XML/XMLProcess.h"

#include <algorithm>

namespace hasp
{
namespace
{

template <typename T>
void ReadPoints(XMLProcess& process, std::uint64_t count, SurfaceBuilder& builder)
{
  std::vector<T> piece(3 * std::min<std::uint64_t>(count, 1 << 14));
  for (std::uint64_t done = 0; done < count;)
  {
    const std::uint64_t here = std::min<std::uint64_t>(count - done, piece.size() / 3);
    process.Read(piece.data(), 3 * here * sizeof(T));
    for (std::uint64_t n = 0; n < here; ++n, ++done)
      builder.AddPoint({ piece[3 * n], piece[3 * n + 1], piece[3 * n + 2] }, { "point", done + 1 });
  }
}

/// The words of the faces, through a buffer.
class FaceWords
{
public:
  FaceWords(XMLProcess& process, std::uint64_t count)
    : Process(process),
      Left(count),
      Piece(std::min<std::uint64_t>(count, 1 << 16)),
      Next(Piece.size())
  {
  }
  std::uint32_t Take()
  {
    if (this->Next == this->Piece.size())
    {
      this->Piece.resize(std::min<std::uint64_t>(this->Left, this->Piece.size()));
      if (this->Piece.empty())
        this->Process.ThrowGarbage("more corners than it announced");
      this->Process.Read(this->Piece.data(), this->Piece.size() * sizeof(std::uint32_t));
      this->Left -= this->Piece.size();
      this->Next = 0;
    }
    return this->Piece[this->Next++];
  }

private:
  XMLProcess& Process;
  std::uint64_t Left;
  std::vector<std::uint32_t> Piece;
  std::size_t Next;
};

void ReadFaces(XMLProcess& process, const XMLSurfaceRecord& record, SurfaceBuilder& builder)
{
  FaceWords words(process, record.faces + record.corners);
  std::vector<std::uint32_t> corners;
  std::uint64_t left = record.corners;
  for (std::uint64_t face = 1; face <= record.faces; ++face)
  {
    const std::uint32_t count = words.Take();
    if (count > left)
      process.ThrowGarbage("more corners than it announced");
    left -= count;
    corners.resize(count);
    for (std::uint32_t& corner : corners)
      corner = words.Take();
    builder.AddFace(corners, { "face", face });
  }
  if (left > 0)
    process.ThrowGarbage("fewer corners than it announced");
}

} // namespace

LoadedSurface ReadVtp(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress)
{
  XMLProcess process(XMLProcess::Vtk, "surface", file,
    { settings.decoderMemoryBytes, settings.decoderSilenceSeconds, settings.decoderTotalSeconds,
      ". Is it damaged? Write it again, or raise decoderMemoryBytes" },
    progress);
  const auto record = process.Answer<XMLSurfaceRecord>();
  if (record.status != static_cast<std::uint32_t>(XMLStatus::Good))
    ThrowFileError(file, "is damaged or no VTK surface file (.vtp); write it again");
  constexpr std::uint64_t most = std::uint64_t(1) << 40; // sums below stay far from 2^64
  if ((record.coordinateBytes != 4 && record.coordinateBytes != 8) || record.points > most ||
      record.faces > most || record.corners > most)
    process.ThrowGarbage("size");
  SurfaceBuilder builder(file, settings);
  // A face of fewer than three corners is refused below. So this bounds the corners of one, too.
  builder.Expect(record.points,
    std::max(record.faces, record.corners - std::min(record.corners, 2 * record.faces)));
  if (record.coordinateBytes == 4)
    ReadPoints<float>(process, record.points, builder);
  else
    ReadPoints<double>(process, record.points, builder);
  ReadFaces(process, record, builder);
  process.Finish();
  if (record.otherCells > 0)
    builder.Warn(std::to_string(record.otherCells) + " vertices and lines were left out");
  SurfaceNotes notes;
  notes.lps = record.saysLps != 0;
  notes.ras = record.saysRas != 0;
  notes.otherSpace = record.saysOther != 0;
  return builder.Finish("VTP", "XML", notes);
}

} // namespace hasp
