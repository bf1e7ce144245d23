#include "Steps/FaultLine.h"

#include "Steps/RecipeForm.h"

namespace hasp
{

FaultLine::FaultLine(const QString& prefix, QWidget* parent) : QLabel(parent)
{
  this->setObjectName(prefix + ".fault");
  this->setWordWrap(true);
  this->setStyleSheet(QStringLiteral("color: #c02020"));
  this->hide();
}

void FaultLine::Know(RecipeForm* form)
{
  this->Forms.push_back(form);
  connect(form, &RecipeForm::Refused, this, &FaultLine::Say);
}

void FaultLine::Say(const QString& text)
{
  this->setText(this->InWords(text));
  this->setVisible(!text.isEmpty());
}

QString FaultLine::InWords(QString text) const
{
  for (const RecipeForm* form : this->Forms)
    text = form->InWords(text);
  return text;
}

} // namespace hasp
