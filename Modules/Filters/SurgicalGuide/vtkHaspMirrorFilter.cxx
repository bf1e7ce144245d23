#include "vtkHaspMirrorFilter.h"

#include "MirrorGhost.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "Distance/Coverage.h"
#include "Grid/LabelGrid.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkHaspMirrorFilter);

vtkHaspMirrorFilter::vtkHaspMirrorFilter()
{
  this->SetNumberOfInputPorts(2);
}

void vtkHaspMirrorFilter::SetLabelConnection(vtkAlgorithmOutput* labels)
{
  this->SetInputConnection(1, labels);
}

void vtkHaspMirrorFilter::SetLabelData(vtkImageData* labels)
{
  this->SetInputData(1, labels);
}

int vtkHaspMirrorFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkHaspMirrorFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < 2; ++port)
    for (int n = 0; n < inputs[port]->GetNumberOfInformationObjects(); ++n)
      if (vtkInformation* input = inputs[port]->GetInformationObject(n);
          input->Has(Pipeline::WHOLE_EXTENT()))
        input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  return 1;
}

void vtkHaspMirrorFilter::Forget()
{
  for (double* three : { this->UsedPoint, this->UsedNormal })
    std::fill_n(three, 3, 0.0);
  this->MedianDistance = this->DistanceOf95 = this->MatchedShare = 0.0;
}

namespace
{
/// The label's bone, or without labels all large pieces.
std::vector<std::uint8_t> KeptBone(const hasp::AnyGridView& grey, vtkImageData* labels, int label,
  double isovalue, double ignoreBelowMm3)
{
  if (!labels)
    return hasp::KeepLargePieces(grey, isovalue, ignoreBelowMm3);
  const hasp::AnyGridView view = hasp::ViewImage(labels);
  hasp::CheckLabelGrid("mirror", hasp::GeometryOf(grey), hasp::GeometryOf(view));
  return hasp::KeepLabel(view, label);
}

void Give(const hasp::MirrorGhost& ghost, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> distances;
  distances->SetName("SignedDistance");
  distances->SetNumberOfTuples(vtkIdType(ghost.signedDistanceMm.size()));
  std::copy(ghost.signedDistanceMm.begin(), ghost.signedDistanceMm.end(), distances->GetPointer(0));
  output->ShallowCopy(hasp::MakePolyData(ghost.mesh));
  output->GetPointData()->SetScalars(distances);
}
} // namespace

int vtkHaspMirrorFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  this->Forget();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      const hasp::AnyGridView grey = hasp::ViewImage(vtkImageData::GetData(inputs[0]));
      const std::vector<std::uint8_t> keep = KeptBone(
        grey, vtkImageData::GetData(inputs[1]), this->Label, this->IsoValue, this->IgnoreBelow);
      hasp::MirrorGhostSettings settings;
      settings.spacingMm = this->Spacing;
      if (const double* p = this->PlanePoint, *n = this->PlaneNormal; !this->FindPlane)
        settings.plane = hasp::MirrorPlane{ { p[0], p[1], p[2] }, { n[0], n[1], n[2] } };
      const hasp::MirrorGhost ghost =
        hasp::MakeMirrorGhost(grey, this->IsoValue, keep, settings, progress);
      Give(ghost, output);
      for (int a = 0; a < 3; ++a)
      {
        this->UsedPoint[a] = ghost.plane.point[a];
        this->UsedNormal[a] = ghost.plane.normal[a];
      }
      this->MedianDistance = ghost.medianMm;
      this->DistanceOf95 = ghost.p95Mm;
      this->MatchedShare = ghost.matchedShare;
    });
}

void vtkHaspMirrorFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsoValue: " << this->IsoValue << "\n"
     << indent << "Label: " << this->Label << "\n"
     << indent << "IgnoreBelow: " << this->IgnoreBelow << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "FindPlane: " << this->FindPlane << "\n"
     << indent << "MedianDistance: " << this->MedianDistance << "\n"
     << indent << "DistanceOf95: " << this->DistanceOf95 << "\n"
     << indent << "MatchedShare: " << this->MatchedShare << "\n";
}
