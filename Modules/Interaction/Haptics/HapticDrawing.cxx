#include "HapticDrawing.h"

#include "HapticExchange.h"
#include "PropPose.h"
#include "vtkHaspForceArrows.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspPointShellMapper.h"

#include "vtkActor.h"
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

void HapticDrawing::DrawForces(vtkHaspHapticLoop* loop)
{
  if (!this->ArrowProp)
  {
    this->ArrowProp = vtkSmartPointer<vtkHaspForceArrows>::New();
    this->ArrowProp->PickableOff();
    this->Renderer->AddViewProp(this->ArrowProp);
  }
  const HapticSnapshot& seen = loop->GetSnapshot();
  std::vector<ForceArrow> arrows;
  for (const Wrench& wrench : { seen.contact, seen.attraction })
    if (glm::length(wrench.force) > 0.0)
      arrows.push_back({ seen.tool.position, wrench.force });
  this->ArrowProp->SetMmPerNewton(this->mmPerNewton);
  this->ArrowProp->SetArrows(std::move(arrows));
}

void HapticDrawing::DrawShell(vtkHaspHapticLoop* loop)
{
  if (!this->ShellProp)
  {
    this->ShellMapper = vtkSmartPointer<vtkHaspPointShellMapper>::New();
    this->ShellProp = vtkSmartPointer<vtkActor>::New();
    this->ShellProp->SetMapper(this->ShellMapper);
    this->ShellProp->PickableOff();
    this->Renderer->AddViewProp(this->ShellProp);
  }
  const HapticDiscRequest* said = loop->AskForDiscs(this->mostDiscs);
  const std::uint32_t count = said != nullptr ? said->count : 0;
  this->ShellProp->SetVisibility(count > 0);
  if (count == 0)
    return;
  this->ShellMapper->SetDiscs(
    std::make_shared<const std::vector<ShellDisc>>(said->room.begin(), said->room.begin() + count));
  SetUserPose(this->ShellProp, loop->GetSnapshot().tool);
}

bool HapticDrawing::Update(vtkHaspHapticLoop* loop)
{
  const bool moved = loop->GetSnapshot().ticks != this->Ticks;
  this->Ticks = loop->GetSnapshot().ticks;
  if (this->pointer && moved)
    SetUserPose(this->pointer, loop->GetSnapshot().tool);
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
    this->DrawForces(loop);
  if (this->shell)
    this->DrawShell(loop);
  return moved && (this->pointer || this->forces || this->shell);
}

} // namespace hasp
