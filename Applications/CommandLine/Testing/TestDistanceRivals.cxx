#include "Distance/NearSurface.h"
#include "Distance/SolidShapes.h"
#include "DistanceErrors.h"
#include "Evaluation/MeshCheck.h"
#include "RandomTree.h"
#include "TrialShapes.h"
#include "VtkRivals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace hasp;

TEST(DistanceRivals, VtksTransformsAreOffByWhatIsKnownOfThem)
{
  const AnalyticVolume ball = AnalyticSphere(0.31 * glm::dvec3(TrialVoxelMm), 5.0);
  TransformInput input;
  input.grid = TrialGrid(40);
  input.coverage = ExactCoverage(ball, input.grid);
  input.mask = MaskOf(input.coverage);
  const auto rmsOf = [&](const RivalTransform& rival)
  {
    const auto run = rival.make(input);
    run->Run();
    run->Run(); // again, as in a race
    DistanceErrors errors(TrialVoxelMm);
    AddErrors(run->Distances(), TrueDistances(ball, input.grid), input.grid, {}, "ball", errors);
    return errors.Rms();
  };
  EXPECT_NEAR(rmsOf(VtkEuclideanRival()), 0.24, 0.02); // that of any exact distance to a mask
  EXPECT_LT(rmsOf(VtkPointsRival()), 0.3);
}

TEST(DistanceRivals, FlyingEdgesAreOutwardsAndInMillimetres)
{
  const GridGeometry grid = TrialGrid(40);
  const SolidPointer ball = MakeCapsule(glm::dvec3(0.1), glm::dvec3(0.1), 5.0);
  const TriangleMesh mesh =
    FlyingEdges().make(DenseValues(EvaluateNearSurface(*ball, grid, 1.2)), grid);
  const MeshCheck check = CheckMesh(WeldPoints(mesh));
  EXPECT_TRUE(check.Closed());
  EXPECT_NEAR(std::abs(check.volumeMm3) / (4.0 / 3.0 * 3.14159265 * 125.0), 1.0, 0.01);
}

TEST(DistanceRivals, BooleansOfOneLeafAreTheLeaf)
{
  const BooleanRival rival = VtkBooleans();
  ASSERT_TRUE(rival.absent.empty()) << rival.absent;
  RandomTreeSettings settings;
  settings.depth = 0;
  settings.meshes = true;
  int leaves = 0;
  for (std::uint32_t seed = 1; seed < 12; ++seed)
  {
    const SolidNode tree = RandomTree(seed, settings);
    if (!tree.parts.empty()) // a slot
      continue;
    const BooleanOutcome outcome = rival.run(seed, 0);
    ++leaves;
    EXPECT_EQ(outcome.ending, "");
    EXPECT_TRUE(outcome.closed && outcome.manifold) << seed;
    EXPECT_LE(outcome.crossings, 0);
    EXPECT_NEAR(outcome.volumeMm3 / VolumeOf(*SolidOf(tree), 8.0, 0.05), 1.0, 5e-3) << seed;
  }
  EXPECT_GE(leaves, 5);
  EXPECT_EQ(rival.run(1, 99).ending, "exit code 1"); // a depth that is refused
}

} // namespace
