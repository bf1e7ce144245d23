// Implants that cannot be made: what is said, and where.
#include "ImplantFixture.h"

using namespace implanttest;

namespace
{

const Scan& Head()
{
  static const Scan scan(1.5);
  return scan;
}

template <typename Change>
std::string Fault(const Change& change)
{
  hasp::ImplantRecipe recipe = AroundTheHole(Head());
  recipe.spacingMm = 1.0;
  change(recipe);
  return FaultOf(Head(), recipe);
}

void ExpectSays(const std::string& said, const std::string& words)
{
  EXPECT_NE(said.find(words), std::string::npos) << "said: " << said;
}

TEST(ImplantFaults, NoneOfThePlainOne)
{
  EXPECT_EQ(Fault([](auto&) {}), "");
}

TEST(ImplantFaults, OutlinesThatAreNone)
{
  const hasp::PhantomDefect hole = Head().Hole();
  ExpectSays(Fault([](auto& r) { r.clearanceMm = -1; }), "clearanceMm is -1");
  // In the air of the hole.
  ExpectSays(Fault([&](auto& r) { r.outline[3] = hole.center + 4.0 * hole.outward; }),
    "implant: outline[3] (");
  // On one line.
  ExpectSays(
    Fault(
      [&](auto& r) {
        r.outline = { OnTable(Head(), -10, 30), OnTable(Head(), 0, 30), OnTable(Head(), 10, 30) };
      }),
    "encloses next to nothing");
  // Around twice.
  ExpectSays(Fault(
               [](auto& r)
               {
                 const auto once = r.outline;
                 r.outline.insert(r.outline.end(), once.begin(), once.end());
               }),
    "the outline meets itself, seen along the axis: after outline[0]");
  ExpectSays(Fault([](auto& r) { std::swap(r.outline[2], r.outline[3]); }), "meets itself");
}

TEST(ImplantFaults, OutlinesThatAreNotAroundOneHole)
{
  const hasp::PhantomDefect hole = Head().Hole();
  // Over whole bone behind the hole.
  ExpectSays(Fault(
               [&](auto& r)
               {
                 r.outline = { OnTable(Head(), 5, 24), OnTable(Head(), -5, 24),
                   OnTable(Head(), -5, 34), OnTable(Head(), 5, 34) };
               }),
    "there is no hole within the outline");
  // Across it: from rim to rim.
  ExpectSays(Fault(
               [&](auto& r)
               {
                 const double y = 0.5 * hole.widthMm + 4.0, x = 0.5 * hole.lengthMm + 4.0;
                 r.outline = { OnTable(Head(), 0, -y), OnTable(Head(), x, -y),
                   OnTable(Head(), x, y), OnTable(Head(), 0, y) };
               }),
    "the hole is open: there is no bone below the outline between outline[3] and outline[0]");
}

TEST(ImplantFaults, AxesThatItCannotBePutInAlong)
{
  ExpectSays(Fault([](auto& r) { r.axis = -*r.axis; }), "the axis is 180 degrees from upright");
  ExpectSays(Fault([](auto& r) { r.axis = Head().Hole().along; }), "degrees from upright");
}

TEST(ImplantFaults, MirroredSidesThatDoNotFit)
{
  ExpectSays(Fault(
               [](auto& r) {
                 r.mirror = hasp::MirrorPlane{ { 300, 0, 0 }, { 1, 0, 0 } };
               }),
    "there is no mirrored bone's surface around the outline");
  ExpectSays(Fault(
               [](auto& r) {
                 r.mirror = hasp::MirrorPlane{ { 8, 0, 0 }, { 1, 0, 0 } };
               }),
    "mirrored bone does not meet the bone around the hole");
  ExpectSays(Fault([](auto& r) { r.isovalue = 30000; }), "no bone");
  // The other side has a hole, too.
  Scan both(1.5);
  const hasp::GridGeometry& g = both.grid;
  const hasp::PhantomDefect hole = both.Hole();
  for (std::size_t n = 0; n < both.samples.size(); ++n)
  {
    glm::dvec3 p = g.IndexToWorld({ double(n % g.dims.x), double(n / g.dims.x % g.dims.y),
      double(n / (std::size_t(g.dims.x) * g.dims.y)) });
    p.x = -p.x;
    const glm::dvec3 q = p - hole.center;
    if (std::abs(glm::dot(q, hole.along)) < 8 && std::abs(glm::dot(q, hole.across)) < 8 &&
        glm::dot(q, hole.outward) > -30)
      both.samples[n] = 40;
  }
  hasp::ImplantRecipe recipe = AroundTheHole(both);
  recipe.spacingMm = 1.0;
  ExpectSays(FaultOf(both, recipe), "it has a hole or an edge, too, mirrored to (");
}

TEST(ImplantFaults, PerforationWithoutRoom)
{
  ExpectSays(Fault(
               [](auto& r)
               {
                 r.holeDiameterMm = 12;
                 r.holePitchMm = 20;
                 r.holeEdgeMm = 10;
               }),
    "it has no room for a hole");
}

TEST(ImplantFaults, TwoHolesWithinTheOutline)
{
  // A bar of bone across the hole.
  Scan barred(1.5);
  const hasp::GridGeometry& g = barred.grid;
  const hasp::PhantomDefect hole = barred.Hole();
  for (std::size_t n = 0; n < barred.samples.size(); ++n)
  {
    const glm::dvec3 p = g.IndexToWorld({ double(n % g.dims.x), double(n / g.dims.x % g.dims.y),
      double(n / (std::size_t(g.dims.x) * g.dims.y)) });
    const glm::dvec3 q = p - hole.center;
    if (std::abs(glm::dot(q, hole.along) - 5) < 2 && std::abs(glm::dot(q, hole.across)) < 20 &&
        glm::dot(q, hole.outward) > -8 && glm::dot(q, hole.outward) < -1)
      barred.samples[n] = 1000;
  }
  hasp::ImplantRecipe recipe = AroundTheHole(barred);
  recipe.spacingMm = 1.0;
  ExpectSays(FaultOf(barred, recipe), "there is more than one hole within the outline");
}

} // namespace
