#pragma once
#include "Haptics/SeatByContact.h"
#include "Tools/PartOnBone.h"
#include "Tools/PropCover.h"
#include "Tools/Tool.h"
#include "Tools/VtkFaults.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

class vtkHaspHapticInteractor;

namespace hasp
{

class CellProp;
class MeshProp;
struct Planner;
class ToolMarks;

/// How it stands with a part that is tried on.
struct FitState
{
  bool isReady = false; ///< what can be felt has been prepared
  double share = 0.0;   ///< of that, [0, 1]
  bool isHeld = false, isTouching = false;
  double offMm = 0.0; ///< of its planned place, along its withdrawal; below 0: beyond it
};

/// The test fit of a part before it is exported (thesis 4.2): the part is moved against its bone
/// and touches it, with the mouse or a haptic device. It begins PartOnBone::LiftMm off its planned
/// place.
///
/// While it is in hand the view shows the part and the bone that it is held to, as they lie in the
/// bone's place, and nothing else of the plan: what is seen is what is felt. Nothing of it is an
/// edit; afterwards all is as it was. Threads: RENDER; ticks on HAPTIC while the part is held.
/// Cost: the distances of the bone and points of the part, made on a WORKER; nothing before and
/// after.
class FitTool : public Tool
{
  Q_OBJECT
public:
  explicit FitTool(Planner& planner, QObject* parent = nullptr);
  ~FitTool() override;

  /// What is tried, and where: before it is taken in hand. nullptr: nothing.
  void SetBody(std::shared_ptr<const PartOnBone> body);
  const std::shared_ptr<const PartOnBone>& Body() const { return this->Tried; }

  void Begin() override;
  void End() override;
  QString Hint() const override;
  bool TakesDevice() const override { return true; }

  ///@{
  /// While it is in hand: puts the part LiftMm off again; so many mm off its planned place, turned
  /// as that; where a push has brought it, with a mark where it touches first.
  void Lift();
  void PutAt(double offMm);
  void Show(const Seat& seat);
  ///@}
  FitState State() const;

Q_SIGNALS:
  void StateChanged(); ///< 10 times a second at most while something goes on

private:
  bool IsInHand() const { return this->Hand != nullptr; }
  void TakeHand();
  void TakeDevice();
  void Cover();
  void Heard(vtkObject* object, unsigned long event);

  Planner& Of;
  VtkFaults Faults;
  PropCover Others;
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCamera> Before; ///< as the view looked
  std::shared_ptr<const PartOnBone> Tried;
  std::unique_ptr<CellProp> Bone;
  std::unique_ptr<MeshProp> Part;
  std::unique_ptr<ToolMarks> Marks;
  std::optional<glm::dvec3> TouchAt;
  vtkSmartPointer<vtkHaspHapticInteractor> Hand; ///< null: it is not in hand
  QTimer Telling;
  unsigned long FrameTag = 0;
};

} // namespace hasp
