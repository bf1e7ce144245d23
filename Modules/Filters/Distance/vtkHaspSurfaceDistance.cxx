#include "vtkHaspSurfaceDistance.h"

#include "Distance/BodyDistance.h"
#include "Distance/DistanceLookup.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspSurfaceDistance);

namespace
{
constexpr double SamplesAlong = 160.0; // the longest side, where nothing is asked for
}

/// The reference's samples, and what they were made of.
struct vtkHaspSurfaceDistance::Internals
{
  hasp::BodyDistance baked;
  vtkDataObject* of = nullptr; ///< to be told from another, not to be used
  vtkMTimeType at = 0;
  double spacing = -1.0, band = -1.0;

  /// True: they were made anew.
  bool Bake(vtkPolyData* reference, double wantedSpacing, double wantedBand,
    const hasp::ProgressFunction& progress)
  {
    if (this->of == reference && this->at == reference->GetMTime() &&
        this->spacing == wantedSpacing && this->band == wantedBand)
      return false;
    const hasp::TriangleMesh mesh = hasp::TrianglesOf(reference);
    const double* b = reference->GetBounds();
    hasp::BodyDistanceSettings settings;
    const double longest = std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] }) + 2.0 * wantedBand;
    settings.spacingMm = wantedSpacing > 0.0 ? wantedSpacing : longest / SamplesAlong;
    settings.bandMm = wantedBand;
    this->of = nullptr; // whatever becomes of it
    this->baked = hasp::DistanceOfMesh(mesh, settings, progress);
    this->of = reference;
    this->at = reference->GetMTime();
    this->spacing = wantedSpacing;
    this->band = wantedBand;
    return true;
  }
};

namespace
{

hasp::GridView<const float> SamplesOf(vtkImageData* image)
{
  const hasp::AnyGridView view = hasp::ViewImage(image);
  const auto* distances = std::get_if<hasp::GridView<const float>>(&view);
  if (!distances)
    throw std::invalid_argument(
      "the reference's samples are not of type float, so they are no distances in mm: "
      "vtkHaspSignedDistance makes such");
  return *distances;
}

glm::dmat4 PoseOf(vtkMatrix4x4* matrix)
{
  glm::dmat4 pose(1.0);
  for (int r = 0; matrix && r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      pose[c][r] = matrix->GetElement(r, c);
  return pose;
}

template <typename Array>
std::span<const typename Array::ValueType> Coordinates(Array* array)
{
  return { array->GetPointer(0), std::size_t(array->GetNumberOfValues()) };
}

void LookUp(const hasp::GridView<const float>& samples, const glm::dmat4& pose, vtkPoints* points,
  std::span<float> found)
{
  if (auto* floats = vtkFloatArray::SafeDownCast(points->GetData()))
    return hasp::LookUpDistances<float>(samples, pose, Coordinates(floats), found);
  if (auto* doubles = vtkDoubleArray::SafeDownCast(points->GetData()))
    return hasp::LookUpDistances<double>(samples, pose, Coordinates(doubles), found);
  vtkNew<vtkDoubleArray> copied;
  copied->DeepCopy(points->GetData());
  hasp::LookUpDistances<double>(samples, pose, Coordinates(copied.Get()), found);
}

} // namespace

vtkHaspSurfaceDistance::vtkHaspSurfaceDistance() : Inside(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
}

vtkHaspSurfaceDistance::~vtkHaspSurfaceDistance() = default;

void vtkHaspSurfaceDistance::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

void vtkHaspSurfaceDistance::SetReferenceData(vtkDataObject* reference)
{
  this->SetInputData(1, reference);
}

void vtkHaspSurfaceDistance::SetSurfaceToReference(vtkMatrix4x4* pose)
{
  if (this->SurfaceToReference == pose)
    return;
  this->SurfaceToReference = pose;
  this->Modified();
}

vtkMatrix4x4* vtkHaspSurfaceDistance::GetSurfaceToReference()
{
  return this->SurfaceToReference;
}

vtkMTimeType vtkHaspSurfaceDistance::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->SurfaceToReference ? std::max(own, this->SurfaceToReference->GetMTime()) : own;
}

int vtkHaspSurfaceDistance::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
    return this->Superclass::FillInputPortInformation(port, info);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHaspSurfaceDistance::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* surface = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      if (auto* mesh = vtkPolyData::GetData(inputs[1]))
        this->Samplings += this->Inside->Bake(mesh, this->Spacing, this->Band, progress);
      auto* image = vtkImageData::GetData(inputs[1]);
      const auto samples = image ? SamplesOf(image) : this->Inside->baked.View();
      vtkNew<vtkFloatArray> distances;
      distances->SetName("SignedDistance");
      distances->SetNumberOfValues(surface->GetNumberOfPoints());
      if (surface->GetNumberOfPoints() > 0)
        LookUp(samples, PoseOf(this->SurfaceToReference), surface->GetPoints(),
          { distances->GetPointer(0), std::size_t(distances->GetNumberOfValues()) });
      output->ShallowCopy(surface);
      output->GetPointData()->SetScalars(distances);
    });
}

void vtkHaspSurfaceDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceToReference: " << this->SurfaceToReference.Get() << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "Band: " << this->Band << "\n"
     << indent << "Samplings: " << this->Samplings << "\n";
}
