#include "Evaluation/FitFaults.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <cstdio>

namespace hasp
{

namespace
{
std::string Text(const char* format, auto... figures)
{
  char text[240];
  std::snprintf(text, sizeof text, format, figures...);
  return text;
}

std::string Place(const glm::dvec3& p)
{
  return Text("(%.1f, %.1f, %.1f)", p.x, p.y, p.z);
}

void Add(FitFaults& faults, FitFaultKind kind, const std::string& text,
  const std::optional<glm::dvec3>& at = {})
{
  faults.push_back({ kind, at ? text + ", at " + Place(*at) : text, at });
}

/// How far a tilt moves the ends of what is that high.
double AtTheEnds(double tiltDegrees, double heightMm)
{
  return 0.5 * heightMm * std::tan(glm::radians(tiltDegrees));
}
} // namespace

const char* FitFaultName(FitFaultKind kind)
{
  switch (kind)
  {
    case FitFaultKind::NotClosed:
      return "not-closed";
    case FitFaultKind::NotManifold:
      return "not-manifold";
    case FitFaultKind::Turned:
      return "turned";
    case FitFaultKind::NoArea:
      return "no-area";
    case FitFaultKind::MeetsItself:
      return "meets-itself";
    case FitFaultKind::NotChecked:
      return "not-checked";
    case FitFaultKind::Pieces:
      return "pieces";
    case FitFaultKind::ThinWall:
      return "thin-wall";
    case FitFaultKind::Gap:
      return "gap";
    case FitFaultKind::TouchesBone:
      return "touches-bone";
    case FitFaultKind::Slot:
      return "slot";
    case FitFaultKind::Hole:
      return "hole";
    case FitFaultKind::Undercut:
      return "undercut";
    case FitFaultKind::Mirrored:
      return "mirrored";
    case FitFaultKind::Units:
      return "units";
    case FitFaultKind::Space:
      return "space";
    case FitFaultKind::SaidRed:
      return "said-red";
  }
  return "unknown";
}

void JudgeMesh(const FitCertificate& c, FitFaults& faults)
{
  const MeshCheck& m = c.mesh;
  if (m.triangles == 0)
    return Add(faults, FitFaultKind::NotClosed, "there is no triangle in it");
  if (m.borderEdges > 0)
    Add(faults, FitFaultKind::NotClosed,
      "the mesh is not closed: " + std::to_string(m.borderEdges) + " open edges", m.borderAt);
  if (!m.TwoManifold())
    Add(faults, FitFaultKind::NotManifold,
      "the mesh is not 2-manifold: " + std::to_string(m.crowdedEdges) + " edges, " +
        std::to_string(m.pinchedPoints) + " points",
      m.crowdedAt ? m.crowdedAt : m.pinchedAt);
  if (m.turnedEdges > 0)
    Add(faults, FitFaultKind::Turned,
      "triangles are turned against their neighbours, along " + std::to_string(m.turnedEdges) +
        " edges",
      m.turnedAt);
  else if (!m.Outward())
    Add(faults, FitFaultKind::Turned, "the mesh is inside out");
  if (m.degenerate > 0)
    Add(faults, FitFaultKind::NoArea,
      "the mesh has " + std::to_string(m.degenerate) + " triangles without an area",
      m.degenerateAt);
  if (c.pieces.size() != c.claims.pieces)
  {
    const MeshPiece& least = c.pieces.back();
    Add(faults, FitFaultKind::Pieces,
      "the part is in " + std::to_string(c.pieces.size()) + " pieces, must be in " +
        std::to_string(c.claims.pieces) + Text("; the smallest has %.2f mm3", least.volumeMm3),
      0.5 * (least.low + least.high));
  }
}

void JudgeWalls(const FitCertificate& c, FitFaults& faults)
{
  if (c.wall.wallMm2 > 0.0 && c.wall.leastMm < c.claims.leastWallMm)
    Add(faults, FitFaultKind::ThinWall,
      Text("a wall is %.2f mm thick, must be %.2f at least", c.wall.leastMm, c.claims.leastWallMm),
      c.wall.leastAt);
  if (c.uncut && c.uncut->wallMm2 > 0.0 && c.uncut->leastMm < c.claims.leastUncutMm)
    Add(faults, FitFaultKind::ThinWall,
      Text("a wall away from slots and holes is %.2f mm thick, must be %.2f at least",
        c.uncut->leastMm, c.claims.leastUncutMm),
      c.uncut->leastAt);
  if (!c.shell)
    return;
  const double least = c.claims.shell->thicknessMm - c.claims.shell->thicknessToleranceMm;
  if (c.shell->shellMm2 > 0.0 && c.shell->leastMm < least)
    Add(faults, FitFaultKind::ThinWall,
      Text("the shell is %.2f mm thick, must be %.2f, less %.2f at most", c.shell->leastMm,
        c.claims.shell->thicknessMm, c.claims.shell->thicknessToleranceMm),
      c.shell->leastAt);
}

void JudgeGap(const GuideGap& gap, const ClaimedShell& shell, double volumeMm3, FitFaults& faults)
{
  if (!(gap.innerWallMm2 > 0.0))
    return Add(faults, FitFaultKind::Gap, "no wall faces bone within reach");
  const double asShell = std::max(std::abs(volumeMm3) - shell.besideMm3, 0.0) / shell.thicknessMm;
  if (gap.innerWallMm2 < InnerShare * asShell)
    Add(faults, FitFaultKind::Gap,
      Text(
        "only %.0f mm2 face bone within reach, a shell of this volume has %.0f; at least %.0f must",
        gap.innerWallMm2, asShell, InnerShare * asShell));
  if (gap.share < shell.leastGapShare)
    Add(faults, FitFaultKind::Gap,
      Text("only %.1f %% of the inner wall is within %.2f mm of the gap of %.2f, at least %.1f %% "
           "must be",
        100.0 * gap.share, shell.gapToleranceMm, shell.gapMm, 100.0 * shell.leastGapShare),
      gap.worstAt);
  if (!(gap.leastAnywhere > 0.0))
    Add(faults, FitFaultKind::TouchesBone,
      Text("a wall touches bone, %.2f mm in it", -gap.leastAnywhere), gap.leastAnywhereAt);
}

void JudgeSlot(const SlotFit& fit, const ClaimedSlot& slot, std::size_t number, FitFaults& faults)
{
  const std::string name = "slots[" + std::to_string(number) + "]";
  const double tolerance = slot.toleranceMm;
  const auto fault = [&](const std::string& text, const std::optional<glm::dvec3>& at = {})
  { Add(faults, FitFaultKind::Slot, name + text, at); };
  if (fit.blockedAt)
    fault(" is blocked", fit.blockedAt);
  if (fit.places == 0)
  {
    if (!fit.blockedAt)
      fault(" does not meet the part", slot.point);
    return;
  }
  if (fit.leastWidthMm < slot.widthMm - tolerance)
    fault(
      Text(" is %.2f mm wide, must be %.2f within %.2f", fit.leastWidthMm, slot.widthMm, tolerance),
      fit.leastAt);
  if (fit.widthMm > slot.widthMm + tolerance)
    fault(Text(" is %.2f mm wide between its planes, must be %.2f within %.2f", fit.widthMm,
      slot.widthMm, tolerance));
  if (fit.flatnessMm > tolerance)
    fault(Text(
      " has walls that are flat within %.2f mm, must be within %.2f", fit.flatnessMm, tolerance));
  if (fit.offsetMm > tolerance)
    fault(Text(" lies %.2f mm off its plane, may %.2f", fit.offsetMm, tolerance));
  if (AtTheEnds(fit.tiltDegrees, fit.guideMm) > tolerance)
    fault(Text(" is tilted by %.2f degrees", fit.tiltDegrees));
}

void JudgeHole(const HoleFit& fit, const ClaimedHole& hole, std::size_t number, FitFaults& faults)
{
  const std::string name = NameOfHole(hole, number);
  const double tolerance = hole.toleranceMm;
  const auto fault = [&](const std::string& text, const std::optional<glm::dvec3>& at = {})
  { Add(faults, FitFaultKind::Hole, name + text, at); };
  if (fit.blockedAt)
    fault(" is blocked", fit.blockedAt);
  if (fit.sections == 0)
  {
    if (fit.touchedShare > 0.0)
      fault(Text(" is open at the side: at most %.0f %% of its wall is there",
              100.0 * fit.touchedShare),
        hole.point);
    else if (!fit.blockedAt)
      fault(" does not touch the part", hole.point);
    return;
  }
  if (std::abs(fit.diameterMm - hole.diameterMm) > tolerance)
    fault(Text(" has a diameter of %.2f mm, must have %.2f within %.2f", fit.diameterMm,
            hole.diameterMm, tolerance),
      fit.middle);
  else if (fit.leastMm < hole.diameterMm - tolerance)
    fault(Text(" lets %.2f mm through, must %.2f, less %.2f at most", fit.leastMm, hole.diameterMm,
            tolerance),
      fit.middle);
  if (fit.offsetMm > tolerance)
    fault(Text(" lies %.2f mm off its axis, may %.2f", fit.offsetMm, tolerance), fit.middle);
  if (AtTheEnds(fit.tiltDegrees, fit.guideMm) > tolerance)
    fault(Text(" is tilted by %.2f degrees", fit.tiltDegrees), fit.middle);
}

void JudgeInsertion(const Insertion& insertion, FitFaults& faults)
{
  if (insertion.blocked > 0)
    Add(faults, FitFaultKind::Undercut,
      Text(
        "it cannot be put on along its axis: %.1f mm2 of it would pass through bone, up to %.2f mm "
        "deep, such as ",
        insertion.blockedMm2, insertion.deepestMm) +
        Place(insertion.boneAt) + ", by the place of the part",
      insertion.partAt);
}

} // namespace hasp
