#ifndef HapticGrab_h
#define HapticGrab_h

#include "HapticProps.h"

#include <vector>

class vtkHaspHapticLoop;

namespace hasp
{

/// What is in hand: which tool, where it was taken, and its props on the way. Threads: RENDER.
class HapticGrab
{
public:
  /// The tool's shells and what it can touch become the loop's scene, its isovalues the control's.
  /// False if the loop refuses (it has said why) or the tool is not ready. Throws as
  /// HapticProp::Pose. Cost on RENDER: loop->SetScene's, 0.002 ms a static prop and body, 0.2 ms a
  /// dynamic prop and body, several times that at first; Refresh's is the same where something has
  /// changed.
  bool Take(int tool, const HapticProps& props, vtkHaspHapticLoop* loop);
  /// The props stay where they are.
  void Drop(vtkHaspHapticLoop* loop);

  int Tool() const { return this->Held; } ///< -1: nothing is in hand
  /// The loop's newest pose on the props; true if they moved. Nothing before the scene is felt.
  bool Follow(vtkHaspHapticLoop* loop);
  /// What can be touched, or where it stands, has changed: the loop gets it, the tool goes on.
  void Refresh(const HapticProps& props, vtkHaspHapticLoop* loop);

private:
  struct Part
  {
    vtkWeakPointer<vtkProp3D> prop;
    RigidPose toTool; ///< its user matrix, seen from the tool's axes
  };
  bool Bring(const HapticProps& props, vtkHaspHapticLoop* loop, const RigidPose* start);
  void SayIsovalues(const HapticProps& props, vtkHaspHapticLoop* loop) const;

  int Held = -1;
  std::uint64_t Scene = 0;
  std::vector<Part> Parts;
  std::vector<HapticBody> Bodies;  ///< as they were brought
  std::vector<HapticShell> Shells; ///< of the tool, as it was taken
  RigidPose Last;
};

} // namespace hasp

#endif
