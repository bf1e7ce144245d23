#include "vtkHaspFragmentSurface.h"

#include "vtkHaspFilterRun.h"
#include "vtkHaspFragmentScan.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedShortArray.h"

#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspFragmentSurface);

vtkHaspFragmentSurface::vtkHaspFragmentSurface()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHaspFragmentSurface::SetLabelConnection(vtkAlgorithmOutput* labels)
{
  this->SetInputConnection(1, labels);
}

void vtkHaspFragmentSurface::SetLabelData(vtkImageData* labels)
{
  this->SetInputData(1, labels);
}

int vtkHaspFragmentSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHaspFragmentSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < 2; ++port)
    if (vtkInformation* input = inputs[port]->GetInformationObject(0);
        input->Has(Pipeline::WHOLE_EXTENT()))
      input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  return 1;
}

namespace
{
/// Meshes in one, each with its label.
class LabelledMeshes
{
public:
  void Add(const hasp::TriangleMesh& mesh, std::uint16_t label)
  {
    if (this->All.points.size() + mesh.points.size() > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("the surfaces have 2^32 points or more: choose a larger Spacing");
    const auto first = static_cast<std::uint32_t>(this->All.points.size());
    this->All.points.insert(this->All.points.end(), mesh.points.begin(), mesh.points.end());
    for (const glm::uvec3& triangle : mesh.triangles)
    {
      this->All.triangles.push_back(triangle + first);
      this->Labels->InsertNextValue(label);
    }
  }
  void Give(vtkPolyData* output)
  {
    this->Labels->SetName("Label");
    output->ShallowCopy(hasp::MakePolyData(this->All));
    output->GetCellData()->SetScalars(this->Labels);
  }

private:
  hasp::TriangleMesh All;
  vtkNew<vtkUnsignedShortArray> Labels;
};
} // namespace

int vtkHaspFragmentSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      hasp::FragmentModels models(hasp::FragmentScanOf(vtkImageData::GetData(inputs[0]),
                                    vtkImageData::GetData(inputs[1]), this->IsoValue),
        { .spacingMm = this->Spacing });
      std::vector<std::uint16_t> labels;
      if (this->Label != 0)
        labels.push_back(static_cast<std::uint16_t>(this->Label));
      else
        for (const hasp::FragmentLabel& there : models.Labels())
          labels.push_back(there.label);
      models.Prepare(labels, { .surface = true }, progress);
      LabelledMeshes meshes;
      for (const std::uint16_t label : labels)
      {
        meshes.Add(*models.Surface(label), label);
        models.Release(label);
      }
      meshes.Give(output);
    });
}

void vtkHaspFragmentSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n"
     << indent << "Label: " << this->Label << "\n"
     << indent << "Spacing: " << this->Spacing << "\n";
}
