#include "SegmentList.h"

#include "VerbWork.h"
#include "vtkHaspPrintableText.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <type_traits>
#include <vector>

namespace hasp
{
namespace
{

/// Voxels of each label.
std::vector<std::size_t> CountVoxels(vtkImageData* labels)
{
  std::vector<std::size_t> voxels(65536);
  std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      if constexpr (std::is_integral_v<T>)
        for (std::size_t n = 0; n < view.geometry.Size(); ++n)
          ++voxels[static_cast<std::uint16_t>(view.data[n])];
    },
    ViewImage(labels));
  return voxels;
}

std::string ColourText(const Segment& segment)
{
  const auto part = [&](int n) { return int(std::lround(255.0 * segment.color[std::size_t(n)])); };
  return Line("#%02x%02x%02x", part(0), part(1), part(2));
}

} // namespace

bool IsSegmentationName(const std::string& path)
{
  std::string name = path;
  std::transform(
    name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return name.ends_with(".seg.nrrd");
}

nlohmann::ordered_json DescribeSegments(const LoadedVolume& segmentation, bool names)
{
  const glm::dvec3 spacing = ImageGeometry(segmentation.image).spacing;
  std::vector<std::size_t> voxels = CountVoxels(segmentation.image);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const auto add = [&](std::size_t label)
  {
    list.push_back({ { "label", label }, { "voxels", voxels[label] },
      { "volume_mm3", double(voxels[label]) * spacing.x * spacing.y * spacing.z } });
    voxels[label] = 0; // told
  };
  for (const Segment& segment : segmentation.segments)
  {
    add(std::size_t(segment.labelValue));
    list.back()["colour"] = ColourText(segment);
    if (names)
      list.back()["name"] = segment.name;
  }
  for (std::size_t label = 1; label < voxels.size(); ++label)
    if (voxels[label] > 0)
      add(label);
  return list;
}

std::string SegmentsText(const nlohmann::ordered_json& segments)
{
  std::string text;
  for (const auto& segment : segments)
  {
    const auto voxels = segment["voxels"].get<long long>();
    text += Line("label %5d  %7s  %10lld voxel%s  %12.1f mm3", segment["label"].get<int>(),
      segment.value("colour", "no name").c_str(), voxels, voxels == 1 ? " " : "s",
      segment["volume_mm3"].get<double>());
    if (segment.contains("name"))
      text += "  " + PrintableText(segment["name"].get<std::string>());
    text += "\n";
  }
  return text;
}

} // namespace hasp
