#include "Steps/FileQuestion.h"

#include <QFileDialog>

namespace hasp
{

QString AskForFile(QWidget* parent, const QString& title, const QString& filter)
{
  return QFileDialog::getOpenFileName(parent, title, {}, filter);
}

QString AskForFolder(QWidget* parent, const QString& title)
{
  return QFileDialog::getExistingDirectory(parent, title);
}

QString AskForNewFile(
  QWidget* parent, const QString& title, const QString& name, const QString& filter)
{
  return QFileDialog::getSaveFileName(parent, title, name, filter);
}

QString AskForNewFolder(QWidget* parent, const QString& title, const QString& name)
{
  QFileDialog dialog(parent, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave); // one that is not there yet has a name, too
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setOption(QFileDialog::DontConfirmOverwrite); // what is there and not empty is refused
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace hasp
