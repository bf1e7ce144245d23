#pragma once
#include "Output/PartFacts.h"

#include <QTableWidget>

#include <vector>

namespace hasp
{

/// All parts of the plan: how each stands, its verdict, its gap to the bone. Follows the plan and
/// what is made of it while it is seen. Object name: check.table. Threads: RENDER.
class PartTable : public QTableWidget
{
  Q_OBJECT
public:
  explicit PartTable(Planner& planner, QWidget* parent = nullptr);

  const std::vector<PartFacts>& Parts() const { return this->Facts; }
  /// The one that is chosen, and stays so while it is there; nullptr: none.
  const PartFacts* Chosen() const;
  void Choose(PlanId object);

Q_SIGNALS:
  void PartsRead(); ///< Parts, Chosen: others than before, or read again

protected:
  void showEvent(QShowEvent* event) override;

private:
  void Follow();
  void Read();
  void Fill(int row, const PartFacts& facts);

  Planner& Of;
  std::vector<PartFacts> Facts;
  PlanId Now = 0;
  bool Stale = true; ///< something has changed while it was hidden
};

} // namespace hasp
