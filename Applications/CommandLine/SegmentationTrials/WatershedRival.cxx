#include "SplitRival.h"

#include <itkImage.h>
#include <itkMorphologicalWatershedFromMarkersImageFilter.h>
#include <itkVersion.h>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

using Heights = itk::Image<float, 3>;
using Markers = itk::Image<Label, 3>;
using Filter = itk::MorphologicalWatershedFromMarkersImageFilter<Heights, Markers>;

constexpr Label Air = MaxLabel; ///< the marker of all that is no bone

template <typename Image>
typename Image::Pointer MakeItkImage(const GridGeometry& grid)
{
  const auto image = Image::New();
  typename Image::SizeType size;
  typename Image::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(grid.dims[int(axis)]);
    spacing[axis] = grid.spacing[int(axis)];
  }
  image->SetRegions(typename Image::RegionType(size));
  image->SetSpacing(spacing);
  image->Allocate();
  return image;
}

/// The gradient's size by central differences; at the border one-sided.
float GradientAt(GridView<const std::int16_t> grey, const glm::ivec3& at)
{
  double sum = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    glm::ivec3 low = at, high = at;
    low[a] = std::max(at[a] - 1, 0);
    high[a] = std::min(at[a] + 1, grey.geometry.dims[a] - 1);
    if (low[a] == high[a])
      continue;
    const double step = (double(grey(high.x, high.y, high.z)) - double(grey(low.x, low.y, low.z))) /
                        (grey.geometry.spacing[a] * (high[a] - low[a]));
    sum += step * step;
  }
  return float(std::sqrt(sum));
}

class WatershedRun final : public SplitRun
{
public:
  WatershedRun(const SplitInput& input, bool gradient) : Watershed(Filter::New())
  {
    const GridGeometry& grid = input.grey.geometry;
    const auto heights = MakeItkImage<Heights>(grid);
    const auto markers = MakeItkImage<Markers>(grid);
    float* height = heights->GetBufferPointer();
    Label* marker = markers->GetBufferPointer();
    std::size_t v = 0;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i, ++v)
        {
          height[v] = gradient ? GradientAt(input.grey, { i, j, k }) : -float(input.grey.data[v]);
          marker[v] = input.bone.data[v] == 0 ? Air : Label(0);
        }
    for (const SeedVoxels& seed : input.seeds)
      for (const VoxelRun& run : seed.voxels)
        for (std::uint64_t n = run.first; n < run.first + run.length; ++n)
          if (input.bone.data[n] != 0)
            marker[n] = seed.label;
    this->Watershed->SetInput1(heights);
    this->Watershed->SetInput2(markers);
    this->Watershed->SetMarkWatershedLine(false);
    this->Watershed->SetFullyConnected(false);
  }
  void Run() override
  {
    this->Watershed->Modified();
    this->Watershed->Update();
  }
  std::vector<Label> Labels() const override
  {
    const Markers* basins = this->Watershed->GetOutput();
    const Label* begin = basins->GetBufferPointer();
    std::vector<Label> labels(
      begin, begin + basins->GetLargestPossibleRegion().GetNumberOfPixels());
    std::replace(labels.begin(), labels.end(), Air, Label(0));
    return labels;
  }

private:
  Filter::Pointer Watershed;
};

} // namespace

std::vector<SplitRival> WatershedRivals()
{
  std::vector<SplitRival> rivals;
  for (const bool gradient : { false, true })
  {
    SplitRival rival;
    rival.name = std::string("watershed of ") + (gradient ? "the gradient" : "inverted grey") +
                 ", ITK " + itk::Version::GetITKVersion();
    rival.make = [gradient](const SplitInput& input)
    { return std::make_unique<WatershedRun>(input, gradient); };
    rivals.push_back(rival);
  }
  return rivals;
}

} // namespace hasp
