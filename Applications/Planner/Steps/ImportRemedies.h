#pragma once
#include <QWidget>

class QCheckBox;
class QComboBox;
class QPushButton;

namespace hasp
{

struct Passport;
struct VolumeReadSettings;

/// What can be done about a scan that was refused: another of its series, resampling where that
/// mends it, and to try again. Not seen while there is nothing to do.
///
/// Widgets: import.series, import.resample, import.again.
class ImportRemedies : public QWidget
{
  Q_OBJECT
public:
  explicit ImportRemedies(QWidget* parent = nullptr);

  void Offer(const Passport& refused);
  void Withdraw();
  /// As they are chosen now; the defaults where nothing is offered.
  VolumeReadSettings Settings() const;

Q_SIGNALS:
  void TryAgain();

private:
  QComboBox* Series;
  QCheckBox* Resample;
  QPushButton* Again;
  bool HasSeries = false, Mends = false; ///< offered
};

} // namespace hasp
