#include "StereoSketch.h"

#include "Failure.h"
#include "VtkMessages.h"

#include "vtkHaspHeadlessWindows.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

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
  StereoSketch sketch{ "desk", {} };
  sketch.content.emplace();
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
  EXPECT_TRUE(Holds(text, "eyes 60.0 mm apart (red: left, blue: right), 600 mm in front")) << text;
  // 60 * 100 / (600 - 100) in front, crossed; 60 * 150 / (600 + 150) behind; at 600 mm.
  EXPECT_TRUE(Holds(text, "nearest 100 mm in front of the screen: disparity -12.0 mm, -1.15 deg"))
    << text;
  EXPECT_TRUE(Holds(text, "farthest 150 mm behind the screen: disparity 12.0 mm, 1.15 deg"))
    << text;
}

TEST(StereoSketch, WarnsOfWhatIsSeenDouble)
{
  StereoSketch sketch = Desk();
  EXPECT_FALSE(Holds(StereoSketchText(sketch), "TOO FAR APART"));
  (*sketch.content)[0].z = 150.0; // 60 * 150 / (600 - 150) = 20 mm at 600: 1.91 degrees
  EXPECT_TRUE(Holds(StereoSketchText(sketch), "-1.91 degrees: TOO FAR APART"))
    << StereoSketchText(sketch);
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

TEST(StereoSketch, MonoIsOneEyeAndHasNoDisparity)
{
  StereoSketch sketch = Desk();
  sketch.layout = StereoLayout::Mono;
  const std::string text = StereoSketchText(sketch);
  EXPECT_TRUE(Holds(text, "46.9 x 29.9 degrees; one eye, 600 mm in front of it")) << text;
  EXPECT_TRUE(Holds(text, "nearest 100 mm in front of the screen\nfarthest 150 mm behind")) << text;
  EXPECT_FALSE(Holds(text, "disparity")) << text;
}

TEST(StereoSketch, LeftAndRightAreThatEye)
{
  StereoSketch sketch = Desk();
  sketch.rig.head.position.x = 30.0; // so that the left eye is before the middle
  sketch.layout = StereoLayout::Left;
  const std::string left = StereoSketchText(sketch);
  EXPECT_TRUE(Holds(left, "46.9 x 29.9 degrees; the left eye of two 60.0 mm apart, 600 mm"))
    << left;
  EXPECT_FALSE(Holds(left, "disparity")) << left;
  sketch.layout = StereoLayout::Right; // atan(320 / 600) + atan(200 / 600)
  const std::string right = StereoSketchText(sketch);
  EXPECT_TRUE(Holds(right, "46.5 x 29.7 degrees; the right eye")) << right;
}

TEST(StereoSketch, AScreenSeenFromTheSideIsNarrower)
{
  StereoSketch sketch = Desk();
  sketch.rig.head.position = { 300.0, 0.0, 600.0 };
  const std::string text = StereoSketchText(sketch);
  // atan(560 / 600) - atan(40 / 600); 2 atan(160 / sqrt(300^2 + 600^2))
  EXPECT_TRUE(Holds(text, "seen under 39.2 x 26.8 degrees")) << text;
}

TEST(StereoSketch, SaysWhatTheBoxIsOfAndThatThereIsNone)
{
  StereoSketch sketch = Desk();
  EXPECT_FALSE(Holds(StereoSketchText(sketch), "volume"));
  sketch.contentIsVolume = true;
  EXPECT_TRUE(Holds(StereoSketchText(sketch), "\nbox of the volume: nearest 100 mm in front"));
  sketch.content.reset();
  const std::string text = StereoSketchText(sketch);
  EXPECT_TRUE(Holds(text, "\nnothing is shown")) << text;
  EXPECT_FALSE(Holds(text, "nearest")) << text;
}

TEST(StereoSketch, AnErrorOfVtkIsOne)
{
  UseHeadlessWindows();
  const VtkMessageCapture capture([](const std::string&) {});
  vtkNew<vtkRenderWindow> window;
  vtkErrorWithObjectMacro(window, << "no memory");
  EXPECT_THROW(DrawStereoSketch(Desk()), Failure);
  EXPECT_NO_THROW(DrawStereoSketch(Desk()));
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

/// Pixels of one of the two plans.
struct Inks
{
  int left = 0, right = 0, content = 0, screen = 0;
};

std::array<Inks, 2> Draw(const StereoSketch& sketch)
{
  const auto picture = DrawStereoSketch(sketch);
  const int* size = picture->GetDimensions();
  const auto* pixels = static_cast<const unsigned char*>(picture->GetScalarPointer());
  std::array<Inks, 2> inks;
  for (int half = 0; half < 2; ++half)
    for (int y = size[1] / 5; y < size[1]; ++y)
      for (int x = half * size[0] / 2; x < (half + 1) * size[0] / 2; ++x)
      {
        const unsigned char* p = pixels + 3 * (y * size[0] + x);
        inks[half].left += p[0] > 150 && p[1] < 80 && p[2] < 80;
        inks[half].right += p[2] > 150 && p[0] < 60;
        inks[half].content += p[1] > 100 && p[0] < 80 && p[2] < 90;
        inks[half].screen += p[0] < 60 && p[1] < 60 && p[2] < 60;
      }
  return inks;
}

TEST(StereoSketch, DrawsScreenEyesAndContentInBothPlans)
{
  UseHeadlessWindows();
  const auto inks = Draw(Desk());
  EXPECT_GT(inks[0].left, 400); // from the side the right eye hides the left one
  for (const Inks& plan : inks)
  {
    EXPECT_GT(plan.right, 400);
    EXPECT_GT(plan.content, 400);
    EXPECT_GT(plan.screen, 800);
  }
}

TEST(StereoSketch, DrawsNeitherEyesNorContentThatAreNot)
{
  UseHeadlessWindows();
  StereoSketch sketch = Desk();
  sketch.layout = StereoLayout::Left;
  const Inks left = Draw(sketch)[0];
  EXPECT_GT(left.left, 400);
  EXPECT_EQ(left.right, 0);
  sketch.layout = StereoLayout::Mono;
  sketch.content.reset();
  const Inks mono = Draw(sketch)[0];
  EXPECT_EQ(mono.left + mono.right + mono.content, 0);
  EXPECT_GT(mono.screen, left.screen + 300); // the eye between them has the screen's ink
}

} // namespace
