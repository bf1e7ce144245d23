#pragma once
#include <QString>

class QWidget;

namespace hasp
{

///@{
/// Asks for a file to write, or for a folder that is not there yet or empty; empty: none was
/// chosen. Paths name patients, and Qt keeps the folders that its dialogs have shown: that is
/// forgotten each time. `name`: what is proposed. RENDER; waits.
QString AskForNewFile(
  QWidget* parent, const QString& title, const QString& name, const QString& filter);
QString AskForNewFolder(QWidget* parent, const QString& title, const QString& name);
///@}

} // namespace hasp
