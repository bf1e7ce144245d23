#include "StereoSketch.h"

#include "vtkHaspHeadlessWindows.h"
#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{

using namespace hasp;

/// A screen of 520 x 320 mm, eyes 60 mm apart and 600 mm in front of it; a box from 100 mm in front
/// of the screen to 150 mm behind it.
StereoSketch Desk()
{
  StereoSketch sketch{ "desk", {}, std::array<glm::dvec3, 8>{} };
  sketch.rig.screen.widthMm = 520.0;
  sketch.rig.screen.heightMm = 320.0;
  sketch.rig.head.position = { 0.0, 0.0, 600.0 };
  sketch.rig.head.eyeSeparationMm = 60.0;
  for (int n = 0; n < 8; ++n)
    (*sketch.content)[n] = { n & 1 ? 80.0 : -80.0, n & 2 ? 90.0 : -90.0, n & 4 ? 100.0 : -150.0 };
  return sketch;
}

bool Holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(StereoSketch, SaysWhatARulerWouldFind)
{
  const std::string text = StereoSketchText(Desk());
  // 2 atan(260/600), 2 atan(160/600)
  EXPECT_TRUE(Holds(text, "desk\nscreen 520 x 320 mm, seen under 46.9 x 29.9 degrees")) << text;
  EXPECT_TRUE(Holds(text, "eyes 60.0 mm apart, 600 mm in front")) << text;
  // 60 * 100 / (600 - 100) in front, crossed; 60 * 150 / (600 + 150) behind; at 600 mm.
  EXPECT_TRUE(Holds(text, "nearest 100 mm in front of the screen: disparity -12.0 mm, -1.15 deg"))
    << text;
  EXPECT_TRUE(Holds(text, "farthest 150 mm behind the screen: disparity 12.0 mm, 1.15 deg"))
    << text;
}

TEST(StereoSketch, IsTheSameWhereverTheRoomLies)
{
  const StereoSketch here = Desk();
  // A quarter turn about y, and a shift.
  const glm::dmat4 map(glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(1, 0, 0, 0),
    glm::dvec4(5, 6, 7, 1));
  StereoSketch there = here;
  there.rig = TransformStereoRig(here.rig, map);
  for (glm::dvec3& corner : *there.content)
    corner = glm::dvec3(map * glm::dvec4(corner, 1.0));
  EXPECT_EQ(StereoSketchText(there), StereoSketchText(here));
}

TEST(StereoSketch, SaysThatContentIsBehindTheEyes)
{
  StereoSketch sketch = Desk();
  (*sketch.content)[7].z = 650.0;
  EXPECT_TRUE(Holds(StereoSketchText(sketch), "nearest 650 mm in front of the screen: behind the"));
}

TEST(StereoSketch, RefusesWhatIsNoRig)
{
  StereoSketch sketch = Desk();
  sketch.rig.head.position.z = -1.0;
  EXPECT_THROW(DrawStereoSketch(sketch), std::invalid_argument);
}

TEST(StereoSketch, DrawsScreenEyesAndContentInBothPlans)
{
  UseHeadlessWindows();
  const auto picture = DrawStereoSketch(Desk());
  ASSERT_TRUE(picture);
  const int* size = picture->GetDimensions();
  const auto* pixels = static_cast<const unsigned char*>(picture->GetScalarPointer());
  for (int half = 0; half < 2; ++half)
  {
    int left = 0, right = 0, content = 0, screen = 0;
    for (int y = size[1] / 5; y < size[1]; ++y)
      for (int x = half * size[0] / 2; x < (half + 1) * size[0] / 2; ++x)
      {
        const unsigned char* p = pixels + 3 * (y * size[0] + x);
        left += p[0] > 150 && p[1] < 80 && p[2] < 80;
        right += p[2] > 150 && p[0] < 60;
        content += p[1] > 100 && p[0] < 80 && p[2] < 90;
        screen += p[0] < 60 && p[1] < 60 && p[2] < 60;
      }
    EXPECT_GT(right, 400) << half;
    EXPECT_GT(content, 400) << half;
    EXPECT_GT(screen, 800) << half;
    if (half == 0) // from the side the right eye hides the left one
    {
      EXPECT_GT(left, 400);
    }
  }
}

} // namespace
