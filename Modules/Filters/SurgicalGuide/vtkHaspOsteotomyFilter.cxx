#include "vtkHaspOsteotomyFilter.h"

#include "FragmentCutter.h"
#include "Planning/CutRecipe.h"
#if HASP_WITH_JSON
#include "Planning/CutRecipeFile.h"
#endif

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>

vtkStandardNewMacro(vtkHaspOsteotomyFilter);

namespace
{
/// All fragments in one, and whose each triangle is.
void AddMeshes(const hasp::CutBone& cut, vtkPolyData* output)
{
  hasp::TriangleMesh all;
  vtkNew<vtkIntArray> number;
  number->SetName("Fragment");
  for (const hasp::BoneFragment& fragment : cut.fragments)
  {
    const auto first = static_cast<unsigned>(all.points.size());
    all.points.insert(all.points.end(), fragment.mesh.points.begin(), fragment.mesh.points.end());
    for (const glm::uvec3& t : fragment.mesh.triangles)
    {
      all.triangles.push_back(t + first);
      number->InsertNextValue(fragment.number);
    }
  }
  output->ShallowCopy(hasp::MakePolyData(all));
  output->GetCellData()->AddArray(number);
  output->GetCellData()->SetActiveScalars("Fragment");
}

template <typename Items, typename Value>
void AddField(vtkPolyData* output, const char* name, const Items& items, Value value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const auto& item : items)
    array->InsertNextValue(double(value(item)));
  output->GetFieldData()->AddArray(array);
}

void AddMeasures(const hasp::CutBone& cut, vtkPolyData* output)
{
  using Fragment = hasp::BoneFragment;
  using Cut = hasp::CutMeasure;
  AddField(
    output, "FragmentVolumeMm3", cut.fragments, [](const Fragment& f) { return f.volumeMm3; });
  AddField(output, "FragmentCrumb", cut.fragments, [](const Fragment& f) { return f.crumb; });
  AddField(output, "FragmentResected", cut.fragments, [](const Fragment& f) { return f.resected; });
  AddField(output, "CutAreaMm2", cut.cuts, [](const Cut& c) { return c.areaMm2; });
  AddField(output, "CutKerfMm3", cut.cuts, [](const Cut& c) { return c.kerfMm3; });
  AddField(output, "CutLeftMm2", cut.cuts, [](const Cut& c) { return c.leftMm2; });
  AddField(output, "CutFrontMm3", cut.cuts, [](const Cut& c) { return c.frontMm3; });
  AddField(output, "CutBackMm3", cut.cuts, [](const Cut& c) { return c.backMm3; });
  AddField(output, "CutParted", cut.cuts, [](const Cut& c) { return c.parted; });
}
} // namespace

vtkHaspOsteotomyFilter::vtkHaspOsteotomyFilter()
  : Recipe(std::make_unique<hasp::CutRecipe>()),
    Result(std::make_unique<hasp::CutBone>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}
vtkHaspOsteotomyFilter::~vtkHaspOsteotomyFilter() = default;

void vtkHaspOsteotomyFilter::SetRecipe(const hasp::CutRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

bool vtkHaspOsteotomyFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  try
  {
    this->SetRecipe(hasp::ReadCutRecipe(path));
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

int vtkHaspOsteotomyFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkHaspOsteotomyFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkHaspOsteotomyFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* from = inputs[0]->GetInformationObject(0);
  vtkInformation* to = outputs->GetInformationObject(1);
  if (from->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    to->CopyEntry(from, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  return 1;
}

int vtkHaspOsteotomyFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkImageData* labels = vtkImageData::GetData(inputs[1]);
  vtkPolyData* meshes = vtkPolyData::GetData(outputs, 0);
  vtkImageData* numbers = vtkImageData::GetData(outputs, 1);
  meshes->Initialize();
  numbers->Initialize();
  *this->Result = {};
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->GetAbortExecute();
  };
  try
  {
    hasp::BoneImage bone{ hasp::ViewImage(image), {}, this->Label };
    if (labels)
      bone.labels = hasp::ViewImage(labels);
    hasp::CutBone cut = hasp::CutFragments(bone, *this->Recipe, progress);
    if (this->LabelImage)
    {
      const hasp::GridGeometry& grid = hasp::GeometryOf(bone.grey);
      numbers->ShallowCopy(hasp::MakeImage(grid, hasp::LabelFragments(cut.fragments, grid)));
    }
    AddMeshes(cut, meshes);
    AddMeasures(cut, meshes);
    for (hasp::BoneFragment& fragment : cut.fragments)
      fragment.mesh = {};
    *this->Result = std::move(cut);
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

void vtkHaspOsteotomyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cuts: " << this->Recipe->cuts.size() << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "LabelImage: " << this->LabelImage << "\n";
  os << indent << "Fragments: " << this->Result->fragments.size() << "\n";
}
