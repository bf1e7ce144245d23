#pragma once
#include "Steps/StepPanel.h"
#include "Tools/PaintTool.h"

class QBoxLayout;
class QCheckBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace hasp
{

class BonesBox;
class LabelList;

/// What is bone, and which fragment each part of it is: by painting on it, by its pieces, or from a
/// place in it.
///
/// Widgets: IsovalueBox's, LabelList's and BonesBox'; split.paint, split.radius, split.eraser,
/// split.paint.crosshair, split.working, split.rethreshold, split.fill, split.close,
/// split.close.radius, split.make.
class SplitPanel : public StepPanel
{
  Q_OBJECT
public:
  explicit SplitPanel(Planner& planner, QWidget* parent = nullptr);
  ~SplitPanel() override;

  QString Title() const override { return tr("Split"); }
  QString StillNeeds() const override;
  void Enter() override; ///< slices show where bone begins
  void Leave() override; ///< what is painted stays in the plan; its preview is released

  PaintTool& Paint() { return this->Brush; }

private:
  QGroupBox* MakePainting();
  void AddCleaning(QBoxLayout* layout);
  void Refresh();
  void ShowWork();
  void ShowLine();
  void AddStep(const SegmentationStep& step, const QString& label);
  void UseIsovalue();

  PaintTool Brush;
  bool Entered = false;
  LabelList* Labels = nullptr;
  BonesBox* Bones = nullptr;
  QPushButton *Painting = nullptr, *AtCrosshair = nullptr, *Rethreshold = nullptr, *Fill = nullptr,
              *Close = nullptr, *Make = nullptr;
  QCheckBox* Eraser = nullptr;
  QDoubleSpinBox *Radius = nullptr, *CloseRadius = nullptr;
  QProgressBar* Working = nullptr;
};

} // namespace hasp
