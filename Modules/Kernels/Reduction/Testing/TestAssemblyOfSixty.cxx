#include "BrokenBlock.h"

#include "Grid/FinitePose.h"
#include "Reduction/Assembly.h"

#include <gtest/gtest.h>

namespace
{
constexpr double TileMm = 12.0;

/// A plate of 120 x 72 x 10 mm broken into sixty tiles by rough faces, in closed form.
struct BrokenPlate
{
  static constexpr int Columns = 10, Rows = 6;

  static double Wave(int face, double along, double up)
  {
    return 0.9 * (std::sin(0.8 * along + 1.7 * face) * std::cos(0.6 * up - face) +
                   0.5 * std::sin(1.1 * up - 0.7 * along + 2.3 * face));
  }
  /// Beyond face `face` of an axis (0: between columns, 1: between rows), about mm.
  static double Beyond(int axis, int face, const glm::dvec3& x)
  {
    const int last = axis == 0 ? Columns : Rows;
    const double along = axis == 0 ? x.y : x.x;
    const int seed = face + 20 * axis;
    if (face == 0 || face == last)
      return x[axis] - TileMm * face;
    const double wave = Wave(seed, along, x.z), step = 1e-4;
    const double slope = (Wave(seed, along + step, x.z) - wave) / step;
    const double rise = (Wave(seed, along, x.z + step) - wave) / step;
    return (x[axis] - TileMm * face - wave) / std::sqrt(1.0 + slope * slope + rise * rise);
  }

  static hasp::PlacedBody Tile(int column, int row)
  {
    const glm::dvec3 origin(TileMm * (column + 0.5), TileMm * (row + 0.5), 0.0);
    const double spacing = 0.75;
    hasp::GridGeometry grid;
    grid.spacing = glm::dvec3(spacing);
    const glm::dvec3 half(0.5 * TileMm + 6.0, 0.5 * TileMm + 6.0, 5.0 + 4.5);
    grid.origin = origin - half;
    grid.dims = glm::ivec3(glm::ceil(2.0 * half / spacing)) + 1;
    std::vector<float> distances;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i)
        {
          const glm::dvec3 x = grid.IndexToWorld({ i, j, k });
          distances.push_back(float(std::max({ std::abs(x.z) - 5.0, -Beyond(0, column, x),
            Beyond(0, column + 1, x), -Beyond(1, row, x), Beyond(1, row + 1, x) })));
        }
    const hasp::GridView<const float> view{ distances.data(), grid };
    auto map = std::make_shared<const hasp::DistanceMap>(
      view, hasp::DistanceMapSettings{ .rangeMm = 4.0, .origin = origin });
    auto shell = hasp::PointShell::OfSurface(view, origin, { .points = 1024, .coarsest = 256 });
    return { std::make_shared<const hasp::FitBody>(std::move(map), std::move(shell)), { origin } };
  }
};
} // namespace

TEST(AssemblyOfSixty, PiecesMeetTheirNeighboursAndErrorsPileUpToTwoVoxels)
{
  std::vector<hasp::AssemblyUnit> units;
  std::vector<hasp::RigidPose> truth;
  for (int n = 0; n < BrokenPlate::Columns * BrokenPlate::Rows; ++n)
  {
    const hasp::PlacedBody tile =
      BrokenPlate::Tile(n % BrokenPlate::Columns, n / BrokenPlate::Columns);
    const double angle = 2.4 * n; // each elsewhere off by 1 mm and 3 degrees
    truth.push_back(tile.bodyInWorld);
    units.push_back({ { { tile.body, {} } },
      Moved(tile.bodyInWorld, { 0.7 * std::cos(angle), 0.7 * std::sin(angle), n % 2 ? 0.7 : -0.7 },
        { std::sin(angle), 0.3, std::cos(angle) }, 3.0),
      false, {} });
  }
  const std::size_t middle = 25;
  units[middle].groupInWorld = truth[middle];
  units[middle].fixed = true;
  hasp::AssemblySettings settings;
  settings.proposals.starts = 1;
  settings.proposals.fit.captureMm = 3.0;
  settings.proposals.fit.coarsePoints = 256;
  settings.proposals.fit.points = 1024;
  settings.rounds = 1;
  const auto made = hasp::Assemble(units, settings);
  ASSERT_EQ(made.size(), 60U);
  for (std::size_t n = 0; n < made.size(); ++n)
  {
    ASSERT_TRUE(hasp::IsFinite(made[n].groupInWorld)) << n;
    EXPECT_TRUE(made[n].placed) << n;
    // They begin up to 1.4 mm off. A voxel is 0.75 mm: columns that slid along a face go together,
    // and no single piece can take them back.
    EXPECT_LT(hasp::RmsWay(units[n].bodies, truth[n], made[n].groupInWorld), 1.5) << n;
    if (n % BrokenPlate::Columns == 0)
      continue;
    // Where the one to the left has it, all the same.
    const hasp::RigidPose beside = made[n - 1].groupInWorld * truth[n - 1].Inverse() * truth[n];
    EXPECT_LT(hasp::RmsWay(units[n].bodies, beside, made[n].groupInWorld), 0.5) << n;
  }
}
