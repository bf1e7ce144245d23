#include "CertificateRead.h"

#include "PartReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <stdexcept>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr std::size_t MostPieces = 100, MostBins = 100'000; // CertificateJson writes no more

/// Infinite in the file is null.
double Number(const Json& json, const char* key)
{
  const Json& value = json.at(key);
  return value.is_null() ? HUGE_VAL : value.get<double>();
}

std::size_t Count(const Json& json, const char* key)
{
  return json.at(key).get<std::size_t>();
}

std::optional<glm::dvec3> PlaceOrNone(const Json& json, const char* key)
{
  const Json& value = json.at(key);
  if (value.is_null())
    return std::nullopt;
  const auto at = value.get<std::array<double, 3>>();
  return glm::dvec3(at[0], at[1], at[2]);
}

glm::dvec3 Place(const Json& json, const char* key)
{
  return PlaceOrNone(json, key).value_or(glm::dvec3(0.0));
}

void ReadMesh(const Json& json, FitCertificate& c)
{
  MeshCheck& m = c.mesh;
  m.triangles = Count(json, "triangles");
  m.points = Count(json, "points");
  m.borderEdges = Count(json, "open_edges");
  m.crowdedEdges = Count(json, "crowded_edges");
  m.turnedEdges = Count(json, "turned_edges");
  m.pinchedPoints = Count(json, "pinched_points");
  m.degenerate = Count(json, "degenerate");
  m.pieces = Count(json, "pieces");
  m.volumeMm3 = Number(json, "volume_mm3");
  m.areaMm2 = Number(json, "area_mm2");
  c.slivers = Count(json, "slivers");
  if (!json.at("self_intersections").is_null())
    c.selfIntersections = Count(json, "self_intersections");
  c.low = Place(json, "low");
  c.high = Place(json, "high");
  for (const Json& piece : json.at("largest_pieces"))
    if (c.pieces.size() < MostPieces)
      c.pieces.push_back({ Count(piece, "triangles"), Number(piece, "volume_mm3"),
        Place(piece, "low"), Place(piece, "high") });
}

WallThickness ReadWall(const Json& json, double& limitMm)
{
  WallThickness wall;
  if (json.is_null())
    return wall;
  wall.leastMm = Number(json, "least_mm");
  wall.leastAt = Place(json, "least_at");
  wall.p5Mm = Number(json, "p5_mm");
  wall.p50Mm = Number(json, "p50_mm");
  wall.wallMm2 = Number(json, "wall_mm2");
  limitMm = Number(json, "limit_mm");
  return wall;
}

void ReadShell(const Json& json, FitCertificate& c)
{
  if (json.is_null())
    return;
  ClaimedShell& claim = c.claims.shell ? *c.claims.shell : c.claims.shell.emplace();
  claim.thicknessMm = Number(json, "asked_mm");
  claim.thicknessToleranceMm = Number(json, "tolerance_mm");
  c.shell = { Number(json, "shell_mm2"), Number(json, "least_mm"), Place(json, "least_at"),
    Number(json, "p5_mm"), Number(json, "p50_mm") };
}

void ReadGap(const Json& json, FitCertificate& c)
{
  if (json.is_null())
    return;
  ClaimedShell& claim = c.claims.shell ? *c.claims.shell : c.claims.shell.emplace();
  claim.gapMm = Number(json, "asked_mm");
  claim.gapToleranceMm = Number(json, "tolerance_mm");
  claim.leastGapShare = Number(json, "least_share");
  GuideGap& gap = c.gap.emplace();
  gap.innerWallMm2 = Number(json, "inner_wall_mm2");
  gap.share = Number(json, "share_within");
  gap.closer = Number(json, "share_closer");
  gap.least = Number(json, "least_mm");
  gap.p5 = Number(json, "p5_mm");
  gap.p50 = Number(json, "p50_mm");
  gap.p95 = Number(json, "p95_mm");
  gap.most = Number(json, "most_mm");
  gap.worstAt = Place(json, "worst_at");
  gap.leastAnywhere = Number(json, "nearest_wall_mm");
  gap.leastAnywhereAt = Place(json, "nearest_wall_at");
  for (const Json& area : json.at("histogram").at("area_mm2"))
    if (gap.histogramMm2.size() < MostBins)
      gap.histogramMm2.push_back(area.get<double>());
}

void ReadSlot(const Json& json, FitCertificate& c)
{
  ClaimedSlot claim;
  claim.widthMm = Number(json, "asked_mm");
  claim.toleranceMm = Number(json, "tolerance_mm");
  SlotFit fit;
  fit.places = Count(json, "places");
  fit.widthMm = Number(json, "width_mm");
  fit.leastWidthMm = Number(json, "least_width_mm");
  fit.leastAt = Place(json, "least_at");
  fit.flatnessMm = Number(json, "flatness_mm");
  fit.tiltDegrees = Number(json, "tilt_degrees");
  fit.offsetMm = Number(json, "offset_mm");
  fit.lengthMm = Number(json, "length_mm");
  fit.guideMm = Number(json, "guide_mm");
  fit.blockedAt = PlaceOrNone(json, "blocked_at");
  c.claims.slots.push_back(claim);
  c.slots.push_back(fit);
}

void ReadHole(const Json& json, FitCertificate& c)
{
  ClaimedHole claim;
  static const std::regex names("(holes|screws)\\[[0-9]{1,4}\\]");
  if (const auto name = json.at("name").get<std::string>(); std::regex_match(name, names))
    claim.name = name;
  claim.diameterMm = Number(json, "asked_mm");
  claim.toleranceMm = Number(json, "tolerance_mm");
  HoleFit fit;
  fit.sections = Count(json, "sections");
  fit.diameterMm = Number(json, "diameter_mm");
  fit.leastMm = Number(json, "least_mm");
  fit.roundnessMm = Number(json, "roundness_mm");
  fit.tiltDegrees = Number(json, "tilt_degrees");
  fit.offsetMm = Number(json, "offset_mm");
  fit.guideMm = Number(json, "guide_mm");
  fit.middle = Place(json, "middle");
  fit.touchedShare = Number(json, "wall_around");
  fit.blockedAt = PlaceOrNone(json, "blocked_at");
  c.claims.holes.push_back(claim);
  c.holes.push_back(fit);
}

void ReadInsertion(const Json& json, FitCertificate& c)
{
  if (json.is_null())
    return;
  c.claims.withdrawal = Place(json, "direction");
  c.insertion = { Count(json, "samples"), Count(json, "blocked"), Number(json, "blocked_mm2"),
    Number(json, "deepest_mm"), Place(json, "part_at"), Place(json, "bone_at") };
}

FitCertificate Read(const Json& json)
{
  if (json.at("format") != "hasp-certificate-1")
    throw std::runtime_error("format");
  FitCertificate c;
  c.claims.isovalue = Number(json, "isovalue");
  ReadMesh(json.at("mesh"), c);
  c.wall = ReadWall(json.at("walls"), c.claims.leastWallMm);
  if (!json.at("uncut_walls").is_null())
    c.uncut = ReadWall(json.at("uncut_walls"), c.claims.leastUncutMm);
  ReadGap(json.at("gap"), c);
  ReadShell(json.at("shell"), c);
  for (const Json& slot : json.at("slots"))
    ReadSlot(slot, c);
  for (const Json& hole : json.at("holes"))
    ReadHole(hole, c);
  ReadInsertion(json.at("insertion"), c);
  for (const Json& fault : json.at("faults"))
    c.faults.push_back(ReadFault(fault));
  return c;
}

} // namespace

FitCertificate ReadCertificate(const nlohmann::ordered_json& json)
{
  try
  {
    return Read(json);
  }
  catch (const std::exception&)
  {
    throw std::runtime_error("the certificate in the report is none that Hasp wrote");
  }
}

std::optional<FitCertificate> CertificateOfReport(const std::string& report)
{
  const Json json = Json::parse(report, nullptr, false);
  if (!json.is_object())
    throw std::runtime_error("the report on the part is none that Hasp wrote");
  if (!json.contains("certificate"))
    return std::nullopt;
  return ReadCertificate(json["certificate"]);
}

} // namespace hasp
