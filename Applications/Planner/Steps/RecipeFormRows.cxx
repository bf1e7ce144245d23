// Rows of a form that are no numbers.
#include "Steps/RecipeForm.h"

#include "Steps/NumberText.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <glm/geometric.hpp>

#include <memory>

namespace hasp
{

namespace
{
constexpr double LeastLength = 1e-6;
} // namespace

QComboBox* RecipeForm::Choice(const QString& name, const QString& label, const QStringList& texts,
  std::function<int()> read, std::function<void(int)> write)
{
  auto* box = new QComboBox;
  box->setObjectName(this->NameOf(name));
  box->addItems(texts);
  this->Row(label, box);
  connect(box, qOverload<int>(&QComboBox::activated), this,
    [this, read, write](int row)
    {
      if (row == read())
        return;
      write(row);
      Q_EMIT this->Edited();
    });
  this->Readers.push_back([box, read] { box->setCurrentIndex(read()); });
  return box;
}

QCheckBox* RecipeForm::Check(const QString& name, const QString& label, std::function<bool()> read,
  std::function<void(bool)> write)
{
  auto* box = new QCheckBox(label);
  box->setObjectName(this->NameOf(name));
  this->Row(box);
  connect(box, &QCheckBox::clicked, this,
    [this, write](bool on)
    {
      write(on);
      Q_EMIT this->Edited();
    });
  this->Readers.push_back([box, read] { box->setChecked(read()); });
  return box;
}

QLineEdit* RecipeForm::Text(const QString& name, const QString& label, Value<std::string> value)
{
  auto* line = new QLineEdit;
  line->setObjectName(this->NameOf(name));
  line->setMaxLength(50); // of 4 bytes each: what a plan takes
  this->Row(label, line);
  const auto shown = std::make_shared<QString>(); // as it was read: a longer one is cut off
  connect(line, &QLineEdit::editingFinished, this,
    [this, line, value, shown]
    {
      line->setModified(false);
      if (line->text() == *shown)
        return;
      *shown = line->text();
      value() = line->text().trimmed().toStdString();
      Q_EMIT this->Edited();
    });
  this->Readers.push_back(
    [line, value, shown]
    {
      if (line->isModified())
        return;
      line->setText(QString::fromStdString(value()));
      *shown = line->text();
    });
  return line;
}

QLineEdit* RecipeForm::Direction(const QString& name, const char* key, const QString& label,
  const std::vector<DirectionButton>& buttons, std::function<glm::dvec3()> read,
  std::function<void(const glm::dvec3&)> write)
{
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  auto* line = new QLineEdit;
  line->setObjectName(this->NameOf(name));
  line->setAccessibleName(label);
  box->setFocusProxy(line); // the label's buddy is the box
  line->setToolTip(tr("Towards the patient's left, back and head: three numbers"));
  column->addWidget(line);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  const auto take = [this, write, line](glm::dvec3 direction)
  {
    line->setModified(false);
    const double length = glm::length(direction);
    if (length > LeastLength)
      write(direction / length);
    if (length > LeastLength)
      Q_EMIT this->Edited();
    return length > LeastLength;
  };
  for (const DirectionButton& each : buttons)
  {
    auto* button = new QPushButton(each.text);
    button->setObjectName(this->NameOf(name + '.' + each.word));
    connect(button, &QPushButton::clicked, this, [take, give = each.give] { take(give()); });
    row->addWidget(button);
  }
  connect(line, &QLineEdit::editingFinished, this,
    [this, line, take]
    {
      glm::dvec3 typed(0.0);
      if (!line->isModified())
        return;
      if (!ReadNumbers(line->text(), typed) || !take(typed))
        Q_EMIT this->Refused(tr("A direction is three numbers that are not all 0: 0 0 1."));
    });
  this->Know(key, label);
  this->Row(label, box);
  this->Readers.push_back(
    [line, read]
    {
      if (!line->isModified())
        line->setText(WriteNumbers(read(), 4));
    });
  return line;
}

} // namespace hasp
