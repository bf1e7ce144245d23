#include "SolidInputs.h"

#include "Distance/GridSolid.h"
#include "vtkHaspSolid.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

SolidPointer MakeOf(vtkImageData* image)
{
  if (image->GetPointData()->GetScalars() && image->GetScalarType() != VTK_FLOAT)
    throw std::invalid_argument("signed distances are of type float, in mm, as those of "
                                "vtkHaspSignedDistance; this image holds " +
                                std::string(image->GetScalarTypeAsString()));
  const auto grid = std::get<GridView<const float>>(ViewImage(image));
  const float first = *grid.data; // where nothing or everything is inside, all are infinite
  if (std::isinf(first))
    throw std::invalid_argument(
      first > 0.0F ? "nothing is inside: is the isovalue above all samples, or the label not there?"
                   : "everything is inside: is the isovalue below all samples?");
  return MakeGridSolid(
    std::make_shared<const std::vector<float>>(grid.data, grid.data + grid.geometry.Size()),
    grid.geometry);
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

std::vector<SolidPointer> SolidInputs::Get(vtkInformationVector* inputs, const std::string& name)
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
      throw std::invalid_argument(name + " " + std::to_string(i) + ": " + error.what());
    }
  }
  this->Images = std::move(seen);
  return solids;
}

} // namespace hasp
