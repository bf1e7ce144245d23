#include "vtkHaspGuideFilter.h"

#include "GuideBuilder.h"
#include "Planning/GuideRecipe.h"
#include "RecipeFilter.h"
#if HASP_WITH_JSON
#include "Planning/GuideRecipeFile.h"
#endif

#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
vtkStandardNewMacro(vtkHaspGuideFilter);

vtkHaspGuideFilter::vtkHaspGuideFilter()
  : Recipe(std::make_unique<hasp::GuideRecipe>()),
    MadeRecipe(std::make_unique<hasp::GuideRecipe>())
{
}
vtkHaspGuideFilter::~vtkHaspGuideFilter() = default;

void vtkHaspGuideFilter::SetRecipe(const hasp::GuideRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

void vtkHaspGuideFilter::SetBlades(const std::vector<hasp::Osteotomy>& blades)
{
  if (this->Blades == blades)
    return;
  this->Blades = blades;
  this->Modified();
}

bool vtkHaspGuideFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  return hasp::Succeeds(this, [&] { this->SetRecipe(hasp::ReadGuideRecipe(path)); });
#else
  (void)path;
  return hasp::CannotReadRecipe(this);
#endif
}

int vtkHaspGuideFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  return hasp::AskForImages(port, info);
}

int vtkHaspGuideFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  return hasp::Succeeds(this,
    [&]
    {
      const hasp::BuiltGuide guide = hasp::BuildGuide(
        hasp::ViewImage(image), *this->Recipe, this->Blades, hasp::ProgressOf(this));
      output->ShallowCopy(hasp::MakePolyData(guide.mesh));
      *this->MadeRecipe = guide.made.recipe;
      this->UndercutShare = guide.made.undercut;
    });
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
  vtkSmartPointer<vtkImageData> preview;
  hasp::Succeeds(this,
    [&]
    {
      const hasp::GuideSamples samples = hasp::SampleGuide(
        hasp::MakePreviewSolid(hasp::ViewImage(image), *this->Recipe, this->Blades, spacingMm),
        spacingMm);
      preview = hasp::MakeImage(samples.grid, samples.values);
    });
  return preview;
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
