#include "View/SkinSurface.h"

#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "Segmentation/ThresholdProposal.h"
#include "View/CellProp.h"
#include "View/ScanSurface.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double SkinHU = -300.0, SkinOpacity = 0.3;
const glm::dvec3 SkinColour{ 0.90, 0.66, 0.55 };

double ProposedSkin(const ShelfScan& scan)
{
  const Passport& passport = scan.passport;
  if (passport.hounsfield)
    return SkinHU;
  try
  {
    return 0.5 * (passport.minimum + ProposeThreshold(ViewImage(scan.image)).softTissue);
  }
  catch (const std::invalid_argument&) // one grey value alone
  {
    return 0.5 * (passport.minimum + passport.maximum);
  }
}

} // namespace

SkinSurface::SkinSurface(SceneContext& of, const ScanSurface& scan) : SceneLayer(of), Scan(scan) {}

SkinSurface::~SkinSurface() = default;

double SkinSurface::Value() const
{
  const PlanId volume = this->Scan.Volume();
  if (const auto said = this->Values.find(volume); said != this->Values.end())
    return said->second;
  const ShelfScan* scan = this->Of.scans.OfVolume(this->Of.plan.Now(), volume);
  return scan ? this->Values[volume] = ProposedSkin(*scan) : SkinHU;
}

void SkinSurface::SetValue(double value)
{
  this->Values[this->Scan.Volume()] = value;
}

bool SkinSurface::Sync()
{
  vtkImageData* image = this->On ? this->Scan.Image() : nullptr;
  const bool stale = this->Shown && this->Shown->Image() != image;
  if (stale)
    this->Shown.reset();
  if (!image)
    return stale;
  const bool made = !this->Shown;
  if (made)
    this->Shown = std::make_unique<CellProp>(this->Of.view, image, this->Value());
  this->Shown->Mapper()->SetIsoValue(this->Value());
  this->Shown->SetLook({ SkinColour, SkinOpacity, false });
  return made;
}

void SkinSurface::AddBounds(vtkBoundingBox& box) const
{
  if (this->Shown)
    this->Shown->AddBounds(box);
}

void SkinSurface::ListResources(ResourceList& list) const
{
  if (this->Shown)
    this->Shown->ListResourcesAs("skin", list);
  else
    list.push_back({ "skin", 0, 0.0,
      !this->On             ? "switched off"
      : this->Scan.Volume() ? "the scan is not in memory"
                            : "the plan has no scan" });
}

} // namespace hasp
