// The light of the 3D view: made when it is switched on, better at rest, gone when it is off.
#include "BallsScene.h"
#include "View/ScanLooks.h"
#include "View/ViewLight.h"

#include "vtkImageData.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"

#include <QColor>
#include <QtTest>

namespace hasp::testing
{
namespace
{

class ViewLightOfBalls : public PlanSceneOfBalls
{
protected:
  void SetUp() override
  {
    if (!ViewLight::IsThere())
      return;
    this->desk.AddScan(this->balls.image, BallsHash);
    this->desk.Settle();
    this->desk.scene.LookFrom('F');
    this->desk.Settle();
  }
  ViewLight& Light() { return this->desk.scene.Looks().Light(); }
  int Samples() const
  {
    return std::atoi(this->desk.UseOf("light, paths").reason.c_str()); // "37 samples a pixel"
  }
  int Grey(const QImage& picture, const glm::dvec3& place) const
  {
    const QPoint at = this->desk.PixelOf(place);
    return picture.pixelColor(at.x(), picture.height() - 1 - at.y()).green();
  }
};

TEST_F(ViewLightOfBalls, PlainLightHasNothing)
{
  EXPECT_EQ(this->Light().GetMode(), ViewLight::Plain);
  EXPECT_EQ(this->desk.UseOf("light").bytes, 0U);
  EXPECT_EQ(this->desk.view.Renderer()->GetPass(), nullptr);
  if (!ViewLight::IsThere()) // a build without Embree has no other
    return;
  const QImage plain = this->desk.Picture("LightPlain");
  this->Light().SetMode(ViewLight::Traced);
  this->desk.Settle();
  this->Light().SetMode(ViewLight::Plain);
  EXPECT_EQ(this->desk.view.Renderer()->GetPass(), nullptr);
  EXPECT_EQ(this->desk.UseOf("light, trees").reason, "not listed");
  this->desk.Settle();
  const QImage again = this->desk.Picture("LightPlainAgain");
  for (int y = 0; y < plain.height(); ++y)
    for (int x = 0; x < plain.width(); ++x) // cells may be traced by now, which rounds otherwise
      ASSERT_NEAR(again.pixelColor(x, y).green(), plain.pixelColor(x, y).green(), 2)
        << x << " " << y;
  EXPECT_FALSE(this->desk.view.IsWaiting()) << "at rest nothing is drawn";
}

TEST_F(ViewLightOfBalls, AmbientOcclusionDarkensBetweenTheBalls)
{
  if (!ViewLight::IsThere())
    return;
  const QImage plain = this->desk.Picture("LightPlain");
  this->Light().SetMode(ViewLight::AmbientOcclusion);
  this->desk.Settle();
  const QImage dark = this->desk.Picture("LightAmbient");
  EXPECT_GT(this->desk.UseOf("light, kept").bytes, 0U);
  EXPECT_EQ(this->desk.UseOf("light, environment").bytes, 0U);
  // The left ball's side that the right one stands before, and its far side.
  const glm::dvec3 way = glm::normalize(this->balls.right - this->balls.left);
  const glm::dvec3 up = this->balls.left - glm::dvec3(0, 0.5 * this->balls.leftRadius, 0);
  const glm::dvec3 near = up + 0.8 * this->balls.leftRadius * way,
                   far = up - 0.8 * this->balls.leftRadius * way;
  EXPECT_LT(this->Grey(dark, near), this->Grey(plain, near) - 4);
  EXPECT_NEAR(this->Grey(dark, far), this->Grey(plain, far), 6);
}

TEST_F(ViewLightOfBalls, TracedLightGetsBetterAtRestAndEndsThen)
{
  if (!ViewLight::IsThere())
    return;
  this->desk.view.resize(160, 120); // 256 paths a pixel are soon there
  this->Light().SetMode(ViewLight::Traced);
  ASSERT_TRUE(QTest::qWaitFor([this] { return this->Samples() >= 256; }, 120'000));
  this->desk.Settle();
  const unsigned long long frames = this->desk.view.Frames();
  QTest::qWait(250);
  EXPECT_EQ(this->desk.view.Frames(), frames) << "nothing is drawn when it is done";
  const QImage traced = this->desk.Picture("LightTraced");
  EXPECT_GT(this->Grey(traced, this->balls.left - glm::dvec3(0, this->balls.leftRadius, 0)), 100);

  this->desk.view.Moving();
  this->desk.view.DrawNow();
  EXPECT_EQ(this->Samples(), 0) << "paths are given up while something moves";
  EXPECT_EQ(this->desk.UseOf("light, paths").bytes, 0U);
  ASSERT_TRUE(QTest::qWaitFor([this] { return this->Samples() > 0; }, 120'000))
    << "and begin anew at rest";
}

} // namespace
} // namespace hasp::testing
