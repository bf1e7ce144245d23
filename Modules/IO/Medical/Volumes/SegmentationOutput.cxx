#include "Files/AtomicFile.h"
#include "Volumes/EncodeHeader.h"
#include "Volumes/GzipOutput.h"
#include "Volumes/NrrdHeader.h"
#include "Volumes/SegmentPairs.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ParallelFor.h"

#include "vtkImageData.h"

#include <glm/common.hpp>

#include <limits>
#include <optional>
#include <stdexcept>

namespace hasp
{
namespace
{

template <typename T>
LabelBox BoxOfSlice(const GridView<const T>& labels, int k)
{
  const glm::ivec3 dims = labels.geometry.dims;
  LabelBox box{ dims, glm::ivec3(-1) };
  for (int j = 0; j < dims.y; ++j)
  {
    const T* row = &labels(0, j, k);
    int first = 0, last = dims.x - 1;
    while (first < dims.x && row[first] == 0)
      ++first;
    if (first == dims.x)
      continue;
    while (row[last] == 0)
      --last;
    box.low = glm::min(box.low, glm::ivec3(first, j, k));
    box.high = glm::max(box.high, glm::ivec3(last, j, k));
  }
  return box;
}

/// Of all samples that are not 0.
template <typename T>
LabelBox BoxOf(const GridView<const T>& labels)
{
  std::vector<LabelBox> slices(labels.geometry.dims.z);
  ParallelFor(0, labels.geometry.dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        slices[k] = BoxOfSlice(labels, static_cast<int>(k));
    });
  LabelBox box{ labels.geometry.dims, glm::ivec3(-1) };
  for (const LabelBox& slice : slices)
    box = { glm::min(box.low, slice.low), glm::max(box.high, slice.high) };
  return box.high.x < 0 ? LabelBox{} : box;
}

template <typename T>
void WriteFile(const std::filesystem::path& file, const VolumeHeader& header,
  const GridView<const T>& labels, bool compress, const ProgressFunction& progress)
{
  AtomicFile output(file);
  output.Write(header.bytes.data(), header.bytes.size());
  std::optional<GzipOutput> gzip;
  if (compress)
    gzip.emplace(output);
  const glm::ivec3 dims = labels.geometry.dims;
  for (int k = 0; k < dims.z; ++k)
  {
    ReportProgress(progress, double(k) / dims.z);
    const std::size_t bytes = std::size_t(dims.x) * dims.y * sizeof(T);
    if (gzip)
      gzip->Write(&labels(0, 0, k), bytes);
    else
      output.Write(&labels(0, 0, k), bytes);
  }
  if (gzip)
    gzip->Finish();
  ReportProgress(progress, 1.0); // may cancel: before the file is put in place
  output.Commit();
}

} // namespace

void WriteSegmentation(vtkImageData* labels, const std::vector<Segment>& segments,
  const std::string& path, const SegmentationWriteSettings& settings,
  const ProgressFunction& progress)
{
  const AnyGridView grid = ViewImage(labels);
  const std::filesystem::path file = std::filesystem::u8path(path);
  if (LowerExtension(file) != ".seg.nrrd")
    ThrowFileError(file, "segmentations are written as .seg.nrrd; give the name this ending");
  std::visit(
    [&](const auto& view)
    {
      using T = std::remove_const_t<std::remove_pointer_t<decltype(view.data)>>;
      if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::uint16_t>)
      {
        CheckSegments(segments, std::numeric_limits<T>::max());
        if (view.geometry.dims == glm::ivec3(1))
          throw std::invalid_argument("a segmentation of one sample stands for an empty one in 3D "
                                      "Slicer; write it as .nrrd");
        const VolumeHeader header = EncodeNrrd(view.geometry, static_cast<SampleType>(grid.index()),
          settings.compress, SegmentPairs(segments, view.geometry, BoxOf(view)));
        if (header.bytes.size() > NrrdHeaderLimit)
          throw std::invalid_argument(
            std::to_string(segments.size()) + " segments and their names take " +
            std::to_string(header.bytes.size()) + " bytes of a header, " +
            std::to_string(NrrdHeaderLimit) + " at most are read back; shorten or merge them");
        WriteFile(file, header, view, settings.compress, progress);
      }
      else
        throw std::invalid_argument("labels are " + SampleTypeName(labels->GetScalarType()) +
                                    ", must be uint8 or uint16; cast them");
    },
    grid);
}

} // namespace hasp
