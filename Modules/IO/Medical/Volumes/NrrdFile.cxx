#include "Volumes/NrrdHeader.h"

#include "vtkImageData.h"

#include <algorithm>

// NRRD: "field: value" lines up to a blank one, then the samples, here or in the file named. Axes
// come fastest first; "space directions" are the world vectors of one index step along each.
namespace hasp
{

OpenedVolume OpenNrrd(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  const NrrdHeader header = ReadNrrdHeader(file);
  OpenedVolume opened;
  SampleFile samples = NrrdSamples(file, header);
  std::vector<NrrdAxis> axes = NrrdAxes(file, header);
  if (axes.size() == 4)
  {
    // The axis that is none of space; where the header does not say, one of a single component.
    auto other = std::find_if(axes.begin(), axes.end(),
      [&](const NrrdAxis& axis)
      { return !axis.step && axis.kind != "domain" && axis.kind != "space" && axis.size == 1; });
    if (other == axes.end())
      ThrowFileError(file, "has several components at each point (colours, vectors, times or "
                           "layers), must have 1; save one of them");
    axes.erase(other);
  }
  for (const NrrdAxis& axis : axes)
    for (const char* kind : { "list", "time", "vector", "point", "normal", "stub", "scalar",
           "complex", "color", "colour", "matrix", "quaternion", "covariant" })
      if (axis.kind.find(kind) != axis.kind.npos)
        ThrowFileError(file, "has an axis that is none of space, must have three of space");
  for (int a = 0; a < 3; ++a)
    samples.size[a] = axes[a].size;
  CheckSamples(samples, settings, opened.passport);
  SetNrrdGeometry(file, header, axes, opened.passport);
  opened.passport.format = "NRRD";
  opened.passport.compression = samples.zipped ? "gzip" : "";
  opened.samples = std::make_shared<const SampleFile>(samples);
  opened.load = [samples, geometry = opened.passport.geometry](const ProgressFunction& progress,
                  Passport&) { return LoadSamples(samples, geometry, progress); };
  return opened;
}

} // namespace hasp
