#include "RandomImplants.h"

#include "Draw.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

/// A turn of the skull's world against the phantom's.
glm::dmat3 TurnOf(std::uint32_t skull)
{
  const double angles[ImplantSkulls] = { 0.0, 0.15, -0.2, 0.1 };
  return glm::dmat3(glm::rotate(
    glm::dmat4(1.0), angles[skull % ImplantSkulls], glm::normalize(glm::dvec3(1, skull, 2))));
}

/// Places on the outer table around the hole, in the skull's world.
class Table
{
public:
  Table(const ImplantSkull& skull, const glm::dmat3& turn)
    : Settings(skull.settings),
      Hole(DefectOf(skull.settings)),
      Turn(turn)
  {
  }
  /// mm along and across the hole, from its middle; above the table.
  glm::dvec3 At(const glm::dvec2& place, double above = 0.0) const
  {
    const glm::dvec3 p =
      this->Hole.center + place.x * this->Hole.along + place.y * this->Hole.across;
    return this->Turn * (PhantomOuterTable(this->Settings, p - this->Settings.center) +
                          above * this->Hole.outward);
  }
  glm::dvec3 Turned(const glm::dvec3& direction) const { return this->Turn * direction; }
  glm::dvec2 Half() const { return 0.5 * glm::dvec2(this->Hole.lengthMm, this->Hole.widthMm); }

  const PhantomSettings& Settings;
  const PhantomDefect Hole;

private:
  const glm::dmat3 Turn;
};

/// Around a middle, between `from` and `to` of a turn.
std::vector<glm::dvec3> Arc(const Table& table, Draw& draw, const glm::dvec2& middle,
  const glm::dvec2& half, double from, double to)
{
  const std::size_t count = 10 + draw.Below(10);
  std::vector<glm::dvec3> points;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double angle =
      6.283185307179586 * (from + (to - from) * (double(n) + draw.From(-0.2, 0.2)) / double(count));
    points.push_back(
      table.At(middle + draw.From(1.0, 1.1) * half * glm::dvec2(std::cos(angle), std::sin(angle))));
  }
  return points;
}

/// All of what a sound recipe may be.
ImplantRecipe SoundRecipe(const Table& table, Draw& draw)
{
  ImplantRecipe r;
  // An ellipse that holds the hole's corners, or more.
  const double room = draw.From(1.45, 1.6);
  r.outline = Arc(table, draw, glm::dvec2(0.0), room * (table.Half() + 2.0), 0.0, 1.0);
  if (draw.Below(2))
    r.axis = table.Turned(
      glm::normalize(table.Hole.outward + 0.15 * glm::cross(table.Hole.outward, draw.Direction())));
  r.clearanceMm = draw.From(0.0, 1.0);
  r.thicknessMm = draw.From(3.0, 6.0);
  r.spacingMm = draw.From(0.9, 1.15);
  if (draw.Below(2))
  {
    r.holeDiameterMm = draw.From(2.4, 4.0);
    r.holePitchMm = draw.From(7.0, 15.0);
    r.holeEdgeMm = draw.From(2.5, 4.0);
  }
  return r;
}

void Spoil(RandomImplant& made, const Table& table, Draw& draw)
{
  ImplantRecipe& r = made.recipe;
  const std::size_t at = draw.Below(r.outline.size());
  const glm::dvec2 half = table.Half();
  switch (made.nonsense)
  {
    case ImplantNonsense::None:
      break;
    case ImplantNonsense::OffBone:
      r.outline[at] += table.Turned(table.Hole.outward) *
                       (draw.Below(2) ? draw.From(4.0, 40.0) : draw.From(-40.0, -14.0));
      made.says = "mm from bone";
      break;
    case ImplantNonsense::Collinear:
    {
      const glm::dvec3 a = r.outline[0], b = r.outline[1];
      r.outline = { a, glm::mix(a, b, draw.From(0.2, 0.8)), b };
      made.says = "encloses next to nothing";
      break;
    }
    case ImplantNonsense::Doubled:
      r.outline.insert(r.outline.begin() + std::ptrdiff_t(at), r.outline[at]);
      made.says = "is the same point as the next";
      break;
    case ImplantNonsense::TwiceAround:
    {
      const auto once = r.outline;
      r.outline.insert(r.outline.end(), once.begin(), once.end());
      made.says = "meets itself";
      break;
    }
    case ImplantNonsense::Crossing:
      std::swap(r.outline[at], r.outline[(at + r.outline.size() / 3) % r.outline.size()]);
      made.says = "meets itself";
      break;
    case ImplantNonsense::NoHole:
      r.outline = Arc(table, draw, glm::dvec2(draw.From(-6.0, 6.0), half.y + 22.0),
        glm::dvec2(draw.From(8.0, 14.0), draw.From(8.0, 12.0)), 0.0, 1.0);
      r.axis.reset();
      made.says = "there is no hole within the outline";
      break;
    case ImplantNonsense::HalfRound:
      r.outline = Arc(table, draw, glm::dvec2(0.0), 1.35 * (half + 2.0), 0.0, draw.From(0.4, 0.6));
      made.says = "the hole is open";
      break;
    case ImplantNonsense::CrowdedHoles:
      r.holeDiameterMm = 2.0 * r.spacingMm + 0.01;
      r.holePitchMm = r.holeDiameterMm + 2.0 * r.spacingMm + 0.01;
      r.holeEdgeMm = 1.5;
      break;
    case ImplantNonsense::NoRoom:
      r.holeDiameterMm = 20.0;
      r.holePitchMm = 30.0;
      r.holeEdgeMm = draw.From(5.0, 50.0);
      made.says = "no room for a hole";
      break;
    case ImplantNonsense::MirrorAside:
      r.mirror = MirrorPlane{ table.Turned(table.Settings.center) +
                                table.Turned({ draw.From(10.0, 200.0), 0, 0 }),
        table.Turned({ 1, 0, 0 }) };
      made.says = "mirrored";
      break;
    case ImplantNonsense::AxisAlong:
      r.axis = draw.Below(2) ? table.Turned(table.Hole.across) : -table.Turned(table.Hole.outward);
      made.says = "degrees from upright";
      break;
    case ImplantNonsense::ThickClearance:
      r.clearanceMm = 5.0;
      r.thicknessMm = draw.From(19.0, 20.0);
      made.says = "there is no hole within the outline";
      break;
  }
}
} // namespace

const char* ImplantNonsenseName(ImplantNonsense nonsense)
{
  constexpr const char* names[ImplantNonsenses] = { "none", "off-bone", "collinear", "doubled",
    "twice-around", "crossing", "no-hole", "half-round", "crowded-holes", "no-room", "mirror-aside",
    "axis-along", "thick-clearance" };
  return names[int(nonsense)];
}

ImplantSkull MakeImplantSkull(std::uint32_t skull)
{
  skull %= ImplantSkulls;
  const double size[] = { 1.0, 0.95, 1.05, 1.0 }, noise[] = { 0.0, 20.0, 0.0, 60.0 };
  const glm::dvec3 spacing[] = { glm::dvec3(1.5), { 1.0, 1.0, 2.0 }, { 1.25, 1.0, 1.25 },
    glm::dvec3(1.25) };
  ImplantSkull made;
  made.settings.skinRadii *= size[skull];
  made.settings.center = glm::dvec3(10.0, -5.0, 20.0) * double(skull);
  made.settings.blurMm = glm::dvec3(0.5);
  made.settings.noiseHU = noise[skull];
  made.settings.seed = skull + 1;
  made.scan = PhantomGrid(spacing[skull], made.settings);
  // The vault alone, and said to lie turned.
  const auto below =
    int((made.settings.center.z - 20.0 - made.scan.origin.z) / made.scan.spacing.z);
  made.scan.origin.z += below * made.scan.spacing.z;
  made.scan.dims.z -= below;
  made.grey = SamplePhantom(made.scan, made.settings);
  made.scan.origin = TurnOf(skull) * made.scan.origin;
  made.scan.direction = TurnOf(skull) * made.scan.direction;
  return made;
}

RandomImplant RandomImplantRecipe(std::uint32_t seed, const ImplantSkull& skull)
{
  Draw draw(seed);
  const Table table(skull, TurnOf(seed % ImplantSkulls));
  RandomImplant made;
  // Skulls take turns faster than nonsenses: each meets all of them.
  const std::uint32_t turn = seed / ImplantSkulls + seed % ImplantSkulls;
  if (turn % 2)
    made.nonsense = ImplantNonsense(1 + turn / 2 % (ImplantNonsenses - 1));
  made.recipe = SoundRecipe(table, draw);
  Spoil(made, table, draw);
  return made;
}

} // namespace hasp
