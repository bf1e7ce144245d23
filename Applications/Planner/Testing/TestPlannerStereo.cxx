// The second window for two eyes: what each of them sees there is the geometry of eyes, screen and
// head that the settings say in millimetres, wherever a tracked head is.
#include "PlannerDesk.h"
#include "StereoBalls.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <optional>

namespace
{
using namespace stereo;

constexpr std::chrono::seconds TooLate(60);
constexpr double PixelsOff = 0.5; // of the middle of a ball's pixels from that of the ball

std::string TextOf(const Seen& seen)
{
  return nlohmann::json(seen).dump();
}

class PlannerStereo : public PlannerDesk
{
protected:
  std::unique_ptr<PlannerProcess> OpenBalls()
  {
    const std::filesystem::path scan = this->folder / "balls.mha";
    BallScan{ { Near, Far } }.Write(scan);
    auto planner = this->Open({ scan.string() });
    planner->Click("step.split");
    planner->SetNumber("split.isovalue", 0.5 * (BallScan::Tissue + BallScan::Bone));
    planner->Key("alt+1"); // from the front
    return planner;
  }
  /// A path of heads as `hasp view --record-head` writes it; of one pose: a head that keeps still.
  std::string Recording(const std::vector<std::pair<double, Head>>& path) const
  {
    const std::string file = (this->folder / "head.csv").string();
    std::ofstream out(file);
    out << "timeS,xMm,yMm,zMm,qw,qx,qy,qz\n";
    for (const auto& [timeS, head] : path)
    {
      const double half = head.tiltDegrees * M_PI / 360.0;
      out << timeS << ',' << head.at[0] << ',' << head.at[1] << ',' << head.at[2] << ','
          << std::cos(half) << ",0,0," << std::sin(half) << '\n';
    }
    return file;
  }
  static void AskForSettings(PlannerProcess& planner)
  {
    planner.Menu({ "menu.view", "view.stereo.settings" });
    planner.Choose("stereo.layout", 1); // side by side
    planner.SetChecked("stereo.known", true);
    planner.SetNumber("stereo.width", ScreenMm[0]);
    planner.SetNumber("stereo.height", ScreenMm[1]);
    planner.SetChecked("stereo.life", true);
  }
  /// Where the head is said by a recording. The program does not come to rest while it moves.
  static layout::Rect Follow(PlannerProcess& planner, const std::string& recording)
  {
    AskForSettings(planner);
    planner.Choose("stereo.head", 3);
    planner.SetText("stereo.head.more", recording);
    const auto ok = layout::RectOf(planner.Widget("stereo.ok"));
    planner.Hand().Click(layout::MiddleX(ok), layout::MiddleY(ok));
    return WindowOf(planner);
  }
  static layout::Rect WindowOf(PlannerProcess& planner)
  {
    planner.WaitUntil(
      "the stereo window", [](const auto& now) { return layout::Find(now, "stereo.window"); });
    return layout::RectOf(*layout::Find(planner.Layout(), "stereo.window"));
  }
  /// It has the keyboard, and lies above the menus: closed, it is gone.
  static void Close(PlannerProcess& planner)
  {
    planner.Hand().Key("3");
    planner.WaitUntil(
      "no stereo window", [](const auto& now) { return !layout::Find(now, "stereo.window"); });
  }
  /// What the window shows now; none while a ball is missing.
  static std::optional<Seen> Look(PlannerProcess& planner, const layout::Rect& window)
  {
    const QImage picture =
      planner.Hand().Picture().copy(window[0], window[1], window[2], window[3]);
    Seen seen{};
    for (int eye = 0; eye < 2; ++eye)
      for (int ball = 0; ball < 2; ++ball)
      {
        const QRect part(eye * picture.width() / 2, ball * picture.height() / 2,
          picture.width() / 2, picture.height() / 2);
        const auto middle = MiddleOf(picture.copy(part));
        if (!middle)
          return std::nullopt;
        seen[std::size_t(eye)][std::size_t(ball)] = { (*middle)[0], (*middle)[1] + part.y() };
      }
    return seen;
  }
  /// Of the pixels of bone: as red as green and less blue, which the ground is not.
  static std::optional<std::array<double, 2>> MiddleOf(const QImage& picture)
  {
    double x = 0.0, y = 0.0, count = 0.0;
    for (int row = 0; row < picture.height(); ++row)
      for (int column = 0; column < picture.width(); ++column)
        if (const QRgb pixel = picture.pixel(column, row); qBlue(pixel) < qRed(pixel))
        {
          x += column + 0.5;
          y += row + 0.5;
          ++count;
        }
    if (count < 200) // a ball has more than twice that
      return std::nullopt;
    return std::array{ x / count, y / count };
  }
  /// The tracker eases to a head that it finds elsewhere: waits until the picture is that one's.
  static void ExpectSeenFrom(PlannerProcess& planner, const layout::Rect& window, const Head& head)
  {
    const Seen expected = Expected(head, window);
    std::optional<Seen> seen;
    const auto start = std::chrono::steady_clock::now();
    do
      seen = Look(planner, window);
    while ((!seen || Farthest(*seen, expected) > PixelsOff) &&
           std::chrono::steady_clock::now() - start < TooLate);
    ASSERT_TRUE(seen) << "a ball is not seen";
    EXPECT_LE(Farthest(*seen, expected), PixelsOff) << TextOf(*seen) << "\n" << TextOf(expected);
    // What is before the screen stands farther right for the left eye, what is behind it farther
    // left.
    EXPECT_GT((*seen)[0][0][0], (*seen)[1][0][0] + 2.0);
    EXPECT_LT((*seen)[0][1][0], (*seen)[1][1][0] - 2.0);
  }
};

TEST_F(PlannerStereo, EyesSeeWhatTheSettingsSayInMillimetres)
{
  const auto planner = this->OpenBalls();
  for (const Head& head : { Head{}, Head{ { 0, 0, 450 }, 0.0, 80.0 } })
  {
    AskForSettings(*planner);
    planner->SetNumber("stereo.distance", head.at[2]);
    planner->SetNumber("stereo.eyes", head.eyesMm);
    planner->Click("stereo.ok");
    ExpectSeenFrom(*planner, WindowOf(*planner), head);
    Close(*planner);
  }
}

TEST_F(PlannerStereo, TheDeskIsDrawnWithWhatIsShown)
{
  const auto planner = this->OpenBalls();
  const auto drawing = [&]
  {
    AskForSettings(*planner);
    const auto rect = layout::RectOf(planner->Widget("stereo.sketch"));
    const QImage picture = planner->Hand().Picture().copy(rect[0], rect[1], rect[2], rect[3]);
    planner->Click("stereo.cancel");
    return picture;
  };
  const QImage shown = drawing();
  EXPECT_EQ(drawing(), shown);
  planner->ClickId("objects", 1, 0, 3);
  planner->Click("objects.show"); // which hides it
  EXPECT_NE(drawing(), shown);
}

TEST_F(PlannerStereo, EyesSeeFromWhereATrackedHeadIs)
{
  const auto planner = this->OpenBalls();
  for (const Head& head : { Head{ { 150, 60, 450 } }, Head{ { -120, -50, 700 }, 25.0 } })
  {
    const auto window = Follow(*planner, this->Recording({ { 0.0, head } }));
    ExpectSeenFrom(*planner, window, head);
    Close(*planner);
  }
}

/// Whatever the 3D view shows: here bone that goes with its isovalue, and comes back.
TEST_F(PlannerStereo, ShowsWhatThe3DViewShows)
{
  const auto planner = this->OpenBalls();
  AskForSettings(*planner);
  planner->Click("stereo.ok");
  const auto window = WindowOf(*planner);
  ExpectSeenFrom(*planner, window, {});
  const auto setIsovalue = [&](double share) { // the slider lies beside the stereo window
    planner->ClickAt("split.isovalue.slider", share, 0.5, 2);
  };
  setIsovalue(0.995); // above bone
  const auto start = std::chrono::steady_clock::now();
  while (Look(*planner, window) && std::chrono::steady_clock::now() - start < TooLate)
    ;
  EXPECT_FALSE(Look(*planner, window)) << "bone that is gone is still seen";
  setIsovalue(0.65);
  ExpectSeenFrom(*planner, window, {});
}

/// While a head goes from side to side the pictures are of one head each, wherever it is just then:
/// the near ball in the left eye says where, and all else is seen from there.
TEST_F(PlannerStereo, PicturesGoWithAHeadThatMoves)
{
  constexpr double AsideMm = 120.0, SweepS = 6.0;
  const auto planner = this->OpenBalls();
  const auto window = Follow(*planner,
    this->Recording({ { 0.0, { { -AsideMm, 0, 600 } } }, { SweepS, { { AsideMm, 0, 600 } } } }));
  const double middle = Expected({}, window)[0][0][0];
  const double perMm = Expected({ { 1, 0, 600 } }, window)[0][0][0] - middle;
  double x = 0.0, least = 0.0, most = 0.0; // of the head
  const auto isOfOneHead = [&](const std::optional<Seen>& seen)
  {
    x = seen ? ((*seen)[0][0][0] - middle) / perMm : 0.0;
    return seen && Farthest(*seen, Expected({ { x, 0, 600 } }, window)) <= 2.0 * PixelsOff;
  };
  const auto start = std::chrono::steady_clock::now();
  const auto isLate = [&] { return std::chrono::steady_clock::now() - start > TooLate; };
  while (!isOfOneHead(Look(*planner, window))) // until it has drawn for the first time
    ASSERT_FALSE(isLate());
  int pictures = 0;
  for (; (least > -0.5 * AsideMm || most < 0.5 * AsideMm) && !isLate(); ++pictures)
  {
    const auto seen = Look(*planner, window);
    ASSERT_TRUE(isOfOneHead(seen)) << "head at " << x << " mm: " << (seen ? TextOf(*seen) : "");
    least = std::min(least, x);
    most = std::max(most, x);
  }
  EXPECT_LT(least, -0.5 * AsideMm);
  EXPECT_GT(most, 0.5 * AsideMm);
  std::cout << pictures << " pictures, the head from " << least << " to " << most << " mm\n";
}

} // namespace
