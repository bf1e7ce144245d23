#include "Steps/FileQuestion.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace hasp
{
namespace
{

struct Words
{
  Q_DECLARE_TR_FUNCTIONS(FileQuestion)
};

/// Of a name that has it or `besides`, in whatever case, or none.
QString WithEnding(const QString& file, const QString& ending, const QString& besides)
{
  for (const QString& has : { ending, besides })
    if (!has.isEmpty() && file.endsWith(has, Qt::CaseInsensitive))
      return file.chopped(has.size()) + ending;
  return file + ending;
}

/// Asks, if it is there.
bool MayReplace(QWidget* parent, const QString& file)
{
  const QFileInfo there(file);
  if (!there.exists() || there.isDir()) // a folder is refused by whoever writes
    return true;
  QMessageBox question(QMessageBox::Warning, Words::tr("Replace the file?"),
    Words::tr("%1 is there already.").arg(there.fileName()), QMessageBox::NoButton, parent);
  question.setObjectName("question.replace");
  question.setTextFormat(Qt::PlainText);
  QPushButton* replace = question.addButton(Words::tr("&Replace it"), QMessageBox::DestructiveRole);
  replace->setObjectName("question.replace.yes");
  QPushButton* other = question.addButton(Words::tr("&Another name"), QMessageBox::RejectRole);
  other->setObjectName("question.replace.no");
  question.setDefaultButton(other);
  question.setEscapeButton(other);
  question.exec();
  return question.clickedButton() == replace;
}

} // namespace

QString AskForFile(QWidget* parent, const QString& title, const QString& filter)
{
  return QFileDialog::getOpenFileName(parent, title, {}, filter);
}

QString AskForFolder(QWidget* parent, const QString& title)
{
  return QFileDialog::getExistingDirectory(parent, title);
}

QString AskForNewFile(QWidget* parent, const QString& title, const QString& name,
  const QString& filter, const QString& besides)
{
  const QString ending = '.' + QFileInfo(name).suffix();
  QFileDialog dialog(parent, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setOption(QFileDialog::DontConfirmOverwrite); // it would ask of the name without ending
  dialog.selectFile(name);
  while (dialog.exec() == QDialog::Accepted)
  {
    const QString file = WithEnding(dialog.selectedFiles().value(0), ending, besides);
    const QString beside = file.chopped(ending.size()) + besides;
    if (MayReplace(parent, file) && (besides.isEmpty() || MayReplace(parent, beside)))
      return file;
  }
  return {};
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
