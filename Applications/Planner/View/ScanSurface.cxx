#include "View/ScanSurface.h"

#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Segmentation/ThresholdProposal.h"
#include "View/ScanActor.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"

#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double BoneHU = 226.0;
const glm::dvec3 BoneColour{ 0.89, 0.855, 0.788 };

/// The first fragment of the volume that is said by an isovalue.
std::optional<double> IsovalueOfFragments(const Plan& plan, PlanId volume)
{
  for (const PlanFragment& fragment : plan.fragments)
    if (VolumeOfFragment(plan, fragment.id) == volume)
      return IsovalueOfFragment(plan, fragment.id);
  return std::nullopt;
}

double ProposedIsovalue(const ShelfScan& scan)
{
  if (scan.passport.hounsfield)
    return BoneHU;
  try
  {
    return ProposeThreshold(ViewImage(scan.image)).threshold;
  }
  catch (const std::invalid_argument&) // one grey value alone
  {
    return BoneHU;
  }
}

} // namespace

ScanSurface::ScanSurface(SceneContext& of) : SceneLayer(of) {}

ScanSurface::~ScanSurface() = default;

PlanId ScanSurface::Volume() const
{
  const Plan& plan = this->Of.plan.Now();
  if (FindPlanObject<PlanVolume>(plan, this->Asked))
    return this->Asked;
  return plan.volumes.empty() ? 0 : plan.volumes.front().id;
}

vtkImageData* ScanSurface::Image() const
{
  const ShelfScan* scan = this->Of.scans.OfVolume(this->Of.plan.Now(), this->Volume());
  return scan ? scan->image.Get() : nullptr;
}

double ScanSurface::Isovalue() const
{
  const PlanId volume = this->Volume();
  if (const auto said = this->Isovalues.find(volume); said != this->Isovalues.end())
    return said->second;
  if (const auto ofFragments = IsovalueOfFragments(this->Of.plan.Now(), volume))
    return *ofFragments;
  const ShelfScan* scan = this->Of.scans.OfVolume(this->Of.plan.Now(), volume);
  return scan ? this->Isovalues[volume] = ProposedIsovalue(*scan) : BoneHU;
}

void ScanSurface::SetIsovalue(double value, bool moving)
{
  this->Isovalues[this->Volume()] = value;
  this->Moving = moving;
  if (this->Shown)
    this->Shown->SetIsovalue(value, moving);
}

void ScanSurface::Forget()
{
  this->Asked = 0;
  this->Moving = false;
  this->Isovalues.clear();
}

bool ScanSurface::Sync()
{
  vtkImageData* image = this->Image();
  const PlanId volume = this->Volume();
  const bool wanted = image && this->Of.isVisible(volume) && !this->Of.brightest;
  bool changed = false;
  if (this->Shown && (!wanted || this->Shown->Image() != image))
  {
    this->Shown.reset();
    changed = true;
  }
  if (wanted && !this->Shown)
  {
    this->Shown = std::make_unique<ScanActor>(this->Of.view, image);
    changed = true;
  }
  if (this->Shown)
  {
    this->Shown->SetIsovalue(this->Isovalue(), this->Moving);
    this->Shown->SetLook({ BoneColour, 1.0, this->Of.selected == volume });
  }
  return changed;
}

vtkProp3D* ScanSurface::PropOf(PlanId object) const
{
  return this->Shown && object == this->Volume() ? this->Shown->Actor() : nullptr;
}

void ScanSurface::Pick(const SceneRay& ray, std::optional<SceneHit>& nearest) const
{
  if (this->Shown)
    this->Shown->Pick(0, ray, nearest);
}

void ScanSurface::AddBounds(vtkBoundingBox& box) const
{
  if (this->Shown)
    this->Shown->AddBounds(box);
}

bool ScanSurface::IsRefining() const
{
  return this->Shown && this->Shown->IsRefining();
}

void ScanSurface::ListResources(ResourceList& list) const
{
  if (this->Shown)
    this->Shown->ListResources(list);
  else
    list.push_back({ "scan's isosurface", 0, 0.0,
      this->Image() && this->Of.brightest ? "the brightest values are shown instead"
      : this->Image()                     ? "hidden, or its fragments are shown"
      : this->Volume()                    ? "the scan is not in memory"
                                          : "the plan has no scan" });
}

} // namespace hasp
