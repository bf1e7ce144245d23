#ifndef HapticDrawing_h
#define HapticDrawing_h

#include "ForceArrow.h"
#include "Grid/RigidPose.h"

#include "vtkHaspInteractionHapticsModule.h" // for export macro: tests
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkActor;
class vtkHaspForceArrows;
class vtkHaspPointShellMapper;
class vtkProp3D;
class vtkRenderer;

namespace hasp
{

struct HapticDiscRequest;
struct HapticSnapshot;

/// What haptics adds to a picture, each part made when it is first asked for and gone when it is
/// not: arrows of the forces, the dynamic shell's points, and a prop that stands where the tool is.
/// Threads: RENDER.
class VTKHASPINTERACTIONHAPTICS_EXPORT HapticDrawing
{
public:
  HapticDrawing();
  ~HapticDrawing();

  void SetRenderer(vtkRenderer* renderer);
  bool forces = false, shell = false;
  double mmPerNewton = 10.0;
  std::size_t mostDiscs = 4096;
  void SetPointer(vtkProp3D* prop);

  /// Once a frame: the newest tick, and its dynamic shells' points where they are drawn and there
  /// are any yet; null: none. True if something changed.
  bool Update(const HapticSnapshot& seen, const HapticDiscRequest* discs);

private:
  void Drop();
  /// True if the picture is another one now; so the next ones.
  bool DropUnused();
  bool MovePointer(const HapticSnapshot& seen);
  bool DrawForces(const HapticSnapshot& seen);
  bool DrawShell(const HapticSnapshot& now, const HapticDiscRequest* discs);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkProp3D> Pointer;
  vtkSmartPointer<vtkHaspForceArrows> ArrowProp;
  vtkSmartPointer<vtkActor> ShellProp;
  vtkSmartPointer<vtkHaspPointShellMapper> ShellMapper;
  std::uint64_t Ticks = 0;
  RigidPose Pointed;              ///< where the pointer stands
  std::vector<ForceArrow> Arrows; ///< as they are drawn
};

} // namespace hasp

#endif
