#pragma once
#include "Steps/ObjectBox.h"

class QComboBox;
class QTabWidget;

namespace hasp
{

class ObjectChecks;
class PointsEdit;

/// Bone plates: landmarks along the middle line, and screws, on fragments where the plan puts them
/// or on a scan as it is.
///
/// Widgets: plate.choose, plate.new, plate.remove, plate.status, plate.make, plate.name,
/// plate.bone, plate.fragment.ID, plate.landmarks (PointsEdit's), plate.gap, plate.thickness,
/// plate.width, plate.bevel, plate.bridge, plate.edge, plate.hole, plate.spacing, plate.isovalue,
/// plate.ignore, plate.screws (PointsEdit's), plate.screw.diameter, plate.screw.head,
/// plate.screw.room, plate.screw.cone, plate.screw.length, plate.screw.axis, plate.screw.axis.view,
/// plate.screw.axis.upright, plate.fault.
class PlateBox : public ObjectBox<PlanPlate>
{
  Q_OBJECT
public:
  explicit PlateBox(Planner& planner, QWidget* parent = nullptr);

protected:
  PlanPlate Fresh() override;
  void Begun() override;
  void Fill() override;

private:
  PlateRecipe& Recipe() { return this->Draft.Typed().recipe; }
  QWidget* LinePage();
  QWidget* ShapePage();
  QWidget* ScrewPage();
  void FillBone();
  void TakeLandmarks();
  void TakeBone();
  void TakeScrews();
  void TakeScrewNumbers();
  PlateScrew& Screw();
  void SetAxis(const std::optional<glm::dvec3>& axis);

  RecipeForm *Form, *ScrewForm;
  QTabWidget* Pages;
  QComboBox* Bone;
  ObjectChecks* Fragments;
  PointsEdit *Landmarks, *Screws;
  PlateScrew NextScrew;
};

} // namespace hasp
