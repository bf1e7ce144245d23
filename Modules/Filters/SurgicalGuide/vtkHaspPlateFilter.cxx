#include "vtkHaspPlateFilter.h"

#include "Planning/PlateRecipe.h"
#include "PlateBuilder.h"
#if HASP_WITH_JSON
#include "Planning/PlateRecipeFile.h"
#endif

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkHaspPlateFilter);

namespace
{
void AddScrewAxes(const std::vector<hasp::PlacedScrew>& screws, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> axes;
  axes->SetName("ScrewAxes");
  axes->SetNumberOfComponents(6);
  for (const hasp::PlacedScrew& screw : screws)
    axes->InsertNextTuple6(
      screw.outer.x, screw.outer.y, screw.outer.z, screw.axis.x, screw.axis.y, screw.axis.z);
  output->GetFieldData()->AddArray(axes);
}
} // namespace

vtkHaspPlateFilter::vtkHaspPlateFilter() : Recipe(std::make_unique<hasp::PlateRecipe>())
{
  this->SetNumberOfInputPorts(2);
}
vtkHaspPlateFilter::~vtkHaspPlateFilter() = default;

void vtkHaspPlateFilter::SetRecipe(const hasp::PlateRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

bool vtkHaspPlateFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  try
  {
    this->SetRecipe(hasp::ReadPlateRecipe(path));
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
#else
  (void)path;
  vtkErrorMacro("cannot read a recipe: built without HASP_ENABLE_JSON");
  return false;
#endif
}

int vtkHaspPlateFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkHaspPlateFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkImageData* labels = vtkImageData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  try
  {
    hasp::BoneScan scan{ hasp::ViewImage(image), {} };
    if (labels)
      scan.labels = hasp::ViewImage(labels);
    const hasp::BuiltPlate plate = hasp::BuildPlate(scan, *this->Recipe, progress);
    output->ShallowCopy(hasp::MakePolyData(plate.mesh));
    AddScrewAxes(plate.made.screws, output);
    return 1;
  }
  catch (const hasp::Cancelled&)
  {
    return 1; // what was asked for: nothing
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkHaspPlateFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Landmarks: " << this->Recipe->landmarks.size() << "\n";
  os << indent << "Width: " << this->Recipe->widthMm << " mm\n";
  os << indent << "Thickness: " << this->Recipe->thicknessMm << " mm\n";
  os << indent << "Screws: " << this->Recipe->screws.size() << "\n";
  os << indent << "Fragments: " << this->Recipe->fragments.size() << "\n";
}
