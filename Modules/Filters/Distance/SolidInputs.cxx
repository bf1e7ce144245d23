#include "SolidInputs.h"

#include "Distance/GridSolid.h"
#include "vtkHaspSolid.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

SolidPointer MakeOf(vtkImageData* image)
{
  const AnyGridView any = ViewImage(image);
  const auto* grid = std::get_if<GridView<const float>>(&any);
  if (!grid)
    throw std::invalid_argument("signed distances are of type float, in mm, as those of "
                                "vtkHaspSignedDistance; this image holds " +
                                std::string(image->GetScalarTypeAsString()));
  return MakeGridSolid(
    std::make_shared<const std::vector<float>>(grid->data, grid->data + grid->geometry.Size()),
    grid->geometry);
}

} // namespace

void SolidInputs::Accept(vtkInformation* port)
{
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHaspSolid");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
}

SolidPointer SolidInputs::SolidOf(vtkImageData* image)
{
  for (const Image& known : this->Images)
    if (known.image == image && known.time == image->GetMTime())
      return known.solid;
  return MakeOf(image);
}

std::vector<SolidPointer> SolidInputs::Get(vtkInformationVector* inputs)
{
  std::vector<SolidPointer> solids;
  std::vector<Image> seen;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    try
    {
      if (vtkImageData* image = vtkImageData::GetData(inputs, i))
        solids.push_back(seen.emplace_back(image, image->GetMTime(), this->SolidOf(image)).solid);
      else if (vtkHaspSolid* solid = vtkHaspSolid::GetData(inputs, i); solid && solid->GetSolid())
        solids.push_back(solid->GetSolid());
      else
        throw std::invalid_argument("there is no solid");
    }
    catch (const std::invalid_argument& error)
    {
      throw std::invalid_argument("input " + std::to_string(i) + ": " + error.what());
    }
  }
  this->Images = std::move(seen);
  return solids;
}

} // namespace hasp
