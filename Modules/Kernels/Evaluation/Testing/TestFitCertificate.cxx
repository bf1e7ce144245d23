#include "Evaluation/FitCertificate.h"
#include "Grid/AnalyticVolumes.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using hasp::FitFaultKind;

hasp::TriangleMesh Both(hasp::TriangleMesh a, const hasp::TriangleMesh& b)
{
  const auto base = static_cast<unsigned>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const glm::uvec3& t : b.triangles)
    a.triangles.push_back(t + base);
  return a;
}

/// Bone is z < 0; on it lies a plate of 20 x 14 x 2.5 mm, 0.3 mm off, with a slot of 1.2 mm that is
/// in its middle along no axis. All of it under a rotation.
struct Bench
{
  explicit Bench(int seed) : motion(parttest::AnyMotion(seed))
  {
    this->grid = { { 81, 81, 41 }, {}, glm::dvec3(0.6), motion.turn };
    this->grid.origin = motion.Place({ -24, -24, -10 });
    const parttest::Motion m = motion;
    const hasp::AnalyticVolume bone{ "half space", [m](const glm::dvec3& world) {
                                      return -glm::dot(world - m.to, m.Turn({ 0, 0, 1 }));
                                    } };
    this->samples = hasp::SampleAnalytic<float>(bone, this->grid, 1, 0);
    claims.isovalue = 0;
    claims.shell = hasp::ClaimedShell{};
    claims.slots = { { motion.Place({ 3.6, 1, 1 }), motion.Turn({ 1, 0, 0 }),
      motion.Turn({ 0, 1, 0 }), 1.2, 8.0 } };
    claims.withdrawal = motion.Turn({ 0, 0, 1 });
  }
  /// dent: how deep a pit of 2 x 2 mm in the outer wall is.
  static hasp::TriangleMesh Plate(double gap = 0.3, double slot = 1.2, double dent = 0.0)
  {
    const double pit = dent > 0 ? gap + 2.5 - dent : gap + 1.0;
    return parttest::Blocks({ -10, -6, -4, 3, 3 + slot, 10 }, { -7, -3, -1, 1, 5, 7 },
      { gap, pit, gap + 2.5 },
      [dent](int i, int j, int k)
      {
        if (i == 3 && j >= 1 && j <= 3)
          return false;
        return !(dent > 0 && i == 1 && j == 2 && k == 1);
      });
  }
  hasp::FitCertificate Certify(const hasp::TriangleMesh& mesh) const
  {
    const hasp::AnyGridView view = hasp::GridView<const float>{ this->samples.data(), this->grid };
    return hasp::CertifyFit(mesh, view, this->claims,
      [](const hasp::TriangleMesh&) { return std::vector<std::array<std::uint32_t, 2>>{}; });
  }
  hasp::FitCertificate Placed(const hasp::TriangleMesh& mesh) const
  {
    return this->Certify(this->motion(mesh));
  }
  parttest::Motion motion;
  hasp::GridGeometry grid;
  std::vector<float> samples;
  hasp::PartClaims claims;
};

std::string All(const hasp::FitCertificate& c)
{
  std::string text;
  for (const hasp::FitFault& fault : c.faults)
    text += std::string(hasp::FitFaultName(fault.kind)) + ": " + fault.text + "\n";
  return text;
}

bool Has(const hasp::FitCertificate& c, FitFaultKind kind)
{
  return std::any_of(
    c.faults.begin(), c.faults.end(), [kind](const auto& fault) { return fault.kind == kind; });
}

TEST(FitCertificate, APartAsClaimedHoldsUnderAnyRotation)
{
  for (int seed = 0; seed < 5; ++seed)
  {
    const hasp::FitCertificate c = Bench(seed).Placed(Bench::Plate());
    EXPECT_TRUE(c.Holds()) << All(c);
    EXPECT_NEAR(c.wall.leastMm, 2.0, 1e-6); // between the slot's end and the rim
    EXPECT_NEAR(c.shell->leastMm, 2.5, 1e-6);
    EXPECT_NEAR(c.gap->p50, 0.3, 0.01); // a plane: 0.01 of a sample is what the method promises
    EXPECT_NEAR(c.gap->innerWallMm2, 20 * 14 - 1.2 * 8, 1e-6);
    double binned = 0;
    for (const double mm2 : c.gap->histogramMm2)
      binned += mm2;
    EXPECT_NEAR(binned, c.gap->innerWallMm2, 1e-6);
    EXPECT_NEAR(c.slots[0].widthMm, 1.2, 1e-6);
    EXPECT_EQ(c.insertion->blocked, 0U);
    EXPECT_EQ(c.selfIntersections, 0U);
    EXPECT_NEAR(c.mesh.volumeMm3, 2.5 * (20 * 14 - 1.2 * 8), 1e-6);
    EXPECT_EQ(c.slivers, 0U);
  }
}

TEST(FitCertificate, FaultsOfTheMeshHaveAPlace)
{
  const Bench bench(1);
  hasp::TriangleMesh open = bench.motion(Bench::Plate());
  const glm::uvec3 gone = open.triangles.back();
  open.triangles.pop_back();
  hasp::FitCertificate c = bench.Certify(open);
  ASSERT_TRUE(Has(c, FitFaultKind::NotClosed)) << All(c);
  EXPECT_LT(glm::distance(*c.faults[0].at, open.points[gone.x]), 15.0);

  hasp::TriangleMesh turned = bench.motion(Bench::Plate());
  std::swap(turned.triangles[5].y, turned.triangles[5].z);
  EXPECT_TRUE(Has(bench.Certify(turned), FitFaultKind::Turned));
  for (glm::uvec3& t : turned.triangles = bench.motion(Bench::Plate()).triangles)
    std::swap(t.y, t.z);
  EXPECT_TRUE(Has(bench.Certify(turned), FitFaultKind::Turned)); // all of them

  const auto crumb =
    parttest::Blocks({ 14, 14.8 }, { 3, 3.8 }, { 4, 4.8 }, [](int, int, int) { return true; });
  c = bench.Placed(Both(Bench::Plate(), crumb));
  ASSERT_TRUE(Has(c, FitFaultKind::Pieces)) << All(c);
  EXPECT_LT(glm::distance(*c.faults[0].at, bench.motion.Place({ 14.4, 3.4, 4.4 })), 1e-9);
  EXPECT_NEAR(c.pieces[1].volumeMm3, 0.512, 1e-9);

  hasp::TriangleMesh flat = bench.motion(Bench::Plate());
  flat.triangles.push_back({ 0, 1, 1 });
  EXPECT_TRUE(Has(bench.Certify(flat), FitFaultKind::NoArea));
  EXPECT_TRUE(Has(bench.Certify({}), FitFaultKind::NotClosed));
}

TEST(FitCertificate, WhatIsNotCheckedIsNeverGreen)
{
  const Bench bench(0);
  const hasp::AnyGridView view = hasp::GridView<const float>{ bench.samples.data(), bench.grid };
  const hasp::TriangleMesh part = bench.motion(Bench::Plate());
  EXPECT_TRUE(Has(hasp::CertifyFit(part, view, bench.claims, {}), FitFaultKind::NotChecked));
  const auto meets = [](const hasp::TriangleMesh&) {
    return std::vector<std::array<std::uint32_t, 2>>{ { 3, 8 } };
  };
  const auto c = hasp::CertifyFit(part, view, bench.claims, meets);
  EXPECT_TRUE(Has(c, FitFaultKind::MeetsItself));
  EXPECT_EQ(c.faults[0].at, part.points[part.triangles[3].x]);
  const auto cannot = [](const hasp::TriangleMesh&) -> std::vector<std::array<std::uint32_t, 2>>
  { throw std::invalid_argument("not this mesh"); };
  EXPECT_TRUE(Has(hasp::CertifyFit(part, view, bench.claims, cannot), FitFaultKind::NotChecked));
}

TEST(FitCertificate, WallsGapAndSlotsAreHeldToTheirClaims)
{
  for (const int seed : { 1, 4 })
  {
    const Bench bench(seed);
    hasp::FitCertificate c = bench.Placed(Bench::Plate(0.3, 1.2, 1.0)); // 1.5 mm left
    ASSERT_TRUE(Has(c, FitFaultKind::ThinWall)) << All(c);
    EXPECT_EQ(c.faults.size(), 1U) << All(c);
    EXPECT_LT(glm::distance(*c.faults[0].at, bench.motion.Place({ -5, 0, 1.05 })), 1.5);
    EXPECT_TRUE(bench.Placed(Bench::Plate(0.3, 1.2, 0.35)).Holds()); // 0.4 may be missing

    c = bench.Placed(Bench::Plate(0.55));
    ASSERT_TRUE(Has(c, FitFaultKind::Gap)) << All(c);
    EXPECT_FALSE(Has(c, FitFaultKind::TouchesBone));
    EXPECT_TRUE(bench.Placed(Bench::Plate(0.45)).Holds());
    EXPECT_TRUE(Has(bench.Placed(Bench::Plate(-0.1)), FitFaultKind::TouchesBone));
    EXPECT_TRUE(Has(bench.Placed(Bench::Plate(8.0)), FitFaultKind::Gap)); // nothing near bone

    c = bench.Placed(Bench::Plate(0.3, 1.05));
    ASSERT_TRUE(Has(c, FitFaultKind::Slot)) << All(c);
    EXPECT_NE(All(c).find("slots[0] is 1.05 mm wide"), std::string::npos) << All(c);
    EXPECT_TRUE(Has(bench.Placed(Bench::Plate(0.3, 1.4)), FitFaultKind::Slot));
  }
}

TEST(FitCertificate, HolesAreHeldToTheirClaims)
{
  Bench bench(2);
  bench.claims.slots.clear();
  bench.claims.shell->thicknessMm = 4.0;
  bench.claims.holes = { { bench.motion.to, *bench.claims.withdrawal, 2.0 } };
  const auto sleeve = [&](double inner, double off)
  {
    parttest::Motion up = bench.motion;
    up.to = bench.motion.Place({ off, 0, 2.3 });
    return bench.Certify(up(parttest::Tube(inner, 5.0, 4.0, 96)));
  };
  EXPECT_TRUE(sleeve(1.0, 0.0).Holds()) << All(sleeve(1.0, 0.0));
  EXPECT_TRUE(Has(sleeve(0.93, 0.0), FitFaultKind::Hole)); // 1.86
  EXPECT_TRUE(Has(sleeve(1.08, 0.0), FitFaultKind::Hole));
  EXPECT_TRUE(Has(sleeve(1.0, 0.15), FitFaultKind::Hole));
  const auto gone = sleeve(1.0, 12.0);
  EXPECT_NE(All(gone).find("holes[0] does not touch the part"), std::string::npos) << All(gone);
}

TEST(FitCertificate, WhatIsPerforatedIsAsThickAsClaimedAwayFromThat)
{
  Bench bench(4);
  bench.claims.leastWallMm = 1.9; // 2 mm are between the slot's ends and the rim
  bench.claims.leastUncutMm = 2.4;
  const auto whole = bench.Placed(Bench::Plate());
  EXPECT_TRUE(whole.Holds()) << All(whole);
  ASSERT_TRUE(whole.uncut);
  EXPECT_NEAR(whole.uncut->leastMm, 2.5, 1e-6);
  const auto dented = bench.Placed(Bench::Plate(0.3, 1.2, 0.3)); // 2.2 mm are left
  EXPECT_NE(All(dented).find("a wall away from slots and holes is 2.20 mm thick, must be 2.40"),
    std::string::npos)
    << All(dented);
  bench.claims.leastUncutMm = 0.0;
  EXPECT_FALSE(bench.Placed(Bench::Plate()).uncut);
}

TEST(FitCertificate, APartThatCannotBePutOnIsNamed)
{
  Bench bench(1);
  bench.claims.withdrawal = bench.motion.Turn({ 0, 0, -1 }); // straight through the bone
  const auto c = bench.Placed(Bench::Plate());
  ASSERT_TRUE(Has(c, FitFaultKind::Undercut)) << All(c);
  EXPECT_LT(glm::dot(c.insertion->boneAt - bench.motion.to, bench.motion.Turn({ 0, 0, 1 })), 0.0);
}

/// Each triangle as four.
hasp::TriangleMesh Divided(const hasp::TriangleMesh& mesh)
{
  hasp::TriangleMesh fine;
  const auto triangle = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const auto n = std::uint32_t(fine.points.size());
    fine.points.insert(fine.points.end(), { a, b, c });
    fine.triangles.emplace_back(n, n + 1, n + 2);
  };
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    triangle(a, ab, ca);
    triangle(ab, b, bc);
    triangle(ca, bc, c);
    triangle(ab, bc, ca);
  }
  return hasp::WeldPoints(fine);
}

hasp::TriangleMesh Scaled(hasp::TriangleMesh mesh, double factor)
{
  for (glm::dvec3& p : mesh.points)
    p *= factor;
  return mesh;
}

TEST(FitCertificate, UnitsMirrorsAndSpacesAreNamed)
{
  const Bench bench(3);
  const hasp::TriangleMesh part = bench.motion(Bench::Plate());
  const auto changed = [&](const glm::dvec3& factor, const glm::dvec3& about, bool turn)
  {
    hasp::TriangleMesh mesh = part;
    for (glm::dvec3& p : mesh.points)
      p = about + factor * (p - about);
    for (glm::uvec3& t : mesh.triangles)
      if (turn)
        std::swap(t.y, t.z);
    return bench.Certify(mesh);
  };
  const auto first = [](const hasp::FitCertificate& c)
  { return c.Holds() ? "holds" : std::string(hasp::FitFaultName(c.faults[0].kind)); };
  const auto whole = bench.Certify(part);
  const glm::dvec3 middle = 0.5 * (whole.low + whole.high), zero(0.0);
  EXPECT_EQ(first(changed(glm::dvec3(1 / 25.4), zero, false)), "units");
  EXPECT_EQ(first(changed(glm::dvec3(25.4), zero, false)), "units");
  EXPECT_EQ(first(changed(glm::dvec3(0.1), zero, false)), "units");
  // In metres all triangles of a real part are too low to be measured.
  EXPECT_EQ(first(bench.Certify(Scaled(Divided(Divided(Divided(part))), 0.001))), "units");
  EXPECT_EQ(first(changed({ -1, 1, 1 }, zero, true)), "mirrored");
  EXPECT_EQ(first(changed({ 1, 1, -1 }, middle, true)), "mirrored");
  const auto insideOut = changed({ -1, 1, 1 }, zero, false);
  EXPECT_TRUE(Has(insideOut, FitFaultKind::Mirrored) && Has(insideOut, FitFaultKind::Turned));
  EXPECT_EQ(first(changed({ -1, -1, 1 }, zero, false)), "space");
  // A part that is just in the wrong place is none of them.
  EXPECT_EQ(first(bench.Certify(parttest::Motion{ glm::dmat3(1), { 0, 3, 4 } }(part))), "gap");
}

TEST(FitCertificate, BadClaimsThrowAndItCanBeCancelled)
{
  const auto refused = [](const std::function<void(hasp::PartClaims&)>& spoil)
  {
    Bench bench(0);
    spoil(bench.claims);
    EXPECT_THROW(bench.Placed(Bench::Plate()), std::invalid_argument);
  };
  refused([](hasp::PartClaims& c) { c.isovalue = NAN; });
  refused([](hasp::PartClaims& c) { c.leastWallMm = -1; });
  refused([](hasp::PartClaims& c) { c.leastUncutMm = NAN; });
  refused([](hasp::PartClaims& c) { c.shell->gapToleranceMm = 0; });
  refused([](hasp::PartClaims& c) { c.shell->thicknessMm = NAN; });
  refused([](hasp::PartClaims& c) { c.slots[0].normal *= 1.01; });
  refused([](hasp::PartClaims& c) { c.slots[0].along = c.slots[0].normal; });
  refused([](hasp::PartClaims& c) { c.slots[0].point.x = INFINITY; });
  refused([](hasp::PartClaims& c) { c.holes = { { {}, { 0, 0, 1 }, 60.0 } }; });
  refused([](hasp::PartClaims& c) { c.withdrawal = glm::dvec3(0.0); });
  const Bench bench(0);
  const hasp::AnyGridView view = hasp::GridView<const float>{ bench.samples.data(), bench.grid };
  double last = 0.0;
  const auto rises = [&](double share)
  {
    EXPECT_GE(share, last);
    last = share;
    return share < 0.6;
  };
  EXPECT_THROW(
    hasp::CertifyFit(bench.motion(Bench::Plate()), view, bench.claims, {}, rises), hasp::Cancelled);
}

} // namespace
