#include "EvaluateSteps.h"
#include "EvaluateText.h"
#include "Failure.h"
#include "Session.h"
#include "VerbWork.h"
#include "VolumeInput.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/SurfaceRegistration.h"
#include "Planning/PlanLists.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <iostream>
#include <utility>

namespace hasp
{
namespace
{

/// The isovalue of the bone that a fragment is of.
double IsovalueOf(const Plan& plan, PlanId id)
{
  const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, id);
  while (const auto* piece = std::get_if<PieceSource>(&fragment->source))
    fragment = FindPlanObject<PlanFragment>(plan, piece->fragment);
  if (const auto* label = std::get_if<LabelSource>(&fragment->source))
    return label->isovalue;
  if (const auto* component = std::get_if<ComponentSource>(&fragment->source))
    return component->isovalue;
  throw Failure(ExitCode::WrongUse,
    "fragment " + std::to_string(id) + " is a surface: say --isovalue of the other scan's bone");
}

/// The bone of a scan, outward, contoured in its own steps: whatever its axes.
TriangleMesh BoneOf(vtkImageData* image, double isovalue)
{
  const GridGeometry geometry = ImageGeometry(image);
  vtkNew<vtkImageData> steps;
  steps->ShallowCopy(image);
  steps->SetExtent(0, geometry.dims.x - 1, 0, geometry.dims.y - 1, 0, geometry.dims.z - 1);
  steps->SetOrigin(0.0, 0.0, 0.0);
  steps->SetSpacing(1.0, 1.0, 1.0);
  vtkNew<vtkMatrix3x3> straight;
  steps->SetDirectionMatrix(straight);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(steps);
  contour->SetValue(0, isovalue);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  TriangleMesh mesh = TrianglesOf(contour->GetOutput());
  for (glm::dvec3& point : mesh.points)
    point = geometry.IndexToWorld(point);
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
    volume += glm::dot(mesh.points[t.x], glm::cross(mesh.points[t.y], mesh.points[t.z]));
  if (volume < 0.0)
    for (glm::uvec3& t : mesh.triangles)
      std::swap(t.y, t.z);
  return mesh;
}

std::string WhyNot(const SurfaceRegistration& r, const SurfaceRegistrationSettings& s)
{
  return Line("the other scan's bone does not fit the reference: %.1f %% of it match within %g mm "
              "(at least %g %% is asked for), ",
           100.0 * r.share, s.matchMm, 100.0 * s.leastShare) +
         Line("median %.3g mm (at most %g): is it the same patient, and the right isovalue?",
           r.medianMm, s.mostMedianMm);
}

} // namespace

void EvaluateScan(const EvaluateOptions& options, Session& session)
{
  const EvaluatedSide side = PlanSide(options.first);
  const std::string reference = ReferenceOf(side, options.reference);
  if (reference.empty())
    throw Failure(ExitCode::WrongUse,
      "--scan needs --reference: the fragment that lies still in both, as the cranium");
  VolumeChoices choices;
  choices.input = options.scan;
  choices.series = options.series;
  const LoadedVolume other = ReadVolume(choices, session);
  SayWarnings(other.passport, session);
  const EvaluatedFragment& still = side.fragments.at(reference);
  const double isovalue =
    options.isovalue ? *options.isovalue : IsovalueOf(side.document->history.Current(), still.id);
  RequireIsoValue(isovalue, other.passport);
  EvaluatedSurfaces surfaces(options.volumes, options.surfaces, session);
  const auto part = surfaces.Of(reference, { &side });
  session.progress.Step("registering the other scan");
  const MeasuredSurface whole = Try(ExitCode::BadInput,
    "the other scan: ", [&] { return MeasuredSurface(BoneOf(other.image, isovalue)); });
  ScanResult result;
  result.reference = CalledFragment(reference, still, session);
  const SurfaceRegistrationSettings settings;
  result.registration = RegisterSurfaces(*part, whole, settings,
    [&session](double share)
    {
      session.progress.Share(share);
      return true;
    });
  const RigidPose scanToOther = result.registration.otherToScan.Inverse();
  for (const std::string& key : KeysOf(side))
    if (key != reference && result.registration.fits)
      result.fragments.push_back(
        { side.fragments.at(key).id, CalledFragment(key, side.fragments.at(key), session),
          MeasureDistances(*surfaces.Of(key, { &side }),
            scanToOther * PoseBeside(side, key, reference), whole, {}) });
  session.progress.Wipe();
  session.result.update(JsonOf(result));
  session.resultStands = true;
  if (!session.json)
    std::cout << TextOf(result);
  if (!result.registration.fits)
    throw Failure(ExitCode::FailedCheck, WhyNot(result.registration, settings));
  if (result.registration.ambiguous)
    SayWarning(session, "the reference fits elsewhere in the other scan as well: look at both");
}

} // namespace hasp
