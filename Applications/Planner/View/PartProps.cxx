#include "View/PartProps.h"

#include "Model/PlanSession.h"
#include "Planning/PlanLists.h"
#include "View/BlobFile.h"

#include <QCoreApplication>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Of Okabe and Ito (2008): told apart by colour-blind readers too.
const glm::dvec3 GuideColour{ 0.35, 0.70, 0.90 }, PlateColour{ 0.72, 0.75, 0.80 },
  ImplantColour{ 0.90, 0.62, 0.00 }, TransplantColour{ 0.00, 0.62, 0.45 },
  MitreGuideColour{ 0.80, 0.47, 0.65 }, OutdatedColour{ 0.60, 0.60, 0.60 };
constexpr double OutdatedOpacity = 0.35;

/// What is to be shown of an object; nullptr: nothing was made.
const DerivedPart* NewestPart(
  const Plan& plan, std::span<const DerivedPart> parts, PlanId object, bool& inDate)
{
  const std::vector<PartInput> now = PartInputs(plan, object);
  const DerivedPart* newest = nullptr;
  inDate = false;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
  {
    if (part->object != object || part->format == PartFormat::Nrrd)
      continue;
    if (part->inputs == now)
    {
      inDate = true;
      return &*part;
    }
    newest = newest ? newest : &*part;
  }
  return newest;
}

} // namespace

void PartProps::Forget()
{
  this->Job.Drop();
  this->Entries.clear();
}

template <typename T>
void PartProps::Follow(const std::vector<T>& objects, const glm::dvec3& colour)
{
  const PlanDocument& document = this->Of.plan.Document();
  for (const T& object : objects)
  {
    PartEntry& entry = this->Entries[object.id];
    const DerivedPart* part =
      NewestPart(this->Of.plan.Now(), document.parts, object.id, entry.inDate);
    entry.part = part ? PartBlob{ part->bytes, part->format } : PartBlob{};
    entry.colour = colour;
  }
}

bool PartProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  bool changed = std::erase_if(this->Entries,
                   [&](const auto& entry) { return !PlanNoun(plan, entry.first); }) > 0;
  this->Follow(plan.guides, GuideColour);
  this->Follow(plan.plates, PlateColour);
  this->Follow(plan.implants, ImplantColour);
  this->Follow(plan.transplants, TransplantColour);
  this->Follow(plan.mitreGuides, MitreGuideColour);
  std::map<PlanId, PartBlob> missing;
  for (auto& [id, entry] : this->Entries)
  {
    if (entry.part.blob.empty() && entry.shown)
    {
      entry.shown.reset();
      entry.shownBlob.clear();
      changed = true;
    }
    this->Place(id, entry);
    const bool known = entry.part.blob == entry.shownBlob || entry.part.blob == entry.failedBlob;
    if (!known && !entry.part.blob.empty() && this->Of.isVisible(id))
      missing[id] = entry.part;
  }
  this->ReadMissing(missing);
  return changed;
}

void PartProps::Place(PlanId object, const PartEntry& entry)
{
  if (!entry.shown)
    return;
  const bool inDate = entry.inDate && entry.shownBlob == entry.part.blob;
  entry.shown->SetLook({ inDate ? entry.colour : OutdatedColour, inDate ? 1.0 : OutdatedOpacity,
    this->Of.selected == object });
  entry.shown->SetVisible(this->Of.isVisible(object));
}

void PartProps::ReadMissing(const std::map<PlanId, PartBlob>& missing)
{
  if (missing.empty())
    return this->Job.Drop();
  if (this->Job.IsUnderWay() && missing == this->Asked)
    return;
  this->Asked = missing;
  this->Job.Begin(QCoreApplication::translate("PlanScene", "Showing parts"),
    [this, missing, folder = this->Of.plan.Folder()](const ProgressFunction& progress)
    {
      std::map<PlanId, Read> read;
      for (const auto& [id, part] : missing)
        try
        {
          read[id].mesh = ReadMeshBlob(folder, part.blob, part.format, progress);
        }
        catch (const Cancelled&)
        {
          throw;
        }
        catch (const std::exception& error)
        {
          read[id].fault = error.what();
        }
      return [this, missing, read] { this->Take(missing, read); };
    });
}

void PartProps::Take(const std::map<PlanId, PartBlob>& asked, const std::map<PlanId, Read>& read)
{
  const Plan& plan = this->Of.plan.Now();
  QString faults;
  for (const auto& [id, part] : asked)
  {
    const auto entry = this->Entries.find(id);
    if (entry == this->Entries.end() || entry->second.part != part)
      continue;
    const Read& is = read.at(id);
    if (!is.mesh)
    {
      entry->second.failedBlob = part.blob;
      faults += QString::fromStdString(
        CalledObject(plan, id) + " cannot be shown: " + is.fault + "; make it again\n");
      continue;
    }
    entry->second.shown = std::make_unique<MeshProp>(this->Of.view, is.mesh);
    entry->second.shownBlob = part.blob;
    this->Place(id, entry->second);
  }
  this->Of.propsChanged();
  if (!faults.isEmpty())
    this->Of.fault(faults.trimmed());
}

void PartProps::ListResources(ResourceList& list) const
{
  for (const auto& [id, entry] : this->Entries)
  {
    const std::string called = CalledObject(this->Of.plan.Now(), id);
    if (entry.shown)
      entry.shown->ListResourcesAs(called, list);
    else
      list.push_back({ called, 0, 0.0,
        entry.part.blob.empty()     ? "it has not been made"
        : !this->Of.isVisible(id)   ? "hidden"
        : !entry.failedBlob.empty() ? "its file is damaged"
                                    : "being read" });
  }
}

} // namespace hasp
