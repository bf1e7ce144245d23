#include "BrokenBlock.h"

#include "Reduction/Assembly.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
constexpr double Thick = 12.0;

/// A column of 24 x 18 mm broken in layers of 12 mm, in closed form; face n is below layer n. The
/// ends are flat.
struct BrokenColumn
{
  int layers = 4;

  double Height(int face, double x, double y) const
  {
    if (face == 0 || face == this->layers)
      return 0.0;
    const double phase = 1.7 * face;
    return 1.4 * (std::sin(0.55 * x + phase) * std::cos(0.43 * y - phase) +
                   0.5 * std::sin(0.83 * y - 0.71 * x + 2.0 * phase));
  }
  double Above(int face, const glm::dvec3& x) const
  {
    const double height = this->Height(face, x.x, x.y), step = 1e-4;
    const double dx = (this->Height(face, x.x + step, x.y) - height) / step;
    const double dy = (this->Height(face, x.x, x.y + step) - height) / step;
    return (x.z - Thick * face - height) / std::sqrt(1.0 + dx * dx + dy * dy);
  }

  hasp::PlacedBody Layer(int n) const
  {
    const glm::dvec3 low(-12.0, -9.0, Thick * n - 3.0), high(12.0, 9.0, Thick * (n + 1) + 3.0);
    const double margin = 8.0, spacing = 0.6;
    hasp::GridGeometry grid;
    grid.spacing = glm::dvec3(spacing);
    grid.origin = low - margin;
    grid.dims = glm::ivec3(glm::ceil((high - low + 2.0 * margin) / spacing)) + 1;
    std::vector<float> distances;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
        {
          const glm::dvec3 x = grid.IndexToWorld({ i, j, k });
          const glm::dvec2 q = glm::abs(glm::dvec2(x)) - glm::dvec2(12.0, 9.0);
          const double side =
            glm::length(glm::max(q, glm::dvec2(0.0))) + std::min(0.0, std::max(q.x, q.y));
          distances.push_back(float(std::max({ side, -this->Above(n, x), this->Above(n + 1, x) })));
        }
    const hasp::GridView<const float> view{ distances.data(), grid };
    const glm::dvec3 origin(0.0, 0.0, Thick * (n + 0.5));
    auto map = std::make_shared<const hasp::DistanceMap>(
      view, hasp::DistanceMapSettings{ .rangeMm = 7.0, .origin = origin });
    auto shell = hasp::PointShell::OfSurface(view, origin, { .points = 1024 });
    return { std::make_shared<const hasp::FitBody>(std::move(map), std::move(shell)), { origin } };
  }
};

const std::vector<hasp::PlacedBody>& Column()
{
  static const std::vector<hasp::PlacedBody> layers = []
  {
    const BrokenColumn column;
    std::vector<hasp::PlacedBody> made;
    for (int n = 0; n < column.layers; ++n)
      made.push_back(column.Layer(n));
    return made;
  }();
  return layers;
}

/// All of the column, each layer a little more off than the one below.
std::vector<hasp::AssemblyUnit> CoarseUnits()
{
  std::vector<hasp::AssemblyUnit> units;
  for (std::size_t n = 0; n < Column().size(); ++n)
  {
    const double off = double(n);
    units.push_back({ { { Column()[n].body, {} } },
      Moved(Column()[n].bodyInWorld, { 0.6 * off, -0.5 * off, 0.5 * off },
        { 1.0, double(n % 2), 0.5 }, 1.2 * off) });
  }
  units[0].fixed = true;
  return units;
}

hasp::AssemblySettings FewStarts()
{
  hasp::AssemblySettings settings;
  settings.proposals.starts = 4;
  settings.rounds = 2;
  return settings;
}
} // namespace

TEST(Assembly, RefusesWhatItCannotUse)
{
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  units[1].bodies.clear();
  EXPECT_THROW(hasp::Assemble(units), std::invalid_argument);
  units = CoarseUnits();
  units[1].partners = { 9 };
  EXPECT_THROW(hasp::Assemble(units), std::invalid_argument);
  units = CoarseUnits();
  units[1].partners = { 1 };
  EXPECT_THROW(hasp::Assemble(units), std::invalid_argument);
  units = CoarseUnits();
  hasp::AssemblySettings settings;
  settings.rounds = -1;
  EXPECT_THROW(hasp::Assemble(units, settings), std::invalid_argument);
  settings = {};
  settings.leastFacesMm2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hasp::Assemble(units, settings), std::invalid_argument);
}

TEST(Assembly, PutsLayersOnEachOtherFromTheFixedOneUp)
{
  const std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  const auto made = hasp::Assemble(units, FewStarts());
  ASSERT_EQ(made.size(), units.size());
  EXPECT_EQ(made[0].turn, 0);
  EXPECT_EQ(made[0].groupInWorld, units[0].groupInWorld);
  for (std::size_t n = 1; n < made.size(); ++n)
  {
    EXPECT_TRUE(made[n].placed);
    EXPECT_EQ(made[n].turn, int(n)); // whatever is next to nothing has to wait
    const double off = hasp::RmsWay(units[n].bodies, Column()[n].bodyInWorld, made[n].groupInWorld);
    EXPECT_LT(off, 0.1) << n; // a sixth of a voxel, for the layers' edges are rounded
  }
}

TEST(Assembly, KeepsGroupsTogether)
{
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  // Layers 2 and 3 as they were scanned, moved as one.
  const hasp::RigidPose group = units[2].groupInWorld * Column()[2].bodyInWorld.Inverse();
  units[2].bodies = { { Column()[2].body, Column()[2].bodyInWorld },
    { Column()[3].body, Column()[3].bodyInWorld } };
  units[2].groupInWorld = group;
  units.pop_back();
  const auto made = hasp::Assemble(units, FewStarts());
  ASSERT_TRUE(made[2].placed);
  for (std::size_t n = 0; n < 2; ++n)
    EXPECT_LT(hasp::RmsWay(std::vector<hasp::GroupBody>{ { Column()[2 + n].body, {} } },
                Column()[2 + n].bodyInWorld, made[2].groupInWorld * units[2].bodies[n].bodyInGroup),
      0.1);
}

TEST(Assembly, LeavesWhatNothingReachesWhereItIs)
{
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  units[3].groupInWorld.position.x += 200.0;
  const auto made = hasp::Assemble(units, FewStarts());
  EXPECT_TRUE(made[2].placed);
  EXPECT_FALSE(made[3].placed);
  EXPECT_EQ(made[3].groupInWorld, units[3].groupInWorld);
}

TEST(Assembly, ASwappedPieceFitsWorse)
{
  // Layer 2 where layer 1 was, on layer 0.
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  units.resize(2);
  const auto right = hasp::Assemble(units, FewStarts());
  units[1].bodies = { { Column()[2].body, {} } };
  const auto swapped = hasp::Assemble(units, FewStarts());
  EXPECT_GT(swapped[1].fit.sums.energy, 0.5 * right[1].fit.sums.energy);
  EXPECT_LT(swapped[1].fit.sums.facesMm2, 0.7 * right[1].fit.sums.facesMm2);
}

TEST(Assembly, IsTheSameEachTime)
{
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  units.resize(2);
  const auto a = hasp::Assemble(units, FewStarts());
  const auto b = hasp::Assemble(units, FewStarts());
  for (std::size_t n = 0; n < a.size(); ++n)
    EXPECT_EQ(a[n].groupInWorld, b[n].groupInWorld);
}

TEST(Assembly, WithoutAFixedUnitTheLargestStays)
{
  std::vector<hasp::AssemblyUnit> units = CoarseUnits();
  units[0].fixed = false;
  const auto made = hasp::Assemble(units, FewStarts());
  EXPECT_EQ(std::count_if(made.begin(), made.end(),
              [](const hasp::AssembledUnit& unit) { return unit.placed && unit.turn == 0; }),
    1);
}

namespace
{
/// Layers in their places; one before the other only, or the lowest as well before the ground.
std::vector<hasp::FitSpread> SpreadsOfColumn(
  std::size_t moving, bool together, const glm::dvec3& about = glm::dvec3(0.0))
{
  std::vector<std::vector<hasp::GroupBody>> bodies;
  std::vector<hasp::SpreadUnit> units;
  std::vector<hasp::SpreadPair> pairs;
  for (std::size_t n = 1; n <= moving; ++n)
    bodies.push_back({ { Column()[n].body, hasp::RigidPose{ -about } } });
  for (std::size_t n = 1; n <= moving; ++n)
  {
    hasp::RigidPose group = Column()[n].bodyInWorld;
    group.position += about;
    units.push_back({ bodies[n - 1], group });
    hasp::SpreadPair below{ n - 1, {}, { { Column()[n - 1] }, {} } };
    if (n > 1 && together)
      below.other = n - 2;
    pairs.push_back(below);
  }
  return hasp::MeasureSpreads(units, pairs, {});
}
} // namespace

// Springs in a row: the end of a chain is as far off as all its links together.
TEST(Assembly, ErrorsAddUpFromLayerToLayer)
{
  const auto alone = SpreadsOfColumn(3, false), together = SpreadsOfColumn(3, true);
  EXPECT_NEAR(together[0].within95Mm, alone[0].within95Mm, 0.02 * alone[0].within95Mm);
  for (std::size_t n = 1; n < 3; ++n)
  {
    EXPECT_GT(together[n].within95Mm, 1.1 * together[n - 1].within95Mm);
    EXPECT_GT(together[n].within95Mm, 1.2 * alone[n].within95Mm);
  }
}

// A pull on one body is the opposite pull on the other, wherever their origins are.
TEST(Assembly, SpreadsAskNotWhereAGroupsOriginIs)
{
  const auto here = SpreadsOfColumn(2, true),
             there = SpreadsOfColumn(2, true, { 30.0, -50.0, 20.0 });
  for (std::size_t n = 0; n < 2; ++n)
    for (const std::size_t turn : { 15, 18, 20 }) // variances about x, y and z
      EXPECT_NEAR(
        there[n].covariance[turn], here[n].covariance[turn], 0.01 * here[n].covariance[turn]);
}

// A chip is not loose because a skull is put together with it: four hundred layers that move as one
// are held four hundred times as well as one is.
TEST(Assembly, ASmallPieceIsHeldAsItIsHeldAlone)
{
  const std::vector<hasp::GroupBody> small{ { Column()[1].body, {} } }, large(400, small[0]);
  const std::vector<hasp::SpreadUnit> both{ { large, Column()[1].bodyInWorld },
    { small, Column()[1].bodyInWorld } };
  const hasp::FitScene ground{ { Column()[0] }, {} };
  const std::vector<hasp::SpreadPair> pairs{ { 0, {}, ground }, { 1, {}, ground } };
  hasp::FitSettings settings;
  settings.points = 256;
  const auto together = hasp::MeasureSpreads(both, pairs, settings);
  const auto alone = hasp::MeasureSpreads({ &both[1], 1 }, { &pairs[0], 1 }, settings);
  EXPECT_LT(alone[0].within95Mm, 1.0);
  EXPECT_NEAR(together[1].within95Mm, alone[0].within95Mm, 0.05 * alone[0].within95Mm);
}

TEST(Assembly, SpreadsOfNothingAndOfWhatNothingHoldsAreFinite)
{
  EXPECT_TRUE(hasp::MeasureSpreads({}, {}, {}).empty());
  const std::vector<hasp::GroupBody> body{ { Column()[1].body, {} } };
  const hasp::SpreadUnit free{ body, Column()[1].bodyInWorld };
  const std::vector<hasp::FitSpread> spreads = hasp::MeasureSpreads({ &free, 1 }, {}, {});
  ASSERT_EQ(spreads.size(), 1u);
  EXPECT_TRUE(std::isfinite(spreads[0].within95Mm));
  EXPECT_GT(spreads[0].within95Mm, 4.0);
}
