#include "HapticDrawing.h"

#include "HapticExchange.h"
#include "PropPose.h"
#include "vtkHaspForceArrows.h"
#include "vtkHaspPointShellMapper.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <memory>
#include <vector>

namespace hasp
{

HapticDrawing::HapticDrawing() = default;

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

void HapticDrawing::SetRenderer(vtkRenderer* renderer)
{
  this->Drop();
  this->Renderer = renderer;
}

void HapticDrawing::DrawForces(const HapticSnapshot& seen)
{
  if (!this->ArrowProp)
  {
    this->ArrowProp = vtkSmartPointer<vtkHaspForceArrows>::New();
    this->ArrowProp->PickableOff();
    this->ArrowProp->GetProperty()->SetColor(0.9, 0.3, 0.2);
    this->Renderer->AddViewProp(this->ArrowProp);
  }
  std::vector<ForceArrow> arrows;
  for (const Wrench& wrench : { seen.contact, seen.attraction })
    if (glm::length(wrench.force) > 0.0)
      arrows.push_back({ seen.tool.position, wrench.force });
  this->ArrowProp->SetMmPerNewton(this->mmPerNewton);
  this->ArrowProp->SetArrows(std::move(arrows));
}

void HapticDrawing::DrawShell(const HapticSnapshot& seen, const HapticDiscRequest* discs)
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
  this->ShellProp->SetVisibility(count > 0);
  if (count == 0)
    return;
  this->ShellMapper->SetDiscs(std::make_shared<const std::vector<ShellDisc>>(
    discs->room.begin(), discs->room.begin() + count));
  SetUserPose(this->ShellProp, seen.tool);
}

bool HapticDrawing::Update(const HapticSnapshot& seen, const HapticDiscRequest* discs)
{
  const bool moved = seen.ticks != this->Ticks;
  this->Ticks = seen.ticks;
  if (this->pointer && moved)
    SetUserPose(this->pointer, seen.tool);
  if (!this->Renderer)
    return moved && this->pointer;
  if (!this->forces && this->ArrowProp)
  {
    this->Renderer->RemoveViewProp(this->ArrowProp);
    this->ArrowProp = nullptr;
  }
  if (!this->shell && this->ShellProp)
  {
    this->Renderer->RemoveViewProp(this->ShellProp);
    this->ShellProp = nullptr;
    this->ShellMapper = nullptr;
  }
  if (this->forces)
    this->DrawForces(seen);
  if (this->shell)
    this->DrawShell(seen, discs);
  return moved && (this->pointer || this->forces || this->shell);
}

} // namespace hasp
