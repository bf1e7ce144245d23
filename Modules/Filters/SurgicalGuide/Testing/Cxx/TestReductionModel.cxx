#include "ReductionModel.h"

#include "CutFixture.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace
{

hasp::TriangleMesh Box(const glm::dvec3& low, const glm::dvec3& high)
{
  hasp::TriangleMesh mesh;
  for (int c = 0; c < 8; ++c)
    mesh.points.emplace_back(
      c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
  for (const glm::uvec4& q : { glm::uvec4(0, 4, 6, 2), { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
         { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } })
  {
    mesh.triangles.emplace_back(q.x, q.y, q.z);
    mesh.triangles.emplace_back(q.x, q.z, q.w);
  }
  return mesh;
}

/// Closed, 2-manifold, outward, and free of self-intersections.
hasp::MeshCheck ExpectPrintable(const hasp::TriangleMesh& mesh)
{
  const hasp::MeshCheck check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  return check;
}

hasp::RigidPose Shifted(const glm::dvec3& by)
{
  return { by, { 1.0, 0.0, 0.0, 0.0 } };
}

const hasp::TriangleMesh Twenty = Box({ 0, 0, 0 }, { 20, 18, 16 });
constexpr double TwentyMm3 = 20.0 * 18.0 * 16.0;

std::string Fault(std::span<const hasp::PosedMesh> fragments, double spacingMm = 1.0)
{
  try
  {
    hasp::UniteFragments(fragments, spacingMm);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(ReductionModel, RefusesByName)
{
  EXPECT_EQ(Fault({}), "there are no fragments to be united");
  const hasp::PosedMesh one{ &Twenty, {} };
  for (const double spacing : { 0.0, -1.0, 5.1, std::nan("") })
    EXPECT_NE(Fault(std::span(&one, 1), spacing).find("spacingMm is"), std::string::npos);
  EXPECT_NE(Fault(std::span(&one, 1), 0.01).find("spacing"), std::string::npos);
  const hasp::TriangleMesh empty;
  hasp::TriangleMesh turned = Twenty, open = Twenty, wild = Twenty;
  for (glm::uvec3& t : turned.triangles)
    std::swap(t.x, t.y);
  open.triangles.pop_back();
  wild.triangles[3].z = 8;
  const auto second = [&](const hasp::TriangleMesh* mesh, const hasp::RigidPose& pose = {})
  {
    const hasp::PosedMesh both[] = { one, { mesh, pose } };
    return Fault(both);
  };
  EXPECT_EQ(second(nullptr), "fragments[1] has no triangles");
  EXPECT_EQ(second(&empty), "fragments[1] has no triangles");
  EXPECT_EQ(second(&turned), "fragments[1] encloses no volume, or is inside out");
  EXPECT_EQ(second(&wild), "fragments[1] has a triangle that names a point that is not there");
  EXPECT_NE(second(&open).find("closed"), std::string::npos);
  EXPECT_NE(
    second(&Twenty, { {}, { 2, 0, 0, 0 } }).find("fragments[1] has a pose"), std::string::npos);
  EXPECT_NE(second(&Twenty, Shifted({ std::nan(""), 0, 0 })).find("fragments[1] has a pose"),
    std::string::npos);
}

TEST(ReductionModel, BoxesThatOverlapCountOnce)
{
  const hasp::PosedMesh both[] = { { &Twenty, {} }, { &Twenty, Shifted({ 7.3, 4.1, -3.7 }) } };
  const auto check = ExpectPrintable(hasp::UniteFragments(both, 0.5));
  EXPECT_EQ(check.pieces, 1U);
  const double truth = 2 * TwentyMm3 - (20 - 7.3) * (18 - 4.1) * (16 - 3.7);
  EXPECT_NEAR(check.volumeMm3, truth, 0.01 * truth);
}

TEST(ReductionModel, OneBoxTwiceInOnePlaceIsThatBox)
{
  const hasp::PosedMesh both[] = { { &Twenty, {} }, { &Twenty, {} } };
  const auto check = ExpectPrintable(hasp::UniteFragments(both, 0.5));
  EXPECT_EQ(check.pieces, 1U);
  EXPECT_NEAR(check.volumeMm3, TwentyMm3, 0.01 * TwentyMm3);
}

TEST(ReductionModel, BoxesApartStayTwo)
{
  const hasp::PosedMesh both[] = { { &Twenty, {} }, { &Twenty, Shifted({ 22.0, 0, 0 }) } };
  const auto check = ExpectPrintable(hasp::UniteFragments(both, 0.5));
  EXPECT_EQ(check.pieces, 2U);
  EXPECT_NEAR(check.volumeMm3, 2 * TwentyMm3, 0.02 * TwentyMm3);
}

TEST(ReductionModel, BoxesThatShareAFaceAreOne)
{
  // Wherever the face lies in the grid, and turned out of its axes.
  const hasp::RigidPose turned{ { 3, 2, 1 },
    hasp::TurnBy(0.7 * glm::normalize(glm::dvec3(1, -2, 3))) };
  for (const double at : { 20.0, 20.0 / 3.0 })
    for (const hasp::RigidPose& place : { hasp::RigidPose{}, turned })
    {
      const hasp::TriangleMesh left = Box({ 0, 0, 0 }, { at, 18, 16 });
      const hasp::TriangleMesh right = Box({ at, 0, 0 }, { 30, 18, 16 });
      const hasp::PosedMesh both[] = { { &left, place }, { &right, place } };
      const auto check = ExpectPrintable(hasp::UniteFragments(both, 0.5));
      EXPECT_EQ(check.pieces, 1U) << at;
      EXPECT_NEAR(check.volumeMm3, 1.5 * TwentyMm3, 0.015 * TwentyMm3) << at;
    }
}

TEST(ReductionModel, HollowsStay)
{
  hasp::TriangleMesh hollow = Twenty;
  hasp::TriangleMesh inner = Box({ 5, 5, 5 }, { 15, 13, 11 });
  for (glm::uvec3& t : inner.triangles)
    hollow.triangles.emplace_back(t.y + 8, t.x + 8, t.z + 8);
  hollow.points.insert(hollow.points.end(), inner.points.begin(), inner.points.end());
  const hasp::PosedMesh one{ &hollow, {} };
  const auto check = ExpectPrintable(hasp::UniteFragments(std::span(&one, 1), 0.5));
  EXPECT_EQ(check.pieces, 2U);
  const double truth = TwentyMm3 - 10.0 * 8.0 * 6.0;
  EXPECT_NEAR(check.volumeMm3, truth, 0.01 * truth);
}

TEST(ReductionModel, ThePhantomsCutJawComesTogether)
{
  const cuttest::BoneScan scan = cuttest::ScanOfJaw();
  const hasp::CutRecipe recipe = cuttest::JawCuts();
  const hasp::CutBone cut = hasp::CutFragments({ scan.View(), {}, 1 }, recipe);
  ASSERT_EQ(cut.fragments.size(), 3U);
  std::vector<hasp::PosedMesh> fragments;
  double sum = 0.0;
  for (const hasp::BoneFragment& fragment : cut.fragments)
  {
    fragments.push_back({ &fragment.mesh, {} });
    sum += fragment.volumeMm3;
  }
  const auto apart = ExpectPrintable(hasp::UniteFragments(fragments, 0.6));
  EXPECT_NEAR(apart.volumeMm3, sum, 0.01 * sum);
  // Both pieces behind the first cut come forward by more than its kerf of 1.5 mm, the last one by
  // as much again: each reaches 0.5 mm into the one before it.
  const glm::dvec3 step = 2.0 * recipe.cuts[0].blade.normal;
  fragments[2].pose = Shifted(step);
  fragments[1].pose = Shifted(step + 2.0 * recipe.cuts[1].blade.normal);
  const auto reduced = ExpectPrintable(hasp::UniteFragments(fragments, 0.6));
  EXPECT_LE(reduced.pieces + 2, apart.pieces) << "three bodies are one";
  EXPECT_LT(reduced.volumeMm3, apart.volumeMm3);
  EXPECT_GT(reduced.volumeMm3, 0.97 * sum);
  std::printf("jaw: fragments %.0f mm3, united apart %.0f (%zu pieces), reduced %.0f (%zu)\n", sum,
    apart.volumeMm3, apart.pieces, reduced.volumeMm3, reduced.pieces);
}

} // namespace
