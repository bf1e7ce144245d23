#include "Studies/SampledLoop.h"
#include "Studies/StabilityCases.h"

#include <cmath>

namespace hasp
{
namespace
{

struct Shape
{
  std::string id, text;
  std::shared_ptr<const ImplicitField> body;
  std::vector<glm::dvec3> points;
  double touching;          ///< points that touch at once, about
  glm::dvec3 moveMm{ 0.0 }; ///< of the hand, beyond its start
  glm::dvec3 turn{ 0.0 };
  glm::dvec3 startMm{ 0.0 };
  double scale = 1.0; ///< of voxel, speed and tool
};

std::vector<Shape> Shapes()
{
  std::vector<Shape> shapes;
  for (const double degrees : { 20.0, 45.0, 70.0 })
  {
    auto groove = std::make_shared<GrooveBody>();
    groove->slope = degrees * std::acos(-1.0) / 180.0;
    shapes.push_back(
      { "groove" + Figure(degrees), "groove with flanks of " + Figure(degrees) + " degrees", groove,
        PegPoints(2.0, 6.0, 2, 8), 2.0, { 0.3, 0.0, -12.0 }, {}, { 0.0, 0.0, 8.0 } });
  }
  auto hole = std::make_shared<HoleBody>();
  const auto peg = PegPoints(4.9, 20.0, 3, 12); // 0.1 mm of clearance
  shapes.push_back({ "peg.side", "peg in a hole with 0.1 mm of clearance, pressed aside", hole, peg,
    6.0, { 3.0, 0.5, -5.0 } });
  shapes.push_back(
    { "peg.tilt", "the same peg, tilted", hole, peg, 6.0, { 0.0, 0.0, -5.0 }, { 0.0, 0.2, 0.0 } });
  shapes.push_back({ "peg.both", "the same peg, pressed aside and tilted", hole, peg, 6.0,
    { 2.0, 0.0, 0.0 }, { 0.1, 0.1, 0.3 } });
  auto slot = std::make_shared<SlotBody>();
  shapes.push_back(
    { "slot.fits", "two walls one tool apart", slot, FootPoints(3, 10.0), 3.0, { 2.0, 0.0, 0.0 } });
  auto narrow = std::make_shared<SlotBody>();
  narrow->half = 4.95;
  shapes.push_back({ "slot.tight", "two walls 0.1 mm closer than the tool is wide", narrow,
    FootPoints(3, 10.0), 6.0, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 0.1 } });
  auto ball = std::make_shared<BallBody>();
  shapes.push_back({ "ball.top", "a point on top of a ball", ball, TipPoints(), 1.0,
    { 0.0, 0.0, -4.0 }, {}, { 0.0, 0.0, 11.0 } });
  shapes.push_back({ "ball.foot", "a foot on top of a ball", ball, FootPoints(3, 10.0), 1.0,
    { 0.0, 0.0, -4.0 }, {}, { 0.0, 0.0, 11.0 } });
  const auto wall = std::make_shared<WallBody>();
  shapes.push_back({ "wall.line", "points on one line, laid on a wall", wall, LinePoints(7, 20.0),
    7.0, { 0.0, 0.0, -4.0 }, { 0.5, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } });
  shapes.push_back({ "groove.line", "points on one line across a groove", shapes.front().body,
    LinePoints(7, 20.0), 2.0, { 0.0, 0.0, -5.0 }, { 0.5, 0.0, 0.1 }, { 0.0, 0.0, 5.0 } });
  shapes.push_back({ "wall.none", "a tool without points", wall, {}, 1.0, { 0.0, 0.0, -4.0 }, {},
    { 0.0, 0.0, 1.0 } });
  shapes.push_back({ "wall.tilted", "a foot that comes tilted", wall, FootPoints(5, 10.0), 25.0,
    { 0.0, 0.0, -4.0 }, { 0.3, 0.2, 0.1 }, { 0.0, 0.0, 4.0 } });
  auto slanted = std::make_shared<WallBody>();
  slanted->normal = { 0.48, 0.6, 0.64 };
  shapes.push_back({ "wall.slanted", "a slanted wall", slanted, FootPoints(3, 10.0), 1.0,
    { 0.0, 0.0, -6.0 }, {}, { 0.0, 0.0, 9.0 } });
  auto seed = std::make_shared<BallBody>();
  seed->radius = 0.5;
  shapes.push_back({ "scale.1mm", "a ball of 1 mm under a foot of 0.5 mm", seed, FootPoints(3, 0.5),
    1.0, { 0.0, 0.0, -0.2 }, {}, { 0.0, 0.0, 0.55 }, 0.05 });
  auto house = std::make_shared<BallBody>();
  house->radius = 5000.0;
  shapes.push_back({ "scale.10m", "a ball of 10 m under a foot of 5 m", house,
    FootPoints(3, 5000.0), 1.0, { 0.0, 0.0, -4.0 }, {}, { 0.0, 0.0, 5001.0 }, 500.0 });
  auto far = std::make_shared<WallBody>();
  far->height = -10'000.0;
  shapes.push_back({ "scale.far", "a wall 10 m from the origin", far, FootPoints(3, 10.0), 9.0,
    { 0.0, 0.0, -4.0 }, {}, { 0.0, 0.0, -9999.0 } });
  return shapes;
}

} // namespace

// Wedges, pegs, slots, lines, scales: in each the device feels no more than its coupling, so what
// holds on a wall holds here.
void AddShapeRows(std::vector<StabilityRow>& rows)
{
  for (const Shape& shape : Shapes())
    for (const BenchHand& hand : { LooseHand(), FirmHand() })
      for (const double stiffness : { 1.0, 100.0 })
      {
        StabilityCase made;
        made.scene.device = Frictionless(FalconLike());
        made.scene.hand = hand;
        made.scene.start.position = shape.startMm;
        made.scene.strokes = { { 0.1, 0.4, shape.moveMm, shape.turn } };
        made.scene.pressed = !shape.points.empty();
        made.body = shape.body;
        made.points = shape.points;
        made.stiffness = stiffness;
        made.touching = shape.touching;
        double radius = 1e-3 * shape.scale;
        for (const glm::dvec3& point : shape.points)
          radius = std::max(radius, std::hypot(point.x, point.y, point.z));
        made.coupling =
          DefaultCoupling(made.scene.device, made.scene.clock, 0.5 * shape.scale, radius);
        StabilityRow row;
        row.id = "shape." + shape.id + ".k" + Figure(stiffness) + "." + hand.name;
        row.text = shape.text + ", contact " + Figure(stiffness) + " N/mm, hand " + hand.name;
        row.byDefault = true;
        row.law = "spectral radius of a tick, at most";
        row.figure = SampledLoop(made.scene.device, hand, made.scene.clock)
                       .SpringRadius(made.coupling.spring.stiffness);
        HoldWhenSettled(made.scene, SettlingRate(made.scene.clock, row.figure));
        RunQuasiStatic(row, made);
        rows.push_back(std::move(row));
      }
}

} // namespace hasp
