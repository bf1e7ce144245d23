#pragma once
#include "StepsOneDesk.h"

#include "Steps/ImportPanel.h"

#include <QTextBrowser>

namespace hasp::testing
{

/// The panel that imports.
struct ImportDesk : StepsOneDesk
{
  explicit ImportDesk(const CanaryFolder& folder, const std::string& state = "state")
    : StepsOneDesk(folder, state),
      panel(this->planner)
  {
  }
  bool Import(const std::string& path)
  {
    this->panel.ImportPath(QString::fromStdString(path));
    return this->Settle();
  }
  QString Passport() { return Find<QTextBrowser>(this->panel, "import.passport").toPlainText(); }
  /// All that was said, and what the page says.
  QString AllText() { return this->said.join(' ') + this->faults.join(' ') + this->Passport(); }

  ImportPanel panel;
};

} // namespace hasp::testing
