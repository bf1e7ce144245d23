#include "CertificateText.h"

#include "Version.h"

#include <nlohmann/json.hpp>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

Json At(const glm::dvec3& p)
{
  return Json::array({ p.x, p.y, p.z });
}

Json At(const std::optional<glm::dvec3>& p)
{
  return p ? At(*p) : Json(nullptr);
}

Json MeshJson(const FitCertificate& c)
{
  const MeshCheck& m = c.mesh;
  Json pieces = Json::array();
  for (std::size_t n = 0; n < c.pieces.size() && n < 100; ++n)
    pieces.push_back(
      { { "triangles", c.pieces[n].triangles }, { "volume_mm3", c.pieces[n].volumeMm3 },
        { "low", At(c.pieces[n].low) }, { "high", At(c.pieces[n].high) } });
  Json json{ { "triangles", m.triangles }, { "points", m.points }, { "closed", m.Closed() },
    { "manifold", m.TwoManifold() }, { "outward", m.Outward() }, { "open_edges", m.borderEdges },
    { "crowded_edges", m.crowdedEdges }, { "turned_edges", m.turnedEdges },
    { "pinched_points", m.pinchedPoints }, { "degenerate", m.degenerate }, { "slivers", c.slivers },
    { "self_intersections", nullptr }, { "volume_mm3", m.volumeMm3 }, { "area_mm2", m.areaMm2 },
    { "low", At(c.low) }, { "high", At(c.high) }, { "pieces", m.pieces },
    { "largest_pieces", pieces } };
  if (c.selfIntersections)
    json["self_intersections"] = *c.selfIntersections;
  return json;
}

Json WallsJson(const WallThickness& wall, double leastMm)
{
  if (!(wall.wallMm2 > 0.0))
    return nullptr;
  return { { "least_mm", wall.leastMm }, { "least_at", At(wall.leastAt) }, { "p5_mm", wall.p5Mm },
    { "p50_mm", wall.p50Mm }, { "wall_mm2", wall.wallMm2 }, { "limit_mm", leastMm } };
}

Json ShellJson(const FitCertificate& c)
{
  if (!c.shell)
    return nullptr;
  return { { "asked_mm", c.claims.shell->thicknessMm },
    { "tolerance_mm", c.claims.shell->thicknessToleranceMm }, { "least_mm", c.shell->leastMm },
    { "least_at", At(c.shell->leastAt) }, { "p5_mm", c.shell->p5Mm }, { "p50_mm", c.shell->p50Mm },
    { "shell_mm2", c.shell->shellMm2 } };
}

Json GapJson(const FitCertificate& c)
{
  if (!c.gap)
    return nullptr;
  const ClaimedShell& claim = *c.claims.shell;
  const GuideGap& gap = *c.gap;
  const bool near = gap.leastAnywhere < 1e30; // else nothing is within reach
  return { { "asked_mm", claim.gapMm }, { "tolerance_mm", claim.gapToleranceMm },
    { "least_share", claim.leastGapShare }, { "share_within", gap.share },
    { "share_closer", gap.closer }, { "inner_wall_mm2", gap.innerWallMm2 },
    { "least_mm", gap.least }, { "p5_mm", gap.p5 }, { "p50_mm", gap.p50 }, { "p95_mm", gap.p95 },
    { "most_mm", gap.most }, { "worst_at", At(gap.worstAt) },
    { "nearest_wall_mm", near ? Json(gap.leastAnywhere) : Json(nullptr) },
    { "nearest_wall_at", near ? At(gap.leastAnywhereAt) : Json(nullptr) },
    { "histogram", { { "from_mm", -0.5 * GuideGap::BinMm * double(gap.histogramMm2.size()) },
                     { "bin_mm", GuideGap::BinMm }, { "area_mm2", gap.histogramMm2 } } } };
}

Json SlotJson(const SlotFit& fit, const ClaimedSlot& claim)
{
  return { { "asked_mm", claim.widthMm }, { "tolerance_mm", claim.toleranceMm },
    { "places", fit.places }, { "width_mm", fit.widthMm }, { "least_width_mm", fit.leastWidthMm },
    { "least_at", At(fit.leastAt) }, { "flatness_mm", fit.flatnessMm },
    { "tilt_degrees", fit.tiltDegrees }, { "offset_mm", fit.offsetMm },
    { "length_mm", fit.lengthMm }, { "guide_mm", fit.guideMm },
    { "blocked_at", At(fit.blockedAt) } };
}

Json HoleJson(const HoleFit& fit, const ClaimedHole& claim, std::size_t number)
{
  return { { "name", NameOfHole(claim, number) }, { "asked_mm", claim.diameterMm },
    { "tolerance_mm", claim.toleranceMm }, { "sections", fit.sections },
    { "diameter_mm", fit.diameterMm }, { "least_mm", fit.leastMm },
    { "roundness_mm", fit.roundnessMm }, { "tilt_degrees", fit.tiltDegrees },
    { "offset_mm", fit.offsetMm }, { "guide_mm", fit.guideMm }, { "middle", At(fit.middle) },
    { "wall_around", fit.touchedShare }, { "blocked_at", At(fit.blockedAt) } };
}

Json InsertionJson(const FitCertificate& c)
{
  if (!c.insertion)
    return nullptr;
  const bool blocked = c.insertion->blocked > 0;
  return { { "direction", At(*c.claims.withdrawal) }, { "samples", c.insertion->samples },
    { "blocked", c.insertion->blocked }, { "blocked_mm2", c.insertion->blockedMm2 },
    { "deepest_mm", c.insertion->deepestMm },
    { "part_at", blocked ? At(c.insertion->partAt) : Json(nullptr) },
    { "bone_at", blocked ? At(c.insertion->boneAt) : Json(nullptr) } };
}

} // namespace

nlohmann::ordered_json CertificateJson(const FitCertificate& c)
{
  Json slots = Json::array(), holes = Json::array(), faults = Json::array();
  for (std::size_t n = 0; n < c.slots.size(); ++n)
    slots.push_back(SlotJson(c.slots[n], c.claims.slots[n]));
  for (std::size_t n = 0; n < c.holes.size(); ++n)
    holes.push_back(HoleJson(c.holes[n], c.claims.holes[n], n));
  for (const FitFault& fault : c.faults)
    faults.push_back(
      { { "kind", FitFaultName(fault.kind) }, { "text", fault.text }, { "at", At(fault.at) } });
  const Json passed = c.Holds() && !ClaimFit(c.claims) ? Json(nullptr) : Json(c.Holds());
  return { { "format", "hasp-certificate-1" }, { "passed", passed },
    { "verdict", CertificateVerdict(c) }, { "faults", faults }, { "isovalue", c.claims.isovalue },
    { "mesh", MeshJson(c) }, { "walls", WallsJson(c.wall, c.claims.leastWallMm) },
    { "uncut_walls", c.uncut ? WallsJson(*c.uncut, c.claims.leastUncutMm) : Json(nullptr) },
    { "shell", ShellJson(c) }, { "gap", GapJson(c) }, { "slots", slots }, { "holes", holes },
    { "insertion", InsertionJson(c) },
    { "program", std::string("hasp ") + Version() + ", commit " + Commit() },
    { "intended_use", "research use only, not a medical device" } };
}

} // namespace hasp
