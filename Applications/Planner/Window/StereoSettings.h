#pragma once
#include "HeadChoices.h"
#include "StereoChoices.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace hasp
{

class PlannerWindow;

struct PlannerStereo
{
  StereoChoices stereo;
  HeadChoices head;
  bool fullScreen = false;
};

/// Stereo's settings in millimetres, and the drawing of desk, screen and eyes to hold them against:
/// it follows each change. Threads: RENDER.
class StereoSettings : public QDialog
{
  Q_OBJECT
public:
  StereoSettings(PlannerWindow& window, const PlannerStereo& before);

  PlannerStereo Choices() const;

private:
  void Build();
  void Show(const PlannerStereo& before);
  void Sketch();

  PlannerWindow& Window;
  QComboBox* Layout;
  QComboBox* Resolution;
  QComboBox* Mirror;
  QComboBox* Head;
  QLineEdit* HeadMore;
  QCheckBox* Swap;
  QCheckBox* LifeSize;
  QCheckBox* FullScreen;
  QCheckBox* Known; ///< the screen's size
  QDoubleSpinBox* Width;
  QDoubleSpinBox* Height;
  QDoubleSpinBox* Distance;
  QDoubleSpinBox* Eyes;
  QDoubleSpinBox* Angle;
  QLabel* Drawing;
  QLabel* Fault;
};

} // namespace hasp
