#include "Tools/DistanceBody.h"

#include "Distance/BodyDistance.h"
#include "Distance/DistanceLookup.h"
#include "Grid/ProgressPart.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double MostSamples = 2e6;
constexpr double BandMm = 6.0; ///< farther the colours have ended

vtkSmartPointer<vtkPolyData> MeshOf(const ShownBody& body)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(body.data))
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(mesh);
    vtkNew<vtkPoints> points; // of floats, as distances are looked up
    points->SetDataTypeToFloat();
    points->DeepCopy(mesh->GetPoints());
    copy->SetPoints(points);
    return copy;
  }
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputDataObject(body.data);
  edges->SetValue(0, body.isovalue);
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput();
}

BodyDistance MeasureTo(const ShownBody& body, const ProgressFunction& progress)
{
  auto* data = vtkDataSet::SafeDownCast(body.data);
  auto* image = vtkImageData::SafeDownCast(body.data);
  double bounds[6], volume = 1.0;
  data->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
    volume *= bounds[2 * axis + 1] - bounds[2 * axis] + 2.0 * BandMm;
  const double finest =
    image ? *std::min_element(image->GetSpacing(), image->GetSpacing() + 3) : 0.1;
  const BodyDistanceSettings settings{
    .spacingMm = std::max(finest, std::cbrt(volume / MostSamples)), .bandMm = BandMm
  };
  return image ? DistanceOfVolume(ViewImage(image), body.isovalue, settings, progress)
               : DistanceOfMesh(TrianglesOf(vtkPolyData::SafeDownCast(data)), settings, progress);
}

BodyDistance MeasureOrNone(const ShownBody& body, const ProgressFunction& progress)
{
  try
  {
    return MeasureTo(body, progress);
  }
  catch (const std::invalid_argument&) // no bone, or open triangles: there is no distance to it
  {
    return {};
  }
}

glm::dmat4 MatrixOf(const RigidPose& pose)
{
  glm::dmat4 matrix = glm::mat4_cast(pose.orientation);
  matrix[3] = glm::dvec4(pose.position, 1.0);
  return matrix;
}

/// Whether any place of the surface can be nearer to the body than the colours reach.
bool IsNear(vtkPolyData* surface, const BodyDistance& body, const RigidPose& surfaceToBody)
{
  glm::dvec3 middle;
  surface->GetCenter(&middle.x);
  const glm::dvec3 last = glm::dvec3(body.geometry.dims - 1),
                   corner = body.geometry.IndexToWorld(last),
                   centre = body.geometry.IndexToWorld(0.5 * last);
  return glm::distance(surfaceToBody.Place(middle), centre) <
         0.5 * surface->GetLength() + glm::distance(corner, centre);
}

} // namespace

std::optional<ShownBody> ShownBody::Of(vtkProp3D* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (auto* cells = vtkHaspClusteredCellMapper::SafeDownCast(mapper); cells && cells->GetImage())
    return ShownBody{ cells->GetImage(), cells->GetIsoValue() };
  if (auto* mesh = vtkPolyDataMapper::SafeDownCast(mapper); mesh && mesh->GetInput())
    return ShownBody{ mesh->GetInput(), 0.0 };
  return std::nullopt;
}

DistanceWork MakeWork(PlanId fragment, const ShownBody& shown, bool mesh, bool distance)
{
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(shown.data->NewInstance());
  copy->ShallowCopy(shown.data);
  return { fragment, shown, { copy, shown.isovalue }, mesh, distance };
}

std::vector<MadeDistance> DoWork(
  const std::vector<DistanceWork>& works, const ProgressFunction& progress)
{
  std::vector<MadeDistance> all;
  for (std::size_t n = 0; n < works.size(); ++n)
  {
    const DistanceWork& work = works[n];
    const ProgressFunction part =
      PartOf(progress, double(n) / double(works.size()), double(n + 1) / double(works.size()));
    ReportProgress(part, 0.0);
    MadeDistance made{ work.fragment, work.shown, {}, {} };
    if (work.mesh)
      made.mesh = MeshOf(work.copy);
    if (work.distance)
      made.distance = std::make_shared<const BodyDistance>(MeasureOrNone(work.copy, part));
    all.push_back(std::move(made));
  }
  return all;
}

void FindLeastDistances(vtkPolyData* mesh, const RigidPose& pose,
  std::span<const PlacedDistance> others, std::span<float> least)
{
  std::fill(least.begin(), least.end(),
    others.empty() ? std::numeric_limits<float>::quiet_NaN() : float(FarMm));
  auto* places = vtkFloatArray::SafeDownCast(mesh->GetPoints()->GetData());
  std::vector<float> found(least.size());
  for (const PlacedDistance& other : others)
  {
    const RigidPose toOther = other.pose.Inverse() * pose;
    if (!IsNear(mesh, *other.distance, toOther))
      continue;
    LookUpDistances<float>(other.distance->View(), MatrixOf(toOther),
      { places->GetPointer(0), 3 * found.size() }, found);
    std::transform(least.begin(), least.end(), found.begin(), least.begin(),
      [](float a, float b) { return std::min(a, b); });
  }
}

} // namespace hasp
