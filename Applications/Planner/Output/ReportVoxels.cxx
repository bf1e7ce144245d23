#include "Output/ReportVoxels.h"

#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"
#include "View/BlobFile.h"
#include "View/FragmentWork.h"
#include "View/SceneLayer.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkProp3D.h"

#include <optional>
#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{

/// The triangles of a fragment of a surface, as the scene has them; nullptr: it has not.
vtkPolyData* TrianglesOf(const Planner& planner, PlanId fragment)
{
  auto* actor = vtkActor::SafeDownCast(planner.scene.PropOf(fragment));
  return actor && actor->GetMapper()
           ? vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
           : nullptr;
}

void AddFragment(const Plan& plan, PlanId fragment, vtkImageData* voxels, ReportBodies& bodies)
{
  bodies.fragments[fragment] = BoneSurface(voxels, IsovalueOfFragment(plan, fragment));
}

/// Those that are hidden, for the scene makes nothing of what is not shown.
void MakeFragmentsNow(Planner& planner, const std::vector<PlanId>& fragments, ReportBodies& bodies,
  QStringList& missing)
{
  if (fragments.empty())
    return;
  const SceneContext context{ planner.plan, planner.scans, planner.jobs, planner.views.Scene(), {},
    {}, {}, {} };
  const MadeFragments made = MakeFragments(VoxelWork(context), fragments, {});
  for (const auto& [id, image] : made.images)
    AddFragment(planner.plan.Now(), id, image, bodies);
  for (const auto& [id, fault] : made.faults)
    missing.append(
      ReportText::tr("Pictures lack a fragment: %1.").arg(QString::fromStdString(fault)));
}

/// Why a fragment that is to be seen is not there: the scene has tried, or is at it.
QString WhyNotSeen(const Planner& planner, PlanId fragment)
{
  const QString called = QString::fromStdString(CalledObject(planner.plan.Now(), fragment));
  return planner.jobs.IsIdle()
           ? ReportText::tr(
               "Pictures lack %1: it cannot be shown. Open its scan if that is missing; else "
               "it is no piece of its own: move its cuts. Then write the report again.")
               .arg(called)
           : ReportText::tr(
               "Pictures lack %1: it is being made. Write the report again when it is shown.")
               .arg(called);
}

void AddFragments(Planner& planner, ReportBodies& bodies, QStringList& missing)
{
  const Plan& plan = planner.plan.Now();
  std::vector<PlanId> hidden;
  for (const PlanFragment& fragment : plan.fragments)
  {
    if (IsDivided(plan, fragment.id))
      continue;
    if (vtkImageData* voxels = planner.scene.ImageOfFragment(fragment.id))
      AddFragment(plan, fragment.id, voxels, bodies);
    else if (vtkPolyData* triangles = TrianglesOf(planner, fragment.id))
      bodies.fragments[fragment.id] = triangles;
    else if (planner.scene.IsVisible(fragment.id))
      missing.append(WhyNotSeen(planner, fragment.id));
    else if (IsOfScan(plan, fragment.id))
      hidden.push_back(fragment.id);
    else
      missing.append(
        ReportText::tr("Pictures lack %1: it is hidden. Show it, and write the report again.")
          .arg(QString::fromStdString(CalledObject(plan, fragment.id))));
  }
  MakeFragmentsNow(planner, hidden, bodies, missing);
}

/// Those in date: what is out of date is no part of the plan.
void AddParts(Planner& planner, ReportBodies& bodies, QStringList& missing)
{
  const Plan& plan = planner.plan.Now();
  for (const PlanId object : PartObjects(plan))
    for (const PartFormat format :
      { PartFormat::Stl, PartFormat::ThreeMf, PartFormat::Ply, PartFormat::Obj })
    {
      const bool isBone = FindPlanObject<PlanFragment>(plan, object) || //
                          FindPlanObject<PlanGroup>(plan, object);
      const DerivedPart* part = PartInDate(plan, planner.plan.Document().parts, object, format);
      if (isBone || !part || bodies.parts.contains(object))
        continue;
      try
      {
        bodies.parts[object] = ReadMeshBlob(planner.plan.Folder(), part->bytes, format, {});
      }
      catch (const std::runtime_error& error)
      {
        missing.append(ReportText::tr("Pictures lack %1: %2; make it again.")
                         .arg(QString::fromStdString(CalledObject(plan, object)),
                           QString::fromStdString(error.what())));
      }
    }
}

/// What bone is to a guide, a plate or an implant on a scan; none: nothing is on it.
std::optional<double> IsovalueOn(const Plan& plan, PlanId volume)
{
  for (const PlanGuide& guide : plan.guides)
    if (guide.bone == volume)
      return guide.recipe.isovalue;
  for (const PlanPlate& plate : plan.plates)
    if (plate.volume == volume)
      return plate.recipe.isovalue;
  for (const PlanImplant& implant : plan.implants)
    if (implant.volume == volume)
      return implant.recipe.isovalue;
  return std::nullopt;
}

/// Of scans without a fragment: those that something is planned on, and the one that is shown where
/// the plan has no fragments at all.
void AddScans(const Planner& planner, ReportBodies& bodies)
{
  const Plan& plan = planner.plan.Now();
  std::set<PlanId> divided;
  for (const PlanFragment& fragment : plan.fragments)
    divided.insert(VolumeOfFragment(plan, fragment.id));
  for (const PlanVolume& volume : plan.volumes)
  {
    const ShelfScan* scan = planner.scans.OfVolume(plan, volume.id);
    if (!scan || divided.contains(volume.id))
      continue;
    std::optional<double> isovalue = IsovalueOn(plan, volume.id);
    if (!isovalue && volume.id == planner.scene.ShownVolume() && plan.fragments.empty())
      isovalue = planner.scene.Isovalue();
    if (isovalue)
      bodies.scans[volume.id] = BoneSurface(scan->image, *isovalue);
  }
}

} // namespace

ReportBodies BodiesOf(Planner& planner, QStringList& missing)
{
  ReportBodies bodies;
  AddFragments(planner, bodies, missing);
  AddParts(planner, bodies, missing);
  AddScans(planner, bodies);
  return bodies;
}

} // namespace hasp
