#include "SeedFiles.h"

#include "Isosurface/Testing/CellFixture.h"
#include "vtkHaspCellFile.h"

#include "vtk_zlib.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace hasp
{
namespace
{

template <typename T>
void MakeSeed(const std::filesystem::path& file, CellPrecision precision, bool attributes)
{
  const GridGeometry grid{ { 13, 11, 18 }, { -31, 12, 100 }, { 0.5, 0.75, 1.25 }, glm::dmat3(1) };
  const auto samples = testing::Noise<T>(grid);
  ClusteredCells cells =
    testing::CellsOf(GridView<const T>{ samples.data(), grid }, 100.5, precision);
  if (attributes)
  {
    cells.labels.assign(cells.count, 3);
    for (const CellCluster& cluster : cells.clusters)
    {
      cells.firstColors.push_back(static_cast<std::uint32_t>(cells.colors.size()));
      cells.colors.resize(cells.colors.size() + cluster.CornerCount(), 0xFF204060U);
    }
  }
  WriteCells(cells, file.string());
}

} // namespace

void MakeCellSeeds(const std::filesystem::path& folder)
{
  MakeSeed<std::int16_t>(folder / "int16.hcells", CellPrecision::Exact, false);
  MakeSeed<std::uint8_t>(folder / "uint8.hcells", CellPrecision::Exact, true);
  MakeSeed<float>(folder / "float32.hcells", CellPrecision::Exact, false);
  MakeSeed<float>(folder / "compact.hcells", CellPrecision::Compact, true);
}

std::string SealCells(const std::string& bytes)
{
  constexpr std::size_t body = 216, head = 220, end = 224; // of the checksums, as the page says
  if (bytes.size() < end)
    return bytes;
  std::string sealed = bytes;
  const auto put = [&](std::size_t at, std::string_view of)
  {
    const auto sum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(of.data()), static_cast<uInt>(of.size())));
    std::memcpy(sealed.data() + at, &sum, sizeof sum);
  };
  put(body, std::string_view(sealed).substr(end));
  put(head, std::string_view(sealed).substr(0, head));
  return sealed;
}

void UseCells(const ClusteredCells& cells)
{
  float sum = 0.0F;
  for (std::size_t n = 0; n < cells.Count(); ++n)
  {
    const glm::ivec3 cell = cells.Cell(n);
    const CellCluster& cluster = cells.clusters[cells.ClusterOf(n)];
    for (const float corner : cells.CornersFromIsovalue(cluster, cell - cluster.Origin()))
      sum += corner;
    if (cells.Find(cell) != n)
      std::abort(); // a lie has passed
  }
  [[maybe_unused]] const volatile float used = sum;
}

} // namespace hasp
