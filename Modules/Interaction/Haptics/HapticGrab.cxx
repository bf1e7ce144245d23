#include "HapticGrab.h"

#include "HapticExchange.h"
#include "PropPose.h"
#include "vtkHaspHapticLoop.h"

#include "vtkProp3D.h"

#include <algorithm>
#include <utility>

namespace hasp
{

bool HapticGrab::Bring(const HapticProps& props, vtkHaspHapticLoop* loop, const RigidPose* start)
{
  std::vector<HapticBody> bodies = props.Bodies(this->Held);
  const std::uint64_t scene = loop->SetScene(this->Shells, bodies, start);
  if (scene == 0)
    return false;
  this->Bodies = std::move(bodies);
  this->Scene = start != nullptr ? scene : this->Scene;
  return true;
}

/// Before the scene goes out: its first tick is to feel them, not those of the tool before.
void HapticGrab::SayIsovalues(const HapticProps& props, vtkHaspHapticLoop* loop) const
{
  HapticControl control = loop->GetControl();
  control.isovalues = props.Isovalues(this->Held);
  loop->SetControl(control);
}

bool HapticGrab::Take(int tool, const HapticProps& props, vtkHaspHapticLoop* loop)
{
  if (!props.ToolReady(tool))
    return false;
  if (loop->GetSnapshot().ticks == 0)
    loop->Update(); // where the device is, nobody has asked yet
  const RigidPose start = loop->GetSnapshot().device;
  std::vector<Part> parts;
  for (const HapticProp& it : props.All())
    if (it.tool == tool && it.prop)
      parts.push_back({ it.prop, start.Inverse() * UserPose(it.prop) });
  this->Shells = props.Shells(tool, start);
  this->Held = tool;
  this->SayIsovalues(props, loop);
  if (!this->Bring(props, loop, &start))
  {
    this->Held = -1;
    return false;
  }
  this->Parts = std::move(parts);
  this->Last = start;
  return true;
}

void HapticGrab::Drop(vtkHaspHapticLoop* loop)
{
  if (this->Held < 0)
    return;
  this->Held = -1;
  this->Shells.clear();
  this->Bodies.clear();
  this->Parts.clear();
  loop->SetScene({}, {}); // nothing can be touched: no thread
}

void HapticGrab::Refresh(const HapticProps& props, vtkHaspHapticLoop* loop)
{
  const std::vector<HapticBody> now = props.Bodies(this->Held);
  const bool same = std::equal(now.begin(), now.end(), this->Bodies.begin(), this->Bodies.end(),
    [](const HapticBody& a, const HapticBody& b)
    { return a.map == b.map && a.mapInWorld == b.mapInWorld; });
  if (!same && this->Held >= 0)
    this->Bring(props, loop, nullptr);
}

bool HapticGrab::Follow(vtkHaspHapticLoop* loop)
{
  const HapticSnapshot& seen = loop->GetSnapshot();
  if (this->Held < 0 || seen.scene < this->Scene || seen.tool == this->Last)
    return false;
  this->Last = seen.tool;
  for (const Part& part : this->Parts)
    if (part.prop)
      SetUserPose(part.prop, seen.tool * part.toTool);
  return true;
}

} // namespace hasp
