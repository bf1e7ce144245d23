#include "Output/ReportTables.h"

#include "Model/ObjectNames.h"
#include "Planning/PlanLists.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hasp
{
namespace
{

constexpr double Degrees = 180.0 / std::numbers::pi;
constexpr double LeastMm = 0.005, LeastDegrees = 0.005; // what is no motion at two digits

/// Towards the patient's left, back and top: "2.00 L, 1.50 A, 0.30 S".
QString Directions(const glm::dvec3& mm)
{
  constexpr std::array letters{ std::pair('L', 'R'), std::pair('P', 'A'), std::pair('S', 'I') };
  QStringList parts;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(mm[axis]) >= LeastMm)
      parts.append(Decimal(std::abs(mm[axis]), 2) + " " +
                   QChar(mm[axis] > 0.0 ? letters[std::size_t(axis)].first
                                        : letters[std::size_t(axis)].second));
  return parts.join(", ");
}

QString Place(const glm::dvec3& at, int digits)
{
  return "(" + Decimal(at.x, digits) + ", " + Decimal(at.y, digits) + ", " + Decimal(at.z, digits) +
         ")";
}

/// "4.20 mm: 2.00 L, 3.69 A"
QString Motion(const PlanPose& pose, const glm::dvec3& point)
{
  const glm::dvec3 by = pose.Place(point) - point;
  const double mm = glm::length(by);
  return mm < LeastMm ? ReportText::tr("not moved") : Decimal(mm, 2) + " mm: " + Directions(by);
}

/// The shorter way round, about the axis that it is positive around.
QString Turn(const PlanPose& pose)
{
  glm::dquat q = pose.orientation;
  if (q.w < 0.0)
    q = -q;
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double length = glm::length(axis), degrees = 2.0 * std::atan2(length, q.w) * Degrees;
  if (degrees < LeastDegrees)
    return ReportText::tr("not turned");
  return ReportText::tr("%1° about %2").arg(Decimal(degrees, 2), Place(axis / length, 3));
}

QString SourceOf(const ReportNaming& of, const PlanFragment& fragment)
{
  if (const auto* label = std::get_if<LabelSource>(&fragment.source))
    return ReportText::tr("label %1 of %2")
      .arg(label->label)
      .arg(CalledInReport(of, label->segmentation));
  if (const auto* piece = std::get_if<PieceSource>(&fragment.source))
    return ReportText::tr("a piece of %1").arg(CalledInReport(of, piece->fragment));
  if (const auto* surface = std::get_if<SurfaceSource>(&fragment.source))
    return CalledInReport({ of.plan, false }, surface->surface);
  return ReportText::tr("bone of %1")
    .arg(CalledInReport({ of.plan, false }, std::get<ComponentSource>(fragment.source).volume));
}

QString StateOf(const Plan& plan, const PlanFragment& fragment)
{
  if (fragment.state == FragmentState::Resected)
    return ReportText::tr("resected");
  if (IsDivided(plan, fragment.id))
    return ReportText::tr("cut into pieces");
  return fragment.locked ? ReportText::tr("kept, locked: the reference") : ReportText::tr("kept");
}

/// Where it is, for its motion; none: only its pose is known.
const glm::dvec3* PointOf(const PlanFragment& fragment, const std::map<PlanId, glm::dvec3>& middles)
{
  if (const auto found = middles.find(fragment.id); found != middles.end())
    return &found->second;
  if (const auto* piece = std::get_if<PieceSource>(&fragment.source))
    return &piece->seed;
  const auto* component = std::get_if<ComponentSource>(&fragment.source);
  return component ? &component->seed : nullptr;
}

QString List(const ReportNaming& of, const std::vector<PlanId>& objects)
{
  QStringList names;
  for (const PlanId object : objects)
    names.append(CalledInReport(of, object));
  return names.join(", ");
}

/// Between a plane with that normal and those across the patient's axes.
QString Angle(double alongAxis)
{
  return Decimal(std::acos(std::min(std::abs(alongAxis), 1.0)) * Degrees, 1) + "°";
}

} // namespace

QString Decimal(double value, int digits)
{
  const QString text = QString::number(value, 'f', digits);
  const bool isZero = std::none_of(
    text.begin(), text.end(), [](QChar letter) { return letter >= '1' && letter <= '9'; });
  return isZero && text.startsWith('-') ? text.mid(1) : text;
}

QString CalledInReport(const ReportNaming& of, PlanId object)
{
  QString text = QString::fromStdString(CalledObject(of.plan, object));
  ForEachPlanObject(of.plan,
    [&](const auto& is)
    {
      if (of.names && is.id == object && ObjectNames::IsGiven(is))
        text += " (" + QString::fromStdString(is.name) + ")";
    });
  return text;
}

ReportTable FragmentTable(const ReportNaming& of, const std::map<PlanId, glm::dvec3>& middles)
{
  ReportTable table{ ReportText::tr("Fragments"),
    ReportText::tr(
      "Motion from the scan to the plan. A fragment is moved as the middle of its box is, "
      "or the place that it was picked at; L, R, A, P, S and I are the patient's left, "
      "right, front, back, top and bottom. It is turned about that place, by the right-hand "
      "rule; axes are patient LPS."),
    { ReportText::tr("fragment"), ReportText::tr("of"), ReportText::tr("state"),
      ReportText::tr("moved"), ReportText::tr("turned") },
    {} };
  for (const PlanFragment& fragment : of.plan.fragments)
  {
    const glm::dvec3* point = PointOf(fragment, middles);
    const bool stands = fragment.state == FragmentState::Kept && !IsDivided(of.plan, fragment.id);
    const PlanPose& pose = fragment.scanToPlanned;
    table.rows.push_back(
      { CalledInReport(of, fragment.id), SourceOf(of, fragment), StateOf(of.plan, fragment),
        !stands              ? QString("–")
        : point              ? Motion(pose, *point)
        : pose == PlanPose{} ? ReportText::tr("not moved")
                             : ReportText::tr("moved; its scan is not there to tell by how much"),
        stands ? Turn(pose) : QString("–") });
  }
  return table;
}

ReportTable GroupTable(const ReportNaming& of)
{
  ReportTable table{ ReportText::tr("Groups"), ReportText::tr("Fragments that are moved as one."),
    { ReportText::tr("group"), ReportText::tr("fragments") }, {} };
  for (const PlanGroup& group : of.plan.groups)
    table.rows.push_back({ CalledInReport(of, group.id), List(of, group.fragments) });
  return table;
}

ReportTable CutTable(const ReportNaming& of)
{
  ReportTable table{ ReportText::tr("Cuts"),
    ReportText::tr(
      "Where the bone lies in the scan; places are patient LPS, mm. Angles are those between "
      "the blade's plane and the axial, coronal and sagittal planes."),
    { ReportText::tr("cut"), ReportText::tr("through"), ReportText::tr("middle of the blade"),
      ReportText::tr("axial"), ReportText::tr("coronal"), ReportText::tr("sagittal"),
      ReportText::tr("blade, mm"), ReportText::tr("kerf, mm") },
    {} };
  for (const PlanCut& cut : of.plan.cuts)
    table.rows.push_back(
      { CalledInReport(of, cut.id), List(of, cut.fragments), Place(cut.blade.point, 2),
        Angle(cut.blade.normal.z), Angle(cut.blade.normal.y), Angle(cut.blade.normal.x),
        Decimal(cut.blade.widthMm, 1) + " × " + Decimal(cut.blade.depthMm, 1),
        Decimal(cut.blade.kerfMm, 2) });
  return table;
}

ReportTable MeasureTable(const ReportNaming& of)
{
  ReportTable table{ ReportText::tr("Measures"), {},
    { ReportText::tr("measure"), ReportText::tr("planned"), ReportText::tr("in the scan"),
      ReportText::tr("change") },
    {} };
  Plan scanned = of.plan;
  for (PlanFragment& fragment : scanned.fragments)
    fragment.scanToPlanned = {};
  for (const PlanMeasure& measure : of.plan.measures)
  {
    const bool isAngle = measure.kind == MeasureKind::Angle;
    const QString unit = isAngle ? QString("°") : QString(" mm");
    const double planned = MeasureValue(of.plan, measure), before = MeasureValue(scanned, measure);
    table.rows.push_back({ CalledInReport(of, measure.id), Decimal(planned, 2) + unit,
      Decimal(before, 2) + unit, Decimal(planned - before, 2) + unit });
  }
  return table;
}

ReportTable SourceTable(const Plan& plan)
{
  ReportTable table{ ReportText::tr("Scans and surfaces"),
    ReportText::tr(
      "By the SHA-256 of what they hold: it is the same wherever a file lies and whatever "
      "it is called."),
    { ReportText::tr("object"), ReportText::tr("SHA-256") }, {} };
  for (const PlanVolume& volume : plan.volumes)
    table.rows.push_back(
      { CalledInReport({ plan, false }, volume.id), QString::fromStdString(volume.hash) });
  for (const PlanSurface& surface : plan.surfaces)
    table.rows.push_back(
      { CalledInReport({ plan, false }, surface.id), QString::fromStdString(surface.hash) });
  return table;
}

} // namespace hasp
