// What a transplant's form does on the donor's side.
#include "Grid/ProgressPart.h"
#include "Output/ScanWorlds.h"
#include "PlanFragmentLabels.h"
#include "PlanProposals.h"
#include "Planning/TransplantPath.h"
#include "Steps/LabelMaps.h"
#include "Steps/PointsEdit.h"
#include "Steps/TouchedFragment.h"
#include "Steps/TransplantBox.h"

#include <QPointer>

namespace hasp
{

namespace
{
bool SameTips(const std::vector<glm::dvec3>& axis, const std::array<glm::dvec3, 2>& tips)
{
  return axis.size() >= 2 && axis.front() == tips[0] && axis.back() == tips[1];
}
} // namespace

/// The donor is what was touched; bone that is no fragment yet becomes one.
void TransplantBox::TakeTips()
{
  if (!this->Draft.IsShown())
    this->Draft.Begin(this->Fresh());
  const std::vector<TouchedPlace> places = this->Tips->Places();
  if (places.empty())
    return;
  PlanId donor = places.back().object;
  if (donor == 0 && this->Draft.Typed().donor == 0)
  {
    PlanFragment bone = FragmentFromTouch(this->Of, places.back());
    bone.id = this->Of.plan.NewId();
    if (!this->Of.plan.Do(AddObject<PlanFragment>{ bone }))
      return;
    donor = bone.id;
  }
  if (donor != 0)
    this->Draft.Typed().donor = donor;
  if (places.size() < 2)
    return this->Fill();
  const std::vector<glm::dvec3> tips = this->Tips->Points();
  this->Bone().donor.axis = tips;
  this->Tips->PutAway();
  this->Put();
  for (const ScanWorld& world : WorldsOf(this->Of.plan.Now()))
    if (world.isDonor && world.volume == this->Of.scene.ShownVolume())
      this->Of.scene.SetVisible(this->Draft.Id(), false); // it lies in the jaw's world
  this->Resting.start();                                  // they may be typed number by number
}

void TransplantBox::TakeDonor(PlanId donor)
{
  if (!this->Draft.IsShown())
    return;
  this->Draft.Typed().donor = donor;
  this->Put();
}

void TransplantBox::FindAxis()
{
  const PlanId donor = this->Draft.Typed().donor;
  const std::vector<glm::dvec3>& axis = this->Bone().donor.axis;
  if (donor == 0 || axis.size() < 2)
    return this->ShowFault(tr("Touch both tips of the donor bone first."));
  const std::array tips{ axis.front(), axis.back() };
  const auto snapshot = std::make_shared<PlanSnapshot>(
    this->Of.plan.Document(), this->Of.scans, this->Of.plan.Folder());
  this->Of.jobs.Add(tr("Finding the middle line of fragment %1").arg(donor),
    [me = QPointer<TransplantBox>(this), snapshot, donor, tips,
      radiusMm = this->Bone().donor.radiusMm](const ProgressFunction& progress) -> JobQueue::Finish
    {
      const SnapshotImages images =
        ImagesOfFragments(*snapshot, { donor }, PartOf(progress, 0.0, 0.2));
      const auto found = ProposeDonorAxis(
        snapshot->plan, images.images, donor, tips, radiusMm, PartOf(progress, 0.2, 1.0));
      return [me, made = images.made, donor, tips, found]
      {
        if (!me)
          return;
        for (const DerivedPart& part : made)
          me->Of.plan.KeepMade(part);
        // Else it is of another bone, or between other tips, by now.
        if (me->Draft.Typed().donor == donor && SameTips(me->Bone().donor.axis, tips))
          me->TakeAxis(found);
      };
    });
}

void TransplantBox::TakeAxis(const std::vector<glm::dvec3>& axis)
{
  this->Bone().donor.axis = axis;
  this->Put(tr("Find the donor's middle line"));
}

void TransplantBox::TakeSide(const TouchedPlace& place)
{
  if (!this->Draft.IsShown())
    return;
  try
  {
    this->Bone().donor.lateral = LateralTowards(this->Bone().donor.axis, place.inScan);
  }
  catch (const std::invalid_argument& error)
  {
    return this->ShowFault(QString::fromStdString(error.what()));
  }
  this->Put();
}

/// A vessel of one place is not finished, nor skin without a vessel or of fewer than three places.
void TransplantBox::TakeTissue()
{
  if (!this->Draft.IsShown())
    return;
  const std::vector<glm::dvec3> vessel = this->Vessel->Points(), outline = this->Paddle->Points(),
                                perforator = this->Perforator->Points();
  if (vessel.size() != 1)
    this->Bone().vessel = vessel;
  if (outline.size() >= 3 && !perforator.empty())
    this->Bone().paddle = SkinPaddle{ outline, perforator[0] };
  else if (outline.empty() && perforator.empty())
    this->Bone().paddle.reset();
  else
    return this->ShowFault(
      tr("Skin needs an outline of three places or more, and the place of its vessel."));
  if (vessel.size() == 1)
    return this->ShowFault(tr("A vessel needs two places or more."));
  this->Put();
}

/// Donor and jaw lie in worlds of their own, one over the other: only one of them is shown, with
/// what is planned in it.
void TransplantBox::LookAt(bool donor)
{
  const Plan& plan = this->Of.plan.Now();
  const PlanId leg = VolumeOfFragment(plan, this->Draft.Typed().donor);
  PlanId shown = 0;
  for (const PlanVolume& volume : plan.volumes)
  {
    const bool isDonor = leg != 0 ? volume.id == leg : volume.id == plan.volumes.back().id;
    if (isDonor == donor && shown == 0)
      shown = volume.id;
  }
  if (shown == 0)
    return this->Of.SayFault(tr("There is one scan only: import the donor's as a second one."));
  PlanScene& scene = this->Of.scene;
  for (const ScanWorld& world : WorldsOf(plan))
    for (const PlanId object : SeenIn(world))
      scene.SetVisible(object, world.volume == shown);
  scene.SetShownVolume(shown);
  scene.ShowAll();
}

} // namespace hasp
