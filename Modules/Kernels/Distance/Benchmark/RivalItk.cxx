#include "Benchmark/Rivals.h"

#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

namespace hasp::bench
{

std::vector<float> ItkSignedMaurer(
  const GridGeometry& geometry, std::span<const std::uint8_t> inside, int threads)
{
  using Mask = itk::Image<std::uint8_t, 3>;
  using Distances = itk::Image<float, 3>;
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  auto mask = Mask::New();
  Mask::SizeType size;
  Mask::SpacingType spacing;
  for (unsigned a = 0; a < 3; ++a)
  {
    size[a] = static_cast<itk::SizeValueType>(geometry.dims[int(a)]);
    spacing[a] = geometry.spacing[int(a)];
  }
  mask->SetRegions(size);
  mask->SetSpacing(spacing);
  // Not copied: the filter only reads it.
  mask->GetPixelContainer()->SetImportPointer(
    const_cast<std::uint8_t*>(inside.data()), inside.size(), false);
  auto filter = itk::SignedMaurerDistanceMapImageFilter<Mask, Distances>::New();
  filter->SetInput(mask);
  filter->SetSquaredDistance(false);
  filter->SetUseImageSpacing(true);
  filter->SetInsideIsPositive(false);
  filter->SetNumberOfWorkUnits(static_cast<unsigned>(threads));
  filter->Update();
  const float* values = filter->GetOutput()->GetBufferPointer();
  return { values, values + inside.size() };
}

} // namespace hasp::bench
