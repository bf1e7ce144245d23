#include "vtkHaspCoverage.h"

#include "Distance/Coverage.h"
#include "Distance/MeshCoverage.h"
#include "ImageOutput.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspCoverage);

vtkHaspCoverage::vtkHaspCoverage()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHaspCoverage::SetGridConnection(vtkAlgorithmOutput* grid)
{
  this->SetInputConnection(1, grid);
}

void vtkHaspCoverage::SetGridData(vtkImageData* grid)
{
  this->SetInputData(1, grid);
}

int vtkHaspCoverage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 0)
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

namespace
{

/// Whose grid the output has.
vtkInformation* GridInformation(vtkInformationVector** inputs)
{
  if (vtkInformation* grid = inputs[1]->GetInformationObject(0))
    return grid;
  vtkInformation* volume = inputs[0]->GetInformationObject(0);
  if (!vtkImageData::GetData(volume))
    throw std::invalid_argument("a surface has no grid of its own: SetGridData or "
                                "SetGridConnection");
  return volume;
}

/// How far a mesh reaches beyond the voxels of a grid, mm; 0 if it does not.
double Beyond(const hasp::TriangleMesh& mesh, const hasp::GridGeometry& grid)
{
  glm::dvec3 most(0.0);
  for (const glm::dvec3& point : mesh.points)
  {
    const glm::dvec3 index = grid.WorldToIndex(point);
    most = glm::max(most, glm::max(-0.5 - index, index - glm::dvec3(grid.dims) + 0.5));
  }
  const glm::dvec3 mm = most * grid.spacing;
  return std::max({ mm.x, mm.y, mm.z });
}

} // namespace

int vtkHaspCoverage::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction&)
    {
      hasp::SayImage(
        outputs->GetInformationObject(0), hasp::PipelineGeometry(GridInformation(inputs)));
    });
}

int vtkHaspCoverage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
    if (vtkInformation* input = inputs[port]->GetInformationObject(0))
      hasp::AskForAll(input);
  return 1;
}

int vtkHaspCoverage::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      const hasp::GridGeometry grid = hasp::PipelineGeometry(GridInformation(inputs));
      if (vtkPolyData* surface = vtkPolyData::GetData(inputs[0]))
      {
        const hasp::TriangleMesh mesh = hasp::TrianglesOf(surface);
        if (mesh.triangles.empty())
          throw std::invalid_argument("the surface has no triangles");
        if (const double mm = Beyond(mesh, grid); mm > 0.0)
          vtkWarningMacro(
            "the surface reaches " << mm << " mm beyond its grid, and is cut off there");
        return hasp::GiveImage(
          output, grid, hasp::MeshCoverage(mesh, grid, this->SamplesPerAxis, progress), "Coverage");
      }
      vtkImageData* volume = vtkImageData::GetData(inputs[0]);
      std::vector<std::uint8_t> keep;
      if (!this->LabelArrayName.empty())
      {
        vtkDataArray* labels = volume->GetPointData()->GetArray(this->LabelArrayName.c_str());
        if (!labels)
          throw std::invalid_argument(
            "the volume has no point array " + this->LabelArrayName + " for labels");
        keep = hasp::KeepLabel(hasp::ViewPointArray(volume, labels), this->Label);
      }
      hasp::GiveImage(output, grid,
        hasp::Coverage(hasp::ViewImage(volume), grid,
          { .isovalue = this->IsoValue, .samplesPerAxis = this->SamplesPerAxis, .keep = keep },
          progress),
        "Coverage");
    });
}

void vtkHaspCoverage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n"
     << indent << "SamplesPerAxis: " << this->SamplesPerAxis << "\n"
     << indent << "LabelArrayName: " << this->LabelArrayName << "\n"
     << indent << "Label: " << this->Label << "\n";
}
