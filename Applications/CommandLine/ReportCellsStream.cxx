// A volume larger than what one wants to hold: extracted from its file in slabs, drawn and traced,
// by a process of its own whose memory is watched.
#include "ReportCellsParts.h"

#include "CellChecks.h"
#include "Grid/Phantom.h"
#include "Isosurface/ClusteredCells.h"
#include "MeasuredChild.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeSlabReader.h"
#include "vtkHaspVolumeSlabs.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

constexpr double GiB = 1024.0 * 1024.0 * 1024.0;

/// The figures are there; the file they were made from is to go.
struct Measured : std::exception
{
};

void WriteHead(ReportContext& context, const std::string& path, int n)
{
  PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.8);
  settings.noiseHU = 25.0;
  settings.seed = context.settings.seed;
  const GridGeometry grid = PhantomGridOfSize(glm::ivec3(n), settings);
  VolumeSlabWriter writer(path, grid, SampleType::Int16);
  const std::size_t slice = std::size_t(n) * n;
  const int thickness = std::clamp(int((std::size_t(1) << 25) / slice), 1, n);
  std::vector<std::int16_t> slab(slice * thickness);
  for (int k = 0; k < n; k += thickness)
  {
    const int last = std::min(k + thickness, n);
    const std::span<std::int16_t> samples = std::span(slab).first(slice * (last - k));
    SamplePhantomSlab(grid, settings, k, last, samples);
    writer.Append(samples);
    context.progress(double(last) / n, "");
  }
  writer.Commit();
}

/// Cells and corners that are not the file's, by brute force.
std::size_t WrongCells(const std::string& volume, const ClusteredCells& cells)
{
  VolumeSlabReader reader(volume, {});
  const int slices = cells.geometry.dims.z;
  std::size_t wrong = 0;
  for (int first = 0; first + 1 < slices; first += 8)
  {
    const LosslessCheck check =
      CheckLosslessSlab(reader.Read(first, std::min(9, slices - first)), first, cells);
    wrong += check.activeInVolume - check.cells + check.wrongCorners;
  }
  return wrong;
}

/// A run of `hasp` that must succeed; what it held goes into the row's text, the most into its
/// value.
double Run(const char* what, const std::vector<std::string>& arguments, ReportRow& row)
{
  const MeasuredChild use = RunMeasured(arguments);
  if (use.exitCode != 0)
    throw std::runtime_error(std::string(what) + " ended with exit code " +
                             std::to_string(use.exitCode) + ": " + use.error);
  char text[140];
  std::snprintf(text, sizeof text, "; %s held %.3f GiB (%.3f with mapped files), %.1f s", what,
    double(use.heldBytes) / GiB, double(use.residentBytes) / GiB, use.seconds);
  row.data += text;
  row.value = std::max(row.value.value_or(0.0), double(use.heldBytes) / GiB);
  row.timeS = row.timeS.value_or(0.0) + use.seconds;
  row.cpuS = row.cpuS.value_or(0.0) + use.cpuSeconds;
  return use.seconds;
}

void MeasureStream(ReportContext& context, const std::string& volume, int n, const std::string& tag)
{
  const std::filesystem::path folder = std::filesystem::path(volume).parent_path();
  const std::string cellFile = (folder / "cells.hcells").string();
  ReportRow row;
  row.id = "cells.stream.gib" + tag;
  row.unit = "GiB anonymous and shared memory, resident at most";
  row.better = Better::Lower;
  row.data = "phantom head, " + std::to_string(n) + "^3 int16 on disk, 300 HU";
  const auto draw = [&](const char* renderer)
  {
    return std::vector<std::string>{ "render", cellFile, "--quiet", "--renderer", renderer,
      "--output", (folder / "picture.png").string() };
  };
  context.progress(
    0.3, "cells: extracting, drawing and tracing " + std::to_string(n) + "^3 samples");
  double first = Run(
    "extraction", { "cells", volume, "--isovalue", "300", "--quiet", "--output", cellFile }, row);
#if HASP_WITH_RAYS
  first += Run("tracing", draw("trace"), row);
  Run("rasterising", draw("rasterize"), row);
#else
  first += Run("rasterising", draw("rasterize"), row);
#endif
  context.progress(0.7, "cells: checking what was extracted");
  const auto cells = LoadCells(cellFile);
  row.error = double(WrongCells(volume, *cells));
  row.errorUnit = "cells and corners that differ from the file";
  char text[160];
  std::snprintf(text, sizeof text,
    "the volume whole in memory and vtkFlyingEdges3D's mesh of 88 bytes a cell, as computed: %.2f "
    "GiB",
    (2.0 * n * n * n + 88.2 * double(cells->Count())) / GiB);
  row.rival = text;
  row.data += "; " + std::to_string(cells->Count()) + " active cells";
  ReportRow image = row;
  image.id = "cells.stream.first" + tag;
  image.value = first;
  image.unit = "s from the file to the first picture";
  context.report.rows.insert(context.report.rows.end(), { row, image });
}

} // namespace

void ReportCellStream(ReportContext& context, int n)
{
  const std::string tag =
    n == 1024 ? std::string() : std::string("@").append(std::to_string(n)); // GCC 12 warns of +
  const char* const rival = "the volume whole in memory, its mesh beside it";
  const auto folder = std::filesystem::temp_directory_path();
  const double bytes = 2.0 * n * n * n;
  const double room = double(std::filesystem::space(folder).available);
  if (room < bytes + GiB)
  {
    char reason[100];
    std::snprintf(reason, sizeof reason,
      "needs %.1f GiB of room for a temporary file, there are %.1f", bytes / GiB + 1.0, room / GiB);
    context.report.rows.push_back(AbsentRow("cells.stream.gib" + tag, rival, reason));
    return;
  }
  context.progress(0.0, "cells: writing a phantom of " + std::to_string(n) + "^3 samples");
  try
  {
    WriteInspected((folder / "hasp-report-stream.mha").string(),
      [&](const std::string& path) { WriteHead(context, path, n); },
      [&](const std::string& path)
      {
        MeasureStream(context, path, n, tag);
        throw Measured();
      });
  }
  catch (const Measured&) // nothing is left of the file, nor is it after an error or a signal
  {
  }
}

} // namespace hasp
