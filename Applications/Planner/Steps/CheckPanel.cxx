#include "Steps/CheckPanel.h"

#include "Output/PartMaking.h"
#include "Planning/DerivedPart.h"
#include "Steps/CertificateBox.h"
#include "Steps/FitBox.h"
#include "Steps/PanelWidgets.h"
#include "Steps/PartTable.h"
#include "Steps/PlanFigures.h"
#include "Tools/ToolMarks.h"

#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace hasp
{
namespace
{

const QColor FaultColour(230, 40, 40);
constexpr double OnSliceMm = 1.0; // marks farther off a slice are hollow

} // namespace

CheckPanel::CheckPanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Table(new PartTable(planner)),
    Certificate(new CertificateBox(planner)),
    Trying(new FitBox(planner)),
    Why(new QLabel)
{
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Table);
  this->Why->setObjectName("check.why");
  this->Why->setWordWrap(true);
  layout->addWidget(this->Why);
  auto* row = new QHBoxLayout;
  this->Make = AddButton(row, "check.make", tr("Ma&ke"));
  this->All = AddButton(row, "check.makeall", tr("Make &all"));
  this->All->setToolTip(tr("All parts that are not in date"));
  layout->addLayout(row);
  layout->addWidget(this->Certificate);
  layout->addWidget(this->Trying);
  layout->addWidget(new PlanFigures(planner));
  connect(this->Table, &PartTable::PartsRead, this, &CheckPanel::Refresh);
  connect(this->Certificate, &CertificateBox::FaultChosen, this, &CheckPanel::Mark);
  connect(this->Make, &QPushButton::clicked, this,
    [this]
    {
      if (const PartFacts* chosen = this->Table->Chosen())
        MakePart(this->Of, chosen->object);
    });
  connect(this->All, &QPushButton::clicked, this, [this] { MakeAll(this->Of); });
  this->Refresh();
}

/// The tool is put away while all that follows it is there.
CheckPanel::~CheckPanel()
{
  CheckPanel::Leave();
}

QString CheckPanel::StillNeeds() const
{
  return PartObjects(this->Of.plan.Now()).empty()
           ? tr("Plan something that parts are made of first: a fragment, a guide, a plate.")
           : QString();
}

void CheckPanel::Enter()
{
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& view)
    {
      const PartFacts* facts = this->Table->Chosen();
      if (!facts || !facts->certificate)
        return;
      const std::vector<FitFault>& faults = facts->certificate->faults;
      for (std::size_t n = 0; n < faults.size(); ++n)
        if (const auto pixel = faults[n].at ? view.PixelOf(*faults[n].at) : std::nullopt)
          PaintBall(painter, *pixel, FaultColour, QString::number(n + 1), int(n) == this->Fault,
            view.Off(*faults[n].at) > OnSliceMm);
    });
}

void CheckPanel::Leave()
{
  this->Marks.reset();
  if (this->Of.tools.InHand() == &this->Trying->Tool())
    this->Of.tools.Take(nullptr);
}

void CheckPanel::Refresh()
{
  const PartFacts* chosen = this->Table->Chosen();
  this->Make->setEnabled(chosen != nullptr);
  this->All->setEnabled(!this->Table->Parts().empty());
  this->Why->setText(!chosen                 ? QString()
                     : chosen->why.isEmpty() ? WhyNotCertified(this->Of.plan.Now(), *chosen)
                                             : chosen->why + '.');
  this->Why->setVisible(!this->Why->text().isEmpty());
  this->Certificate->Show(chosen);
  this->Trying->Show(chosen);
  if (this->Marks)
    this->Marks->Update();
}

void CheckPanel::Mark(int fault)
{
  this->Fault = fault;
  if (this->Marks)
    this->Marks->Update();
}

} // namespace hasp
