#pragma once
#include <QTextBrowser>

namespace hasp
{

struct Planner;

/// The passport of the scan that is shown, wherever it comes from: an import, a sample, a plan.
/// What was imported or refused last, where it is not that scan, stands above it.
///
/// Widget: import.passport. Threads: RENDER.
class PassportBrowser : public QTextBrowser
{
  Q_OBJECT
public:
  explicit PassportBrowser(Planner& planner, QWidget* parent = nullptr);

  /// PassportPage's, until another one comes, or another plan; empty: nothing.
  void SetAbove(const QString& html);

private:
  void Refresh();

  Planner& Of;
  QString Above, Now;
};

} // namespace hasp
