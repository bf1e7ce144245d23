#pragma once
#include <QString>

class QWidget;

namespace hasp
{

// Empty: none was chosen. Qt keeps no folder of them (RunPlanner), for paths name patients. RENDER;
// each waits.

///@{
/// Asks for a file, or for a folder, to open.
QString AskForFile(QWidget* parent, const QString& title, const QString& filter);
QString AskForFolder(QWidget* parent, const QString& title);
///@}
///@{
/// Asks for a file to write, or for a folder that is not there yet or empty. `name`: what is
/// proposed. A file gets its ending, where another name is typed; `besides`: the ending of what is
/// written beside it. Asks again before one that is there is overwritten.
QString AskForNewFile(QWidget* parent, const QString& title, const QString& name,
  const QString& filter, const QString& besides = {});
QString AskForNewFolder(QWidget* parent, const QString& title, const QString& name);
///@}

} // namespace hasp
