#include "Steps/FileQuestion.h"

#include <QFileDialog>
#include <QSettings>

namespace hasp
{
namespace
{

void ForgetFolders()
{
  QSettings settings(QSettings::UserScope, QStringLiteral("QtProject")); // QFileDialog's own
  settings.beginGroup(QStringLiteral("FileDialog"));
  for (const char* key : { "history", "lastVisited", "shortcuts" })
    settings.remove(QLatin1String(key));
}

} // namespace

QString AskForFile(QWidget* parent, const QString& title, const QString& filter)
{
  QString chosen = QFileDialog::getOpenFileName(parent, title, {}, filter);
  ForgetFolders();
  return chosen;
}

QString AskForFolder(QWidget* parent, const QString& title)
{
  QString chosen = QFileDialog::getExistingDirectory(parent, title);
  ForgetFolders();
  return chosen;
}

} // namespace hasp
