#include "vtkHaspOsteotomyFilter.h"

#include "FragmentCutter.h"
#include "Planning/CutRecipe.h"
#include "RecipeFilter.h"
#if HASP_WITH_JSON
#include "Planning/CutRecipeFile.h"
#endif

#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkHaspOsteotomyFilter);

namespace
{
/// All fragments in one, and whose each triangle is.
void AddMeshes(const hasp::CutBone& cut, vtkPolyData* output)
{
  hasp::NumberedMeshes all;
  for (const hasp::BoneFragment& fragment : cut.fragments)
    all.Add(fragment.mesh, fragment.number);
  all.Give(output, "Fragment");
}

void AddMeasures(const hasp::CutBone& cut, vtkPolyData* output)
{
  using Fragment = hasp::BoneFragment;
  using Cut = hasp::CutMeasure;
  hasp::AddField(
    output, "FragmentVolumeMm3", cut.fragments, [](const Fragment& f) { return f.volumeMm3; });
  hasp::AddField(output, "FragmentCrumb", cut.fragments, [](const Fragment& f) { return f.crumb; });
  hasp::AddField(
    output, "FragmentResected", cut.fragments, [](const Fragment& f) { return f.resected; });
  hasp::AddField(output, "CutAreaMm2", cut.cuts, [](const Cut& c) { return c.areaMm2; });
  hasp::AddField(output, "CutKerfMm3", cut.cuts, [](const Cut& c) { return c.kerfMm3; });
  hasp::AddField(output, "CutLeftMm2", cut.cuts, [](const Cut& c) { return c.leftMm2; });
  hasp::AddField(output, "CutFrontMm3", cut.cuts, [](const Cut& c) { return c.frontMm3; });
  hasp::AddField(output, "CutBackMm3", cut.cuts, [](const Cut& c) { return c.backMm3; });
  hasp::AddField(output, "CutParted", cut.cuts, [](const Cut& c) { return c.parted; });
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
  return hasp::Succeeds(this, [&] { this->SetRecipe(hasp::ReadCutRecipe(path)); });
#else
  (void)path;
  return hasp::CannotReadRecipe(this);
#endif
}

int vtkHaspOsteotomyFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return hasp::AskForImages(port, info);
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
  return hasp::Succeeds(this,
    [&]
    {
      hasp::BoneImage bone{ hasp::ViewImage(image), {}, this->Label };
      if (labels)
        bone.labels = hasp::ViewImage(labels);
      hasp::CutBone cut = hasp::CutFragments(bone, *this->Recipe, hasp::ProgressOf(this));
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
    });
}

void vtkHaspOsteotomyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cuts: " << this->Recipe->cuts.size() << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "LabelImage: " << this->LabelImage << "\n";
  os << indent << "Fragments: " << this->Result->fragments.size() << "\n";
}
