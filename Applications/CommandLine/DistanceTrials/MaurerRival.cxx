#include "RivalLibrary.h"

#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>
#include <itkVersion.h>

#include <algorithm>

namespace hasp
{
namespace
{

using Mask = itk::Image<unsigned char, 3>;
using Distance = itk::Image<float, 3>;
using Filter = itk::SignedMaurerDistanceMapImageFilter<Mask, Distance>;

class MaurerRun final : public RivalRun
{
public:
  explicit MaurerRun(const TransformInput& input) : Maurer(Filter::New())
  {
    const auto mask = Mask::New();
    Mask::SizeType size;
    Mask::SpacingType spacing;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      size[axis] = static_cast<itk::SizeValueType>(input.grid.dims[int(axis)]);
      spacing[axis] = input.grid.spacing[int(axis)];
    }
    mask->SetRegions(Mask::RegionType(size));
    mask->SetSpacing(spacing);
    mask->Allocate();
    std::copy(input.mask.begin(), input.mask.end(), mask->GetBufferPointer());
    this->Maurer->SetInput(mask);
    this->Maurer->SetSquaredDistance(false);
    this->Maurer->SetUseImageSpacing(true);
    this->Maurer->SetInsideIsPositive(false);
    this->Maurer->SetBackgroundValue(0);
    this->Maurer->GetMultiThreader()->SetMaximumNumberOfThreads(input.threads);
    this->Maurer->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(input.threads));
  }
  void Run() override
  {
    this->Maurer->Modified();
    this->Maurer->Update();
  }
  std::vector<float> Distances() const override
  {
    const Distance* distance = this->Maurer->GetOutput();
    const float* begin = distance->GetBufferPointer();
    std::vector<float> distances(
      begin, begin + distance->GetLargestPossibleRegion().GetNumberOfPixels());
    // ITK measures to the middles of the outermost voxels inside.
    const float half = 0.5F * static_cast<float>(distance->GetSpacing()[0]);
    for (float& value : distances)
      value -= half;
    return distances;
  }

private:
  Filter::Pointer Maurer;
};

} // namespace

RivalTransform MakeMaurerRival()
{
  RivalTransform rival;
  rival.key = "itk";
  rival.name =
    std::string("ITK ") + itk::Version::GetITKVersion() +
    " SignedMaurerDistanceMapImageFilter of the mask, spacing used, not squared, less half a "
    "voxel";
  rival.exact = true;
  rival.make = [](const TransformInput& input) { return std::make_unique<MaurerRun>(input); };
  return rival;
}

} // namespace hasp
