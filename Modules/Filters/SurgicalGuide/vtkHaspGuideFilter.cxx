#include "vtkHaspGuideFilter.h"

#include "GuideBuilder.h"
#include "Planning/GuideRecipe.h"
#if HASP_WITH_JSON
#include "Planning/GuideRecipeFile.h"
#endif

#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkHaspGuideFilter);

vtkHaspGuideFilter::vtkHaspGuideFilter()
  : Recipe(std::make_unique<hasp::GuideRecipe>()),
    MadeRecipe(std::make_unique<hasp::GuideRecipe>())
{
}
vtkHaspGuideFilter::~vtkHaspGuideFilter() = default;

void vtkHaspGuideFilter::SetRecipe(const hasp::GuideRecipe& recipe)
{
  *this->Recipe = recipe;
  this->Modified();
}

void vtkHaspGuideFilter::SetBlades(const std::vector<hasp::Osteotomy>& blades)
{
  this->Blades = blades;
  this->Modified();
}

bool vtkHaspGuideFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  try
  {
    this->SetRecipe(hasp::ReadGuideRecipe(path));
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
#else
  vtkErrorMacro("cannot read " << path << ": built without HASP_ENABLE_JSON");
  return false;
#endif
}

int vtkHaspGuideFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHaspGuideFilter::RequestData(
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
    const hasp::BuiltGuide guide =
      hasp::BuildGuide(hasp::ViewImage(image), *this->Recipe, this->Blades, progress);
    output->ShallowCopy(hasp::MakePolyData(guide.mesh));
    *this->MadeRecipe = guide.made.recipe;
    this->UndercutShare = guide.made.undercut;
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

vtkSmartPointer<vtkImageData> vtkHaspGuideFilter::MakePreview(double spacingMm)
{
  vtkImageData* image = nullptr;
  if (vtkAlgorithm* input = this->GetInputAlgorithm())
  {
    input->Update();
    image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  }
  if (!image)
  {
    vtkErrorMacro("has no image to make a preview from");
    return nullptr;
  }
  try
  {
    const hasp::GuideSamples samples = hasp::SampleGuide(
      hasp::MakePreviewSolid(hasp::ViewImage(image), *this->Recipe, this->Blades, spacingMm),
      spacingMm);
    return hasp::MakeImage(samples.grid, samples.values);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return nullptr;
  }
}

void vtkHaspGuideFilter::GetInsertionAxis(double direction[3]) const
{
  std::copy_n(&this->MadeRecipe->withdrawal.x, 3, direction);
}

double vtkHaspGuideFilter::GetUndercutShare() const
{
  return this->UndercutShare;
}

void vtkHaspGuideFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Landmarks: " << this->Recipe->landmarks.size() << "\n";
  os << indent << "Gap: " << this->Recipe->gapMm << " mm\n";
  os << indent << "Thickness: " << this->Recipe->thicknessMm << " mm\n";
  os << indent << "Slots: " << this->Recipe->slots.size() << "\n";
  os << indent << "Holes: " << this->Recipe->holes.size() << "\n";
  const glm::dvec3& axis = this->MadeRecipe->withdrawal;
  os << indent << "InsertionAxis: " << axis.x << ", " << axis.y << ", " << axis.z << "\n";
  os << indent << "Blades: " << this->Blades.size() << "\n";
  os << indent << "UndercutShare: " << this->UndercutShare << "\n";
}
