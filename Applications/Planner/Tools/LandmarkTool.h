#pragma once
#include "Tools/Tool.h"
#include "Tools/ToolMarks.h"
#include "Tools/Touch.h"
#include "Tools/ViewMouse.h"

#include <QColor>

#include <memory>
#include <vector>

namespace hasp
{

/// What places are touched for.
struct LandmarkPurpose
{
  QString hint;            ///< "Touch bone along the guide's middle line."
  std::size_t most = 1000; ///< more are not taken; a single one is another instead
  bool onBone = true;      ///< in slices and at the crosshair take the bone's surface if it is near
  enum class Line
  {
    None,
    Open,
    Closed
  } line = Line::None; ///< drawn through them, in order
  QColor colour{ 255, 196, 0 };
};

/// Places in order, by touching what is shown. A click on bone, or in a slice, is one more; one on
/// a place chooses it, a drag of a place moves it along the bone, Delete removes the chosen one,
/// and Insert takes the crosshair's place. Any other drag is the view's. Nobody is told of a place
/// until the click or drag is over. Where its places are is seen while it is in hand, and while it
/// is asked to show them.
///
/// Threads: RENDER. Cost while it shows places: marks over the views; while it is in hand, a pick
/// for each click, and for each step of a drag, too. Else nothing but the places.
class LandmarkTool : public Tool
{
  Q_OBJECT
public:
  explicit LandmarkTool(Planner& planner, LandmarkPurpose purpose, QObject* parent = nullptr);
  ~LandmarkTool() override;

  void Begin() override;
  void End() override;
  QString Hint() const override;
  void Show(bool shown); ///< its places, when it is not in hand
  void SetPurpose(const LandmarkPurpose& purpose);
  const LandmarkPurpose& Purpose() const { return this->For; }

  const std::vector<TouchedPlace>& Places() const { return this->All; }
  void SetPlaces(std::vector<TouchedPlace> places); ///< as the plan has them; nobody is told
  int Selected() const { return this->Chosen; }     ///< -1: none
  void Select(int place);

  ///@{
  /// What keys do, for buttons. False: no scan is shown, no room; nothing is chosen.
  bool TouchCrosshair();
  bool RemoveSelected();
  ///@}

Q_SIGNALS:
  void Edited(); ///< a place has come, gone or moved, by hand
  void SelectedChanged(int place);

private:
  bool IsBone(const TouchedPlace& place) const; ///< else it is said what it is
  bool Add(const std::optional<TouchedPlace>& place);
  int At(FrameView& view, const QPointF& pixel) const;
  bool Press(FrameView& view, const QPointF& pixel);
  void Drag(FrameView& view, const QPointF& pixel);
  void Release();
  bool Key(const QKeyEvent& key);
  void Paint(QPainter& painter, const MarkedView& view) const;
  void Update(); ///< the marks, which are there while there is something to mark

  Planner& Of;
  LandmarkPurpose For;
  std::vector<TouchedPlace> All;
  int Chosen = -1;
  bool Moved = false; ///< the place that is held
  bool Shown = false; ///< also when it is not in hand
  ViewMouse Mouse;
  std::unique_ptr<ToolMarks> Marks;
};

} // namespace hasp
