#include "Steps/SaveQuestion.h"

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

QString AskForNewFile(
  QWidget* parent, const QString& title, const QString& name, const QString& filter)
{
  QString chosen = QFileDialog::getSaveFileName(parent, title, name, filter);
  ForgetFolders();
  return chosen;
}

QString AskForNewFolder(QWidget* parent, const QString& title, const QString& name)
{
  QFileDialog dialog(parent, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave); // one that is not there yet has a name, too
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setOption(QFileDialog::DontConfirmOverwrite); // what is there and not empty is refused
  dialog.selectFile(name);
  const bool accepted = dialog.exec() == QDialog::Accepted;
  ForgetFolders();
  return accepted && !dialog.selectedFiles().isEmpty() ? dialog.selectedFiles().front() : QString();
}

} // namespace hasp
