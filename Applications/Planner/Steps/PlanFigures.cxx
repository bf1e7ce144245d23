#include "Steps/PlanFigures.h"

#include "EvaluateSteps.h"
#include "Output/PartWork.h"
#include "Planning/PlanLists.h"
#include "Session.h"
#include "Steps/PanelWidgets.h"
#include "Tools/Planner.h"
#include "VerbWork.h"

#include <QHeaderView>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace hasp
{
namespace
{

constexpr double ReachMm = 5.0; // as hasp evaluate's

QTableWidget* MakeTable(const char* name, const QString& called, const QStringList& columns)
{
  auto* table = new QTableWidget(0, columns.size());
  table->setObjectName(name);
  table->setAccessibleName(called);
  table->setHorizontalHeaderLabels(columns);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

void AddRow(QTableWidget* table, const QStringList& cells)
{
  const int row = table->rowCount();
  table->insertRow(row);
  for (int column = 0; column < cells.size(); ++column)
    table->setItem(row, column, new QTableWidgetItem(cells[column]));
}

QString Mm(double mm)
{
  return QString::number(mm, 'f', 2);
}

/// Median and 95 %, of sizes.
QString SizesOf(const FractureFigures& figures)
{
  return figures.samples == 0
           ? PlanFigures::tr("none can be measured")
           : QStringLiteral("%1 / %2").arg(Mm(figures.p50AbsMm), Mm(figures.p95AbsMm));
}

FracturesResult Measure(const std::shared_ptr<const PlanDocument>& document,
  const std::filesystem::path& folder, const ProgressFunction& progress)
{
  std::vector<std::string> warnings;
  Session session;
  AttachSession(session, progress, warnings);
  return Try(ExitCode::BadInput, "",
    [&]
    {
      const EvaluatedSide side = PlanSide(folder.string(), *document);
      EvaluatedSurfaces surfaces({}, {}, session);
      return MeasureFractures(
        side, [&](const std::string& key) { return surfaces.AtHand(key, { &side }); }, ReachMm,
        session);
    });
}

} // namespace

PlanFigures::PlanFigures(Planner& planner, QWidget* parent)
  : QGroupBox(tr("Measures and fractures"), parent),
    Of(planner),
    Measures(MakeTable(
      "check.planmeasures", tr("Measures of the plan"), { tr("Measure"), tr("As planned") })),
    Fractures(MakeTable("check.fractures", tr("Fractures of the plan"),
      { tr("Fracture"), tr("Step-off: median / 95 %, mm"), tr("Gap: median / 95 %, mm") }))
{
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Measures);
  this->Evaluating = AddButton(layout, "check.evaluate", tr("Mea&sure along the fractures"));
  this->Evaluating->setToolTip(
    tr("Step-off and gap of fragments that face each other, as planned; their parts must be made"));
  layout->addWidget(this->Fractures);
  connect(this->Evaluating, &QPushButton::clicked, this, &PlanFigures::Evaluate);
  connect(&planner.plan, &PlanSession::Changed, this, &PlanFigures::Refresh);
  this->Refresh();
}

void PlanFigures::Refresh()
{
  const Plan& plan = this->Of.plan.Now();
  this->Measures->setRowCount(0);
  for (const PlanMeasure& measure : plan.measures)
  {
    const QString name = measure.name.empty()
                           ? QString::fromStdString(CalledObject(plan, measure.id))
                           : QString::fromStdString(measure.name);
    const double value = MeasureValue(plan, measure);
    AddRow(this->Measures,
      { name, measure.kind == MeasureKind::Distance ? tr("%1 mm").arg(Mm(value))
                                                    : tr("%1°").arg(value, 0, 'f', 1) });
  }
  this->Measures->setVisible(!plan.measures.empty());
  this->Fractures->setRowCount(0); // they were of the plan before
  this->Fractures->setVisible(false);
  this->Evaluating->setEnabled(plan.fragments.size() > 1);
}

void PlanFigures::Evaluate()
{
  const auto document = std::make_shared<const PlanDocument>(this->Of.plan.Document());
  this->Of.jobs.Add(tr("Measuring along the fractures"),
    [document, folder = this->Of.plan.Folder(), figures = QPointer<PlanFigures>(this)](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      const FracturesResult result = Measure(document, folder, progress);
      return [=]
      {
        if (!figures || !(figures->Of.plan.Now() == document->history.Current()))
          return;
        figures->Fractures->setRowCount(0);
        for (const FractureResult& found : result.fractures)
          AddRow(
            figures->Fractures, { tr("fragments %1 and %2").arg(found.firstId).arg(found.secondId),
                                  SizesOf(found.measured.step), SizesOf(found.measured.gap) });
        for (const std::string& why : result.unmeasured)
          AddRow(figures->Fractures, { QString::fromStdString(why), {}, {} });
        if (figures->Fractures->rowCount() == 0)
          AddRow(figures->Fractures, { tr("no two fragments face each other"), {}, {} });
        figures->Fractures->setVisible(true);
      };
    });
}

} // namespace hasp
