#include "Failure.h"
#include "StereoChoices.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{

using namespace hasp;

TEST(StereoChoices, AreRefusedWithWhatToDo)
{
  const auto refuse = [](const std::function<void(StereoChoices&)>& change, const char* words)
  {
    StereoChoices choices;
    change(choices);
    try
    {
      MakeStereoWindow(choices);
      ADD_FAILURE() << "taken: " << words;
    }
    catch (const Failure& failure)
    {
      EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
    }
  };
  for (const char* size : { "520", "520x", "x320", "520x320x1", "520,320", "nanx320", "1x320",
         "20.5x11.5", "520x1e9", "520 x 320", "520x320mm", "infxinf", "-520x320" })
    refuse([&](StereoChoices& c) { c.screen = size; }, "--screen must be WIDTHxHEIGHT in mm");
  refuse([](StereoChoices& c) { c.headMm = { 0.0, 0.0, 600.0 }; }, "give --screen or --hmd too");
  refuse([](StereoChoices& c) { c.lifeSize = true; }, "give --screen or --hmd too");
  refuse([](StereoChoices& c) { c.eyeAngle = 5.0; }, "for two eyes; give --stereo too");
  refuse([](StereoChoices& c) { c.swapEyes = true; }, "for two eyes; give --stereo too");
  refuse(
    [](StereoChoices& c)
    {
      c.screen = "520x320";
      c.eyeSeparationMm = 63.0;
    },
    "for two eyes; give --stereo too");
  refuse(
    [](StereoChoices& c)
    {
      c.layout = "left";
      c.swapEyes = true;
    },
    "--stereo left and right draw one");
  for (const double metres : { 0.063, 6.3 })
    refuse(
      [=](StereoChoices& c)
      {
        c.layout = "anaglyph";
        c.screen = "520x320";
        c.eyeSeparationMm = metres;
      },
      "must be 0 or from 10 to 200 mm");
  refuse(
    [](StereoChoices& c)
    {
      c.layout = "side-by-side";
      c.hmd = { 45.0, 45.0, 45.0, 45.0 };
    },
    "1 is 45 degrees");
  for (const char* layout : { "mono", "left", "right", "anaglyph", "dual-window", "quad-buffer" })
    refuse(
      [&](StereoChoices& c)
      {
        c.layout = layout;
        c.resolution = "half";
      },
      "--eye-resolution half is for");
  refuse(
    [](StereoChoices& c)
    {
      c.screen = "520x320";
      c.headMm = { 0.0, 0.0, -1.0 };
    },
    "in front of the screen");
  refuse([](StereoChoices& c) { c.hmd = { 1.0, 1.0, 1.0, 1.0 }; }, "give --stereo too");
  refuse(
    [](StereoChoices& c)
    {
      c.layout = "side-by-side";
      c.hmd = { -1.0, 1.0, 1.0, 1.0 };
    },
    "left and right add up to");
  refuse([](StereoChoices& c) { c.lens = "no-such-lens.json"; }, "--lens is for a display");
  refuse(
    [](StereoChoices& c)
    {
      c.screen = "520x320";
      c.lens = "no-such-lens.json";
    },
    "--lens: ");
  EXPECT_EQ(ScreenSize("520.5x320"), (std::array{ 520.5, 320.0 }));
}

TEST(StereoChoices, PixelsFollowScreenAndLayout)
{
  StereoChoices choices;
  choices.screen = "520x320";
  using Size = std::array<int, 2>;
  const auto pixels = [&](const char* layout, bool square)
  {
    choices.layout = layout;
    return WindowPixels(MakeStereoWindow(choices), { 800, 800 }, square);
  };
  EXPECT_EQ(pixels("mono", true), (Size{ 1300, 800 }));
  EXPECT_EQ(pixels("mono", false), (Size{ 800, 800 }));
  EXPECT_EQ(pixels("side-by-side", true), (Size{ 2600, 800 }));
  choices.resolution = "half";
  EXPECT_EQ(pixels("side-by-side", true), (Size{ 1300, 800 }));
  EXPECT_EQ(pixels("interlaced", true), (Size{ 1300, 800 }));
  choices.screen.clear();
  choices.resolution = "full";
  choices.layout = "side-by-side";
  EXPECT_THROW(WindowPixels(MakeStereoWindow(choices), { 16384, 100 }, true), Failure);
}

} // namespace
