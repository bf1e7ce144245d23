#pragma once
#include "Output/PartFacts.h"
#include "Output/PartFit.h"
#include "Tools/FitTool.h"

#include "Planning/DerivedPart.h"

#include <QGroupBox>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace hasp
{

/// The test fit of a part: by hand, and by a push along its withdrawal, which says where it seats.
///
/// Widgets: check.fit (takes it in hand), check.lift, check.seat (pushes), check.fit.state,
/// check.seat.result. Threads: RENDER; the bone and the push are jobs.
class FitBox : public QGroupBox
{
  Q_OBJECT
public:
  explicit FitBox(Planner& planner, QWidget* parent = nullptr);

  void Show(const PartFacts* facts); ///< nullptr: none
  FitTool& Tool() { return this->Hand; }
  /// Of the part that is shown, if it has not changed since; nothing: it was not pushed yet.
  std::optional<Seat> LastSeat() const;

private:
  /// Calls `then` with the body of the part that is shown, made first if it is not there.
  void WithBody(const std::function<void(const std::shared_ptr<const PartOnBone>&)>& then);
  void TakeInHand(bool on);
  void Push();
  void Refresh();
  bool IsOfNow(const std::vector<PartInput>& inputs) const;

  Planner& Of;
  FitTool Hand;
  std::optional<PartFacts> Shown;
  struct Kept
  {
    std::vector<PartInput> inputs; ///< that it is of
    std::shared_ptr<const PartOnBone> body;
    std::optional<PartSeat> seat;
  };
  std::optional<Kept> Made;
  QPushButton *Taking, *Lifting, *Pushing;
  QLabel *State, *Result;
};

/// What a push of a part of this plan has found, in words; where it is blocked, what to change.
QString SeatText(const Plan& plan, const PartSeat& push, const PartFacts& facts);

} // namespace hasp
