// Pictures: each pixel against a single ray, planes, depth.
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/Testing/TracedVolume.h"

#include <glm/gtc/matrix_transform.hpp>

#include <bit>

namespace
{

using hasp::testing::Cube;
using hasp::testing::TracedVolume;

TracedVolume<std::int16_t> Gyroid()
{
  const hasp::GridGeometry g = Cube({ 50, 40, 45 });
  return { hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(14), g, 1000, 0), g, 0.5 };
}

/// The pixel's ray between near and far plane, by unprojection of two points.
hasp::CellRay PixelRay(const hasp::PictureView& view, int x, int y)
{
  const glm::dmat4 back = glm::inverse(view.indexToClip);
  const glm::dvec2 device = (glm::dvec2(x, y) + 0.5) / glm::dvec2(view.size) * 2.0 - 1.0;
  const glm::dvec4 a = back * glm::dvec4(device, -1, 1), b = back * glm::dvec4(device, 1, 1);
  const glm::dvec3 from = glm::dvec3(a) / a.w, to = glm::dvec3(b) / b.w;
  return { from, to - from, 0.0, 1.0 };
}

hasp::PictureView Perspective(const glm::ivec2& size)
{
  const glm::dvec3 middle(25, 20, 22);
  return { glm::perspective(0.6, double(size.x) / size.y, 20.0, 200.0) *
             glm::lookAt(middle + glm::dvec3(60, -50, 40), middle, glm::dvec3(0, 0, 1)),
    size, {} };
}

/// Every pixel of the picture is what a single ray finds.
int ExpectSingleRays(const hasp::CellTracer& tracer, const hasp::PictureView& view)
{
  hasp::TracedPicture picture;
  tracer.TracePicture(view, picture);
  EXPECT_EQ(picture.size, view.size);
  int hits = 0, different = 0;
  for (int y = 0; y < view.size.y; ++y)
    for (int x = 0; x < view.size.x; ++x)
    {
      const std::size_t n = std::size_t(y) * view.size.x + x;
      const auto hit = tracer.Trace(PixelRay(view, x, y));
      if (hit.has_value() != (picture.cells[n] != hasp::TracedPicture::Nothing) ||
          (hit && hit->number != picture.cells[n]))
      {
        ++different; // the two rays differ in their last bits: at an edge of the picture, or of a
                     // cell
        continue;
      }
      if (!hit)
      {
        EXPECT_EQ(picture.gradients[n], glm::vec4(0, 0, 0, hasp::TracedPicture::NoDepth));
        EXPECT_EQ(picture.places[n], glm::vec3(0));
        continue;
      }
      ++hits;
      EXPECT_LT(glm::distance(picture.places[n], hit->local), 1e-4F);
      EXPECT_LT(glm::distance(glm::vec3(picture.gradients[n]), hit->gradient),
        1e-3F * glm::length(hit->gradient));
      const glm::dvec4 clip = view.indexToClip * glm::dvec4(hit->Position(), 1.0);
      EXPECT_NEAR(picture.gradients[n].w, 0.5 * clip.z / clip.w + 0.5, 1e-6);
    }
  EXPECT_LE(different, hits / 1000);
  return hits;
}

TEST(CellTracerPicture, PixelsAreSingleRays)
{
  const auto scene = Gyroid();
  EXPECT_GT(ExpectSingleRays(scene.tracer, Perspective({ 101, 67 })), 2000);
  hasp::PictureView parallel = Perspective({ 64, 64 });
  parallel.indexToClip =
    glm::ortho(-30.0, 30.0, -30.0, 30.0, 1.0, 300.0) *
    glm::lookAt(glm::dvec3(100, 90, 80), glm::dvec3(25, 20, 22), glm::dvec3(0, 0, 1));
  EXPECT_GT(ExpectSingleRays(scene.tracer, parallel), 1000);
  parallel.size = { 0, 5 };
  EXPECT_EQ(ExpectSingleRays(scene.tracer, parallel), 0);
}

TEST(CellTracerPicture, PixelsAreWhatTheirRaysMeetInEveryBit)
{
  const auto scene = Gyroid();
  const hasp::PictureView view = Perspective({ 98, 67 });
  const hasp::PictureRays rays(view);
  hasp::TracedPicture picture;
  scene.tracer.TracePicture(view, picture);
  int hits = 0;
  for (int n = 0; n < 98 * 67; ++n)
  {
    hasp::CellRay ray;
    const bool kept = rays.Of(glm::dvec2(n % 98, n / 98) + 0.5, ray);
    const auto hit = kept ? scene.tracer.Trace(ray) : std::nullopt;
    ASSERT_EQ(picture.cells[n], hit ? hit->number : hasp::TracedPicture::Nothing) << n;
    if (!hit)
      continue;
    ++hits;
    ASSERT_EQ(picture.places[n], hit->local) << n;
    ASSERT_EQ(picture.corners[n], hit->cell) << n;
    ASSERT_EQ(glm::vec3(picture.gradients[n]), hit->gradient) << n;
  }
  EXPECT_GT(hits, 2000);
}

TEST(CellTracerPicture, APictureThatWasUsedShowsTheNewOneOnly)
{
  const auto scene = Gyroid();
  const hasp::PictureView view = Perspective({ 98, 67 });
  hasp::PictureView aside = view; // half of what it showed is open now
  aside.indexToClip[0] *= 0.3;
  hasp::TracedPicture used, fresh, plain;
  scene.tracer.TracePicture(view, used);
  scene.tracer.TracePicture(aside, used);
  scene.tracer.TracePicture(aside, fresh);
  scene.tracer.TracePicture(aside, plain, false);
  EXPECT_NE(std::ranges::count(fresh.cells, hasp::TracedPicture::Nothing), 0);
  EXPECT_EQ(used.cells, fresh.cells);
  EXPECT_EQ(used.gradients, fresh.gradients);
  EXPECT_EQ(plain.cells, fresh.cells);
  EXPECT_EQ(plain.gradients, fresh.gradients);
  EXPECT_TRUE(plain.places.empty() && plain.corners.empty()) << "not asked for";
  hasp::TracedPicture lit = used;
  scene.tracer.TracePicture(aside, lit, false);
  EXPECT_EQ(lit.places.capacity() + lit.corners.capacity(), 0) << "not any more";
  for (std::size_t n = 0; n < fresh.cells.size(); ++n)
    if (fresh.cells[n] != hasp::TracedPicture::Nothing)
    {
      ASSERT_EQ(used.places[n], fresh.places[n]) << n;
      ASSERT_EQ(used.corners[n], fresh.corners[n]) << n;
    }
}

/// Embree parts our packets where the CPU has no 16 lanes, and asks for their rays in other orders.
TEST(CellTracerPicture, NarrowerCpusSeeTheSameInEveryBit)
{
  const auto scene = Gyroid();
  const hasp::PictureView view = Perspective({ 98, 67 });
  hasp::TracedPicture wide;
  scene.tracer.TracePicture(view, wide);
  std::vector<hasp::CellHit> hits;
  for (int n = 0; n < 98 * 67; n += 3)
    if (const auto hit = scene.tracer.Trace(PixelRay(view, n % 98, n / 98)))
      hits.push_back(*hit);
  ASSERT_GT(hits.size(), 700U);
  for (const char* device : { "isa=avx2", "isa=avx", "isa=sse4.2", "isa=sse2" })
  {
    const hasp::CellTracer narrow(scene.cells, device);
    hasp::TracedPicture picture;
    narrow.TracePicture(view, picture);
    EXPECT_EQ(picture.cells, wide.cells) << device;
    EXPECT_EQ(picture.places, wide.places) << device;
    EXPECT_EQ(picture.corners, wide.corners) << device;
    EXPECT_EQ(picture.gradients, wide.gradients) << device;
    std::size_t count = 16, lit = 0;
    for (std::size_t from = 0; from + count <= hits.size(); from += count, count = from % 16 + 1)
    {
      const std::span<const hasp::CellHit> some(hits.data() + from, count);
      const std::uint32_t seen = narrow.Sees(some, { 0.3, -0.2, 0.9, 0.0 });
      ASSERT_EQ(seen, scene.tracer.Sees(some, { 0.3, -0.2, 0.9, 0.0 })) << device << " " << from;
      lit += static_cast<std::size_t>(std::popcount(seen));
    }
    EXPECT_GT(lit, 50U);
  }
}

TEST(CellTracerPicture, EyeAMillionVoxelsAwayIsAsGoodAsANearOne)
{
  const auto scene = Gyroid();
  const glm::dvec3 middle(25, 20, 22), way = glm::normalize(glm::dvec3(3, -2, 1));
  const hasp::PictureView view{ glm::perspective(6e-5, 1.0, 1e6 - 100, 1e6 + 100) *
                                  glm::lookAt(middle + 1e6 * way, middle, glm::dvec3(0, 0, 1)),
    { 64, 64 }, {} };
  hasp::TracedPicture picture;
  scene.tracer.TracePicture(view, picture);
  int hits = 0;
  for (int n = 0; n < 64 * 64; ++n)
  {
    // Truth: the same ray, begun next to the volume.
    const hasp::CellRay ray = PixelRay(view, n % 64, n / 64);
    const glm::dvec3 d = glm::normalize(ray.direction);
    const auto truth = hasp::testing::TraceTruth(scene.view, scene.isovalue, ray.origin, d, 0, 1e9);
    ASSERT_EQ(picture.cells[n] != hasp::TracedPicture::Nothing, truth.t.has_value()) << n;
    if (!truth.t)
      continue;
    ++hits;
    const glm::dvec3 place =
      glm::dvec3(scene.cells->Cell(picture.cells[n])) + glm::dvec3(picture.places[n]);
    ASSERT_LT(glm::distance(place, ray.origin + *truth.t * d), 1e-3) << n;
  }
  EXPECT_GT(hits, 1000);
}

TEST(CellTracerPicture, PlanesAndNearPlaneCutRays)
{
  const auto scene = Gyroid();
  hasp::PictureView view = Perspective({ 60, 60 });
  view.planes = { glm::dvec4(-1, 0.2, 0, 22), glm::dvec4(0, 0, -1, 30) };
  hasp::TracedPicture picture;
  scene.tracer.TracePicture(view, picture);
  int hits = 0, moved = 0;
  for (int n = 0; n < 3600; ++n)
  {
    hasp::CellRay ray = PixelRay(view, n % 60, n / 60);
    const auto uncut = scene.tracer.Trace(ray);
    for (const glm::dvec4& plane : view.planes)
    {
      const double at = glm::dot(plane, glm::dvec4(ray.origin, 1)),
                   slope = glm::dot(glm::dvec3(plane), ray.direction);
      (slope > 0 ? ray.tMin : ray.tMax) =
        slope > 0 ? std::max(ray.tMin, -at / slope) : std::min(ray.tMax, -at / slope);
    }
    const auto hit = scene.tracer.Trace(ray);
    ASSERT_EQ(hit.has_value(), picture.cells[n] != hasp::TracedPicture::Nothing) << n;
    if (!hit)
      continue;
    ++hits;
    moved += uncut && uncut->number != hit->number;
    for (const glm::dvec4& plane : view.planes)
      EXPECT_GE(glm::dot(plane, glm::dvec4(hit->Position(), 1)), -1e-4);
    EXPECT_GE(picture.gradients[n].w, 0.0F);
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(moved, 200);

  view.planes = { glm::dvec4(0, 0, 0, -1) }; // keeps nothing
  scene.tracer.TracePicture(view, picture);
  for (const std::uint32_t cell : picture.cells)
    ASSERT_EQ(cell, hasp::TracedPicture::Nothing);
}

TEST(CellTracerPicture, RefusesWhatIsNoView)
{
  const auto scene = Gyroid();
  hasp::TracedPicture picture;
  EXPECT_THROW(
    scene.tracer.TracePicture({ glm::dmat4(1), { -1, 4 }, {} }, picture), std::invalid_argument);
  EXPECT_THROW(
    scene.tracer.TracePicture({ glm::dmat4(0), { 4, 4 }, {} }, picture), std::invalid_argument);
}

} // namespace
