#include "Steps/RecipeForm.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTimer>

#include <memory>

namespace hasp
{

namespace
{
constexpr int RestMs = 500;    // after the last step of an arrow
constexpr int LeastWidth = 90; // whatever its range: panels are narrow

QLineEdit* LineOf(QDoubleSpinBox* box)
{
  return box->findChild<QLineEdit*>();
}
} // namespace

FormNumber Millimetres(double low, double high, double step)
{
  return { low, high, QStringLiteral(" mm"), 2, step };
}

FormNumber Degrees(double low, double high)
{
  return { low, high, QStringLiteral("°"), 1, 1.0 };
}

RecipeForm::RecipeForm(const QString& prefix, QWidget* parent)
  : QWidget(parent),
    Prefix(prefix),
    Rows(new QFormLayout(this))
{
  this->Rows->setContentsMargins(0, 0, 0, 0);
  this->Rows->setRowWrapPolicy(QFormLayout::WrapLongRows);
  this->Rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void RecipeForm::Know(const char* key, const QString& label)
{
  QString plain = label;
  this->Words.emplace_back(QString::fromLatin1(key), plain.remove('&'));
}

QDoubleSpinBox* RecipeForm::Number(const QString& name, const char* key, const QString& label,
  const FormNumber& number, Value<double> value)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(this->NameOf(name));
  box->setDecimals(number.decimals);
  box->setRange(number.low, number.high);
  box->setSingleStep(number.step);
  box->setSuffix(number.unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(LeastWidth);
  box->setToolTip(tr("%1 to %2%3").arg(number.low).arg(number.high).arg(number.unit));
  this->Know(key, label);
  this->Row(label, box);

  const auto shown = std::make_shared<double>(box->value()); // as it was read, in its decimals
  auto* rest = new QTimer(box);
  rest->setSingleShot(true);
  const auto write = [this, box, value, shown, rest]
  {
    rest->stop();
    if (box->value() == *shown)
      return;
    *shown = box->value();
    value() = box->value();
    Q_EMIT this->Edited();
  };
  connect(rest, &QTimer::timeout, this, write);
  connect(box, &QDoubleSpinBox::editingFinished, this, write);
  connect(
    box, qOverload<double>(&QDoubleSpinBox::valueChanged), rest, [rest] { rest->start(RestMs); });
  this->Readers.push_back(
    [box, value, shown, rest]
    {
      if (rest->isActive() || (box->hasFocus() && LineOf(box)->isModified()))
        return; // it is being typed
      const QSignalBlocker quiet(box);
      box->setValue(value());
      *shown = box->value();
    });
  return box;
}

void RecipeForm::Row(const QString& label, QWidget* widget)
{
  auto* text = new QLabel(label);
  text->setBuddy(widget);
  this->Rows->addRow(text, widget);
}

void RecipeForm::Row(QWidget* widget)
{
  this->Rows->addRow(widget);
}

void RecipeForm::Refresh()
{
  for (const auto& read : this->Readers)
    read();
}

QString RecipeForm::InWords(QString text) const
{
  for (const auto& [key, label] : this->Words)
    text.replace(QRegularExpression("\\b" + QRegularExpression::escape(key) + "\\b"),
      QString::fromUtf8("“%1”").arg(label));
  return text;
}

} // namespace hasp
