#include "HapticDrawing.h"

#include "HapticExchange.h"
#include "PropPose.h"
#include "vtkHaspForceArrows.h"
#include "vtkHaspPointShellMapper.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
/// Equal to no pose.
const RigidPose Nowhere{ glm::dvec3(std::numeric_limits<double>::quiet_NaN()), { 1, 0, 0, 0 } };
}

HapticDrawing::HapticDrawing() : Pointed(Nowhere) {}

HapticDrawing::~HapticDrawing()
{
  this->Drop();
}

void HapticDrawing::Drop()
{
  if (this->Renderer && this->ArrowProp)
    this->Renderer->RemoveViewProp(this->ArrowProp);
  if (this->Renderer && this->ShellProp)
    this->Renderer->RemoveViewProp(this->ShellProp);
  this->ArrowProp = nullptr;
  this->ShellProp = nullptr;
  this->ShellMapper = nullptr;
}

void HapticDrawing::SetPointer(vtkProp3D* prop)
{
  this->Pointer = prop;
  this->Pointed = Nowhere;
}

void HapticDrawing::SetRenderer(vtkRenderer* renderer)
{
  this->Drop();
  this->Renderer = renderer;
}

bool HapticDrawing::MovePointer(const HapticSnapshot& seen)
{
  if (seen.tool == this->Pointed)
    return false;
  this->Pointed = seen.tool;
  SetUserPose(this->Pointer, seen.tool);
  return true;
}

bool HapticDrawing::DrawForces(const HapticSnapshot& seen)
{
  if (!this->ArrowProp)
  {
    this->Arrows.clear();
    this->ArrowProp = vtkSmartPointer<vtkHaspForceArrows>::New();
    this->ArrowProp->PickableOff();
    this->ArrowProp->GetProperty()->SetColor(0.9, 0.3, 0.2);
    this->Renderer->AddViewProp(this->ArrowProp);
  }
  std::vector<ForceArrow> arrows;
  for (const Wrench& wrench : { seen.contact, seen.attraction })
    if (glm::length(wrench.force) > 0.0)
      arrows.push_back({ seen.tool.position, wrench.force });
  const auto same = [](const ForceArrow& a, const ForceArrow& b)
  { return a.atMm == b.atMm && a.forceN == b.forceN; };
  if (std::equal(arrows.begin(), arrows.end(), this->Arrows.begin(), this->Arrows.end(), same))
    return false;
  this->Arrows = arrows;
  this->ArrowProp->SetMmPerNewton(this->mmPerNewton);
  this->ArrowProp->SetArrows(std::move(arrows));
  return true;
}

bool HapticDrawing::DrawShell(const HapticSnapshot& now, const HapticDiscRequest* discs)
{
  if (!this->ShellProp)
  {
    this->ShellMapper = vtkSmartPointer<vtkHaspPointShellMapper>::New();
    this->ShellProp = vtkSmartPointer<vtkActor>::New();
    this->ShellProp->SetMapper(this->ShellMapper);
    this->ShellProp->PickableOff();
    this->ShellProp->GetProperty()->SetColor(1.0, 0.8, 0.1);
    this->Renderer->AddViewProp(this->ShellProp);
  }
  const std::uint32_t count = discs != nullptr ? discs->count : 0;
  if (count == 0)
  {
    const bool seen = this->ShellProp->GetVisibility() != 0;
    this->ShellProp->SetVisibility(false);
    return seen;
  }
  this->ShellProp->SetVisibility(true);
  this->ShellMapper->SetDiscs(std::make_shared<const std::vector<ShellDisc>>(
    discs->room.begin(), discs->room.begin() + count));
  SetUserPose(this->ShellProp, now.tool);
  return true;
}

bool HapticDrawing::DropUnused()
{
  if (!this->Renderer)
    return false;
  bool seen = false;
  if (!this->forces && this->ArrowProp)
  {
    seen = !this->Arrows.empty();
    this->Renderer->RemoveViewProp(this->ArrowProp);
    this->ArrowProp = nullptr;
  }
  if (!this->shell && this->ShellProp)
  {
    seen = seen || this->ShellProp->GetVisibility();
    this->Renderer->RemoveViewProp(this->ShellProp);
    this->ShellProp = nullptr;
    this->ShellMapper = nullptr;
  }
  return seen;
}

bool HapticDrawing::Update(const HapticSnapshot& seen, const HapticDiscRequest* discs)
{
  bool changed = this->DropUnused();
  if (std::exchange(this->Ticks, seen.ticks) == seen.ticks)
    return changed;
  changed = (this->Pointer && this->MovePointer(seen)) || changed;
  if (!this->Renderer)
    return changed;
  changed = (this->forces && this->DrawForces(seen)) || changed;
  return (this->shell && this->DrawShell(seen, discs)) || changed;
}

} // namespace hasp
