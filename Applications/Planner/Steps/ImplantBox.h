#pragma once
#include "Steps/ObjectBox.h"

class QComboBox;

namespace hasp
{

class PointsEdit;

/// Implants for holes in a skull: the outline is touched on bone all around the hole, in the scan.
///
/// Widgets: implant.choose, implant.new, implant.remove, implant.status, implant.make,
/// implant.name, implant.outline (PointsEdit's), implant.volume, implant.clearance,
/// implant.thickness, implant.spacing, implant.holes, implant.pitch, implant.edge,
/// implant.isovalue, implant.ignore, implant.axis, implant.axis.view, implant.axis.upright,
/// implant.mirror, implant.fault.
class ImplantBox : public ObjectBox<PlanImplant>
{
  Q_OBJECT
public:
  explicit ImplantBox(Planner& planner, QWidget* parent = nullptr);

protected:
  PlanImplant Fresh() override;
  void Begun() override;
  void Fill() override;

private:
  ImplantRecipe& Recipe() { return this->Draft.Typed().recipe; }
  void AddNumbers();
  void AddDirections();
  void TakeOutline();
  void FillChoices();

  RecipeForm* Form;
  PointsEdit* Outline;
  QComboBox *Volume, *Mirror;
};

} // namespace hasp
