#include "Steps/PartTable.h"

#include "Output/RedParts.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>

namespace hasp
{
namespace
{

enum Column
{
  Called,
  Verdict,
  Gap,
  Volume,
  Columns
};

const QColor Green(29, 107, 52), Red(164, 0, 0);

QString VerdictOf(const PartFacts& facts)
{
  if (!facts.verdict)
    return PartTable::tr("in date");
  if (*facts.verdict == FitVerdict::Red)
    return PartTable::tr("red");
  if (*facts.verdict == FitVerdict::NotCertified)
    return PartTable::tr("not certified");
  return facts.heldTo == 0 ? PartTable::tr("green")
                           : PartTable::tr("green, held to fragment %1 alone").arg(facts.heldTo);
}

/// The verdict of one that is in date; of all others why there is none.
QString TextOf(const PartFacts& facts)
{
  switch (facts.state)
  {
    case PartState::InDate:
      return VerdictOf(facts);
    case PartState::OutOfDate:
      return PartTable::tr("out of date");
    case PartState::DoesNotHold:
      return PartTable::tr("red, not kept");
    case PartState::NotMade:
      break;
  }
  return PartTable::tr("not made");
}

/// Median, 95 % and least, mm.
QString GapOf(const PartFacts& facts)
{
  if (!facts.certificate || !facts.certificate->gap)
    return {};
  const GuideGap& gap = *facts.certificate->gap;
  return QStringLiteral("%1 / %2 / %3")
    .arg(gap.p50, 0, 'f', 2)
    .arg(gap.p95, 0, 'f', 2)
    .arg(gap.least, 0, 'f', 2);
}

} // namespace

PartTable::PartTable(Planner& planner, QWidget* parent)
  : QTableWidget(0, Columns, parent),
    Of(planner)
{
  this->setObjectName("check.table");
  this->setAccessibleName(tr("Parts of the plan"));
  this->setHorizontalHeaderLabels({ tr("Part"), tr("Verdict"), tr("Gap, mm"), tr("mm³") });
  this->horizontalHeaderItem(Gap)->setToolTip(tr("To the bone: median / 95 % / least"));
  this->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->setSelectionMode(QAbstractItemView::SingleSelection);
  this->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->setTabKeyNavigation(false); // Tab goes on to the buttons
  this->verticalHeader()->hide();
  // A panel is narrow: long cells go on in the next line.
  this->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const Column whole : { Called, Volume })
    this->horizontalHeader()->setSectionResizeMode(whole, QHeaderView::ResizeToContents);
  connect(this, &QTableWidget::itemSelectionChanged, this,
    [this]
    {
      const int row = this->currentRow();
      if (row >= 0 && row < int(this->Facts.size()))
        this->Now = this->Facts[std::size_t(row)].object;
      Q_EMIT this->PartsRead();
    });
  connect(&planner.plan, &PlanSession::Changed, this, &PartTable::Follow);
  connect(&planner.plan, &PlanSession::PartsChanged, this, &PartTable::Follow);
  connect(&RedParts::Of(planner), &RedParts::Changed, this, &PartTable::Follow);
}

void PartTable::showEvent(QShowEvent* event)
{
  QTableWidget::showEvent(event);
  if (this->Stale)
    this->Read();
}

void PartTable::Follow()
{
  this->Stale = true;
  if (this->isVisible())
    this->Read();
}

void PartTable::Read()
{
  this->Stale = false;
  this->Facts.clear();
  for (const PlanId object : PartObjects(this->Of.plan.Now()))
    this->Facts.push_back(FactsOf(this->Of, object));
  {
    const QSignalBlocker quiet(this);
    this->setRowCount(int(this->Facts.size()));
    for (std::size_t n = 0; n < this->Facts.size(); ++n)
      this->Fill(int(n), this->Facts[n]);
    if (!this->Chosen() && !this->Facts.empty())
      this->Now = this->Facts.front().object;
    for (std::size_t n = 0; n < this->Facts.size(); ++n)
      if (this->Facts[n].object == this->Now)
        this->setCurrentCell(int(n), Called);
  }
  Q_EMIT this->PartsRead();
}

void PartTable::Fill(int row, const PartFacts& facts)
{
  const QString cells[Columns] = { facts.called, TextOf(facts), GapOf(facts),
    facts.verdict ? QString::number(facts.volumeMm3, 'f', 1) : QString() };
  for (int column = 0; column < Columns; ++column)
  {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setToolTip(facts.why.isEmpty() ? facts.faults.join('\n') : facts.why);
    if (column == Verdict && facts.verdict == FitVerdict::Red)
      item->setForeground(Red);
    if (column == Verdict && facts.verdict == FitVerdict::Green)
      item->setForeground(Green);
    this->setItem(row, column, item);
  }
}

const PartFacts* PartTable::Chosen() const
{
  const auto found = std::find_if(this->Facts.begin(), this->Facts.end(),
    [this](const PartFacts& facts) { return facts.object == this->Now; });
  return found == this->Facts.end() ? nullptr : &*found;
}

void PartTable::Choose(PlanId object)
{
  for (std::size_t n = 0; n < this->Facts.size(); ++n)
    if (this->Facts[n].object == object)
      this->setCurrentCell(int(n), Called);
}

} // namespace hasp
