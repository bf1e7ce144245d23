#include "vtkHaspPlateFilter.h"

#include "Planning/PlateRecipe.h"
#include "PlateBuilder.h"
#include "RecipeFilter.h"
#if HASP_WITH_JSON
#include "Planning/PlateRecipeFile.h"
#endif

#include "vtkDoubleArray.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
  return hasp::Succeeds(this, [&] { this->SetRecipe(hasp::ReadPlateRecipe(path)); });
#else
  (void)path;
  return hasp::CannotReadRecipe(this);
#endif
}

int vtkHaspPlateFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return hasp::AskForImages(port, info);
}

int vtkHaspPlateFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkImageData* labels = vtkImageData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  return hasp::Succeeds(this,
    [&]
    {
      hasp::BoneScan scan{ hasp::ViewImage(image), {} };
      if (labels)
        scan.labels = hasp::ViewImage(labels);
      const hasp::BuiltPlate plate = hasp::BuildPlate(scan, *this->Recipe, hasp::ProgressOf(this));
      output->ShallowCopy(hasp::MakePolyData(plate.mesh));
      AddScrewAxes(plate.made.screws, output);
    });
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
