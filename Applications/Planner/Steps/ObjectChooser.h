#pragma once
#include "Planning/Plan.h"

#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;
class QPushButton;

namespace hasp
{

struct Planner;

/// "guide 8", or "guide 8: for the chin". A name that says no more is not said.
QString CalledWithName(const Plan& plan, PlanId object);

/// Which object of one kind a panel is about; the same that is selected in the scene, where that is
/// one of them.
///
/// Widgets: PREFIX.choose, PREFIX.new, PREFIX.remove. Threads: RENDER.
class ObjectChooser : public QWidget
{
  Q_OBJECT
public:
  using List = std::function<std::vector<PlanId>(const Plan&)>;
  /// `fresh`: "&New guide".
  ObjectChooser(Planner& planner, const QString& prefix, const QString& fresh, List list,
    QWidget* parent = nullptr);

  PlanId Chosen() const { return this->Now; } ///< 0: none, or a new one that is not in the plan
  void Choose(PlanId object);                 ///< 0: none

Q_SIGNALS:
  void ChosenChanged(hasp::PlanId object);
  void NewAsked();

private:
  void Follow();
  void Remove();

  Planner& Of;
  List Objects;
  PlanId Now = 0;
  QComboBox* Box;
  QPushButton* Gone;
};

/// All of a kind, for a chooser.
template <typename T>
std::vector<PlanId> IdsOf(const std::vector<T>& objects)
{
  std::vector<PlanId> ids;
  for (const T& object : objects)
    ids.push_back(object.id);
  return ids;
}

} // namespace hasp
