// The test fit of a guide (Haptics/SeatByContact.h), held against its certificate: the two share
// nothing but the scan and the mesh.
#include "Distance/BodyDistance.h"
#include "Evaluation/FitCertificate.h"
#include "Evaluation/SurfaceDistance.h"
#include "Grid/Phantom.h"
#include "Grid/Stopwatch.h"
#include "Grid/Trilinear.h"
#include "GuideBuilder.h"
#include "GuideClaims.h"
#include "Haptics/SeatByContact.h"
#include "Planning/GuideRecipeFile.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace
{

using namespace hasp;

using Samples = std::vector<MeshSample>;
using Shell = std::shared_ptr<const PointShell>;

/// The phantom's right frontal bone at 1 mm, the guide of its recipe, and the bone as it is felt.
struct Case
{
  GridGeometry grid{ { 76, 92, 86 }, { -68, -100, 4 }, glm::dvec3(1), glm::dmat3(1) };
  std::vector<std::int16_t> values;
  GuideRecipe recipe = ReadGuideRecipe(HASP_PHANTOM_GUIDE);
  TriangleMesh mesh;
  PartClaims claims;
  glm::dvec3 withdrawal{ 0.0 };
  std::vector<HapticBody> bones;

  /// quick: its mesh has half as many triangles, and no letters, which ask for more.
  Case(bool defect, bool quick)
  {
    if (quick)
    {
      this->recipe.spacingMm = 0.6;
      this->recipe.labels.clear();
    }
    PhantomSettings settings;
    settings.defect = defect;
    this->values = SamplePhantom(this->grid, settings);
    BuiltGuide guide = BuildGuide(this->Scan(), this->recipe, {});
    this->mesh = std::move(guide.mesh);
    this->claims = ClaimsOf(guide.made.recipe);
    this->withdrawal = *this->claims.withdrawal;
    const BodyDistance bone =
      DistanceOfVolume(this->Scan(), this->recipe.isovalue, { .spacingMm = 0.5 });
    this->bones = { { std::make_shared<const DistanceMap>(bone.View()), {} } };
  }
  GridView<const std::int16_t> View() const { return { this->values.data(), this->grid }; }
  AnyGridView Scan() const { return this->View(); }
  glm::dvec3 Origin() const { return this->recipe.landmarks[2]; } ///< of shells' axes

  bool InBone(const glm::dvec3& place) const
  {
    const auto value = SampleTrilinear(this->View(), this->grid.WorldToIndex(place));
    return value && *value >= this->recipe.isovalue;
  }
  std::optional<NearestSurface> Nearest(const glm::dvec3& place) const
  {
    return DistanceToIsosurface(
      this->Scan(), this->recipe.isovalue, std::vector<glm::dvec3>{ place }, 3.0)[0];
  }
  /// Points of the mesh itself.
  Shell ShellOf(const Samples& samples) const
  {
    std::vector<SurfacePoint> points;
    double area = 0.0;
    for (const MeshSample& sample : samples)
    {
      points.push_back({ sample.point, sample.normal });
      area += sample.areaMm2;
    }
    return PointShell::OfPoints(
      points, area, this->Origin(), { .points = static_cast<int>(points.size()) });
  }
  Seat Push(const Shell& part, const SeatSettings& settings) const
  {
    return SeatByContact(*part, { this->Origin(), { 1, 0, 0, 0 } }, this->bones, settings);
  }
};

/// Only what looks ahead can touch first: the rest of a closed part follows it.
Samples Ahead(const Samples& samples, const glm::dvec3& withdrawal)
{
  Samples ahead;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(ahead),
    [&](const MeshSample& sample) { return glm::dot(sample.normal, withdrawal) < 0.0; });
  return ahead;
}

constexpr double StepMm = 0.005;

/// Where a ray through the scan itself enters bone, in depths of the push; until if it does not.
double MarchedDepth(const Case& c, const glm::dvec3& place, double from, double until)
{
  while (from < until && !c.InBone(place - from * c.withdrawal))
    from += StepMm;
  return std::min(from, until);
}

/// The same of all samples of a part that has nothing in its way but the bone that it lies on.
double MarchedDepth(const Case& c, const Samples& samples)
{
  std::vector<glm::dvec3> places;
  for (const MeshSample& sample : samples)
    places.push_back(sample.point);
  const auto nearest = DistanceToIsosurface(c.Scan(), c.recipe.isovalue, places, 1.0);
  double least = 1.0;
  for (std::size_t n = 0; n < places.size(); ++n)
    if (nearest[n]) // a ray is at least as long as the way to what is nearest
      least = std::min(least, MarchedDepth(c, places[n], nearest[n]->distance, least));
  return least;
}

/// The gap at a place along the way, if bone were as flat as it is at its nearest point.
double Projected(const Case& c, const glm::dvec3& place)
{
  const std::optional<NearestSurface> nearest = c.Nearest(place);
  EXPECT_TRUE(nearest.has_value());
  return nearest ? nearest->distance / glm::dot(nearest->outward, c.withdrawal) : 0.0;
}

/// With the defect's rim, or plain bone below.
class GuideSeatOnBone : public testing::TestWithParam<bool>
{
};

/// Which figure of the certificate the first touch is, and why. A part whose least distance to bone
/// is d must be pushed by d at least before it touches: GuideGap::leastAnywhere is a bound from
/// below. From above, a wall at a distance d from bone whose normal has the cosine a with the way
/// touches after d / a: leastAnywhere over the cosine at leastAnywhereAt. The two meet where bone
/// faces the way.
TEST_P(GuideSeatOnBone, TouchesWhereTheCertificateHasItsLeastGapAlongTheWay)
{
  // The map's spacing is 0.5 mm. On smooth bone it is off by a tenth of that at most
  // (BodyDistance.h); the first touch is where it is most. The certificate's distances are by 0.01
  // mm, the rays by a step. Along the sharp rim the scan's surface has a tip, some 0.1 mm high, at
  // each sample that is bone just so, of which such a map keeps little: 0.09 mm later, at 0.25 mm
  // 0.07.
  const bool rim = GetParam();
  const double agreeMm = rim ? 0.1 : 0.07;
  const Case c(rim, !rim);
  const FitCertificate certificate = CertifyFit(c.mesh, c.Scan(), c.claims, {});
  for (const FitFault& fault : certificate.faults)
    EXPECT_EQ(fault.kind, FitFaultKind::NotChecked) << fault.text; // needs CGAL
  ASSERT_TRUE(certificate.gap && certificate.insertion);
  EXPECT_EQ(certificate.insertion->blocked, 0U);

  const Samples ahead = Ahead(SampleMesh(c.mesh, GapSampleMm), c.withdrawal);
  const Shell shell = c.ShellOf(ahead);
  const Stopwatch stopwatch;
  const Seat seat = c.Push(shell, { .withdrawal = c.withdrawal });
  RecordProperty("milliseconds", std::to_string(stopwatch.Milliseconds()));
  RecordProperty("points", std::to_string(ahead.size()));
  RecordProperty("depthMm", std::to_string(seat.depthMm));
  ASSERT_TRUE(seat.touched);
  EXPECT_TRUE(seat.seats);

  const double marched = MarchedDepth(c, ahead), least = certificate.gap->leastAnywhere;
  const double along = Projected(c, certificate.gap->leastAnywhereAt);
  RecordProperty("marchedMm", std::to_string(marched));
  RecordProperty("leastMm", std::to_string(least));
  RecordProperty("leastAlongMm", std::to_string(along));
  EXPECT_NEAR(seat.depthMm, marched, agreeMm);
  EXPECT_NEAR(seat.depthMm, along, agreeMm);
  EXPECT_GT(seat.depthMm, least - agreeMm);
  if (!rim) // and its bone faces the way
  {
    EXPECT_NEAR(seat.depthMm, least, agreeMm);
  }
  EXPECT_NEAR(seat.depthMm, Projected(c, seat.partAt), agreeMm);
  const std::optional<NearestSurface> touched = c.Nearest(seat.boneAt);
  ASSERT_TRUE(touched.has_value());
  EXPECT_NEAR(touched->distance, 0.0, agreeMm);
}

INSTANTIATE_TEST_SUITE_P(Phantoms, GuideSeatOnBone, testing::Bool(),
  [](const auto& bone) { return bone.param ? "WithARim" : "Plain"; });

/// A cube of that side, turned as the world.
void AddCube(TriangleMesh& mesh, const glm::dvec3& center, double side)
{
  const auto first = static_cast<unsigned>(mesh.points.size());
  for (int n = 0; n < 8; ++n)
    mesh.points.push_back(
      center + 0.5 * side * glm::dvec3(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1));
  for (const glm::uvec4& face : { glm::uvec4{ 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
         { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } })
  {
    mesh.triangles.push_back(first + glm::uvec3(face.x, face.y, face.z));
    mesh.triangles.push_back(first + glm::uvec3(face.x, face.z, face.w));
  }
}

TEST(GuideSeat, AHookBehindTheBoneAndAnObliqueWayAreStoppedAsTheCertificateSays)
{
  const Case c(true, true);
  const auto insertion = [&](const Samples& samples, const glm::dvec3& direction)
  {
    return MeasureInsertion(
      c.Scan(), samples, { c.recipe.isovalue, c.recipe.ignoreBelowMm3, direction });
  };
  // A hook that has come out of the skull's inner table below the guide.
  double inner = MarchedDepth(c, c.Origin(), -1.0, 5.0);
  while (c.InBone(c.Origin() - inner * c.withdrawal))
    inner += StepMm;
  const glm::dvec3 behind = c.Origin() - (inner + 2.0) * c.withdrawal;
  TriangleMesh hook, hooked = c.mesh;
  AddCube(hook, behind, 1.2);
  AddCube(hooked, behind, 1.2);
  EXPECT_GT(insertion(SampleMesh(hooked, GapSampleMm), c.withdrawal).deepestMm, 1.0);
  const Samples ahead = Ahead(SampleMesh(hooked, GapSampleMm), c.withdrawal);
  const Seat stopped = c.Push(c.ShellOf(ahead), { .withdrawal = c.withdrawal });
  EXPECT_TRUE(stopped.touched);
  EXPECT_FALSE(stopped.seats);
  double marched = 0.0;
  for (const MeshSample& sample : Ahead(SampleMesh(hook, GapSampleMm), c.withdrawal))
    marched = std::min(marched, MarchedDepth(c, sample.point, -30.0, 0.0));
  EXPECT_LT(marched, -inner); // all of the bone lies between
  EXPECT_NEAR(stopped.depthMm, marched, 0.1);
  EXPECT_LT(glm::distance(stopped.partAt, behind), 1.2);

  // The guide alone goes on, but along its own way only.
  const Samples all = SampleMesh(c.mesh, GapSampleMm);
  Samples some; // enough for what is stopped by millimetres
  for (std::size_t n = 0; n < all.size(); n += 8)
    some.push_back(all[n]);
  const Shell guide = c.ShellOf(some);
  const glm::dvec3 across = glm::normalize(glm::cross(c.withdrawal, { 0, 0, 1 }));
  for (const double tilt : { -0.4, 0.0, 0.4 })
  {
    const glm::dvec3 way = TurnBy(tilt * across) * c.withdrawal;
    const Insertion measured = insertion(some, way);
    const Seat seat = c.Push(guide, { .withdrawal = way, .liftMm = 60.0 });
    EXPECT_EQ(seat.seats, tilt == 0.0) << seat.depthMm;
    EXPECT_EQ(measured.blocked == 0, tilt == 0.0);
    if (tilt != 0.0)
    {
      EXPECT_GT(measured.deepestMm, 0.2);
    }
  }
}

} // namespace
