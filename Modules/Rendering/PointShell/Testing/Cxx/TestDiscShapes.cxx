// What is drawn against closed forms: a sphere, a plane, one disc.
#include "DiscScene.h"
#include "Grid/AnalyticVolumes.h"
#include "Haptics/PointShell.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using hasp::testing::DiscScene;
using hasp::testing::Pixel;

constexpr double Radius = 20.0; // mm
constexpr double Overlap = 1.8; // the mapper's default

/// Of discs that share a sphere evenly, mm.
double DiscRadius(int count)
{
  return Overlap * 2.0 * Radius / std::sqrt(double(count));
}

struct SphereError
{
  double rmsMm = 0.0, degrees = 0.0; ///< of depth, radially; mean of the normals
};

SphereError MeasureSphere(int count)
{
  DiscScene scene;
  scene.Mapper->SetDiscs(hasp::testing::SphereDiscs(count, Radius));
  const std::vector<Pixel> pixels = scene.Draw();
  const std::vector<glm::dvec3> normals = scene.Normals();
  SphereError error;
  int hits = 0;
  for (std::size_t n = 0; n < pixels.size(); ++n)
  {
    if (!pixels[n].hit || pixels[n].Miss() > 0.95 * Radius)
      continue;
    ++hits;
    const double off = glm::length(*pixels[n].hit) - Radius;
    error.rmsMm += off * off;
    const double cosine = glm::dot(glm::normalize(normals[n]), glm::normalize(*pixels[n].hit));
    error.degrees += std::acos(std::min(cosine, 1.0)) * 180.0 / std::numbers::pi;
  }
  error.rmsMm = std::sqrt(error.rmsMm / hits);
  error.degrees /= hits;
  return error;
}

void ExpectSphere(DiscScene& scene, int count)
{
  // Discs are tangent: nothing is inside, and a rim stands r^2 / 2R outside.
  const double rim = DiscRadius(count) * DiscRadius(count) / (2.0 * Radius);
  int seen = 0;
  for (const Pixel& pixel : scene.Draw())
  {
    const double miss = pixel.Miss();
    if (miss < Radius - 1e-3)
    {
      EXPECT_TRUE(pixel.hit) << "a hole " << miss << " mm from the middle";
    }
    if (!pixel.hit)
      continue;
    ++seen;
    // Half a pixel's diagonal and the filter's three quarters of a pixel.
    EXPECT_LE(miss, Radius + rim + 0.75 * pixel.mm) << "outside the silhouette";
    // Blended depth is on a chord no longer than a disc's radius. Further out discs are narrower
    // than the filter, and their rims stand for what is beside them.
    const bool wide = miss < 0.98 * Radius;
    const double off = glm::length(*pixel.hit) - Radius;
    EXPECT_GE(off, wide ? -0.25 * rim - 1e-3 : -0.75 * pixel.mm) << miss;
    EXPECT_LE(off, wide ? rim : rim + 0.75 * pixel.mm) << miss;
  }
  EXPECT_GT(seen, 5000);
}

TEST(DiscSphere, IsWhereTheSphereIs)
{
  for (const bool parallel : { false, true })
  {
    DiscScene scene;
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    scene.Renderer->GetActiveCamera()->SetParallelScale(25);
    scene.Mapper->SetDiscs(hasp::testing::SphereDiscs(4096, Radius));
    ExpectSphere(scene, 4096);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(DiscSphere, DiscsFarBelowAPixelLeaveNoHoles)
{
  DiscScene scene(100); // 0.5 mm a pixel, a disc's radius is 0.14 mm
  scene.Look({ 0, 0, 85 });
  scene.Mapper->SetDiscs(hasp::testing::SphereDiscs(262'144, Radius));
  int inside = 0;
  for (const Pixel& pixel : scene.Draw())
    if (pixel.Miss() < Radius - 1e-3)
    {
      ++inside;
      EXPECT_TRUE(pixel.hit) << pixel.Miss();
      if (pixel.hit) // seen from the side, a disc of a pixel is as wrong as that
      {
        EXPECT_LE(std::abs(glm::length(*pixel.hit) - Radius), 0.75 * pixel.mm);
      }
    }
  EXPECT_GT(inside, 3000);
}

TEST(DiscSphere, ErrorFallsWithTheNumberOfPoints)
{
  SphereError before = MeasureSphere(256);
  EXPECT_LT(before.degrees, 6.0);
  for (const int count : { 1024, 4096 })
  {
    const SphereError now = MeasureSphere(count);
    EXPECT_LT(now.rmsMm, 0.35 * before.rmsMm) << count; // a quarter, as the discs' areas
    EXPECT_LT(now.degrees, 0.75 * before.degrees) << count;
    // Blended: where discs lie evenly, the mean over a disc of what it stands out, weighted as its
    // Gaussian, is 0.245 of what its rim does. The nearest of three discs, unblended: 0.75.
    const double rim = DiscRadius(count) * DiscRadius(count) / (2.0 * Radius);
    EXPECT_LT(now.rmsMm, 0.45 * rim) << count;
    before = now;
  }
  EXPECT_LT(before.rmsMm, 0.03);  // of 1 mm voxels
  EXPECT_LT(before.degrees, 1.0); // 8-bit colours alone make 0.2
}

TEST(DiscSphere, EachLevelOfAShellIsClosed)
{
  const hasp::GridGeometry grid{ { 48, 48, 48 }, glm::dvec3(-23.5), { 1, 1, 1 }, glm::dmat3(1) };
  const std::vector<float> samples =
    hasp::SampleAnalytic<float>(hasp::AnalyticSphere({ 0, 0, 0 }, Radius), grid, -1, 0);
  const float middle = samples[samples.size() / 2];
  std::vector<float> distances = samples; // negative inside
  if (middle > 0)
    std::transform(samples.begin(), samples.end(), distances.begin(), std::negate<>());
  DiscScene scene;
  const auto shell =
    hasp::PointShell::OfSurface({ distances.data(), grid }, glm::dvec3(0.0), { 4096, 64, 1 });
  ASSERT_EQ(shell->Levels(), 4);
  scene.Mapper->SetPointShell(shell);
  for (int level = 1; level <= 4; ++level)
  {
    scene.Mapper->SetLevels(level);
    EXPECT_EQ(scene.Mapper->GetNumberOfDiscs(), shell->LevelEnd(level - 1));
    int inside = 0, holes = 0;
    for (const Pixel& pixel : scene.Draw())
      if (pixel.Miss() < 0.97 * Radius)
      {
        ++inside;
        // What lies deeper than a rim may stand out is the far side, seen through a hole.
        holes += !pixel.hit || glm::dot(*pixel.hit, pixel.direction) > 0.0;
      }
    EXPECT_GT(inside, 5000);
    EXPECT_EQ(holes, 0) << "level " << level;
  }
}

TEST(DiscPlane, IsCoveredAndFlatAlsoAtAGrazingAngle)
{
  for (const double degrees : { 3.0, 12.0, 30.0 })
  {
    DiscScene scene;
    scene.Mapper->SetDiscs(hasp::testing::PlaneDiscs(40));
    const double angle = degrees * std::numbers::pi / 180.0;
    scene.Look({ 0, -80 * std::cos(angle), 80 * std::sin(angle) }, { 0, 0, 1 });
    int inside = 0;
    for (const Pixel& pixel : scene.Draw())
    {
      const glm::dvec3 truth = pixel.from - pixel.direction * (pixel.from.z / pixel.direction.z);
      const bool in = std::abs(truth.x) < 20 && std::abs(truth.y) < 20 && pixel.direction.z < 0;
      inside += in;
      EXPECT_TRUE(pixel.hit || !in) << truth.x << " " << truth.y;
      if (!pixel.hit)
        continue;
      // At 3 degrees a disc is half a pixel high: the filter widens it, and its rim stands for what
      // is beside it. At 12 the filter is within the disc, and rays meet planes.
      const double bound = degrees < 10.0 ? 0.75 * pixel.mm : 1e-3;
      if (in)
      {
        EXPECT_LE(std::abs(pixel.hit->z), bound) << degrees;
      }
    }
    EXPECT_GT(inside, 500);
  }
}

TEST(Disc, OfNoSizeIsAPixelWhereverItIs)
{
  DiscScene scene;
  for (int n = 0; n < 12; ++n)
  {
    auto one = std::make_shared<std::vector<hasp::ShellDisc>>();
    const glm::vec3 normal = n % 3 == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1); // or edge on
    one->push_back({ glm::vec3(0.037F * n, 0.023F * n, 0), 1e-6F, normal, 0 });
    scene.Mapper->SetDiscs(one);
    int hits = 0;
    for (const Pixel& pixel : scene.Draw())
      hits += pixel.hit.has_value();
    EXPECT_GE(hits, 1)
      << n; // a circle of 0.75 pixels holds one pixel's middle at least, four at most
    EXPECT_LE(hits, 4) << n;
  }
}

TEST(Disc, IsTheEllipseThatTheActorMakesOfIt)
{
  DiscScene scene;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.6, 0.2, 0.5));
  auto one = std::make_shared<std::vector<hasp::ShellDisc>>();
  one->push_back({ { 2, -1, 3 }, static_cast<float>(std::numbers::pi * 25.0), normal, 0 });
  scene.Mapper->SetDiscs(one);
  scene.Actor->SetScale(1.5, 0.7, 1.2);
  scene.Actor->RotateWXYZ(40, 1, 2, -1);
  scene.Actor->SetPosition(3, -4, 5);
  scene.Look({ 10, 20, 90 });
  const glm::dmat4 toWorld = glm::transpose(glm::make_mat4(scene.Actor->GetMatrix()->GetData()));
  const glm::dmat4 toLocal = glm::inverse(toWorld);
  int inside = 0;
  for (const Pixel& pixel : scene.Draw())
  {
    const glm::dvec3 from = toLocal * glm::dvec4(pixel.from, 1.0);
    const glm::dvec3 along = toLocal * glm::dvec4(pixel.direction, 0.0);
    const glm::dvec3 center(one->front().center);
    const glm::dvec3 truth =
      from + along * (glm::dot(center - from, normal) / glm::dot(along, normal));
    const double off = glm::distance(truth, center) / (Overlap * 5.0);
    if (std::abs(off - 1.0) < 1e-4)
      continue; // on the rim, to the rounding of floats
    EXPECT_EQ(pixel.hit.has_value(), off < 1.0) << off;
    inside += off < 1.0;
    if (pixel.hit)
    {
      const glm::dvec3 world = toWorld * glm::dvec4(truth, 1.0);
      EXPECT_LE(glm::distance(*pixel.hit, world), 1e-3); // 24 bits of depth
    }
  }
  EXPECT_GT(inside, 1000);
  const double* bounds = scene.Mapper->GetBounds();
  for (int axis = 0; axis < 3; ++axis) // the disc's box, in its own coordinates
  {
    const double reach = Overlap * 5.0 * std::sqrt(1.0 - normal[axis] * normal[axis]);
    EXPECT_NEAR(bounds[2 * axis], one->front().center[axis] - reach, 1e-4);
    EXPECT_NEAR(bounds[2 * axis + 1], one->front().center[axis] + reach, 1e-4);
  }
}

} // namespace
