#pragma once
#include "Planning/Plan.h"
#include "Tools/Tool.h"
#include "Tools/VtkFaults.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <QTimer>

#include <map>
#include <memory>
#include <vector>

class vtkHaspHapticInteractor;
class vtkHaspReductionSession;
class vtkProp3D;

namespace hasp
{

struct Planner;

/// How it stands with what can be taken in hand.
struct GrabState
{
  bool isReady = false;     ///< what can be felt has been prepared
  double share = 0.0;       ///< of that, [0, 1]
  std::vector<PlanId> held; ///< fragments in hand; none: empty
  bool isTouching = false;
  double contactN = 0.0;    ///< pushing it away
  double attractionN = 0.0; ///< Snap-to-fit's, pulling it in
  double deepestMm = 0.0;   ///< how far it is in bone, >= 0
};

/// Takes fragments in hand, with the mouse or a haptic device, and feels the others with them: what
/// is let go elsewhere is one step of the plan (vtkHaspReductionSession). Groups go as one, locked
/// fragments not at all; what is hidden is not felt.
///
/// Threads: RENDER; ticks on HAPTIC while something is in hand. Cost: distances and points of all
/// fragments that are shown, made on a WORKER while it is in hand (8 million samples the largest);
/// nothing before and after.
class GrabTool : public Tool
{
  Q_OBJECT
public:
  explicit GrabTool(Planner& planner, QObject* parent = nullptr);
  ~GrabTool() override;

  void Begin() override;
  void End() override; ///< what is in hand is let go where it is
  QString Hint() const override;
  bool TakesDevice() const override { return true; }

  void SetSnap(bool on); ///< Snap-to-fit: broken faces attract
  bool IsSnap() const { return this->Snap; }
  void SetShowForces(bool on); ///< as arrows
  bool IsShowForces() const { return this->Forces; }

  GrabState State() const;
  /// nullptr while it is not in hand.
  vtkHaspHapticInteractor* Haptic() const;

Q_SIGNALS:
  void StateChanged(); ///< 10 times a second at most while something goes on
  void HeldChanged();  ///< State().held

private:
  void FollowSoon() { this->Soon.start(); }
  void Follow();
  void TakeDevice();
  double Spacing() const;
  void Heard(vtkObject* object, unsigned long event);
  void SayWhyNot();
  std::vector<PlanId> Held() const;

  Planner& Of;
  VtkFaults Faults;
  vtkNew<vtkCallbackCommand> Command, BeforePress, Untaken;
  vtkSmartPointer<vtkHaspHapticInteractor> Hand;
  vtkSmartPointer<vtkHaspReductionSession> Session;  ///< null: it is not in hand
  std::map<PlanId, vtkWeakPointer<vtkProp3D>> Known; ///< that the session has
  QTimer Soon, Telling;
  unsigned long FrameTag = 0;
  bool Snap = false, Forces = false;
};

} // namespace hasp
