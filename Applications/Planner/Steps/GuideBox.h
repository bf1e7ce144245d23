#pragma once
#include "Steps/ObjectBox.h"

class QBoxLayout;
class QComboBox;
class QTabWidget;

namespace hasp
{

class ObjectChecks;
class PaintedArea;
class PointsEdit;
struct TouchedPlace;

/// Guides. Landmarks are touched along the bone, or an area is painted; the direction that the
/// guide lifts off along is their mean normal, until it is said otherwise. Everything lies where
/// the bone was scanned.
///
/// Widgets: guide.choose, guide.new, guide.remove, guide.status, guide.make, guide.name,
/// guide.bone, guide.landmarks (PointsEdit's), guide.outline, guide.width, guide.withdrawal,
/// guide.withdrawal.mean, guide.withdrawal.view, guide.search, guide.gap, guide.thickness,
/// guide.edge, guide.clearance, guide.clearance.sla, guide.clearance.fdm, guide.wall, guide.sleeve,
/// guide.spacing, guide.isovalue, guide.ignore, guide.cut.ID, guide.pins (PointsEdit's),
/// guide.pin.diameter, guide.pin.depth, guide.pin.height, guide.side, guide.label (PointsEdit's),
/// guide.label.height, guide.label.depth, guide.label.engraved, guide.label.right,
/// guide.label.right.view, guide.fault.
class GuideBox : public ObjectBox<PlanGuide>
{
  Q_OBJECT
public:
  explicit GuideBox(Planner& planner, QWidget* parent = nullptr);

protected:
  PlanGuide Fresh() override;
  void Begun() override;
  void Fill() override;
  QString WhyNotMade() override;

private:
  GuideRecipe& Recipe() { return this->Draft.Typed().recipe; }
  RecipeForm::Value<double> Member(double GuideRecipe::*member);
  QWidget* AreaPage();
  QWidget* ShapePage();
  QWidget* CutsPage();
  QWidget* PinsPage();
  void AddPinRows();
  void AddLabelRows();
  void FillBones();

  void TakeLandmarks();
  void TakePaint(const TouchedPlace& first);
  void BeginOn(const TouchedPlace& place);
  void LiftAlongNormals();
  void TakeBone();
  void TakePins();
  void TakePinNumbers();
  void TakeLabel();
  glm::dvec3 MeanNormal();
  void SetWithdrawal(const glm::dvec3& direction);
  GuideHole& Pin();
  GuideLabel* CaseLabel();
  GuideLabel& Label();
  glm::dvec3 InScan(const glm::dvec3& direction); ///< of the bone, of one of the world

  RecipeForm *Area, *Shape, *PinForm, *LabelForm;
  QTabWidget* Pages;
  QComboBox* Bone;
  PointsEdit *Landmarks, *Pins, *LabelPlace;
  ObjectChecks* Cuts;
  PaintedArea* Paint;
  bool FollowsNormals = true; ///< the withdrawal direction is the landmarks' mean normal
  GuideHole NextPin;
  GuideLabel NextLabel;
};

} // namespace hasp
