#pragma once
// A scan of a bone that is broken in two, and a third one apart from it.
#include "Planning/SegmentationRecipe.h"
#include "Segmentation/LabelHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <random>
#include <vector>

namespace hasp::testing
{

inline const glm::ivec3 BonesDims(40, 24, 20);

inline GridGeometry BonesGrid()
{
  GridGeometry grid;
  grid.dims = BonesDims;
  grid.spacing = { 0.5, 0.6, 0.8 };
  grid.origin = { -30.0, 12.0, 7.0 };
  return grid;
}

/// Bone is 1000, soft tissue 0, noise between; the crack at x = 15 is as dark as 400.
inline vtkSmartPointer<vtkImageData> TwoBones()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> noise(-60.0F, 60.0F);
  std::vector<float> samples;
  for (int k = 0; k < BonesDims.z; ++k)
    for (int j = 0; j < BonesDims.y; ++j)
      for (int i = 0; i < BonesDims.x; ++i)
      {
        const bool bone =
          i > 2 && i < 36 && (i < 27 || i > 29) && j > 3 && j < 20 && k > 2 && k < 17;
        samples.push_back((!bone ? 0.0F : i == 15 ? 400.0F : 1000.0F) + noise(random));
      }
  return MakeImage(BonesGrid(), samples);
}

inline BrushStroke StrokeAt(int x, std::uint16_t label, double radiusMm = 1.0)
{
  const GridGeometry grid = BonesGrid();
  return { label, radiusMm, { grid.IndexToWorld({ x, 10, 8 }), grid.IndexToWorld({ x, 14, 12 }) } };
}

inline std::uint64_t HashOf(vtkImageData* labels)
{
  return HashLabels(std::get<GridView<const Label>>(ViewImage(labels)));
}

inline Label LabelAt(vtkImageData* labels, int i, int j, int k)
{
  return std::get<GridView<const Label>>(ViewImage(labels))(i, j, k);
}

/// A split of both bones by three strokes.
inline SegmentationRecipe BonesRecipe(double norm = 1.0)
{
  SegmentationRecipe recipe;
  recipe.steps = { GaussianStep{ 0.3 }, ThresholdStep{ 226.0, 1e6 },
    SplitStep{ 1, { StrokeAt(8, 2), StrokeAt(22, 3), StrokeAt(32, 4) }, 90.0, 0.1, norm } };
  recipe.names = { { 2, "left", { 1, 2, 3 } } };
  return recipe;
}

} // namespace hasp::testing
