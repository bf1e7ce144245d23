// Skin and the brightest values in bin/hasp-planner's window, switched by keys and in the menu.
#include "BallScan.h"
#include "LayoutEntries.h"
#include "PlannerDesk.h"

#include <QDir>
#include <QImage>

namespace
{

class PlannerSceneLooks : public PlannerDesk
{
protected:
  PlannerSceneLooks()
  {
    BallScan{ { { 0, 0, 0 } }, { 30, 30, 30 } }.Write(this->folder / "balls.mha");
  }
  QImage View(PlannerProcess& planner, const char* name) const
  {
    const auto view = layout::RectOf(planner.Widget("view.scene"));
    QImage picture = planner.Hand().Picture().copy(view[0], view[1], view[2], view[3]);
    QDir().mkpath(HASP_TEST_PICTURES);
    picture.save(QString(HASP_TEST_PICTURES) + "/" + name + ".png");
    return picture;
  }
  /// Warmer than the ground, which is blue, as is the cube: bone or skin.
  static int WarmPixels(const QImage& view)
  {
    int count = 0;
    for (int y = 0; y < view.height(); ++y)
      for (int x = 0; x < view.width(); ++x)
        count += qBlue(view.pixel(x, y)) < qRed(view.pixel(x, y));
    return count;
  }
};

TEST_F(PlannerSceneLooks, AreSwitchedByKeysAndTheSkinIsSetInTheMenu)
{
  const auto planner = this->Open({ (this->folder / "balls.mha").string() });
  planner->WaitSettled();
  const int bone = WarmPixels(this->View(*planner, "PlannerLooksBone"));
  EXPECT_GT(bone, 500);

  planner->Key("ctrl+k");
  const int skin = WarmPixels(this->View(*planner, "PlannerLooksSkin"));
  EXPECT_GT(skin, 3 * bone); // a body around a ball

  planner->Menu({ "menu.view", "menu.scene", "view.skin.value" });
  planner->Type("5000"); // within bone's rim
  planner->Key("Return");
  const int thin = WarmPixels(this->View(*planner, "PlannerLooksThinSkin"));
  EXPECT_LT(thin, 2 * bone);

  planner->Key("ctrl+k");
  EXPECT_NEAR(WarmPixels(this->View(*planner, "PlannerLooksBoneAgain")), bone, 0.02 * bone);

  planner->Menu({ "menu.view", "menu.scene", "view.brightest" });
  const QImage brightest = this->View(*planner, "PlannerLooksBrightest");
  EXPECT_LT(WarmPixels(brightest), bone / 10);
  const QColor middle = brightest.pixelColor(brightest.width() / 2, brightest.height() / 2);
  EXPECT_GT(middle.red(), 180);
  planner->Key("ctrl+b");
  EXPECT_NEAR(WarmPixels(this->View(*planner, "PlannerLooksBoneAtLast")), bone, 0.02 * bone);
}

TEST_F(PlannerSceneLooks, WithoutAScanThereIsNothingToSetAndItIsSaid)
{
  const auto planner = this->Open();
  planner->Menu({ "menu.view", "menu.scene", "view.skin.value" });
  EXPECT_NE(
    planner->State("message").get<std::string>().find("import one first"), std::string::npos);
  planner->Key("ctrl+k"); // waits for a scan
  planner->Key("ctrl+b");
  EXPECT_TRUE(planner->IsRunning());
}

} // namespace
