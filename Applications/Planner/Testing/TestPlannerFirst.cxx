// What bin/hasp-planner shows at first: a window of the size that was asked for, and a scan's bone
// from the front, all of it, at an isovalue that is proposed.
#include "../../CommandLine/Testing/HaspProcess.h"
#include "BallScan.h"
#include "LayoutEntries.h"
#include "PlannerDesk.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

class PlannerSize : public PlannerDesk
{
protected:
  /// Its window, as it draws it itself.
  HaspRun Shoot(const std::string& size) const
  {
    const std::string own = (this->folder / "own").string();
    return RunHasp({ "--state", own, "--plans", own, "--size", size, "--screenshot",
                     this->Png().string(), "--exit" },
      {}, this->Screen.Display());
  }
  std::filesystem::path Png() const { return this->folder / "window.png"; }
};

TEST_F(PlannerSize, IsWhatWasAskedFor)
{
  for (const auto& [width, height] : { std::pair(1280, 800), { 1130, 790 }, { 1210, 765 } })
  {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const HaspRun run = this->Shoot(size);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const QImage picture(QString::fromStdString(this->Png().string()));
    EXPECT_EQ(picture.width(), width) << size;
    EXPECT_EQ(picture.height(), height) << size;
  }
}

TEST_F(PlannerSize, IsNeverSmallerThanWhatIsInIt)
{
  const HaspRun run = this->Shoot("100x100");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const QImage picture(QString::fromStdString(this->Png().string()));
  EXPECT_GT(picture.width(), 500); // the steps' names
  EXPECT_GT(picture.height(), 200);
}

TEST_F(PlannerSize, WhatIsNoneIsRefusedWithoutAPicture)
{
  for (const char* size : { "1280", "0x800", "1280x-1", "1280x800x2", "wide" })
  {
    EXPECT_EQ(this->Shoot(size).exitCode, 1) << size;
    EXPECT_FALSE(std::filesystem::exists(this->Png())) << size;
  }
}

/// Bone of a file that says no HU: three balls, of which the one in the middle is nearest.
class PlannerFirstLook : public PlannerDesk
{
protected:
  static constexpr BallScan::Place Low{ -20, 70, -40 }, High{ 20, 50, 30 }, Before{ 0, -60, -5 };
  static constexpr double Margin = 25.0; ///< in pixels: what is higher or lower is not Before

  std::unique_ptr<PlannerProcess> Import()
  {
    const std::filesystem::path scan = this->folder / "balls.mha";
    BallScan{ { Low, High, Before } }.Write(scan);
    auto planner = this->Open();
    planner->Click("import.open");
    planner->AnswerFile(scan.string());
    return planner;
  }
  /// Middle of the pixels of bone above that margin, or below it: right and down from the view's.
  static std::array<double, 2> BoneIn(const QImage& view, bool above)
  {
    double x = 0.0, y = 0.0, count = 0.0;
    for (int row = 0; row < view.height(); ++row)
      for (int column = 0; column < view.width(); ++column)
      {
        const double right = column + 0.5 - 0.5 * view.width();
        const double down = row + 0.5 - 0.5 * view.height();
        const QRgb pixel = view.pixel(column, row);
        const bool isBone = qBlue(pixel) < qRed(pixel); // the ground is blue, as is the cube
        if (!isBone || (above ? down > -Margin : down < Margin))
          continue;
        x += right;
        y += down;
        ++count;
      }
    EXPECT_GT(count, 200);
    return { x / count, y / count };
  }
  /// By what VTK's ResetCamera says of it: an angle of 30 degrees along the view's height, and the
  /// sphere around the bone's box in the narrower direction.
  static std::array<double, 2> Expected(const BallScan::Place& ball, const layout::Rect& view)
  {
    constexpr double r = BallScan::RadiusMm;
    const std::array<double, 3> middle{ 0.0, 0.5 * (Low[1] + Before[1]), 0.5 * (Low[2] + High[2]) };
    const double radius =
      std::hypot(High[0] + r, 0.5 * (Low[1] - Before[1]) + r, 0.5 * (High[2] - Low[2]) + r);
    const double aspect = double(view[2]) / view[3], slope = std::tan(M_PI / 12.0);
    const double narrow = std::atan(slope * std::min(1.0, aspect));
    const double away = radius / std::sin(narrow) + ball[1] - middle[1]; // the viewer is anterior
    const double pixels = 0.5 * view[3] / slope / away;
    return { pixels * (ball[0] - middle[0]), -pixels * (ball[2] - middle[2]) };
  }
};

TEST_F(PlannerFirstLook, FramesTheBoneFromTheFront)
{
  const auto planner = this->Import();
  const auto view = layout::RectOf(planner->Widget("view.scene"));
  const QImage picture = planner->Hand().Picture().copy(view[0], view[1], view[2], view[3]);
  for (const auto& [ball, above] : { std::pair(High, true), std::pair(Low, false) })
  {
    const auto seen = BoneIn(picture, above), expected = Expected(ball, view);
    constexpr double off = 2.0; // pixels: the box is of whole voxels, each of them 1.6 pixels
    EXPECT_NEAR(seen[0], expected[0], off) << (above ? "above" : "below");
    EXPECT_NEAR(seen[1], expected[1], off) << (above ? "above" : "below");
  }
}

TEST_F(PlannerFirstLook, AnEmptyWindowSaysHowToBegin)
{
  EXPECT_TRUE(this->Open()->Has("start.hint"));
  EXPECT_FALSE(this->Import()->Has("start.hint"));
}

TEST_F(PlannerFirstLook, APhantomInPlaceOfTheSamplesCTSaysSo)
{
  setenv("HASP_SAMPLE", "none", 1); // of this process alone
  const auto planner = this->Open();
  planner->Menu({ "menu.file", "menu.samples", "file.sample.skull" });
  const std::string said = planner->State("message");
  EXPECT_NE(said.find("Utilities/Scripts/cranium"), std::string::npos) << said;
  EXPECT_FALSE(planner->Has("start.hint"));
}

TEST_F(PlannerFirstLook, AnIsovalueBetweenAirAndBoneIsProposed)
{
  const auto planner = this->Import();
  planner->Click("step.split");
  const double value = planner->Widget("split.isovalue").at("value");
  EXPECT_GT(value, BallScan::Tissue + BallScan::Noise);
  EXPECT_LT(value, BallScan::Bone - BallScan::Noise);
}

} // namespace
