#pragma once
#include <QLabel>

#include <vector>

namespace hasp
{

class RecipeForm;

/// What is not right with what was typed, in words; hidden while all is. Keys of recipes become
/// what its forms call them, and what a form refuses by itself is said, too. Widget: PREFIX.fault.
/// Threads: RENDER.
class FaultLine : public QLabel
{
  Q_OBJECT
public:
  explicit FaultLine(const QString& prefix, QWidget* parent = nullptr);

  void Know(RecipeForm* form);
  void Say(const QString& text); ///< empty: all is right
  QString InWords(QString text) const;

private:
  std::vector<RecipeForm*> Forms;
};

} // namespace hasp
