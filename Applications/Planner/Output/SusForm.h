#pragma once
#include "Output/SusScore.h"

#include <QDialog>

#include <optional>

class QButtonGroup;
class QPushButton;

namespace hasp
{

/// The ten statements of the System Usability Scale, each with five answers. It can be handed in
/// when all are answered. With the keyboard: 1 to 5 answer a statement and go to the next, Up and
/// Down go on without.
///
/// Names: "sus.N.A" for answer A (1 to 5) of statement N (1 to 10), "sus.save", "sus.cancel".
/// Threads: RENDER.
class SusForm : public QDialog
{
  Q_OBJECT
public:
  explicit SusForm(QWidget* parent = nullptr);

  /// None while one is missing.
  std::optional<SusAnswers> Answers() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* Statements();
  void Focus(int statement);

  std::array<QButtonGroup*, SusItems> Groups{};
  QPushButton* Save = nullptr;
};

} // namespace hasp
