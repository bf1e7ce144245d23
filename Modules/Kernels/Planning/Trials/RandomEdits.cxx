#include "RandomEdits.h"

#include "Planning/PlanLists.h"

#include <glm/geometric.hpp>

#include <algorithm>

using namespace hasp;

double RandomEdits::Number(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(this->Random);
}

int RandomEdits::Below(std::size_t count)
{
  return std::uniform_int_distribution<int>(0, int(count) - 1)(this->Random);
}

std::string RandomEdits::Hash()
{
  std::string hash;
  for (int n = 0; n < 64; ++n)
    hash += "0123456789abcdef"[this->Below(16)];
  return hash;
}

std::string RandomEdits::Text()
{
  static const char* const parts[] = { "left ", "ramus", "\"", "\\", "/", "\xc3\xa4",
    "\xe9\xaa\xa8", "\xf0\x9f\xa6\xb4", " ", "{}", "\xc2\xa0" };
  std::string text;
  for (int n = this->Below(8); n > 0; --n)
    text += parts[this->Below(std::size(parts))];
  return text;
}

glm::dvec3 RandomEdits::Point()
{
  return { this->Number(-4000, 4000), this->Number(-1, 1), this->Number(-1e-9, 1e-9) };
}

glm::dvec3 RandomEdits::Direction()
{
  const double z = this->Number(-1, 1), angle = this->Number(0, 6.28), r = std::sqrt(1 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

PlanPose RandomEdits::Pose()
{
  return { this->Point(), glm::angleAxis(this->Number(-3, 3), this->Direction()) };
}

template <typename T>
PlanId RandomEdits::AnyOf(const std::vector<T>& objects)
{
  return objects[std::size_t(this->Below(objects.size()))].id;
}

template <typename T>
std::vector<PlanId> RandomEdits::SomeOf(const std::vector<T>& objects)
{
  std::vector<PlanId> ids;
  for (const T& object : objects)
    if (this->Below(2) == 1)
      ids.push_back(object.id);
  std::shuffle(ids.begin(), ids.end(), this->Random);
  return ids;
}

PlanVolume RandomEdits::MakeVolume()
{
  return { 0, this->Text(), this->Hash() };
}

PlanSegmentation RandomEdits::MakeSegmentation(const Plan& plan)
{
  PlanSegmentation made{ 0, this->Text(), this->AnyOf(plan.volumes), "", {} };
  if (this->Below(2) == 0)
    made.labels = this->Hash();
  if (this->Below(2) == 0)
    made.recipe = RandomSegmentation(this->Random).Recipe(3, this->Text());
  return made;
}

PlanEdit RandomEdits::OfSegmentation(const PlanSegmentation& segmentation)
{
  RandomSegmentation random(this->Random);
  const std::vector<SegmentationStep>& steps = segmentation.recipe.steps;
  if (!steps.empty() && std::holds_alternative<SplitStep>(steps.back()) && this->Below(4) != 0)
    return AddSegmentationStroke{ segmentation.id, random.Stroke(1) };
  const bool filters = steps.empty() || IsImageFilter(steps.back());
  return AddSegmentationStep{ segmentation.id,
    filters && this->Below(2) == 0 ? random.Filter() : random.Step() };
}

/// Those that can be cut, guided and plated.
static std::vector<PlanFragment> ScanFragments(const Plan& plan)
{
  std::vector<PlanFragment> found;
  std::copy_if(plan.fragments.begin(), plan.fragments.end(), std::back_inserter(found),
    [&](const PlanFragment& fragment) { return IsOfScan(plan, fragment.id); });
  return found;
}

FragmentSource RandomEdits::ScanSource(const Plan& plan, PlanId id)
{
  const int kind = this->Below(3);
  const std::vector<PlanFragment> whole = ScanFragments(plan);
  if (kind == 0 && !plan.segmentations.empty())
    return LabelSource{ this->AnyOf(plan.segmentations), std::uint32_t(1 + this->Below(65535)),
      this->Number(-1000, 3000), this->Number(0.1, 2) };
  if (kind == 1 && !whole.empty() && whole[0].id < id)
    return PieceSource{ whole[0].id, this->Point() };
  return ComponentSource{ this->AnyOf(plan.volumes), this->Number(-1000, 3000), this->Point(),
    this->Number(0.1, 2) };
}

PlanFragment RandomEdits::MakeFragment(const Plan& plan, PlanId id)
{
  PlanFragment fragment;
  fragment.name = this->Text();
  const bool there = FindPlanObject<PlanFragment>(plan, id) != nullptr;
  const bool surface =
    !plan.surfaces.empty() && (there ? !IsOfScan(plan, id) : this->Below(4) == 0);
  if (surface)
    fragment.source = SurfaceSource{ this->AnyOf(plan.surfaces), this->Number(0, 50),
      SheetSide(this->Below(2)), this->Number(0.1, 2) };
  else
    fragment.source = this->ScanSource(plan, id);
  for (std::uint8_t& part : fragment.colour)
    part = std::uint8_t(this->Below(256));
  fragment.state = this->Below(2) == 0 ? FragmentState::Kept : FragmentState::Resected;
  fragment.scanToPlanned = this->Pose();
  fragment.locked = this->Below(4) == 0;
  return fragment;
}

PlanCut RandomEdits::MakeCut(const Plan& plan)
{
  const glm::dvec3 normal = this->Direction();
  const glm::dvec3 along = glm::normalize(
    glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return { 0, this->Text(),
    { this->Point(), normal, along, this->Number(0.01, 500), this->Number(0.01, 500),
      this->Number(0.01, 5) },
    this->SomeOf(ScanFragments(plan)), this->Number(0, 500) };
}

PlanGuide RandomEdits::MakeGuide(const Plan& plan)
{
  PlanGuide guide;
  guide.name = this->Text();
  const std::vector<PlanFragment> bones = ScanFragments(plan);
  guide.bone =
    bones.empty() || this->Below(2) == 0 ? this->AnyOf(plan.volumes) : this->AnyOf(bones);
  guide.recipe.note = this->Text();
  for (int n = 2 + this->Below(5); n > 0; --n)
    guide.recipe.landmarks.push_back(this->Point());
  guide.recipe.withdrawal = this->Direction();
  if (this->Below(2) == 0)
    guide.recipe.labels.emplace_back().kind = GuideLabelKind::Case;
  guide.side = BodySide(this->Below(3));
  guide.cuts = this->SomeOf(plan.cuts);
  return guide;
}

PlanPlate RandomEdits::MakePlate(const Plan& plan)
{
  PlanPlate plate;
  plate.name = this->Text();
  plate.fragments = this->SomeOf(ScanFragments(plan));
  if (plate.fragments.empty())
    plate.volume = this->AnyOf(plan.volumes);
  plate.recipe.note = this->Text();
  for (int n = 2 + this->Below(5); n > 0; --n)
    plate.recipe.landmarks.push_back(this->Point());
  plate.recipe.gapMm = this->Number(0, 5);
  for (int n = this->Below(4); n > 0; --n)
  {
    PlateScrew screw{ this->Point() };
    if (this->Below(2) == 0)
      screw.axis = this->Direction();
    plate.recipe.screws.push_back(screw);
  }
  return plate;
}

PlanImplant RandomEdits::MakeImplant(const Plan& plan)
{
  PlanImplant implant{ 0, this->Text(), this->AnyOf(plan.volumes), {} };
  for (int n = 3 + this->Below(5); n > 0; --n)
    implant.recipe.outline.push_back(this->Point());
  if (this->Below(2) == 0)
    implant.recipe.mirror = MirrorPlane{ this->Point(), this->Direction() };
  if (this->Below(2) == 0)
    implant.recipe.axis = this->Direction();
  implant.recipe.holeDiameterMm = this->Below(2) == 0 ? 0.0 : this->Number(1, 5);
  return implant;
}

PlanTransplant RandomEdits::MakeTransplant(const Plan& plan)
{
  PlanTransplant made;
  made.name = this->Text();
  const std::vector<PlanFragment> bones = ScanFragments(plan);
  made.donor = this->AnyOf(bones);
  for (JawFace* face : { &made.first, &made.last })
  {
    if (!plan.cuts.empty() && this->Below(2) == 0)
      face->cut = this->AnyOf(plan.cuts);
    if (this->Below(2) == 0)
      face->fragment = this->AnyOf(bones);
  }
  made.mostGapMm = this->Number(0, 10);
  made.mostOverlapMm = this->Number(0, 10);
  Transplant& t = made.transplant;
  std::vector<glm::dvec3> line{ this->Point() }; // along x, some 30 mm a segment, bent a little
  for (int n = 1 + this->Below(3); n > 0; --n)
  {
    line.push_back(line.back() + glm::dvec3(30, this->Number(-5, 5), this->Number(-5, 5)));
    t.outward.push_back(glm::normalize(glm::dvec3(0.0, this->Number(0.1, 1), 1.0)));
  }
  if (line.back().x > 3990)
    for (glm::dvec3& p : line)
      p.x -= 200;
  t.joints = MitreJoints(line);
  t.donor.axis = { { 0, 0, 0 }, { 0, this->Number(-9, 9), 150 }, { 0, 0, 350 } };
  t.donor.radiusMm = this->Number(1, 50);
  t.fromLastTip = this->Below(2) == 0;
  t.startOffsetMm = this->Number(0, 500);
  t.kerfMm = this->Number(0.1, 5);
  t.betweenMm = this->Number(0, 100);
  if (this->Below(2) == 0)
    t.vessel = { this->Point(), this->Point() };
  if (this->Below(2) == 0)
    t.paddle = SkinPaddle{ { this->Point(), this->Point(), this->Point() }, this->Point() };
  return made;
}

PlanMitreGuide RandomEdits::MakeMitreGuide(const Plan& plan)
{
  MitreGuideChoices choices;
  choices.gapMm = this->Number(0, 10);
  choices.thicknessMm = this->Number(0.1, 50);
  choices.beyondMm = this->Number(5, 100);
  choices.pinDiameterMm = this->Below(2) == 0 ? 0.0 : this->Number(1, 20);
  return { 0, this->Text(), this->AnyOf(plan.transplants), choices };
}

PlanMeasure RandomEdits::MakeMeasure(const Plan& plan)
{
  PlanMeasure measure;
  measure.name = this->Text();
  measure.kind = this->Below(2) == 0 ? MeasureKind::Distance : MeasureKind::Angle;
  for (int n = measure.kind == MeasureKind::Distance ? 2 : 3; n > 0; --n)
    measure.points.push_back(
      { plan.fragments.empty() || this->Below(3) == 0 ? 0 : this->AnyOf(plan.fragments),
        this->Point() });
  return measure;
}

PlanMirror RandomEdits::MakeMirror(const Plan& plan)
{
  PlanMirror mirror;
  mirror.name = this->Text();
  mirror.fragments = this->SomeOf(plan.fragments);
  if (mirror.fragments.empty())
    mirror.volume = this->AnyOf(plan.volumes);
  mirror.isovalue = this->Number(-1000, 3000);
  if (this->Below(2) == 0)
    mirror.plane = MirrorPlane{ this->Point(), this->Direction() };
  return mirror;
}

template <typename T, typename Make>
PlanEdit RandomEdits::AddOrChange(const std::vector<T>& objects, PlanId newId, Make make)
{
  const bool change = !objects.empty() && this->Below(3) == 0;
  const PlanId id = change ? this->AnyOf(objects) : newId;
  T object = make(id);
  object.id = id;
  return change ? PlanEdit(ChangeObject<T>{ object }) : PlanEdit(AddObject<T>{ object });
}

PlanEdit RandomEdits::OfFragments(const Plan& plan)
{
  std::vector<PlanFragment> loose;
  std::copy_if(plan.fragments.begin(), plan.fragments.end(), std::back_inserter(loose),
    [](const PlanFragment& f) { return !f.locked; });
  PoseFragments poses;
  for (const PlanId id : this->SomeOf(loose))
    poses.poses.push_back({ id, this->Pose() });
  if (!poses.poses.empty() && this->Below(2) == 0)
    return poses;
  const SetFragmentState state{ this->SomeOf(plan.fragments), FragmentState(this->Below(2)) };
  return state.fragments.empty() ? PlanEdit(SetCaseLabel{ this->Text() }) : PlanEdit(state);
}

PlanEdit RandomEdits::Next(const Plan& plan, PlanId newId)
{
  const int kind = this->Below(18);
  if (plan.volumes.empty() || kind == 0)
    return this->AddOrChange(plan.volumes, newId, [&](PlanId) { return this->MakeVolume(); });
  if (kind == 1)
    return this->AddOrChange(
      plan.segmentations, newId, [&](PlanId) { return this->MakeSegmentation(plan); });
  if (kind <= 3)
    return this->AddOrChange(
      plan.fragments, newId, [&](PlanId id) { return this->MakeFragment(plan, id); });
  if (kind == 4)
    return this->AddOrChange(plan.groups, newId,
      [&](PlanId) {
        return PlanGroup{ 0, this->Text(), this->SomeOf(plan.fragments) };
      });
  if (kind == 5)
    return this->AddOrChange(plan.cuts, newId, [&](PlanId) { return this->MakeCut(plan); });
  if (kind == 6)
    return this->AddOrChange(plan.guides, newId, [&](PlanId) { return this->MakeGuide(plan); });
  if (kind == 7)
    return this->AddOrChange(plan.measures, newId, [&](PlanId) { return this->MakeMeasure(plan); });
  if (kind == 8)
    return this->OfFragments(plan);
  if (kind == 9)
    return this->AddOrChange(plan.plates, newId, [&](PlanId) { return this->MakePlate(plan); });
  if (kind == 10)
    return this->AddOrChange(plan.implants, newId, [&](PlanId) { return this->MakeImplant(plan); });
  if (kind == 16)
    return this->AddOrChange(plan.surfaces, newId,
      [&](PlanId) {
        return PlanSurface{ 0, this->Text(), this->Hash() };
      });
  if (kind == 17)
    return this->AddOrChange(plan.mirrors, newId, [&](PlanId) { return this->MakeMirror(plan); });
  if (kind == 11 && !ScanFragments(plan).empty())
    return this->AddOrChange(
      plan.transplants, newId, [&](PlanId) { return this->MakeTransplant(plan); });
  if (kind == 12 && !plan.transplants.empty())
    return this->AddOrChange(
      plan.mitreGuides, newId, [&](PlanId) { return this->MakeMitreGuide(plan); });
  if (kind >= 13 && kind <= 14 && !plan.segmentations.empty())
    return this->OfSegmentation(
      plan.segmentations[std::size_t(this->Below(plan.segmentations.size()))]);
  std::vector<PlanId> all, unused;
  ForEachPlanObject(plan, [&](const auto& object) { all.push_back(object.id); });
  std::copy_if(all.begin(), all.end(), std::back_inserter(unused),
    [&](PlanId id) { return UsersOf(plan, id).empty(); });
  if (this->Below(2) == 0 && !unused.empty())
    return RemoveObject{ unused[std::size_t(this->Below(unused.size()))] };
  return RenameObject{ all[std::size_t(this->Below(all.size()))], this->Text() };
}

Plan RandomEdits::MakePlan(int edits)
{
  Plan plan;
  for (; edits > 0; --edits)
  {
    const PlanEdit edit = this->Next(plan, plan.nextId + PlanId(this->Below(3)));
    plan = Apply(std::move(plan), edit);
  }
  return plan;
}
