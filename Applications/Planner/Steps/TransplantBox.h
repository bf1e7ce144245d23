#pragma once
#include "Steps/ObjectBox.h"

#include <QTimer>

class QComboBox;
class QLabel;
class QTabWidget;

namespace hasp
{

class PointsEdit;
struct TouchedPlace;

/// Segments of a donor bone in a defect: the path that they lie along is touched in the jaw, as it
/// is planned, its ends go into the faces of cuts, and the donor is said by its two tips, between
/// which its middle line is found in the scan (on the WORKER).
///
/// Widgets: transplant.choose, transplant.new, transplant.remove, transplant.status,
/// transplant.make, transplant.name, transplant.look.jaw, transplant.look.donor, transplant.path
/// (PointsEdit's), transplant.middle, transplant.more, transplant.less, transplant.first.cut,
/// transplant.first.fragment, transplant.last.cut, transplant.last.fragment, transplant.segment,
/// transplant.outward, transplant.outward.view, transplant.roll, transplant.least,
/// transplant.donor, transplant.tips (PointsEdit's), transplant.axis.find, transplant.axis,
/// transplant.side (TouchButton's), transplant.lateral, transplant.lateral.view, transplant.radius,
/// transplant.keep, transplant.start, transplant.lasttip, transplant.kerf, transplant.between,
/// transplant.gap, transplant.overlap, transplant.vessel, transplant.paddle, transplant.perforator
/// (PointsEdit's), transplant.segments, transplant.fault.
class TransplantBox : public ObjectBox<PlanTransplant>
{
  Q_OBJECT
public:
  explicit TransplantBox(Planner& planner, QWidget* parent = nullptr);

protected:
  PlanTransplant Fresh() override;
  void Begun() override;
  void Fill() override;

private:
  Transplant& Bone() { return this->Draft.Typed().transplant; }
  QWidget* JawPage();
  QWidget* DonorPage();
  QWidget* TissuePage();
  void AddFaces(RecipeForm* form);
  void AddOutward(RecipeForm* form);
  void AddSaw(RecipeForm* form);

  ///@{
  /// The jaw's side.
  void TakePath();
  void LayPath(const std::vector<glm::dvec3>& path);
  std::vector<glm::dvec3> PathNow() const; ///< as it is planned; before that, as touched so far
  void ToTheMiddle();
  void TakeFaces();
  glm::dvec3 Outward() const; ///< of the chosen segment
  void SetOutward(const glm::dvec3& direction);
  void TakeRoll();
  bool IsChosen(std::size_t segment) const;
  ///@}
  ///@{
  /// The donor's side: TransplantDonor.cxx.
  void TakeTips();
  void TakeDonor(PlanId donor);
  void FindAxis();
  void TakeAxis(const std::vector<glm::dvec3>& axis);
  void TakeSide(const TouchedPlace& place);
  void TakeTissue();
  void LookAt(bool donor);
  ///@}
  void FillChoices();
  void SayLayout();

  QTabWidget* Pages;
  PointsEdit *Path, *Tips, *Vessel, *Paddle, *Perforator;
  QComboBox *FirstCut, *FirstFragment, *LastCut, *LastFragment, *Segment, *Donor;
  QLabel *Layout, *Axis;
  double RollDeg = 0.0;              ///< typed and not done yet
  std::vector<TransplantJoint> Laid; ///< what came of the path as it stands in the list
  double LeastMm = 20.0;
  QTimer Resting; ///< after tips have changed: then their middle line is found
};

} // namespace hasp
