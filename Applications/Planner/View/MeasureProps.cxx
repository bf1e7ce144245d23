#include "View/MeasureProps.h"

#include "Model/PlanSession.h"
#include "Planning/PlanLists.h"

#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"

#include <QCoreApplication>

namespace hasp
{
namespace
{

const glm::dvec3 MeasureColour{ 0.98, 0.90, 0.30 }, SelectedColour{ 1.0, 0.65, 0.10 };

QString TextOf(MeasureKind kind, double value)
{
  return kind == MeasureKind::Distance
           ? QCoreApplication::translate("PlanScene", "%1 mm").arg(value, 0, 'f', 2)
           : QCoreApplication::translate("PlanScene", "%1 deg").arg(value, 0, 'f', 1);
}

} // namespace

/// Where the fragments are seen now; where they are not, where the plan has them.
std::vector<glm::dvec3> MeasureProps::PlacesOf(const PlanMeasure& measure) const
{
  std::vector<glm::dvec3> places;
  for (const MeasurePoint& point : measure.points)
  {
    vtkProp3D* prop = point.fragment != 0 ? this->Of.propOf(point.fragment) : nullptr;
    if (vtkMatrix4x4* pose = prop ? prop->GetUserMatrix() : nullptr)
    {
      const double from[4] = { point.point.x, point.point.y, point.point.z, 1.0 };
      double to[4];
      pose->MultiplyPoint(from, to);
      places.push_back({ to[0], to[1], to[2] });
    }
    else
      places.push_back(PlannedPlace(this->Of.plan.Now(), point));
  }
  return places;
}

void MeasureProps::Follow(const PlanMeasure& measure, MeasureActor& shown)
{
  const std::vector<glm::dvec3> places = this->PlacesOf(measure);
  PlanMeasure there = measure; // between places that do not move
  for (std::size_t n = 0; n < places.size(); ++n)
    there.points[n] = { 0, places[n] };
  shown.SetPlaces(places);
  shown.SetText(TextOf(measure.kind, MeasureValue(Plan{}, there)).toStdString());
}

bool MeasureProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  bool changed = std::erase_if(this->Entries, [&](const auto& entry)
                   { return !FindPlanObject<PlanMeasure>(plan, entry.first); }) > 0;
  for (const PlanMeasure& measure : plan.measures)
  {
    const bool visible = this->Of.isVisible(measure.id);
    const bool selected = this->Of.selected == measure.id;
    MeasureEntry& entry = this->Entries[measure.id];
    if (!entry.shown && visible)
    {
      entry.shown = std::make_unique<MeasureActor>(this->Of.view);
      changed = true;
    }
    if (!entry.shown)
      continue;
    const glm::dvec3& colour = selected ? SelectedColour : MeasureColour;
    entry.shown->SetLook({ colour, 1.0, false });
    entry.shown->SetTextLook(colour, visible);
    entry.shown->SetVisible(visible);
    this->Follow(measure, *entry.shown);
  }
  return changed;
}

void MeasureProps::Prepare()
{
  for (const PlanMeasure& measure : this->Of.plan.Now().measures)
    if (const auto entry = this->Entries.find(measure.id);
        entry != this->Entries.end() && entry->second.shown && entry->second.shown->IsVisible())
    {
      this->Follow(measure, *entry->second.shown);
      entry->second.shown->FollowCover();
    }
}

void MeasureProps::ListResources(ResourceList& list) const
{
  for (const auto& [id, entry] : this->Entries)
    if (entry.shown)
      entry.shown->ListResourcesAs(CalledObject(this->Of.plan.Now(), id), list);
    else
      list.push_back({ CalledObject(this->Of.plan.Now(), id), 0, 0.0, "hidden" });
}

} // namespace hasp
