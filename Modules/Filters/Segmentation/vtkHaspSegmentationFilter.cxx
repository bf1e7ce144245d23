#include "vtkHaspSegmentationFilter.h"

#include "SegmentationWarnings.h"
#include "Segmenter.h"
#include "vtkHaspFilterRun.h"
#if HASP_WITH_JSON
#include "Planning/SegmentationRecipeFile.h"
#endif

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkHaspSegmentationFilter);

vtkHaspSegmentationFilter::vtkHaspSegmentationFilter()
  : Recipe(std::make_unique<hasp::SegmentationRecipe>()),
    Tolerance(hasp::RandomWalkerSettings{}.tolerance)
{
  this->SetNumberOfInputPorts(2);
}
vtkHaspSegmentationFilter::~vtkHaspSegmentationFilter() = default;

void vtkHaspSegmentationFilter::SetRecipe(const hasp::SegmentationRecipe& recipe)
{
  if (*this->Recipe == recipe)
    return;
  *this->Recipe = recipe;
  this->Modified();
}

bool vtkHaspSegmentationFilter::ReadRecipe(const std::string& path)
{
#if HASP_WITH_JSON
  try
  {
    this->SetRecipe(hasp::ReadSegmentationRecipe(path));
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

void vtkHaspSegmentationFilter::SetTolerance(double tolerance)
{
  if (tolerance == this->Tolerance)
    return;
  this->Tolerance = tolerance;
  this->Modified();
}

int vtkHaspSegmentationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkHaspSegmentationFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(
    outputs->GetInformationObject(0), VTK_UNSIGNED_SHORT, 1);
  return 1;
}

int vtkHaspSegmentationFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < 2; ++port) // a walk goes through the whole bone
    for (int n = 0; n < inputs[port]->GetNumberOfInformationObjects(); ++n)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(n);
      if (input->Has(Pipeline::WHOLE_EXTENT()))
        input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  return 1;
}

int vtkHaspSegmentationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* scan = vtkImageData::GetData(inputs[0]);
  vtkImageData* labels =
    inputs[1]->GetNumberOfInformationObjects() > 0 ? vtkImageData::GetData(inputs[1]) : nullptr;
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      if (!(this->Tolerance > 0.0 && this->Tolerance <= 0.1)) // also where no step asks for it
        throw std::invalid_argument(
          "Tolerance is " + std::to_string(this->Tolerance) + ", must be in (0, 0.1]");
      const hasp::SegmentedScan made =
        hasp::SegmentScan(scan, *this->Recipe, labels, { .tolerance = this->Tolerance }, progress);
      output->ShallowCopy(made.labels);
      const double* spacing = output->GetSpacing();
      for (const std::string& warning :
        hasp::WarningsOf(*this->Recipe, made.findings, spacing[0] * spacing[1] * spacing[2]))
        vtkWarningMacro(<< warning);
    });
}

void vtkHaspSegmentationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Steps: " << this->Recipe->steps.size() << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
