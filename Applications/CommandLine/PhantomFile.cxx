#include "PhantomFile.h"
#include "ProgressLine.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeSlabs.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

using nlohmann::ordered_json;

/// Samples of a slab: 128 MiB.
constexpr std::size_t SlabSamples = std::size_t{ 1 } << 26;
/// 4 GiB of samples: what readers take back by default.
constexpr std::size_t LargestWhole = std::size_t{ 1 } << 31;

ordered_json Point(const glm::dvec3& p)
{
  return { p.x, p.y, p.z };
}

std::size_t WriteWhole(const GridGeometry& grid, const PhantomSettings& settings,
  const std::string& path, ProgressLine& progress)
{
  if (grid.Size() > LargestWhole)
    throw std::invalid_argument("the phantom would have " + std::to_string(grid.Size()) +
                                " samples, as .vti at most " + std::to_string(LargestWhole) +
                                "; write .mha or .nrrd, or give a larger --spacing");
  progress.Step("sampling the phantom");
  std::vector<std::int16_t> samples(grid.Size());
  SamplePhantomSlab(grid, settings, 0, grid.dims.z, samples,
    [&](double share)
    {
      progress.Share(share);
      return true;
    });
  const vtkSmartPointer<vtkImageData> image = MakeImage(grid, std::move(samples));
  progress.Step("writing " + FileLabel(path));
  WriteVolume(image, path);
  return grid.Size() * sizeof(std::int16_t);
}

ordered_json Tissues(const PhantomSettings& s)
{
  return { { "air", s.airHU }, { "soft", s.softHU }, { "compact_bone", s.boneHU },
    { "diploe", s.diploeHU }, { "mandible_marrow", s.jawMarrowHU },
    { "fibula_marrow", s.fibulaMarrowHU }, { "dentine", s.dentineHU }, { "enamel", s.enamelHU } };
}

} // namespace

std::size_t WritePhantomFile(const GridGeometry& grid, const PhantomSettings& settings,
  const std::string& path, ProgressLine& progress)
{
  if (path.ends_with(".vti"))
    return WriteWhole(grid, settings, path, progress);
  VolumeSlabWriter writer(path, grid, SampleType::Int16);
  const std::size_t slice = static_cast<std::size_t>(grid.dims.x) * grid.dims.y;
  const int thickness =
    static_cast<int>(std::clamp<std::size_t>(SlabSamples / slice, 1, grid.dims.z));
  std::vector<std::int16_t> slab(slice * thickness);
  progress.Step("sampling and writing " + FileLabel(path));
  for (int k = 0; k < grid.dims.z; k += thickness)
  {
    const int last = std::min(k + thickness, grid.dims.z);
    const std::span<std::int16_t> samples = std::span(slab).first(slice * (last - k));
    SamplePhantomSlab(grid, settings, k, last, samples,
      [&](double share)
      {
        progress.Share((k + share * (last - k)) / grid.dims.z);
        return true;
      });
    writer.Append(samples);
  }
  writer.Commit();
  return slab.size() * sizeof(std::int16_t);
}

ordered_json DescribePhantom(const GridGeometry& grid, const PhantomSettings& settings)
{
  ordered_json all;
  all["samples"] = { grid.dims.x, grid.dims.y, grid.dims.z };
  all["spacing_mm"] = Point(grid.spacing);
  all["origin_mm"] = Point(grid.origin);
  all["direction"] = { Point(grid.direction[0]), Point(grid.direction[1]),
    Point(grid.direction[2]) };
  all["hounsfield"] = !settings.coneBeam.on;
  all["tissues_hu"] = Tissues(settings);
  if (settings.coneBeam.on)
    all["grey"] = { { "scale", settings.coneBeam.scale }, { "offset", settings.coneBeam.offset },
      { "cupping", settings.coneBeam.cupping } };
  all["parts"] = ordered_json::array();
  for (const PhantomPart part : PhantomParts(settings))
    all["parts"].push_back(
      { { "name", NameOf(part) }, { "volume_mm3", PhantomSolid(settings, part).Volume(0.5) } });
  all["landmarks"] = ordered_json::array();
  for (const PhantomLandmark& mark : PhantomLandmarks(settings))
    all["landmarks"].push_back(
      { { "name", mark.name }, { "part", NameOf(mark.part) }, { "point", Point(mark.point) } });
  if (settings.defect && settings.anatomy != PhantomAnatomy::Fibula)
  {
    const PhantomDefect hole = DefectOf(settings);
    all["defect"] = { { "center", Point(hole.center) }, { "outward", Point(hole.outward) },
      { "along", Point(hole.along) }, { "length_mm", hole.lengthMm },
      { "width_mm", hole.widthMm } };
  }
  return all;
}

} // namespace hasp
