#pragma once
#include "Output/PartFacts.h"

#include <QGroupBox>

#include <glm/vec3.hpp>

#include <optional>

class QListWidget;
class QPushButton;
class QTableWidget;

namespace hasp
{

struct Planner;

/// What was measured on a part: its faults, each with its place, and every measure beside its
/// limit.
///
/// Widgets: check.faults, check.show (looks at a fault's place: crosshair and camera),
/// check.measures, check.page (the certificate's page). Threads: RENDER.
class CertificateBox : public QGroupBox
{
  Q_OBJECT
public:
  explicit CertificateBox(Planner& planner, QWidget* parent = nullptr);

  void Show(const PartFacts* facts); ///< nullptr: none

Q_SIGNALS:
  void FaultChosen(int number); ///< of the certificate's faults, from 0

private:
  void ShowPlace();
  void OpenPage();

  Planner& Of;
  std::optional<PartFacts> Shown;
  QListWidget* Faults;
  QTableWidget* Measures;
  QPushButton *Place, *Page;
};

} // namespace hasp
