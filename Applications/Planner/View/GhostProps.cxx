#include "View/GhostProps.h"

#include "MirrorGhost.h"
#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "View/BlobFile.h"
#include "vtkHaspVolumeView.h"

#include <QCoreApplication>

#include <algorithm>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double GhostOpacity = 0.35;
const glm::dvec3 GhostColour{ 0.45, 0.62, 1.0 };

/// Those of the mirror that are of scans.
std::vector<PlanId> FragmentsOf(const Plan& plan, const PlanMirror& mirror)
{
  std::vector<PlanId> found;
  for (const PlanId id : mirror.fragments)
    if (IsOfScan(plan, id))
      found.push_back(id);
  return found;
}

PlanId VolumeOf(const Plan& plan, const PlanMirror& mirror)
{
  if (mirror.volume != 0)
    return mirror.volume;
  const std::vector<PlanId> fragments = FragmentsOf(plan, mirror);
  return fragments.empty() ? 0 : VolumeOfFragment(plan, fragments.front());
}

} // namespace

void GhostProps::Forget()
{
  this->Job.Drop();
  this->Entries.clear();
}

GhostShape GhostProps::ShapeOf(const PlanMirror& mirror) const
{
  const Plan& plan = this->Of.plan.Now();
  const PlanId volume = VolumeOf(plan, mirror);
  GhostShape shape;
  if (!this->Of.scans.OfVolume(plan, volume))
    return shape;
  const auto labelMaps = LabelMapBlobs(plan, this->Of.plan.Document().parts);
  if (mirror.volume == 0)
    for (const PlanId id : FragmentsOf(plan, mirror))
    {
      shape.fragments.push_back(ShapeOfFragment(plan, id, labelMaps));
      if (shape.fragments.back().scan.empty())
        return {};
    }
  shape.scan = FindPlanObject<PlanVolume>(plan, volume)->hash;
  shape.isovalue = mirror.isovalue;
  shape.plane = mirror.plane;
  return shape;
}

bool GhostProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  const bool changed = std::erase_if(this->Entries, [&](const auto& entry)
                         { return !FindPlanObject<PlanMirror>(plan, entry.first); }) > 0;
  std::map<PlanId, GhostShape> missing;
  for (const PlanMirror& mirror : plan.mirrors)
  {
    GhostEntry& entry = this->Entries[mirror.id];
    this->Place(mirror.id, entry);
    if (!this->Of.isVisible(mirror.id))
      continue;
    const GhostShape shape = this->ShapeOf(mirror);
    if (!shape.scan.empty() && shape != entry.shape && shape != entry.failed)
      missing[mirror.id] = shape;
  }
  this->MakeMissing(missing);
  return changed;
}

void GhostProps::Place(PlanId mirror, const GhostEntry& entry)
{
  if (!entry.shown)
    return;
  entry.shown->SetLook({ GhostColour, GhostOpacity, this->Of.selected == mirror });
  entry.shown->SetVisible(this->Of.isVisible(mirror));
}

GhostProps::Made GhostProps::Make(
  VoxelWork& work, const PlanMirror& mirror, const ProgressFunction& progress)
{
  try
  {
    const std::vector<PlanId> fragments = FragmentsOf(work.plan, mirror);
    double isovalue = mirror.isovalue;
    std::vector<std::uint8_t> keep;
    if (mirror.volume == 0)
    {
      work.ReadLabelMaps(fragments, {});
      const PlanFragmentVoxels found = PlanFragmentLabels(work.plan, work.images, fragments);
      keep.resize(found.numbers.size());
      std::transform(found.numbers.begin(), found.numbers.end(), keep.begin(),
        [](std::uint16_t number) { return std::uint8_t(number != 0); });
      isovalue = IsovalueOfFragment(work.plan, fragments.front());
      for (const PlanId id : fragments) // each is bone by its own already
        isovalue = std::min(isovalue, IsovalueOfFragment(work.plan, id));
    }
    const MirrorGhost ghost = MakeMirrorGhost(work.images.at(VolumeOf(work.plan, mirror)), isovalue,
      keep, { .plane = mirror.plane }, progress);
    return { WithNormals(MakePolyData(ghost.mesh)), {} };
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    return { nullptr, CalledObject(work.plan, mirror.id) + ": " + error.what() };
  }
}

void GhostProps::MakeMissing(const std::map<PlanId, GhostShape>& missing)
{
  if (missing.empty())
    return this->Job.Drop();
  if (this->Job.IsUnderWay() && missing == this->Asked)
    return;
  this->Asked = missing;
  this->Job.Begin(QCoreApplication::translate("PlanScene", "Mirroring bone"),
    [this, missing, kept = VoxelWork(this->Of)](const ProgressFunction& progress)
    {
      VoxelWork work = kept;
      std::map<PlanId, Made> made;
      for (const auto& [id, shape] : missing)
        made[id] = Make(work, *FindPlanObject<PlanMirror>(work.plan, id), progress);
      return [this, missing, made] { this->Take(missing, made); };
    });
}

void GhostProps::Take(const std::map<PlanId, GhostShape>& asked, const std::map<PlanId, Made>& made)
{
  QString faults;
  for (const auto& [id, shape] : asked)
  {
    const auto* mirror = FindPlanObject<PlanMirror>(this->Of.plan.Now(), id);
    const auto entry = this->Entries.find(id);
    if (!mirror || entry == this->Entries.end() || shape != this->ShapeOf(*mirror))
      continue;
    entry->second.shown.reset();
    entry->second.shape = entry->second.failed = {};
    if (const Made& is = made.at(id); is.mesh)
    {
      entry->second.shown = std::make_unique<MeshProp>(this->Of.view, is.mesh);
      entry->second.shape = shape;
      this->Place(id, entry->second);
    }
    else
    {
      entry->second.failed = shape;
      faults += QString::fromStdString(is.fault + "\n");
    }
  }
  this->Of.propsChanged();
  if (!faults.isEmpty())
    this->Of.fault(faults.trimmed());
}

void GhostProps::ListResources(ResourceList& list) const
{
  for (const auto& [id, entry] : this->Entries)
  {
    const std::string called = CalledObject(this->Of.plan.Now(), id);
    if (entry.shown)
      entry.shown->ListResourcesAs(called, list);
    else
      list.push_back({ called, 0, 0.0,
        !this->Of.isVisible(id)      ? "hidden"
        : !entry.failed.scan.empty() ? "it cannot be made"
        : this->Job.IsUnderWay()     ? "being made"
                                     : "its scan or a label map is not there" });
  }
}

} // namespace hasp
