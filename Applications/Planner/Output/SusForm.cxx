#include "Output/SusForm.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace hasp
{
namespace
{

constexpr int MostAnswer = 5;

/// Brooke 1996, with "system" as it stands there.
constexpr std::array<const char*, SusItems> Statements{
  QT_TRANSLATE_NOOP("hasp::SusForm", "I think that I would like to use this system frequently."),
  QT_TRANSLATE_NOOP("hasp::SusForm", "I found the system unnecessarily complex."),
  QT_TRANSLATE_NOOP("hasp::SusForm", "I thought the system was easy to use."),
  QT_TRANSLATE_NOOP("hasp::SusForm",
    "I think that I would need the support of a technical person to be able to use this system."),
  QT_TRANSLATE_NOOP(
    "hasp::SusForm", "I found the various functions in this system were well integrated."),
  QT_TRANSLATE_NOOP("hasp::SusForm", "I thought there was too much inconsistency in this system."),
  QT_TRANSLATE_NOOP("hasp::SusForm",
    "I would imagine that most people would learn to use this system very quickly."),
  QT_TRANSLATE_NOOP("hasp::SusForm", "I found the system very cumbersome to use."),
  QT_TRANSLATE_NOOP("hasp::SusForm", "I felt very confident using the system."),
  QT_TRANSLATE_NOOP("hasp::SusForm",
    "I needed to learn a lot of things before I could get going with this system."),
};

} // namespace

SusForm::SusForm(QWidget* parent) : QDialog(parent)
{
  this->setObjectName("sus");
  this->setWindowTitle(tr("System Usability Scale"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel(tr("How far do you agree? Answer each statement at once, by what "
                                  "comes to your mind; where you cannot say, take the middle.")));
  column->addWidget(this->Statements());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  this->Save = buttons->button(QDialogButtonBox::Save);
  this->Save->setObjectName("sus.save");
  this->Save->setEnabled(false);
  buttons->button(QDialogButtonBox::Cancel)->setObjectName("sus.cancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  this->Focus(0);
}

QWidget* SusForm::Statements()
{
  auto* inside = new QWidget;
  auto* grid = new QGridLayout(inside);
  grid->addWidget(new QLabel(tr("Strongly\ndisagree")), 0, 1, 1, 2, Qt::AlignLeft);
  grid->addWidget(new QLabel(tr("Strongly\nagree")), 0, 4, 1, 2, Qt::AlignRight);
  grid->setColumnStretch(0, 1);
  for (int n = 0; n < static_cast<int>(SusItems); ++n)
  {
    auto* group = new QButtonGroup(this);
    auto* text = new QLabel(tr("%1. %2").arg(n + 1).arg(
      QCoreApplication::translate("hasp::SusForm", hasp::Statements[std::size_t(n)])));
    text->setWordWrap(true);
    text->setMinimumWidth(420);
    grid->addWidget(text, n + 1, 0);
    for (int answer = 1; answer <= MostAnswer; ++answer)
    {
      auto* button = new QRadioButton(QString::number(answer));
      button->setObjectName(QString("sus.%1.%2").arg(n + 1).arg(answer));
      button->setAccessibleName(tr("Statement %1: %2 of 5").arg(n + 1).arg(answer));
      button->installEventFilter(this);
      group->addButton(button, answer);
      grid->addWidget(button, n + 1, answer);
    }
    this->Groups[std::size_t(n)] = group;
    connect(group, &QButtonGroup::idClicked, this,
      [this] { this->Save->setEnabled(this->Answers().has_value()); });
  }
  return inside;
}

void SusForm::Focus(int statement)
{
  if (statement < 0)
    return;
  if (statement >= static_cast<int>(SusItems))
    return this->Save->setFocus();
  const QButtonGroup& group = *this->Groups[std::size_t(statement)];
  QAbstractButton* answered = group.checkedButton();
  (answered ? answered : group.button(1))->setFocus(Qt::TabFocusReason);
}

bool SusForm::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() != QEvent::KeyPress)
    return false;
  const int key = static_cast<const QKeyEvent*>(event)->key();
  for (int n = 0; n < static_cast<int>(SusItems); ++n)
  {
    const QButtonGroup& group = *this->Groups[std::size_t(n)];
    if (!group.buttons().contains(qobject_cast<QAbstractButton*>(watched)))
      continue;
    const int answer = key - Qt::Key_0;
    if (answer >= 1 && answer <= MostAnswer)
      group.button(answer)->click();
    else if (key != Qt::Key_Up && key != Qt::Key_Down)
      return false;
    this->Focus(key == Qt::Key_Up ? n - 1 : n + 1);
    return true;
  }
  return false;
}

std::optional<SusAnswers> SusForm::Answers() const
{
  SusAnswers answers{};
  for (std::size_t n = 0; n < SusItems; ++n)
  {
    answers[n] = this->Groups[n]->checkedId();
    if (answers[n] < 1)
      return std::nullopt;
  }
  return answers;
}

} // namespace hasp
