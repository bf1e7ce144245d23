#include "View/FragmentProps.h"

#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "View/FragmentLook.h"

#include <QCoreApplication>

#include <algorithm>

namespace hasp
{

vtkImageData* FragmentProps::ImageOf(PlanId fragment) const
{
  const auto found = this->Entries.find(fragment);
  return found == this->Entries.end() || !found->second.shown ? nullptr
                                                              : found->second.shown->Image();
}

bool FragmentProps::HasAny(PlanId volume) const
{
  return std::any_of(this->Entries.begin(), this->Entries.end(),
    [&](const auto& entry) { return entry.second.shown && entry.second.volume == volume; });
}

bool FragmentProps::AreThere() const
{
  return !this->Job.IsUnderWay() &&
         std::any_of(this->Entries.begin(), this->Entries.end(),
           [](const auto& entry) { return entry.second.shown != nullptr; });
}

void FragmentProps::Forget()
{
  this->Job.Drop();
  this->Entries.clear();
}

/// As far as it can be, or need be.
bool FragmentProps::IsThere(const Plan& plan, PlanId fragment) const
{
  if (IsDivided(plan, fragment))
    return this->HasPieces(plan, fragment);
  const auto entry = this->Entries.find(fragment);
  return !this->Of.isVisible(fragment) ||
         (entry != this->Entries.end() &&
           (entry->second.shown || !entry->second.failed.scan.empty()));
}

/// It is divided, and all its pieces are there.
bool FragmentProps::HasPieces(const Plan& plan, PlanId fragment) const
{
  bool any = false;
  for (const PlanFragment& other : plan.fragments)
    if (const auto* piece = std::get_if<PieceSource>(&other.source);
        piece && piece->fragment == fragment)
    {
      if (!this->IsThere(plan, other.id))
        return false;
      any = true;
    }
  return any;
}

void FragmentProps::Place(const Plan& plan, const PlanFragment& fragment)
{
  CellProp& shown = *this->Entries.at(fragment.id).shown;
  shown.SetPose(fragment.scanToPlanned);
  shown.SetLook(LookOf(fragment, this->Of.selected == fragment.id));
  shown.SetVisible(this->Of.isVisible(fragment.id) && !this->HasPieces(plan, fragment.id));
}

bool FragmentProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  const bool changed = std::erase_if(this->Entries, [&](const auto& entry)
                         { return VolumeOfFragment(plan, entry.first) == 0; }) > 0;
  const auto labelMaps = LabelMapBlobs(plan, this->Of.plan.Document().parts);
  std::erase_if(this->Of.labelMaps,
    [&](const auto& map)
    {
      return std::none_of(labelMaps.begin(), labelMaps.end(),
        [&](const auto& blob) { return blob.second == map.first; });
    });
  Shapes missing;
  for (const PlanFragment& fragment : plan.fragments)
  {
    const PlanId volume = VolumeOfFragment(plan, fragment.id);
    if (volume == 0)
      continue;
    const FragmentShape shape = ShapeOfFragment(plan, fragment.id, labelMaps);
    FragmentEntry& entry = this->Entries[fragment.id];
    entry.volume = volume;
    if (entry.shown)
      this->Place(plan, fragment);
    const bool known = shape == entry.shape || shape == entry.failed;
    if (!known && !shape.scan.empty() && !IsDivided(plan, fragment.id) &&
        this->Of.isVisible(fragment.id) && this->Of.scans.OfVolume(plan, volume))
      missing[fragment.id] = shape;
  }
  this->MakeMissing(missing);
  return changed;
}

void FragmentProps::MakeMissing(const Shapes& missing)
{
  if (missing.empty())
    return this->Job.Drop();
  const bool asked = this->Job.IsUnderWay() &&
                     std::all_of(missing.begin(), missing.end(),
                       [&](const auto& wanted)
                       {
                         const auto found = this->Asked.find(wanted.first);
                         return found != this->Asked.end() && found->second == wanted.second;
                       });
  if (asked)
    return;
  std::vector<PlanId> fragments;
  for (const auto& wanted : missing)
    fragments.push_back(wanted.first);
  this->Asked = missing;
  this->Job.Begin(QCoreApplication::translate("PlanScene", "Showing fragments"),
    [this, work = VoxelWork(this->Of), fragments, missing](const ProgressFunction& progress)
    {
      const auto made =
        std::make_shared<const MadeFragments>(MakeFragments(work, fragments, progress));
      return [this, missing, made] { this->Take(missing, *made); };
    });
}

/// What has become another since then is asked for anew by the next Sync.
void FragmentProps::Take(const Shapes& asked, const MadeFragments& made)
{
  const Plan& plan = this->Of.plan.Now();
  const auto labelMaps = LabelMapBlobs(plan, this->Of.plan.Document().parts);
  for (const auto& map : made.labelMaps)
    this->Of.labelMaps.insert(map);
  QString faults;
  for (const auto& [id, shape] : asked)
  {
    const auto entry = this->Entries.find(id);
    if (entry == this->Entries.end() || shape != ShapeOfFragment(plan, id, labelMaps))
      continue;
    if (const auto image = made.images.find(id); image != made.images.end())
    {
      entry->second.shown =
        std::make_unique<CellProp>(this->Of.view, image->second, IsovalueOfFragment(plan, id));
      entry->second.shape = shape;
    }
    else if (const auto fault = made.faults.find(id); fault != made.faults.end())
    {
      entry->second.shown.reset();
      entry->second.shape = {};
      entry->second.failed = shape;
      faults += (faults.isEmpty() ? "" : "\n") + QString::fromStdString(fault->second);
    }
  }
  for (const PlanFragment& fragment : plan.fragments)
    if (this->ImageOf(fragment.id))
      this->Place(plan, fragment);
  this->Of.propsChanged();
  if (!faults.isEmpty())
    this->Of.fault(faults);
}

void FragmentProps::ListResources(ResourceList& list) const
{
  const Plan& plan = this->Of.plan.Now();
  for (const auto& [id, entry] : this->Entries)
  {
    const std::string called = CalledObject(plan, id);
    if (entry.shown)
    {
      list.push_back({ called + ", voxels", entry.shown->Image()->GetActualMemorySize() * 1024, 0.0,
        "of itself alone; haptics read them, too" });
      entry.shown->ListResourcesAs(called, list);
    }
    else
      list.push_back({ called, 0, 0.0,
        !this->Of.isVisible(id)      ? "hidden"
        : IsDivided(plan, id)        ? "its pieces are shown"
        : !entry.failed.scan.empty() ? "no voxels were found"
        : this->Job.IsUnderWay()     ? "being made"
                                     : "its label map or its scan is not there" });
  }
  for (const auto& [blob, map] : this->Of.labelMaps)
    list.push_back({ "label map " + blob.substr(0, 8), map->GetActualMemorySize() * 1024, 0.0,
      "kept for fragments that are cut next" });
}

} // namespace hasp
