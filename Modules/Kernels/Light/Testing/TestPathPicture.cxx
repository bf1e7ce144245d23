// Pictures by paths: edges, sizes, seeds, what a view cuts away.
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;
using hasp::LitScene;
using hasp::PathTracedPicture;

TEST(PathPicture, EdgesAreCoveredByTheirShare)
{
  // A square of 4 mm, seen straight from above without perspective: a pixel is 1 mm, and the
  // square's edges lie at 0.3 and 0.7 of pixels.
  const LitScene scene(
    { Body(PlaneMesh(2.0), Matt(1.0), glm::translate(glm::dmat4(1), { 0.3, 0.7, 0 })) }, {},
    Uniform(1.0));
  const hasp::PictureView view{ glm::ortho(-4.0, 4.0, -4.0, 4.0, -5.0, 5.0), { 8, 8 }, {} };
  PathTracedPicture smooth, hard;
  constexpr int Samples = 256;
  for (int n = 0; n < Samples; ++n)
  {
    hasp::AddPathSample(scene, view, { { 1 }, 3, true }, smooth);
    hasp::AddPathSample(scene, view, { { 1 }, 3, false }, hard);
  }
  const auto overlap = [](int pixel, double middle)
  {
    const double low = pixel - 4.0, high = low + 1.0;
    return std::max(0.0, std::min(high, middle + 2.0) - std::max(low, middle - 2.0));
  };
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
    {
      const double share = overlap(x, 0.3) * overlap(y, 0.7);
      const glm::vec4 pixel = smooth.Pixel(y * 8 + x);
      EXPECT_NEAR(pixel.a, share, 4.0 / Samples) << x << " " << y; // nets of 256 points: a few off
      EXPECT_NEAR(pixel.r, pixel.a, 1e-5) << "white in light of 1, over black";
      const bool covered = overlap(x, 0.3) >= 0.5 && overlap(y, 0.7) >= 0.5;
      EXPECT_EQ(hard.Pixel(y * 8 + x), glm::vec4(covered ? 1.0F : 0.0F)) << x << " " << y;
    }
  EXPECT_EQ(smooth.Bytes(), 64 * 28);
}

TEST(PathPicture, AnotherSizeBeginsAnew)
{
  const LitScene scene({ Body(SphereMesh({}, 3.0), Matt(0.5)) }, {}, Uniform(1.0));
  PathTracedPicture picture, fresh;
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 20, 10 }), {}, picture);
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 20, 10 }), {}, picture);
  EXPECT_EQ(picture.samples, 2);
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 10, 20 }), {}, picture);
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 10, 20 }), {}, fresh);
  EXPECT_EQ(picture.samples, 1);
  EXPECT_EQ(picture.sums, fresh.sums);
  EXPECT_EQ(picture.covered, fresh.covered);
  EXPECT_EQ(picture.rays, fresh.rays);
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 10, 20 }), { {}, 1 }, fresh);
  hasp::AddPathSample(scene, Camera({ 9, 0, 0 }, {}, { 10, 20 }), {}, picture);
  EXPECT_NE(picture.covered, fresh.covered) << "of another seed";
}

TEST(PathPicture, PlanesOfAViewCut)
{
  const LitScene scene({ Body(PlaneMesh(9.0), Matt(0.5)) }, {}, Uniform(1.0));
  hasp::PictureView view{ glm::ortho(-4.0, 4.0, -4.0, 4.0, -5.0, 5.0), { 8, 8 }, {} };
  view.planes.emplace_back(1.0, 0.0, 0.0, 0.0); // x >= 0 is kept
  PathTracedPicture picture;
  hasp::AddPathSample(scene, view, {}, picture);
  for (int n = 0; n < 64; ++n)
    EXPECT_EQ(picture.Pixel(n).a, n % 8 < 4 ? 0.0F : 1.0F) << n;
}

TEST(PathPicture, BadViewsAreRefused)
{
  const LitScene scene({ Body(SphereMesh({}, 3.0), Matt(0.5)) }, {}, Uniform(1.0));
  PathTracedPicture picture;
  hasp::PictureView view = Camera({ 9, 0, 0 }, {}, { 20, 10 });
  view.size = { 20, -1 };
  try
  {
    hasp::AddPathSample(scene, view, {}, picture);
    FAIL();
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("20 x -1"), std::string::npos) << e.what();
  }
  view.size = { 20, 10 };
  view.indexToClip = glm::dmat4(0.0);
  EXPECT_THROW(hasp::AddPathSample(scene, view, {}, picture), std::invalid_argument);
  view = Camera({ 9, 0, 0 }, {}, { 20, 10 });
  EXPECT_THROW(hasp::AddPathSample(scene, view, { { 0 } }, picture), std::invalid_argument);
  EXPECT_EQ(picture.samples, 0);
  view.size = { 0, 10 };
  EXPECT_TRUE(hasp::AddPathSample(scene, view, {}, picture));
  EXPECT_TRUE(picture.sums.empty());
  EXPECT_EQ(PathTracedPicture{}.Bytes(), 0);
}

} // namespace
