#include "Files/Utf8.h"
#include "Files/Words.h"
#include "Volumes/NrrdHeader.h"
#include "Volumes/SegmentPairs.h"

#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

// .seg.nrrd, 3D Slicer's segmentations: an NRRD label map whose pairs "SegmentN_Name" and so on say
// what the labels are. Where segments overlap there is a list axis, fastest, of several label maps
// ("layers"), and labels of two layers have nothing to do with each other.
namespace hasp
{
namespace
{

struct LayeredSegment
{
  Segment segment;
  std::int64_t layer = 0;
};

using Pairs = std::map<std::string, std::string>;

int WholeOr(const std::filesystem::path& file, const Pairs& pairs, const std::string& key,
  int least, int otherwise)
{
  const auto found = pairs.find(key);
  if (found == pairs.end())
    return otherwise;
  const auto number = FiniteNumbers(found->second, 1);
  if (!number || number->front() != std::floor(number->front()) || number->front() < least ||
      number->front() > 65535)
    ThrowFileError(file, "a segment's label value or layer is no whole number in [" +
                           std::to_string(least) + ", 65535]");
  return static_cast<int>(number->front());
}

std::array<double, 3> ColorOf(const Pairs& pairs, const std::string& prefix)
{
  auto found = pairs.find(prefix + "Color");
  if (found == pairs.end())
    found = pairs.find(prefix + "DefaultColor"); // before Slicer 4.9
  const auto color = found == pairs.end() ? std::nullopt : FiniteNumbers(found->second, 3);
  std::array<double, 3> rgb{ 0.5, 0.5, 0.5 };
  for (int n = 0; color && n < 3; ++n)
    rgb[n] = std::clamp((*color)[n], 0.0, 1.0);
  return rgb;
}

/// In the order of N of "SegmentN_ID".
std::vector<LayeredSegment> Segments(const std::filesystem::path& file, const Pairs& pairs)
{
  std::set<int> numbers;
  for (const auto& [key, value] : pairs)
  {
    const std::size_t end = key.find("_ID");
    if (key.rfind("Segment", 0) != 0 || end == key.npos || end + 3 != key.size())
      continue;
    const std::string digits = key.substr(7, end - 7);
    const bool number =
      !digits.empty() && digits.size() < 6 && digits.find_first_not_of("0123456789") == digits.npos;
    if (number)
      numbers.insert(std::stoi(digits));
  }
  std::vector<LayeredSegment> segments;
  std::set<std::pair<std::int64_t, int>> seen;
  for (const int n : numbers)
  {
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    LayeredSegment one;
    // Before Slicer 4.11 each segment was a layer of its own, of 0 and 1.
    const bool old = pairs.count(prefix + "LabelValue") == 0;
    one.segment.labelValue = WholeOr(file, pairs, prefix + "LabelValue", 1, 1);
    one.layer = WholeOr(file, pairs, prefix + "Layer", 0, old ? n : 0);
    const auto name = pairs.find(prefix + "Name");
    one.segment.name = name == pairs.end() ? "" : ValidUtf8(name->second);
    one.segment.color = ColorOf(pairs, prefix);
    const auto tags = pairs.find(prefix + "Tags");
    one.segment.bone = tags != pairs.end() && TagsSayBone(tags->second);
    if (!seen.emplace(one.layer, one.segment.labelValue).second)
      ThrowFileError(file, "two segments have one label value in one layer; save it again");
    segments.push_back(one);
  }
  return segments;
}

/// Layers: for each, which label becomes which.
/// No table by label: 65536 layers may each have a label of 65535.
struct LayerLabels
{
  std::int64_t layer = 0;
  std::map<int, int> becomes;
};

/// How many samples hold labels that no segment names. They stay where there is one layer, and are
/// an error where there are more.
template <typename Stored, typename Label>
std::size_t Merge(const SampleFile& samples, const std::vector<LayerLabels>& layers,
  std::size_t points, Label* labels, const ProgressFunction& progress)
{
  SampleStream stream(samples);
  const auto width = static_cast<std::size_t>(samples.components);
  const std::size_t most = std::max<std::size_t>(1, (1 << 20) / (width * sizeof(Stored)));
  std::vector<Stored> piece(most * width);
  std::size_t overlapping = 0, unnamed = 0;
  for (std::size_t done = 0; done < points;)
  {
    const std::size_t count = std::min(most, points - done);
    auto* bytes = reinterpret_cast<char*>(piece.data());
    stream.Read(bytes, count * width * sizeof(Stored));
    if (samples.bigEndian)
      SwapBytes(bytes, count * width * sizeof(Stored), sizeof(Stored));
    for (std::size_t n = 0; n < count; ++n)
    {
      int label = 0;
      for (const LayerLabels& one : layers)
      {
        const int value = piece[n * width + one.layer];
        if (value == 0)
          continue;
        const auto becomes = one.becomes.find(value);
        const bool named = becomes != one.becomes.end();
        if (!named && (width > 1 || value < 0))
          ThrowFileError(samples.header, "layer " + std::to_string(one.layer + 1) +
                                           " holds label value " + std::to_string(value) +
                                           ", which is no segment's; save it again");
        overlapping += label != 0;
        unnamed += !named;
        label = named ? becomes->second : value;
      }
      labels[done + n] = static_cast<Label>(label);
    }
    done += count;
    ReportProgress(progress, double(done) / double(points));
  }
  stream.ExpectEnd();
  if (overlapping > 0)
    ThrowFileError(
      samples.header, "its segments overlap in " + std::to_string(overlapping) +
                        " samples, where a label map holds one; choose a layer (1 to " +
                        std::to_string(samples.components) +
                        "), or make them exclusive in 3D Slicer and save again");
  return unnamed;
}

vtkSmartPointer<vtkImageData> LoadLayers(const SampleFile& samples, const GridGeometry& geometry,
  const std::vector<LayerLabels>& layers, int vtkType, const ProgressFunction& progress,
  Passport& passport)
{
  std::size_t unnamed = 0;
  auto image = NewImage(geometry, vtkType);
  const auto merge = [&](auto stored, auto* labels)
  { unnamed = Merge<decltype(stored)>(samples, layers, geometry.Size(), labels, progress); };
  const auto into = [&](auto stored)
  {
    void* labels = image->GetScalarPointer();
    if (vtkType == VTK_UNSIGNED_CHAR)
      merge(stored, static_cast<std::uint8_t*>(labels));
    else
      merge(stored, static_cast<std::uint16_t*>(labels));
  };
  if (samples.type == StoredType::UInt8)
    into(std::uint8_t());
  else if (samples.type == StoredType::UInt16)
    into(std::uint16_t());
  else
    into(std::int16_t());
  if (unnamed > 0)
    passport.warnings.push_back(
      std::to_string(unnamed) + " samples hold label values that no segment names; they stay.");
  return image;
}

/// The layers asked for, and what their labels become: as they are in one, counted from 1 in the
/// order of segments where several are merged.
std::vector<LayerLabels> ChooseLayers(const std::filesystem::path& file, int chosen,
  std::int64_t count, std::vector<LayeredSegment>& segments)
{
  if (chosen > count)
    ThrowFileError(
      file, "layer " + std::to_string(chosen) + " was asked for, it has " + std::to_string(count));
  for (const LayeredSegment& one : segments)
    if (one.layer >= count)
      ThrowFileError(file, "a segment is said to be in layer " + std::to_string(one.layer + 1) +
                             " of " + std::to_string(count) + "; save it again");
  if (chosen == 0 && segments.size() > std::numeric_limits<std::uint16_t>::max())
    ThrowFileError(file, "has " + std::to_string(segments.size()) +
                           " segments, a label map tells 65535 apart; choose a layer");
  if (chosen > 0)
    std::erase_if(segments, [&](const LayeredSegment& one) { return one.layer != chosen - 1; });
  std::vector<LayerLabels> layers;
  for (std::int64_t layer = 0; layer < count; ++layer)
    if (chosen == 0 || layer == chosen - 1)
      layers.push_back({ layer, {} });
  for (std::size_t n = 0; n < segments.size(); ++n)
  {
    Segment& segment = segments[n].segment;
    const int label = chosen > 0 ? segment.labelValue : static_cast<int>(n + 1);
    layers[chosen > 0 ? 0 : segments[n].layer].becomes[segment.labelValue] = label;
    segment.labelValue = label;
  }
  return layers;
}

} // namespace

OpenedVolume OpenSegmentation(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  const NrrdHeader header = ReadNrrdHeader(file);
  OpenedVolume opened;
  SampleFile samples = NrrdSamples(file, header);
  std::vector<NrrdAxis> axes = NrrdAxes(file, header);
  if (samples.type != StoredType::UInt8 && samples.type != StoredType::UInt16 &&
      samples.type != StoredType::Int16)
    ThrowFileError(file, "labels must be uint8, uint16 or int16; save it again as a label map");
  if (axes.size() == 4)
  {
    if (axes[0].step || axes[0].kind == "domain" || axes[0].size > 65536)
      ThrowFileError(file, "its first axis must be the list of layers, 65536 at most");
    samples.components = axes[0].size;
    axes.erase(axes.begin());
  }
  for (int a = 0; a < 3; ++a)
    samples.size[a] = axes[a].size;
  std::vector<LayeredSegment> segments = Segments(file, header.pairs);
  if (segments.empty() || (axes[0].size == 1 && axes[1].size == 1 && axes[2].size == 1))
    ThrowFileError(file, "holds no segments (3D Slicer saves an empty segmentation so)");
  CheckSamples(samples, settings, opened.passport);
  SetNrrdGeometry(file, header, axes, opened.passport);
  opened.passport.format = "NRRD segmentation";
  opened.passport.compression = samples.zipped ? "gzip" : "";
  const GridGeometry& geometry = opened.passport.geometry;
  // Of one layer nothing is merged: it is the one chosen.
  const int chosen = samples.components == 1 ? std::max(settings.layer, 1) : settings.layer;
  const auto layers = ChooseLayers(file, chosen, samples.components, segments);
  for (const LayeredSegment& one : segments)
    opened.segments.push_back(one.segment);
  opened.passport.segments = static_cast<int>(segments.size());
  int largest = 0;
  for (const Segment& segment : opened.segments)
    largest = std::max(largest, segment.labelValue);
  // One layer may hold labels that no segment names: they must fit, too.
  const bool wide = samples.components == 1 ? samples.type != StoredType::UInt8 : largest > 255;
  const int vtkType = wide ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR;
  CheckSampleBytes(file, samples.size[0], samples.size[1], samples.size[2],
    wide ? sizeof(std::uint16_t) : sizeof(std::uint8_t), settings.memoryLimitBytes);
  opened.passport.sampleType = SampleTypeName(vtkType);
  if (chosen == 0)
    opened.passport.warnings.push_back("The file's " + std::to_string(samples.components) +
                                       " layers are merged; labels are counted anew from 1.");
  opened.load = [samples, geometry, layers, vtkType](
                  const ProgressFunction& progress, Passport& passport)
  { return LoadLayers(samples, geometry, layers, vtkType, progress, passport); };
  return opened;
}

} // namespace hasp
