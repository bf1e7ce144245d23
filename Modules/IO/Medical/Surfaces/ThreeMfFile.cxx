#include "Files/FileError.h"
#include "Surfaces/SurfaceFormat.h"
#include "XML/XMLProcess.h"

#include <algorithm>

namespace hasp
{
namespace
{

constexpr std::uint64_t Most = std::uint64_t(1) << 40; // sums stay far from 2^64

struct Unit
{
  double mm;
  const char* name;
};
constexpr Unit Units[] = { { 1e-3, "micrometres" }, { 1.0, "mm" }, { 10.0, "centimetres" },
  { 25.4, "inches" }, { 304.8, "feet" }, { 1000.0, "metres" } };

/// Visits `count` records of the child's, in pieces.
template <typename T, typename Visit>
void ReadAll(XMLProcess& process, std::uint64_t count, const Visit& visit)
{
  std::vector<T> piece(std::min<std::uint64_t>(count, 1 << 14));
  for (std::uint64_t left = count; left > 0; left -= piece.size())
  {
    piece.resize(std::min<std::uint64_t>(left, piece.size()));
    process.Read(piece.data(), piece.size() * sizeof(T));
    for (const T& record : piece)
      visit(record);
  }
}

/// What lies before the first NUL; empty if there is none.
template <std::size_t Size>
std::string_view TextIn(const char (&text)[Size])
{
  const char* end = std::find(text, text + Size, '\0');
  return end == text + Size ? std::string_view() : std::string_view(text, end - text);
}

/// The objects after `record`. Texts of the file are compared, and never shown.
std::vector<SurfacePiece> ReadObjects(
  XMLProcess& process, const ThreeMfRecord& record, double mm, SurfaceBuilder& builder)
{
  std::vector<SurfacePiece> pieces;
  std::uint64_t points = 0, triangles = 0;
  for (std::uint32_t n = 1; n <= record.objects; ++n)
  {
    ThreeMfObject object{};
    process.Read(&object, sizeof(object));
    if (object.points > record.points - points || object.triangles > record.triangles - triangles)
      process.ThrowGarbage("more points or triangles than it announced");
    const std::string name(TextIn(object.name));
    pieces.push_back({ IsPartName(name) ? name : "object " + std::to_string(n),
      std::size_t(triangles), std::size_t(object.triangles) });
    std::uint64_t at = points;
    ReadAll<glm::dvec3>(process, object.points,
      [&](const glm::dvec3& point) {
        builder.AddPoint(point * mm, { "point", ++at });
      });
    std::uint64_t face = triangles;
    ReadAll<glm::uvec3>(process, object.triangles,
      [&](const glm::uvec3& corners)
      {
        if (std::max({ corners.x, corners.y, corners.z }) >= object.points)
          process.ThrowGarbage("a corner that is no point of its object");
        const std::uint32_t own[] = { std::uint32_t(points + corners.x),
          std::uint32_t(points + corners.y), std::uint32_t(points + corners.z) };
        builder.AddFace(own, { "triangle", ++face });
      });
    points += object.points;
    triangles += object.triangles;
  }
  if (points != record.points || triangles != record.triangles)
    process.ThrowGarbage("fewer points or triangles than it announced");
  return pieces;
}

} // namespace

LoadedSurface ReadThreeMf(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress)
{
  XMLProcess process(XMLProcess::ThreeMf, "surface", file,
    { settings.decoderMemoryBytes, settings.decoderSilenceSeconds, settings.decoderTotalSeconds,
      ". Is it damaged? Write it again, or raise decoderMemoryBytes" },
    progress);
  const auto record = process.Answer<ThreeMfRecord>();
  if (record.status == static_cast<std::uint32_t>(XMLStatus::TooMany))
    ThrowFileError(file, "builds more than 100000 objects, or has components 64 deep; this is no "
                         "part. Export its bodies alone");
  if (record.status != static_cast<std::uint32_t>(XMLStatus::Good))
    ThrowFileError(file, "is damaged or no 3MF file; write it again");
  if (record.unit >= std::size(Units) || record.objects > ThreeMfRecord::MostObjects ||
      record.points > Most || record.triangles > Most)
    process.ThrowGarbage("size");
  SurfaceBuilder builder(file, settings);
  builder.Expect(record.points, record.triangles);
  const Unit& unit = Units[record.unit];
  std::vector<SurfacePiece> pieces = ReadObjects(process, record, unit.mm, builder);
  process.Finish();
  if (unit.mm != 1.0)
    builder.Warn(std::string("the file is in ") + unit.name + "; it was scaled to mm");
  SurfaceNotes notes;
  notes.Look(TextIn(record.description));
  LoadedSurface loaded = builder.Finish("3MF", "zip", notes);
  loaded.passport.pieces = std::move(pieces);
  return loaded;
}

} // namespace hasp
