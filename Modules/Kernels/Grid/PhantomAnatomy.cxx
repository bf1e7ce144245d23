#include "Grid/PhantomAnatomy.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Coordinates below are millimetres of the default head, from the skull's centre: +x left, +y
// posterior, +z superior. Sizes are those of an adult; everything else is chosen so that parts that
// belong together overlap, and those that do not stay 2 mm apart.

namespace hasp
{
namespace
{

using Solids = std::vector<AnalyticSolid>;

/// Points follow the skull's radii, thicknesses do not.
struct Head
{
  explicit Head(const PhantomSettings& s)
    : settings(s),
      outer(s.skinRadii - s.scalpMm),
      scale(outer / glm::dvec3(70.0, 90.0, 86.0))
  {
  }
  glm::dvec3 At(double x, double y, double z) const
  {
    return this->settings.center + this->scale * glm::dvec3(x, y, z);
  }
  EllipsoidShape Ellipsoid(const glm::dvec3& at, const glm::dvec3& radii, double more = 0.0) const
  {
    return { this->At(at.x, at.y, at.z), this->scale * radii + more };
  }
  RoundConeShape Cone(
    const glm::dvec3& a, double radiusA, const glm::dvec3& b, double radiusB) const
  {
    return { this->At(a.x, a.y, a.z), this->At(b.x, b.y, b.z), radiusA, radiusB };
  }
  HorseshoeShape UpperArch() const
  {
    return { this->At(0.0, -58.0, -60.5), 24.0 * this->scale.x, 1.05, 31.0 * this->scale.y, 1.5,
      4.5 };
  }
  HorseshoeShape LowerArch() const
  {
    return { this->At(0.0, -58.0, -96.0), 22.0 * this->scale.x, 1.08, 61.0 * this->scale.y, 5.0,
      5.5 };
  }

  PhantomSettings settings;
  glm::dvec3 outer;
  glm::dvec3 scale;
};

/// A cavity and its wall: the first is empty, the second is bone within the skull.
struct Cavity
{
  EllipsoidShape space, wall;
  bool throughFace; ///< the bones of the face end there, too
};

std::vector<Cavity> Cavities(const Head& head)
{
  std::vector<Cavity> cavities;
  const auto add = [&](const glm::dvec3& at, const glm::dvec3& radii, double wall, bool throughFace)
  {
    cavities.push_back({ head.Ellipsoid(at, radii), head.Ellipsoid(at, radii, wall), throughFace });
  };
  add({ 0, -72, -42 }, { 11, 22, 17 }, 2.6, true); // nose
  for (const double side : { -1.0, 1.0 })
  {
    add({ side * 32, -78, -18 }, { 19, 19, 17 }, 3.0, true);  // orbit
    add({ side * 62, -22, -72 }, { 36, 40, 40 }, 4.0, false); // below the temple: the ramus
    add({ side * 75, -33, -30 }, { 20, 25, 27 }, 4.0, false); // temple: under the arch
  }
  return cavities;
}

AnalyticSolid Defect(const PhantomSettings& settings)
{
  const PhantomDefect hole = DefectOf(settings);
  const BarShape slot{ hole.center, hole.along, hole.across,
    { 0.5 * hole.lengthMm, 0.5 * hole.widthMm }, 6.0 };
  // Not through the far side.
  const HalfSpaceShape deep{ hole.center - 30.0 * hole.outward, -hole.outward };
  return AnalyticSolid::Intersection({ slot, deep });
}

/// The vault: a shell, open below, its cavities walled off from the brain.
AnalyticSolid Vault(const Head& head, const std::vector<Cavity>& cavities)
{
  const PhantomSettings& s = head.settings;
  Solids solid{ EllipsoidShape{ s.center, head.outer } };
  Solids notBrain{ AnalyticSolid(EllipsoidShape{ s.center, head.outer - s.skullMm }).Complement() };
  for (const Cavity& cavity : cavities)
    notBrain.emplace_back(cavity.wall);
  solid.push_back(AnalyticSolid::Union(notBrain));
  for (const Cavity& cavity : cavities)
    solid.push_back(AnalyticSolid(cavity.space).Complement());
  solid.emplace_back(
    HalfSpaceShape{ s.center + glm::dvec3(0, 0, s.skullBaseMm), { 0.0, 0.0, -1.0 } });
  solid.emplace_back(
    HalfSpaceShape{ head.At(0.0, -88.0, -46.0), glm::normalize(glm::dvec3(0.0, -0.18, -1.0)) });
  return AnalyticSolid::Intersection(solid);
}

Solids Midface(const Head& head)
{
  Solids face{ head.UpperArch(), head.Ellipsoid({ 0, -56, -56 }, { 23, 26, 3.2 }),
    head.Cone({ 0, -86, -12 }, 5.5, { 0, -91.5, -28 }, 3.0) }; // alveolus, palate, nasal bones
  for (const double side : { -1.0, 1.0 })
  {
    const double arch = side > 0 ? 3.6 : 3.2; // the left one is stouter
    face.emplace_back(head.Ellipsoid({ side * 22, -70, -49 }, { 16, 14, 13 })); // maxilla
    face.emplace_back(
      head.Cone({ side * 15, -76, -48 }, 6.0, { side * 10.5, -82, -22 }, 4.2)); // beside the nose
    face.emplace_back(
      head.Cone({ side * 28, -72, -43 }, 8.0, { side * 50, -61, -36 }, 6.5)); // zygoma
    face.emplace_back(
      head.Cone({ side * 50, -61, -35 }, 5.5, { side * 51, -60, -8 }, 5.0)); // its frontal process
    face.emplace_back(
      head.Cone({ side * 51, -60, -36 }, 5.6, { side * 64, -36, -35 }, arch)); // the arch ...
    face.emplace_back(
      head.Cone({ side * 64, -36, -35 }, arch, { side * 62.5, -2, -30 }, 4.8)); // ... to the temple
  }
  return face;
}

AnalyticSolid Cranium(const Head& head)
{
  const std::vector<Cavity> cavities = Cavities(head);
  Solids bones = Midface(head);
  bones.push_back(Vault(head, cavities));
  Solids solid{ AnalyticSolid::Union(bones) };
  for (const Cavity& cavity : cavities)
    if (cavity.throughFace)
      solid.push_back(AnalyticSolid(cavity.space).Complement());
  if (head.settings.defect)
    solid.push_back(Defect(head.settings).Complement());
  return AnalyticSolid::Intersection(solid);
}

/// A point of the plane in which a ramus lies: it flares backwards and upwards.
glm::dvec3 OnRamus(double side, double y, double z)
{
  return { side * (48.5 + 0.25 * (y + 16.0) + 0.08 * (z + 92.0)), y, z };
}

/// The plate of a ramus: a thin prism, rounded.
AnalyticSolid RamusPlate(const Head& head, double side)
{
  const glm::dvec3 thick(0.6, 0.0, 0.0);
  std::vector<glm::dvec3> inner, outer;
  for (const glm::dvec2& yz :
    { glm::dvec2(-10, -94), glm::dvec2(-42, -90), glm::dvec2(-35, -64), glm::dvec2(-10, -62) })
  {
    const glm::dvec3 p = OnRamus(side, yz.x, yz.y);
    inner.push_back(head.At(p.x, p.y, p.z) - thick);
    outer.push_back(head.At(p.x, p.y, p.z) + thick);
  }
  return Frustum(inner, outer, 3.2);
}

AnalyticSolid Mandible(const Head& head, std::vector<PhantomLandmark>& landmarks)
{
  const auto mark = [&](const std::string& name, double side, const glm::dvec3& point)
  {
    landmarks.push_back({ name + (side == 0.0   ? ""
                                   : side < 0.0 ? " right"
                                                : " left"),
      PhantomPart::Mandible, point });
  };
  const HorseshoeShape body = head.LowerArch();
  Solids bones{ body, head.Cone({ -9, -79, -100 }, 5.6, { 9, -79, -100 }, 5.6) }; // chin
  mark("menton", 0.0, body.PointAt(0.0) - glm::dvec3(0.0, 0.0, body.halfHeight + body.tube));
  for (const double side : { -1.0, 1.0 })
  {
    const double tip = side > 0 ? -47.0 : -50.0; // the right coronoid process is shorter
    bones.push_back(RamusPlate(head, side));
    const RoundConeShape coronoid =
      head.Cone(OnRamus(side, -33, -64), 4.0, OnRamus(side, -34, tip), 2.4);
    bones.emplace_back(coronoid);
    bones.emplace_back(head.Cone(OnRamus(side, -12, -64), 4.4, OnRamus(side, -6, -50), 3.9));
    const RoundConeShape condyle =
      head.Cone({ side * 48.5, -5, -48 }, 4.0, { side * 58.5, -6, -48.4 }, 3.8);
    bones.emplace_back(condyle);
    const glm::dvec3 angle = OnRamus(side, -9, -93);
    const RoundConeShape corner = head.Cone(angle, 4.4, OnRamus(side, -22, -97), 4.8);
    bones.emplace_back(corner);
    mark("coronoid tip", side, coronoid.b + glm::dvec3(0, 0, coronoid.radiusB));
    mark("condylion", side, condyle.a + glm::dvec3(0, 0, condyle.radiusA));
    mark("gonion", side, corner.a + corner.radiusA * glm::normalize(glm::dvec3(0, 1, -1)));
  }
  return AnalyticSolid::Union(bones);
}

struct Tooth
{
  RoundConeShape crown, root;
  int quadrant, number; ///< after the FDI: 36 is quadrant 3, number 6
};

/// The teeth of a jaw, side by side along its arch.
std::vector<Tooth> Teeth(const Head& head, bool upper)
{
  // Widths along the arch from the midline to the second molar, mm; roots, mm.
  constexpr std::array<double, 7> UpperWidths{ 8.5, 6.6, 7.6, 7.0, 6.8, 10.2, 9.4 };
  constexpr std::array<double, 7> LowerWidths{ 5.4, 5.9, 6.8, 7.0, 7.1, 11.0, 10.4 };
  constexpr std::array<double, 7> Roots{ 10.0, 9.5, 13.0, 11.0, 11.0, 10.0, 9.0 };
  const HorseshoeShape arch = upper ? head.UpperArch() : head.LowerArch();
  const double down = upper ? -1.0 : 1.0; // from the jaw to the tips
  const double rim = arch.center.z + down * (arch.halfHeight + arch.tube);
  std::vector<Tooth> teeth;
  for (const double side : { -1.0, 1.0 })
  {
    double along = 0.2;
    for (int n = 0; n < 7; ++n)
    {
      const double width = upper ? UpperWidths[n] : LowerWidths[n];
      const double middle = along + 0.5 * width;
      along += width + 0.3;
      const int quadrant = upper ? (side < 0 ? 1 : 2) : (side < 0 ? 4 : 3);
      if ((quadrant == 2 && n == 3) || (quadrant == 4 && n == 5))
        continue; // missing, so that no symmetry hides a flip
      const auto on = [&](double s, double height)
      {
        const glm::dvec3 p = arch.PointAt(side * s);
        return glm::dvec3(p.x, p.y, rim + down * height);
      };
      const double neck = std::min(0.40 * width, 3.7), tip = n < 3 ? 0.34 * width : 0.43 * width;
      Tooth tooth{ { on(middle, neck + 0.2), on(middle, 7.6 - tip), neck, tip },
        { on(middle, 1.0), on(middle, -Roots[n]), 0.9 * neck, 1.1 }, quadrant, n + 1 };
      if (n >= 5) // molars are long
      {
        const double half = 0.5 * width - 3.8;
        tooth.crown = { on(middle - half, 3.8), on(middle + half, 3.8), 3.8, 3.8 };
      }
      teeth.push_back(tooth);
    }
  }
  return teeth;
}

void AddTeeth(const Head& head, bool upper, PhantomShapes& shapes, Solids& crowns)
{
  Solids solids;
  for (const Tooth& tooth : Teeth(head, upper))
  {
    solids.emplace_back(tooth.crown);
    solids.emplace_back(tooth.root);
    crowns.emplace_back(tooth.crown);
    const int name = 10 * tooth.quadrant + tooth.number;
    if (head.settings.metal.on && (name == 36 || name == 47))
      shapes.metal.push_back(
        { tooth.crown.a, tooth.crown.b, tooth.crown.radiusA + 0.4, tooth.crown.radiusB + 0.4 });
    if (tooth.number == 1)
      shapes.landmarks.push_back({ "incisor " + std::to_string(name),
        upper ? PhantomPart::UpperTeeth : PhantomPart::LowerTeeth,
        tooth.crown.b + glm::dvec3(0, 0, (upper ? -1.0 : 1.0) * tooth.crown.radiusB) });
  }
  shapes.parts.emplace_back(
    upper ? PhantomPart::UpperTeeth : PhantomPart::LowerTeeth, AnalyticSolid::Union(solids));
}

void AddHead(const Head& head, PhantomShapes& shapes)
{
  Solids crowns;
  shapes.parts.emplace_back(PhantomPart::Cranium, Cranium(head));
  AddTeeth(head, true, shapes, crowns);
  shapes.parts.emplace_back(PhantomPart::Mandible, Mandible(head, shapes.landmarks));
  AddTeeth(head, false, shapes, crowns);
  shapes.enamel = AnalyticSolid::Union(crowns);
  shapes.skin =
    AnalyticSolid::Union({ EllipsoidShape{ head.settings.center, head.settings.skinRadii },
      head.Ellipsoid({ 0, -36, -78 }, { 50, 48, 34 }),         // cheeks and the floor of the mouth
      head.Cone({ 0, -6, -70 }, 42.0, { 0, 4, -76 }, 38.0) }); // neck
  shapes.airway = AnalyticSolid::Union(
    { Cavities(head)[0].space, head.Cone({ 0, -36, -44 }, 7.0, { 0, -20, -62 }, 7.0),
      head.Cone({ 0, -20, -62 }, 7.0, { 0, -16, -98 }, 6.0) });
}

} // namespace

PhantomShapes MakePhantomShapes(const PhantomSettings& settings)
{
  PhantomShapes shapes;
  if (settings.anatomy != PhantomAnatomy::Fibula)
    AddHead(Head(settings), shapes);
  if (settings.anatomy != PhantomAnatomy::Head)
  {
    const bool alone = settings.anatomy == PhantomAnatomy::Fibula;
    AddPhantomFibula(
      settings.center + glm::dvec3(alone ? 0.0 : 150.0, 0.0, 0.0), settings.fibulaCortexMm, shapes);
  }
  return shapes;
}

} // namespace hasp
