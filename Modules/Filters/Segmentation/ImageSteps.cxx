#include "ImageSteps.h"

#include "Segmentation/ConeBeam.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ParallelFor.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageAnisotropicDiffusion3D.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkImageMedian3D.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// In (0, most].
void CheckAboveZero(const char* name, double value, double most)
{
  if (!(value > 0.0 && value <= most))
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                ", must be in (0, " + std::to_string(most) + "]");
}

constexpr int MostOfMedian = 4096; // voxels of its box

/// Of a median, voxels along each axis.
glm::dvec3 MedianBox(const GridGeometry& grid, double radiusMm)
{
  glm::dvec3 box;
  for (int a = 0; a < 3; ++a)
  {
    const double reach = std::max(std::round(radiusMm / grid.spacing[a]), 1.0);
    box[a] = 2.0 * std::min(reach, grid.dims[a] - 1.0) + 1.0;
  }
  return box;
}

/// Throws std::invalid_argument, with the largest radius that will do.
void CheckMedian(const GridGeometry& grid, double radiusMm)
{
  const auto voxels = [&](double mm)
  {
    const glm::dvec3 box = MedianBox(grid, mm);
    return box.x * box.y * box.z;
  };
  if (voxels(radiusMm) <= MostOfMedian)
    return;
  double least = 0.0, most = radiusMm;
  for (int n = 0; n < 40; ++n)
  {
    const double middle = 0.5 * (least + most);
    (voxels(middle) <= MostOfMedian ? least : most) = middle;
  }
  throw std::invalid_argument("radiusMm is " + std::to_string(radiusMm) + ", a median of " +
                              std::to_string(std::llround(voxels(radiusMm))) +
                              " voxels of this scan, must be of at most " +
                              std::to_string(MostOfMedian) + ": take " +
                              std::to_string(std::floor(least * 1e3) / 1e3) + " or less");
}

/// The samples as float, upright from index 0: older filters lose directions, and some extents.
vtkSmartPointer<vtkImageData> UprightFloat(const AnyGridView& view, vtkDataArray* scalars)
{
  const GridGeometry& geometry = GeometryOf(view);
  auto upright = vtkSmartPointer<vtkImageData>::New();
  upright->SetDimensions(&geometry.dims.x);
  upright->SetSpacing(geometry.spacing.x, geometry.spacing.y, geometry.spacing.z);
  if (scalars->GetDataType() == VTK_FLOAT)
  {
    upright->GetPointData()->SetScalars(scalars); // read alone: no copy
    return upright;
  }
  upright->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(upright->GetScalarPointer());
  std::visit([&](const auto& grid) { std::copy_n(grid.data, geometry.Size(), samples); }, view);
  return upright;
}

/// `scalars` on the grid of an image.
vtkSmartPointer<vtkImageData> OnGridOf(vtkImageData* image, vtkDataArray* scalars)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  scalars->SetName(image->GetPointData()->GetScalars()->GetName());
  result->GetPointData()->SetScalars(scalars);
  return result;
}

/// Hears a filter out: its progress goes on, an end that is asked for reaches it, its errors are
/// kept and not printed. Exceptions must not fly through VTK.
class Listener
{
public:
  Listener(vtkAlgorithm* filter, const ProgressFunction& progress)
    : Filter(filter),
      Progress(progress)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
      { static_cast<Listener*>(self)->Hear(event); });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
    filter->AddObserver(vtkCommand::ErrorEvent, this->Command);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Listener()
  {
    this->Filter->RemoveObserver(this->Command);
    this->Filter->GetExecutive()->RemoveObserver(this->Command);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// What was heard, as an exception.
  void Throw() const
  {
    if (this->Thrown)
      std::rethrow_exception(this->Thrown);
    if (this->Failed)
      throw std::runtime_error(
        std::string(this->Filter->GetClassName()) + " failed: is there enough memory?");
  }

private:
  void Hear(unsigned long event)
  {
    if (event == vtkCommand::ErrorEvent)
      this->Failed = true;
    else if (!this->Thrown && this->Filter->GetProgress() >= this->Most)
    {
      this->Most = this->Filter->GetProgress();
      try
      {
        ReportProgress(this->Progress, std::clamp(this->Most, 0.0, 1.0));
      }
      catch (...)
      {
        this->Thrown = std::current_exception();
        this->Filter->AbortExecuteOn();
      }
    }
  }

  vtkAlgorithm* Filter;
  ProgressFunction Progress;
  vtkNew<vtkCallbackCommand> Command;
  double Most = 0.0;
  std::exception_ptr Thrown;
  bool Failed = false;
};

/// Runs one of VTK's filters over an image.
vtkSmartPointer<vtkImageData> Filtered(vtkImageData* image, const AnyGridView& view,
  vtkThreadedImageAlgorithm* filter, const ProgressFunction& progress)
{
  ReportProgress(progress, 0.0);
  filter->SetInputData(UprightFloat(view, image->GetPointData()->GetScalars()));
  filter->SetEnableSMP(false); // progress would come from threads of the pool
  filter->SetNumberOfThreads(std::clamp(ParallelThreads(), 1, VTK_MAX_THREADS));
  {
    const Listener listener(filter, progress);
    filter->Update();
    listener.Throw();
  }
  vtkDataArray* scalars = filter->GetOutput()->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
    throw std::runtime_error(std::string(filter->GetClassName()) + " gave no image");
  ReportProgress(progress, 1.0);
  return OnGridOf(image, scalars);
}

} // namespace

vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const GaussianStep& step, const ProgressFunction& progress)
{
  CheckAboveZero("sigmaMm", step.sigmaMm, 10.0);
  const AnyGridView view = ViewImage(image);
  const glm::dvec3 sigma = step.sigmaMm / GeometryOf(view).spacing;
  vtkNew<vtkImageGaussianSmooth> filter;
  filter->SetStandardDeviations(sigma.x, sigma.y, sigma.z);
  filter->SetRadiusFactor(4.0); // VTK's own 1.5 makes another, narrower blur
  return Filtered(image, view, filter, progress);
}

vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const MedianStep& step, const ProgressFunction& progress)
{
  CheckAboveZero("radiusMm", step.radiusMm, 10.0);
  const AnyGridView view = ViewImage(image);
  const GridGeometry& grid = GeometryOf(view);
  CheckMedian(grid, step.radiusMm);
  const glm::dvec3 box = MedianBox(grid, step.radiusMm);
  vtkNew<vtkImageMedian3D> filter;
  filter->SetKernelSize(int(box.x), int(box.y), int(box.z));
  return Filtered(image, view, filter, progress);
}

vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const EdgePreservingStep& step, const ProgressFunction& progress)
{
  CheckAboveZero("edge", step.edge, 1e6);
  if (step.iterations < 1 || step.iterations > 100)
    throw std::invalid_argument(
      "iterations is " + std::to_string(step.iterations) + ", must be in [1, 100]");
  const AnyGridView view = ViewImage(image);
  vtkNew<vtkImageAnisotropicDiffusion3D> filter;
  filter->SetNumberOfIterations(step.iterations);
  filter->SetDiffusionThreshold(step.edge);
  filter->SetDiffusionFactor(1.0);
  filter->GradientMagnitudeThresholdOff(); // a step between two voxels, as the recipe says
  filter->FacesOn();
  filter->EdgesOn();
  filter->CornersOn();
  return Filtered(image, view, filter, progress);
}

vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const ConeBeamStep& step, const ProgressFunction& progress)
{
  const AnyGridView view = ViewImage(image);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfValues(image->GetNumberOfPoints());
  CorrectConeBeam(view,
    { .fieldMm = step.fieldMm, .contrastMm = step.contrastMm, .insideAbove = step.insideAbove },
    { scalars->GetPointer(0), GeometryOf(view) }, progress);
  return OnGridOf(image, scalars);
}

} // namespace hasp
