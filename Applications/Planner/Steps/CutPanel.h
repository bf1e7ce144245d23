#pragma once
#include "Steps/ObjectDraft.h"
#include "Steps/StepPanel.h"
#include "Tools/BladeTool.h"

#include <glm/vec3.hpp>

class QPushButton;
class QTabWidget;

namespace hasp
{

class BladeNudge;
class FaultLine;
class ObjectChecks;
class ObjectChooser;
class PiecesBox;
class PointsEdit;
class RecipeForm;
struct TouchedPlace;

/// Osteotomies. Two touched places and the view make a blade, a third one turns it into the plane
/// through all three; its handles and numbers put it right. What it cuts, and the pieces that it
/// leaves (PiecesBox). Bone that is no fragment yet becomes one by the touch.
///
/// Widgets: cut.pages, cut.choose, cut.new, cut.remove, cut.bone, cut.place (PointsEdit's),
/// cut.drag, cut.name, cut.kerf, cut.width, cut.depth, cut.reach, cut.fault, cut.fragment.ID;
/// BladeNudge's, PiecesBox's.
class CutPanel : public StepPanel
{
  Q_OBJECT
public:
  explicit CutPanel(Planner& planner, QWidget* parent = nullptr);

  ~CutPanel() override;

  QString Title() const override { return tr("Cut"); }
  QString StillNeeds() const override;
  void Enter() override;
  void Leave() override;

private:
  QWidget* PlacePage();
  QWidget* BladePage();
  void AddBone(const TouchedPlace& place);
  void ChooseCut(PlanId cut);
  void ForgetPlaces();
  void Touched();
  void PlaceBlade();
  void Put();
  void Follow();
  void Fill();

  ObjectDraft<PlanCut> Draft;
  BladeTool Blade;
  ObjectChooser* List;
  QTabWidget* Pages;
  PointsEdit* Places;
  QPushButton* Drag;
  RecipeForm* Form;
  FaultLine* Fault;
  BladeNudge* Nudge;
  ObjectChecks* Fragments;
  PiecesBox* Pieces;
  std::size_t Counted = 0; ///< places when they were last looked at
  glm::dvec3 Seen{ 0.0 };  ///< how one looked when the second place was touched
};

} // namespace hasp
