// Pins and the label of a guide's form.
#include "Steps/GuideBox.h"
#include "Steps/MatchPoints.h"
#include "Steps/PointsEdit.h"

#include <algorithm>

namespace hasp
{

QWidget* GuideBox::PinsPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(this->Pins);
  this->AddPinRows();
  column->addWidget(this->PinForm);
  column->addWidget(this->LabelPlace);
  this->AddLabelRows();
  column->addWidget(this->LabelForm);
  column->addStretch(1);
  return page;
}

void GuideBox::AddPinRows()
{
  this->PinForm = this->Add(new RecipeForm("guide.pin"));
  this->PinForm->setToolTip(tr("Of the chosen pin; of all of them where none is chosen"));
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double GuideHole::*member)
  {
    this->PinForm->Number(
      name, key, label, range, [this, member]() -> double& { return this->Pin().*member; });
  };
  number("diameter", "diameterMm", tr("Pin, as printed"), Millimetres(0.1, 20.0),
    &GuideHole::diameterMm);
  number(
    "depth", "depthMm", tr("Drilled into bone"), Millimetres(0.1, 500.0, 1.0), &GuideHole::depthMm);
  number("height", "sleeveHeightMm", tr("Sleeve above bone"), Millimetres(0.0, 100.0, 0.5),
    &GuideHole::sleeveHeightMm);
}

void GuideBox::AddLabelRows()
{
  this->LabelForm = this->Add(new RecipeForm("guide"));
  this->LabelForm->Choice(
    "side", tr("Side"), { tr("none"), tr("left"), tr("right") },
    [this] { return int(this->Draft.Typed().side); },
    [this](int row) { this->Draft.Typed().side = BodySide(row); });
  this->LabelForm->Number("label.height", "heightMm", tr("Letters"), Millimetres(3.6, 50.0, 0.5),
    [this]() -> double& { return this->Label().heightMm; });
  this->LabelForm->Number("label.depth", "depthMm", tr("Letters' depth"), Millimetres(0.1, 5.0),
    [this]() -> double& { return this->Label().depthMm; });
  this->LabelForm->Check(
    "label.engraved", tr("Cut in"), [this] { return this->Label().engraved; },
    [this](bool on) { this->Label().engraved = on; });
  this->LabelForm->Direction(
    "label.right", "right", tr("Written towards"),
    { { "view", tr("My right"), [this] { return this->InScan(ViewRight(this->Of)); } } },
    [this] { return this->Label().right; },
    [this](const glm::dvec3& direction) { this->Label().right = direction; });
}

void GuideBox::TakePins()
{
  GuideHole fresh = this->NextPin;
  fresh.axis = this->Recipe().withdrawal;
  this->Recipe().holes = MatchPoints(this->Recipe().holes, this->Pins->Points(), fresh);
  this->Put();
}

GuideHole& GuideBox::Pin()
{
  std::vector<GuideHole>& holes = this->Recipe().holes;
  const int chosen = this->Pins->Tool().Selected();
  return chosen >= 0 && chosen < int(holes.size()) ? holes[std::size_t(chosen)] : this->NextPin;
}

/// Of the chosen pin, or of all, and of those to come.
void GuideBox::TakePinNumbers()
{
  if (&this->Pin() == &this->NextPin)
    for (GuideHole& hole : this->Recipe().holes)
    {
      hole.diameterMm = this->NextPin.diameterMm;
      hole.depthMm = this->NextPin.depthMm;
      hole.sleeveHeightMm = this->NextPin.sleeveHeightMm;
    }
  this->Put();
}

GuideLabel* GuideBox::CaseLabel()
{
  std::vector<GuideLabel>& labels = this->Recipe().labels;
  const auto found = std::find_if(labels.begin(), labels.end(),
    [](const GuideLabel& label) { return label.kind == GuideLabelKind::Case; });
  return found == labels.end() ? nullptr : &*found;
}

GuideLabel& GuideBox::Label()
{
  GuideLabel* label = this->CaseLabel();
  return label ? *label : this->NextLabel;
}

void GuideBox::TakeLabel()
{
  GuideLabel* label = this->CaseLabel();
  const std::vector<glm::dvec3> points = this->LabelPlace->Points();
  if (points.empty())
    std::erase_if(this->Recipe().labels,
      [](const GuideLabel& each) { return each.kind == GuideLabelKind::Case; });
  else if (label)
    label->point = points[0];
  else
  {
    GuideLabel fresh = this->NextLabel;
    fresh.point = points[0];
    fresh.right = this->InScan(ViewRight(this->Of));
    this->Recipe().labels.push_back(fresh);
  }
  this->Put();
}

} // namespace hasp
