#pragma once
#include "Steps/ObjectBox.h"

class QComboBox;

namespace hasp
{

/// The guides that lead the saw on transplants' donors.
///
/// Widgets: mitre.choose, mitre.new, mitre.remove, mitre.status, mitre.make, mitre.name,
/// mitre.transplant, mitre.gap, mitre.thickness, mitre.width, mitre.clearance, mitre.wall,
/// mitre.slot, mitre.height, mitre.beyond, mitre.pin, mitre.spacing, mitre.fault.
class MitreBox : public ObjectBox<PlanMitreGuide>
{
  Q_OBJECT
public:
  explicit MitreBox(Planner& planner, QWidget* parent = nullptr);

protected:
  PlanMitreGuide Fresh() override;
  void Begun() override;
  void Fill() override;

private:
  void AddNumbers();

  RecipeForm* Form;
  QComboBox* Transplant;
};

} // namespace hasp
