#include "vtkHaspImplantFilter.h"

#include "ImplantBuilder.h"
#include "Planning/ImplantRecipe.h"
#if HASP_WITH_JSON
#include "Planning/ImplantRecipeFile.h"
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

vtkStandardNewMacro(vtkHaspImplantFilter);

namespace
{
void AddVectors(vtkPolyData* output, const char* name, std::initializer_list<glm::dvec3> vectors)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3 * int(vectors.size()));
  array->SetNumberOfTuples(1);
  int n = 0;
  for (const glm::dvec3& v : vectors)
    for (int a = 0; a < 3; ++a)
      array->SetComponent(0, n++, v[a]);
  output->GetFieldData()->AddArray(array);
}
} // namespace

vtkHaspImplantFilter::vtkHaspImplantFilter() : Recipe(std::make_unique<hasp::ImplantRecipe>()) {}
vtkHaspImplantFilter::~vtkHaspImplantFilter() = default;

void vtkHaspImplantFilter::SetRecipe(const hasp::ImplantRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

bool vtkHaspImplantFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  try
  {
    this->SetRecipe(hasp::ReadImplantRecipe(path));
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

int vtkHaspImplantFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHaspImplantFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  try
  {
    const hasp::BuiltImplant implant =
      hasp::BuildImplant(hasp::ViewImage(image), *this->Recipe, progress);
    output->ShallowCopy(hasp::MakePolyData(implant.mesh));
    AddVectors(output, "MirrorPlane", { implant.made.mirror.point, implant.made.mirror.normal });
    AddVectors(output, "Axis", { implant.made.axis });
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

void vtkHaspImplantFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Outline: " << this->Recipe->outline.size() << "\n";
  os << indent << "Thickness: " << this->Recipe->thicknessMm << " mm\n";
  os << indent << "Clearance: " << this->Recipe->clearanceMm << " mm\n";
  os << indent << "Mirror: " << (this->Recipe->mirror ? "given" : "fitted") << "\n";
}
