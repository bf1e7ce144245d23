#pragma once
#include <QString>

class QWidget;

namespace hasp
{

///@{
/// Asks for a file, or for a folder, to open; empty: none was chosen. Paths name patients, and Qt
/// keeps the folders that its dialogs have shown: that is forgotten each time. RENDER; waits.
QString AskForFile(QWidget* parent, const QString& title, const QString& filter);
QString AskForFolder(QWidget* parent, const QString& title);
///@}

} // namespace hasp
