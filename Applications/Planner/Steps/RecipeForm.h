#pragma once
#include <QString>
#include <QWidget>

#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;

namespace hasp
{

/// A number as a form has it.
struct FormNumber
{
  double low = 0.0, high = 100.0; ///< the recipe's range
  QString unit;                   ///< " mm"
  int decimals = 2;
  double step = 0.1;
};
FormNumber Millimetres(double low, double high, double step = 0.1);
FormNumber Degrees(double low, double high);

/// Rows of numbers, choices and directions that are read from an object and written into it when an
/// edit is finished: Enter, another widget, or half a second after the last step of an arrow.
/// Edited says so once. What is being typed stays when the form is filled anew.
///
/// Widgets are named PREFIX.NAME.
/// Threads: RENDER.
class RecipeForm : public QWidget
{
  Q_OBJECT
public:
  explicit RecipeForm(const QString& prefix, QWidget* parent = nullptr);

  /// What a row reads and writes; asked each time.
  template <typename T>
  using Value = std::function<T&()>;

  ///@{
  /// `key`: what messages of recipes call it, for InWords.
  QDoubleSpinBox* Number(const QString& name, const char* key, const QString& label,
    const FormNumber& number, Value<double> value);
  QComboBox* Choice(const QString& name, const QString& label, const QStringList& texts,
    std::function<int()> read, std::function<void(int)> write);
  QCheckBox* Check(const QString& name, const QString& label, std::function<bool()> read,
    std::function<void(bool)> write);
  QLineEdit* Text(const QString& name, const QString& label, Value<std::string> value);
  /// Three numbers, "0 0 1"; made unit. `buttons` set it: NAME.WORD, a text, and what gives it (0:
  /// nothing).
  struct DirectionButton
  {
    QString word, text;
    std::function<glm::dvec3()> give;
  };
  QLineEdit* Direction(const QString& name, const char* key, const QString& label,
    const std::vector<DirectionButton>& buttons, std::function<glm::dvec3()> read,
    std::function<void(const glm::dvec3&)> write);
  ///@}
  void Row(const QString& label, QWidget* widget);
  void Row(QWidget* widget);

  /// All rows as the object has it, but for what is being typed.
  void Refresh();
  /// A recipe's message with its keys as the form calls them.
  QString InWords(QString text) const;

Q_SIGNALS:
  void Edited();                     ///< a row has been written
  void Refused(const QString& text); ///< what was typed is no value at all

private:
  QString NameOf(const QString& name) const { return this->Prefix + '.' + name; }
  void Know(const char* key, const QString& label);

  QString Prefix;
  QFormLayout* Rows;
  std::vector<std::function<void()>> Readers;
  std::vector<std::pair<QString, QString>> Words; ///< keys of recipes and labels
};

} // namespace hasp
