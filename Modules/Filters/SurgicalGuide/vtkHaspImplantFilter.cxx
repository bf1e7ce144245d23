#include "vtkHaspImplantFilter.h"

#include "ImplantBuilder.h"
#include "Planning/ImplantRecipe.h"
#include "RecipeFilter.h"
#if HASP_WITH_JSON
#include "Planning/ImplantRecipeFile.h"
#endif

#include "vtkDoubleArray.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

vtkStandardNewMacro(vtkHaspImplantFilter);

namespace
{
void AddTuples(
  vtkPolyData* output, const char* name, int components, std::span<const double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(vtkIdType(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}

void AddFieldData(vtkPolyData* output, const hasp::ImplantSolid& made)
{
  const glm::dvec3 &p = made.mirror.point, &n = made.mirror.normal, &a = made.axis;
  AddTuples(output, "MirrorPlane", 6, std::array{ p.x, p.y, p.z, n.x, n.y, n.z });
  AddTuples(output, "Axis", 3, std::array{ a.x, a.y, a.z });
  const hasp::LaidTable& laid = made.laid;
  AddTuples(output, "Rim", 4, std::array{ laid.shiftMm, laid.tiltDeg, laid.rmsMm, laid.p95Mm });
  std::vector<double> holes;
  for (const glm::dvec3& hole : made.holes)
    holes.insert(holes.end(), { hole.x, hole.y, hole.z });
  AddTuples(output, "Holes", 3, holes);
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
  return hasp::Succeeds(this, [&] { this->SetRecipe(hasp::ReadImplantRecipe(path)); });
#else
  (void)path;
  return hasp::CannotReadRecipe(this);
#endif
}

int vtkHaspImplantFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return hasp::AskForImages(port, info);
}

int vtkHaspImplantFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  return hasp::Succeeds(this,
    [&]
    {
      const hasp::BuiltImplant implant =
        hasp::BuildImplant(hasp::ViewImage(image), *this->Recipe, hasp::ProgressOf(this));
      output->ShallowCopy(hasp::MakePolyData(implant.mesh));
      AddFieldData(output, implant.made);
    });
}

void vtkHaspImplantFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Outline: " << this->Recipe->outline.size() << "\n";
  os << indent << "Thickness: " << this->Recipe->thicknessMm << " mm\n";
  os << indent << "Clearance: " << this->Recipe->clearanceMm << " mm\n";
  os << indent << "Mirror: " << (this->Recipe->mirror ? "given" : "fitted") << "\n";
}
