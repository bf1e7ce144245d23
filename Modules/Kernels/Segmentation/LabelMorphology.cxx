#include "Segmentation/LabelMorphology.h"

#include "Grid/ProgressPart.h"
#include "Segmentation/BoxRows.h"
#include "Segmentation/NearVoxels.h"

#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

GridView<const Label> ReadOnly(GridView<Label> labels)
{
  return { labels.data, labels.geometry };
}

glm::ivec3 CheckedSteps(GridView<Label> labels, Label label, double radiusMm)
{
  labels.geometry.Validate();
  if (label == 0)
    throw std::invalid_argument("morphology: label 0 is nothing, must be in [1, 65535]");
  return StepsWithin(labels.geometry.spacing, radiusMm, "morphology: radius");
}

/// Voxels of label `from` where the mask is `where` become `into`, in the mask's box.
LabelDelta Change(GridView<Label> labels, Label from, const BoxMask& mask, bool where, Label into,
  const ProgressFunction& progress)
{
  LabelDelta delta = ProposeRows(
    ReadOnly(labels), mask.box,
    [&](int j, int k, std::span<Label> row)
    {
      const std::uint8_t* inside = &mask.inside[mask.Offset(mask.box.low.x, j, k)];
      for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] == from && (inside[i] != 0) == where)
          row[i] = into;
    },
    progress);
  return Made(std::move(delta), labels);
}

LabelDelta Nothing(GridView<Label> labels)
{
  return { labels.geometry.dims, {} };
}

/// What of the label's box is within the radius of a voxel that is not of the label. One voxel
/// around the box is enough: from inside it, none beyond is nearer.
BoxMask NearOutside(GridView<Label> labels, const VoxelBox& box, Label label, double radiusMm,
  const ProgressFunction& progress)
{
  const BoxMask outside =
    MaskOf(ReadOnly(labels), box.Grown(glm::ivec3(1)).In(labels.geometry.dims),
      [label](Label other) { return other != label; });
  return Dilated(outside, box, labels.geometry.spacing, radiusMm, progress);
}

} // namespace

LabelDelta DilateLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress)
{
  const glm::ivec3 steps = CheckedSteps(labels, label, radiusMm);
  const VoxelBox box = BoxOfLabel(ReadOnly(labels), label, PartOf(progress, 0.0, 0.1));
  if (box.Empty())
    return Nothing(labels);
  const BoxMask mask =
    MaskOf(ReadOnly(labels), box, [label](Label other) { return other == label; });
  const BoxMask near = Dilated(mask, box.Grown(steps).In(labels.geometry.dims),
    labels.geometry.spacing, radiusMm, PartOf(progress, 0.1, 0.9));
  return Change(labels, 0, near, true, label, PartOf(progress, 0.9, 1.0));
}

LabelDelta ErodeLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress)
{
  CheckedSteps(labels, label, radiusMm);
  const VoxelBox box = BoxOfLabel(ReadOnly(labels), label, PartOf(progress, 0.0, 0.1));
  if (box.Empty())
    return Nothing(labels);
  const BoxMask near = NearOutside(labels, box, label, radiusMm, PartOf(progress, 0.1, 0.9));
  return Change(labels, label, near, true, 0, PartOf(progress, 0.9, 1.0));
}

LabelDelta OpenLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress)
{
  CheckedSteps(labels, label, radiusMm);
  const VoxelBox box = BoxOfLabel(ReadOnly(labels), label, PartOf(progress, 0.0, 0.1));
  if (box.Empty())
    return Nothing(labels);
  BoxMask eroded = MaskOf(ReadOnly(labels), box, [label](Label other) { return other == label; });
  {
    const BoxMask near = NearOutside(labels, box, label, radiusMm, PartOf(progress, 0.1, 0.5));
    for (std::size_t v = 0; v < near.inside.size(); ++v)
      eroded.inside[v] &= near.inside[v] ^ 1U;
  }
  const BoxMask opened =
    Dilated(eroded, box, labels.geometry.spacing, radiusMm, PartOf(progress, 0.5, 0.9));
  return Change(labels, label, opened, false, 0, PartOf(progress, 0.9, 1.0));
}

LabelDelta CloseLabel(
  GridView<Label> labels, Label label, double radiusMm, const ProgressFunction& progress)
{
  const glm::ivec3 steps = CheckedSteps(labels, label, radiusMm);
  const VoxelBox box = BoxOfLabel(ReadOnly(labels), label, PartOf(progress, 0.0, 0.1));
  if (box.Empty())
    return Nothing(labels);
  BoxMask far;
  {
    const BoxMask mask =
      MaskOf(ReadOnly(labels), box, [label](Label other) { return other == label; });
    far = Dilated(
      mask, box.Grown(steps), labels.geometry.spacing, radiusMm, PartOf(progress, 0.1, 0.5));
  }
  for (std::uint8_t& voxel : far.inside)
    voxel ^= 1U;
  // A box closed by a ball is the same box, so nothing outside of it is closed.
  const BoxMask open =
    Dilated(far, box, labels.geometry.spacing, radiusMm, PartOf(progress, 0.5, 0.9));
  return Change(labels, 0, open, false, label, PartOf(progress, 0.9, 1.0));
}

} // namespace hasp
