#include "Steps/PiecesBox.h"

#include "Grid/ProgressPart.h"
#include "LabelPalette.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Steps/LabelMaps.h"
#include "Steps/ObjectChooser.h"
#include "Steps/PanelWidgets.h"
#include "Steps/TouchedFragment.h"

#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace hasp
{

namespace
{
/// The first two colours are nothing's and bone's.
std::array<std::uint8_t, 3> ColourOf(std::size_t piece)
{
  const glm::dvec3 colour = 255.0 * PaletteColour(Label(piece + 2));
  return { std::uint8_t(colour.r), std::uint8_t(colour.g), std::uint8_t(colour.b) };
}

std::vector<PieceSource> PiecesOf(const Plan& plan, PlanId divided)
{
  std::vector<PieceSource> all;
  for (const PlanFragment& fragment : plan.fragments)
    if (const auto* piece = std::get_if<PieceSource>(&fragment.source);
        piece && piece->fragment == divided)
      all.push_back(*piece);
  return all;
}

bool SameDivision(const Plan& a, const Plan& b, PlanId divided)
{
  const auto cuts = [&](const Plan& plan)
  {
    std::vector<PlanCut> all;
    for (const PlanId id : CutsThrough(plan, divided))
      all.push_back(*FindPlanObject<PlanCut>(plan, id));
    return all;
  };
  return FindPlanObject<PlanFragment>(b, divided) && cuts(a) == cuts(b) &&
         PiecesOf(a, divided) == PiecesOf(b, divided);
}
} // namespace

PiecesBox::PiecesBox(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    List(new QListWidget)
{
  auto* column = new QVBoxLayout(this);
  this->FindThem = AddButton(column, "cut.pieces", tr("F&ind the pieces"));
  this->FindThem->setToolTip(tr("All that the cuts leave of the bone become fragments"));
  this->Seeds = new PointsEdit(
    planner, "cut.seeds", tr("&Touch pieces"), { tr("Touch each piece that is to be kept."), 100 });
  column->addWidget(this->Seeds);
  this->KeepThem = AddButton(column, "cut.keep", tr("&Keep the touched pieces"));
  this->List->setObjectName("cut.piece.list");
  this->List->setAccessibleName(tr("Pieces"));
  this->List->setSelectionMode(QAbstractItemView::ExtendedSelection);
  column->addWidget(this->List);
  this->ResectThem = AddButton(column, "cut.resect", tr("Rese&ct"));
  connect(this->FindThem, &QPushButton::clicked, this, &PiecesBox::Find);
  connect(this->KeepThem, &QPushButton::clicked, this, &PiecesBox::KeepTouched);
  connect(this->ResectThem, &QPushButton::clicked, this, &PiecesBox::Resect);
  connect(this->List, &QListWidget::itemSelectionChanged, this,
    [this]
    {
      this->ShowChosen();
      if (const std::vector<PlanId> chosen = this->Chosen(); chosen.size() == 1)
        this->Of.scene.Select(chosen[0]);
    });
  connect(&planner.plan, &PlanSession::Replaced, this, [this] { this->Seeds->SetPlaces({}); });
  connect(&planner.plan, &PlanSession::Changed, this, &PiecesBox::Fill);
  connect(&planner.scene, &PlanScene::SelectedChanged, this,
    [this](PlanId object)
    {
      for (int row = 0; row < this->List->count(); ++row)
        if (this->List->item(row)->data(Qt::UserRole).toUInt() == object)
          this->List->setCurrentRow(row);
    });
  this->Fill();
}

void PiecesBox::Show(PlanId cut)
{
  this->Cut = cut;
  this->Fill();
}

std::vector<PlanId> PiecesBox::Divided() const
{
  const Plan& plan = this->Of.plan.Now();
  if (const PlanCut* cut = FindPlanObject<PlanCut>(plan, this->Cut))
    return cut->fragments;
  std::vector<PlanId> all = FragmentsOfScans(plan);
  std::erase_if(all, [&](PlanId fragment) { return CutsThrough(plan, fragment).empty(); });
  return all;
}

void PiecesBox::Find()
{
  for (const PlanId divided : this->Divided())
  {
    const auto snapshot = std::make_shared<PlanSnapshot>(
      this->Of.plan.Document(), this->Of.scans, this->Of.plan.Folder());
    this->Of.jobs.Add(tr("Finding the pieces of fragment %1").arg(divided),
      [me = QPointer<PiecesBox>(this), snapshot, divided](
        const ProgressFunction& progress) -> JobQueue::Finish
      {
        const auto images = std::make_shared<SnapshotImages>(
          ImagesOfFragments(*snapshot, { divided }, PartOf(progress, 0.0, 0.2)));
        const ProposedPieces found =
          ProposePieces(snapshot->plan, images->images, divided, PartOf(progress, 0.2, 1.0));
        return [me, snapshot, images, divided, found]
        {
          if (!me)
            return;
          for (const DerivedPart& made : images->made)
            me->Of.plan.KeepMade(made);
          me->Take(divided, snapshot->plan, found);
        };
      });
  }
}

void PiecesBox::Take(PlanId divided, const Plan& before, const ProposedPieces& found)
{
  if (!SameDivision(before, this->Of.plan.Now(), divided))
    return this->Of.SayFault(
      tr("Fragment %1 has changed meanwhile: find its pieces again.").arg(divided));
  std::vector<glm::dvec3> seeds;
  for (const ProposedPiece& piece : found.pieces)
    if (!piece.crumb && piece.fragment == 0)
      seeds.push_back(piece.seed);
  if (!seeds.empty())
    this->Keep(divided, seeds);
  else
    this->Of.Say(tr("All pieces of fragment %1 are in the plan.").arg(divided));
  for (const PlanCutMeasure& cut : found.cuts)
    if (!cut.measure.parted)
      this->Of.SayFault(
        tr("Cut %1 does not part the bone: make its blade larger, or its reach.").arg(cut.cut));
}

void PiecesBox::KeepTouched()
{
  const Plan& plan = this->Of.plan.Now();
  std::map<PlanId, std::vector<glm::dvec3>> seeds;
  for (const TouchedPlace& place : this->Seeds->Places())
    if (!CutsThrough(plan, place.object).empty())
      seeds[place.object].push_back(place.inScan);
  if (seeds.empty())
    return this->Of.SayFault(
      tr("Touch pieces of a fragment that a cut goes through, then keep them."));
  this->Seeds->PutAway();
  this->Seeds->SetPlaces({});
  for (const auto& [divided, places] : seeds)
    this->Keep(divided, places);
}

void PiecesBox::Keep(PlanId divided, const std::vector<glm::dvec3>& seeds)
{
  const Plan& plan = this->Of.plan.Now();
  const PlanFragment& whole = *FindPlanObject<PlanFragment>(plan, divided);
  std::size_t number = PiecesOf(plan, divided).size();
  std::vector<PlanEdit> edits;
  for (const glm::dvec3& seed : seeds)
  {
    PlanFragment piece = whole; // it stays where the whole one is
    piece.id = this->Of.plan.NewId() + PlanId(edits.size());
    piece.name = tr("piece %1 of fragment %2").arg(piece.id).arg(divided).toStdString();
    piece.source = PieceSource{ divided, seed };
    piece.colour = ColourOf(number++);
    piece.state = FragmentState::Kept;
    piece.locked = false;
    edits.push_back(AddObject<PlanFragment>{ piece });
  }
  this->Of.plan.Do(std::move(edits), tr("Keep pieces of fragment %1").arg(divided));
}

std::vector<PlanId> PiecesBox::Chosen() const
{
  std::vector<PlanId> chosen;
  for (int row = 0; row < this->List->count(); ++row)
    if (this->List->item(row)->isSelected())
      chosen.push_back(this->List->item(row)->data(Qt::UserRole).toUInt());
  return chosen;
}

void PiecesBox::Resect()
{
  const std::vector<PlanId> chosen = this->Chosen();
  if (chosen.empty())
    return;
  const Plan& plan = this->Of.plan.Now();
  const bool all = std::all_of(chosen.begin(), chosen.end(),
    [&](PlanId id)
    { return FindPlanObject<PlanFragment>(plan, id)->state == FragmentState::Resected; });
  this->Of.plan.Do(SetFragmentState{ chosen, all ? FragmentState::Kept : FragmentState::Resected });
}

void PiecesBox::ShowChosen()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<PlanId> chosen = this->Chosen();
  const bool all = !chosen.empty() && std::all_of(chosen.begin(), chosen.end(),
                                        [&](PlanId id)
                                        {
                                          const auto* piece =
                                            FindPlanObject<PlanFragment>(plan, id);
                                          return piece && piece->state == FragmentState::Resected;
                                        });
  this->ResectThem->setEnabled(!chosen.empty());
  this->ResectThem->setText(all ? tr("Keep it &after all") : tr("Rese&ct"));
}

void PiecesBox::Fill()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<PlanId> divided = this->Divided(), chosen = this->Chosen();
  const QSignalBlocker quiet(this->List);
  this->List->clear();
  for (const PlanFragment& fragment : plan.fragments)
  {
    const auto* piece = std::get_if<PieceSource>(&fragment.source);
    if (!piece || std::find(divided.begin(), divided.end(), piece->fragment) == divided.end())
      continue;
    QString text = CalledWithName(plan, fragment.id);
    if (fragment.state == FragmentState::Resected)
      text += tr(" (resected)");
    auto* item = new QListWidgetItem(text, this->List);
    item->setData(Qt::UserRole, fragment.id);
    item->setSelected(std::find(chosen.begin(), chosen.end(), fragment.id) != chosen.end());
  }
  this->FindThem->setEnabled(!divided.empty());
  this->ShowChosen();
}

} // namespace hasp
