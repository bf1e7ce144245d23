#include "Segmentation/Components.h"

#include "Grid/ProgressPart.h"
#include "Segmentation/BoxRows.h"
#include "Segmentation/LabelPieces.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

void CheckLabel(GridView<Label> labels, Label label, const char* what)
{
  labels.geometry.Validate();
  if (label == 0)
    throw std::invalid_argument(std::string(what) + ": label 0 is nothing, must be in [1, 65535]");
}

/// Voxels of each piece.
std::vector<std::uint64_t> SizesOf(const LabelPieces& pieces)
{
  std::vector<std::uint64_t> sizes(pieces.count);
  for (const LabelPieces::Run& run : pieces.runs)
    sizes[run.piece] += std::uint64_t(run.end - run.begin);
  return sizes;
}

/// The label that each piece gets.
std::vector<Label> NumberPieces(const std::vector<std::uint64_t>& sizes, double voxelMm3,
  Label label, std::size_t largestLabel, const ComponentsSettings& settings)
{
  std::vector<std::uint32_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
  // What is rounded must not remove a piece of exactly the least size.
  const double least = settings.leastMm3 / voxelMm3 * (1.0 - 1e-9);
  std::vector<Label> numbers(sizes.size());
  std::size_t next = largestLabel;
  for (std::size_t n = 0; n < order.size() && double(sizes[order[n]]) >= least; ++n)
    if (n == 0)
      numbers[order[n]] = label;
    else if (settings.keepLargestAlone)
      break;
    else if (++next <= MaxLabel)
      numbers[order[n]] = static_cast<Label>(next);
  if (next > MaxLabel)
    throw std::invalid_argument("components: label " + std::to_string(label) + " has " +
                                std::to_string(next - largestLabel + 1) +
                                " pieces, and labels up to " + std::to_string(largestLabel) +
                                " are in use, must not go beyond 65535; remove pieces below a "
                                "size, or keep the largest alone");
  return numbers;
}

} // namespace

LabelDelta SeparateComponents(GridView<Label> labels, Label label,
  const ComponentsSettings& settings, const ProgressFunction& progress)
{
  CheckLabel(labels, label, "components");
  if (!(settings.leastMm3 >= 0.0 && settings.leastMm3 <= 1e9))
    throw std::invalid_argument("components: least size is " + std::to_string(settings.leastMm3) +
                                " mm3, must be in [0, 1e9]");
  const GridView<const Label> before{ labels.data, labels.geometry };
  const VoxelBox box = BoxOfLabel(before, label, PartOf(progress, 0.0, 0.2));
  LabelDelta delta{ labels.geometry.dims, {} };
  if (box.Empty())
    return delta;
  const LabelPieces pieces = FindLabelPieces(before, box, label, true, PartOf(progress, 0.2, 0.9));
  const glm::dvec3& s = labels.geometry.spacing;
  const std::vector<Label> numbers =
    NumberPieces(SizesOf(pieces), s.x * s.y * s.z, label, CountLabels(before).size() - 1, settings);
  ReportProgress(progress, 0.95);
  pieces.ForEach(
    [&](const LabelPieces::Run& run, int j, int k)
    {
      delta.Append({ labels.Offset(run.begin, j, k), std::uint32_t(run.end - run.begin), label,
        numbers[run.piece] });
    });
  ReportProgress(progress, 1.0);
  return Made(std::move(delta), labels);
}

LabelDelta FillCavities(GridView<Label> labels, Label label, const ProgressFunction& progress)
{
  CheckLabel(labels, label, "cavities");
  const GridView<const Label> before{ labels.data, labels.geometry };
  const VoxelBox box = BoxOfLabel(before, label, PartOf(progress, 0.0, 0.2));
  LabelDelta delta{ labels.geometry.dims, {} };
  if (box.Empty())
    return delta;
  // Beyond the box there is nothing of the label, so what reaches the box's faces gets out.
  const LabelPieces pieces = FindLabelPieces(before, box, label, false, PartOf(progress, 0.2, 0.9));
  std::vector<bool> open(pieces.count);
  pieces.ForEach(
    [&](const LabelPieces::Run& run, int j, int k)
    {
      if (run.begin == box.low.x || run.end == box.high.x || j == box.low.y ||
          j + 1 == box.high.y || k == box.low.z || k + 1 == box.high.z)
        open[run.piece] = true;
    });
  ReportProgress(progress, 0.95);
  pieces.ForEach(
    [&](const LabelPieces::Run& run, int j, int k)
    {
      if (!open[run.piece])
        for (int i = run.begin; i < run.end; ++i)
          if (labels(i, j, k) == 0)
            delta.Append({ labels.Offset(i, j, k), 1, 0, label });
    });
  ReportProgress(progress, 1.0);
  return Made(std::move(delta), labels);
}

} // namespace hasp
