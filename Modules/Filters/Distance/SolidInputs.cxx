#include "SolidInputs.h"

#include "Distance/GridSolid.h"
#include "vtkHaspSolid.h"
#include "vtkHaspVolumeView.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

constexpr const char* HowToMake = "; vtkHaspSignedDistance makes them of scans, coverage and "
                                  "labels";

GridView<const float> DistancesOf(vtkImageData* image)
{
  if (image->GetPointData()->GetScalars() && image->GetScalarType() != VTK_FLOAT)
    throw std::invalid_argument("signed distances are of type float, in mm, as those of "
                                "vtkHaspSignedDistance; this image holds " +
                                std::string(image->GetScalarTypeAsString()));
  const auto grid = std::get<GridView<const float>>(ViewImage(image));
  const float first = *grid.data; // where nothing or everything is inside, all are infinite
  if (std::isinf(first))
    throw std::invalid_argument(
      first > 0.0F
        ? "nothing is inside: is the isovalue above all samples, the label not there, or "
          "the mesh outside of its grid?"
        : "everything is inside: is the isovalue below all samples?");
  return grid;
}

SolidPointer MakeOf(const GridView<const float>& grid)
{
  try
  {
    return MakeGridSolid(
      std::make_shared<const std::vector<float>>(grid.data, grid.data + grid.geometry.Size()),
      grid.geometry);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(error.what() + std::string(HowToMake));
  }
}

/// Of samples that MakeGridSolid took.
SampledFacts FactsOf(const GridView<const float>& grid, int input)
{
  const glm::ivec3 dims = grid.geometry.dims;
  const auto [least, greatest] = std::minmax_element(grid.data, grid.data + grid.geometry.Size());
  float onBorder = *greatest;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
    {
      const bool whole = k == 0 || k == dims.z - 1 || j == 0 || j == dims.y - 1;
      for (int i = 0; i < dims.x; i += whole ? 1 : dims.x - 1)
        onBorder = std::min(onBorder, grid(i, j, k));
    }
  return { input, *least, *greatest, onBorder };
}

} // namespace

void SolidInputs::Accept(vtkInformation* port)
{
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHaspSolid");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
}

SolidInputs::Image SolidInputs::Read(vtkImageData* image, int input) const
{
  for (const Image& known : this->Images)
    if (known.image == image && known.time == image->GetMTime())
    {
      Image again = known;
      again.facts.input = input;
      return again;
    }
  const GridView<const float> grid = DistancesOf(image);
  SolidPointer solid = MakeOf(grid);
  const SampledFacts facts = FactsOf(grid, input);
  if (!(facts.least < 0.0F))
    throw std::invalid_argument(
      "nothing is inside: no sample is below 0, as in coverage; give signed distances" +
      std::string(HowToMake));
  return { image, image->GetMTime(), std::move(solid), facts };
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
        solids.push_back(seen.emplace_back(this->Read(image, i)).solid);
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

std::vector<SampledFacts> SolidInputs::Sampled() const
{
  std::vector<SampledFacts> facts;
  for (const Image& image : this->Images)
    facts.push_back(image.facts);
  return facts;
}

} // namespace hasp
