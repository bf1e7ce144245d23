#include "VtkRivals.h"

#include "MeasuredChild.h"

#include "vtkFlyingEdges3D.h"
#include "vtkHaspVolumeView.h"
#include "vtkImageData.h"
#include "vtkImageEuclideanDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedDistance.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace hasp
{
namespace
{

vtkSmartPointer<vtkImageData> ImageOf(
  const GridGeometry& grid, const std::vector<std::uint8_t>& values, bool turned)
{
  std::vector<std::uint8_t> sides(values.size());
  std::transform(values.begin(), values.end(), sides.begin(),
    [&](std::uint8_t value) { return static_cast<std::uint8_t>((value != 0) != turned); });
  return MakeImage(grid, sides);
}

/// Squared distances from voxels that are not 0 to those that are.
class EuclideanRun final : public RivalRun
{
public:
  explicit EuclideanRun(const TransformInput& input) : Input(&input)
  {
    for (const bool turned : { false, true })
    {
      vtkImageEuclideanDistance* side = turned ? this->Outside : this->Inside;
      // In voxels: with spacing below 1 some voxels keep its largest distance (VTK 9.1).
      GridGeometry cubes = input.grid;
      cubes.spacing = glm::dvec3(1.0);
      side->SetInputData(ImageOf(cubes, input.mask, turned));
      side->SetAlgorithmToSaito();
    }
  }
  void Run() override
  {
    for (vtkImageEuclideanDistance* side : { this->Inside.Get(), this->Outside.Get() })
    {
      side->Modified();
      side->Update();
    }
  }
  std::vector<float> Distances() const override
  {
    const auto* in = static_cast<const double*>(this->Inside->GetOutput()->GetScalarPointer());
    const auto* out = static_cast<const double*>(this->Outside->GetOutput()->GetScalarPointer());
    const double voxel = this->Input->grid.spacing.x; // the surface lies between two
    std::vector<float> distances(this->Input->mask.size());
    for (std::size_t v = 0; v < distances.size(); ++v)
      distances[v] = static_cast<float>(
        voxel * (this->Input->mask[v] ? 0.5 - std::sqrt(in[v]) : std::sqrt(out[v]) - 0.5));
    return distances;
  }

private:
  const TransformInput* Input;
  vtkNew<vtkImageEuclideanDistance> Inside, Outside;
};

class PointsRun final : public RivalRun
{
public:
  explicit PointsRun(const TransformInput& input) : Grid(input.grid)
  {
    const auto image = MakeImage(input.grid, input.coverage);
    this->Contour->SetInputData(image);
    this->Contour->SetValue(0, 0.5);
    this->Contour->ComputeNormalsOn();
    this->Contour->ComputeScalarsOff();
    double bounds[6];
    image->GetBounds(bounds);
    this->Signed->SetInputConnection(this->Contour->GetOutputPort());
    this->Signed->SetDimensions(input.grid.dims.x, input.grid.dims.y, input.grid.dims.z);
    this->Signed->SetBounds(bounds);
    this->Signed->SetRadius(4.0 * input.grid.spacing.x);
  }
  void Run() override
  {
    this->Contour->Modified();
    this->Signed->Update();
  }
  std::vector<float> Distances() const override
  {
    const auto* values = static_cast<const float*>(this->Signed->GetOutput()->GetScalarPointer());
    std::vector<float> distances(values, values + this->Grid.Size());
    for (float& distance : distances) // its normals point to where coverage grows
      distance = -distance;
    return distances;
  }

private:
  GridGeometry Grid;
  vtkNew<vtkFlyingEdges3D> Contour;
  vtkNew<vtkSignedDistance> Signed;
};

std::string Vtk()
{
  return std::string("VTK ") + vtkVersion::GetVTKVersion();
}

} // namespace

RivalTransform VtkEuclideanRival()
{
  RivalTransform rival;
  rival.key = "vtk";
  rival.name = Vtk() + " vtkImageEuclideanDistance (Saito), inside and outside";
  rival.exact = true;
  rival.make = [](const TransformInput& input) { return std::make_unique<EuclideanRun>(input); };
  return rival;
}

RivalTransform VtkPointsRival()
{
  RivalTransform rival;
  rival.key = "vtk.points";
  rival.name =
    Vtk() + " vtkFlyingEdges3D of coverage at 0.5, vtkSignedDistance to its points within 4 voxels";
  rival.band = true;
  rival.make = [](const TransformInput& input) { return std::make_unique<PointsRun>(input); };
  return rival;
}

PlainContour FlyingEdges()
{
  PlainContour plain;
  plain.name = Vtk() + " vtkFlyingEdges3D";
  plain.make = [](const std::vector<float>& values, const GridGeometry& grid)
  {
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(MakeImage(grid, values));
    edges->SetValue(0, 0.0);
    edges->ComputeNormalsOff();
    edges->Update();
    return MakeTriangleMesh(edges->GetOutput());
  };
  return plain;
}

BooleanRival VtkBooleans()
{
  constexpr double LimitS = 60.0;
  BooleanRival rival;
  rival.name = Vtk() + " vtkBooleanOperationPolyDataFilter of meshes of 64 corners a circle, boxes "
                       "of 192 triangles, in a "
                       "child process of 60 s";
  std::error_code none;
  const std::filesystem::path program =
    std::filesystem::read_symlink("/proc/self/exe", none).replace_filename("hasp-boolean-rival");
  if (!std::filesystem::exists(program, none))
  {
    rival.absent = "hasp-boolean-rival, its child process, is not beside this program";
    return rival;
  }
  rival.run = [program](std::uint32_t seed, int depth)
  {
    BooleanOutcome outcome;
    try
    {
      const MeasuredChild child =
        RunMeasured({ std::to_string(seed), std::to_string(depth) }, { program.string(), LimitS });
      int closed = 0, manifold = 0;
      if (child.late)
        outcome.ending = "60 s";
      else if (child.exitCode != 0 ||
               std::sscanf(child.output.c_str(), "%d %d %ld %lf %lf", &closed, &manifold,
                 &outcome.crossings, &outcome.volumeMm3, &outcome.seconds) != 5)
        outcome.ending = "exit code " + std::to_string(child.exitCode);
      if (!outcome.ending.empty())
        outcome.seconds = child.seconds;
      outcome.closed = closed != 0;
      outcome.manifold = manifold != 0;
    }
    catch (const std::runtime_error& failure) // it ended before it could be looked at
    {
      outcome.ending = failure.what();
    }
    return outcome;
  };
  return rival;
}

} // namespace hasp
