#ifndef vtkHaspReductionSession_h
#define vtkHaspReductionSession_h

#include "vtkCommand.h"                        // for the events
#include "vtkHaspInteractionReductionModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for the history

class vtkHaspHapticInteractor;
class vtkProp3D;

namespace hasp
{
class PlanHistory;
}

/**
 * @class   vtkHaspReductionSession
 * @brief   Fragments of a plan in somebody's hand: what is let go elsewhere is an edit.
 *
 * Give it the plan's history, a vtkHaspHapticInteractor and the prop of each fragment, whose data
 * lie where the scan has them. Follow puts the props where the plan has the fragments, and tells
 * the interactor what can be taken: a group as one, a fragment alone, and of units with a locked
 * fragment none; all can be touched but what is resected. Whatever moves the interactor's tools, a
 * haptic device, a 6-DOF mouse or a plain one, with Snap-to-fit or without: when it lets a unit go
 * that stands elsewhere than before, that is one PoseFragments step of the history, which Undo
 * takes back.
 *
 * Call Follow again after any other change of the plan (an undo, an edit, a group taken apart).
 * Where units are others than before, or one has been locked, all are given to the interactor anew,
 * and their maps and shells are baked again.
 *
 * Poses are the plan's: of the prop's user matrix, scan to planned; the prop's own position and
 * turn stay with its data.
 *
 * Events, on this: PlanChangedEvent after each step that a hand has made.
 *
 * Threads: RENDER. Interactor and props are held weakly. Errors: vtkErrorMacro, and nothing
 * changes; a step that the plan refuses (its fragment is gone or locked) leaves the plan as it is,
 * and the props go back to it.
 */
class VTKHASPINTERACTIONREDUCTION_EXPORT vtkHaspReductionSession : public vtkObject
{
public:
  static vtkHaspReductionSession* New();
  vtkTypeMacro(vtkHaspReductionSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    PlanChangedEvent = vtkCommand::UserEvent + 7401
  };

#ifndef __VTK_WRAP__
  /** Where steps go. The application may make others; Follow then. Null: no plan. */
  void SetHistory(std::shared_ptr<hasp::PlanHistory> history);
#endif
  /** Its tools and touchables are this session's from the next Follow on; others of its own are
   * left alone. Of one that it had before, what is in hand is let go, and is no step. */
  void SetInteractor(vtkHaspHapticInteractor* interactor);
  /** What shows the fragment. False after an error: no such fragment, or the prop or the fragment
   * is there already. Counts from the next Follow on. */
  bool AddFragment(unsigned int fragment, vtkProp3D* prop);
  /** Not there: nothing. */
  void RemoveFragment(unsigned int fragment);

  /** False after an error: no history or interactor, something is in hand, or the interactor
   * refuses a prop. */
  bool Follow();
  /** Of the interactor's tools, that which holds the fragment; -1: it cannot be taken. */
  int GetTool(unsigned int fragment) const;

protected:
  vtkHaspReductionSession();
  ~vtkHaspReductionSession() override;

private:
  vtkHaspReductionSession(const vtkHaspReductionSession&) = delete;
  void operator=(const vtkHaspReductionSession&) = delete;

  void PutProps();
  bool OfferUnits();
  void WithdrawUnits();
  void KeepPoses();

  struct Internals;
  const std::unique_ptr<Internals> Self;
};

#endif
