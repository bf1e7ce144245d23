// The light of the 3D view: made when it is switched on, better at rest, settled in pictures, gone
// when it is off.
#include "BallsScene.h"
#include "View/ScanLooks.h"
#include "View/ViewLight.h"

#include "vtkImageData.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"

#include <QColor>
#include <QOpenGLExtraFunctions>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace hasp::testing
{
namespace
{

/// Of a channel, RMS.
double Difference(const QImage& a, const QImage& b)
{
  double squares = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      squares += std::pow(a.pixelColor(x, y).green() - b.pixelColor(x, y).green(), 2.0);
  return std::sqrt(squares / (a.width() * a.height()));
}

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
  /// What is found right after the next frame that is drawn as ever.
  template <typename Look>
  auto AtNextFrame(const Look& look)
  {
    std::optional<decltype(look())> seen;
    QObject receiver;
    QObject::connect(&this->desk.view, &FrameView::Shown, &receiver,
      [&] { seen = seen ? seen : std::optional(look()); });
    this->desk.view.Draw();
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen.has_value(); }, 120'000));
    return seen.value();
  }
  /// Textures, framebuffers, their depths, buffers and vertex arrays in a view's context.
  static std::array<int, 5> OnTheGPU(FrameView& view)
  {
    view.makeCurrent();
    QOpenGLExtraFunctions gl(QOpenGLContext::currentContext());
    std::array<int, 5> count{};
    for (GLuint name = 1; name < 4096; ++name) // a driver gives small names first
    {
      count[0] += gl.glIsTexture(name) != 0;
      count[1] += gl.glIsFramebuffer(name) != 0;
      count[2] += gl.glIsRenderbuffer(name) != 0;
      count[3] += gl.glIsBuffer(name) != 0;
      count[4] += gl.glIsVertexArray(name) != 0;
    }
    return count;
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
  const unsigned long long frames = this->desk.view.Frames();
  this->desk.view.DrawNow([](double) { return false; }); // never asked
  EXPECT_EQ(this->desk.view.Frames(), frames + 1);
}

TEST_F(ViewLightOfBalls, AmbientOcclusionDarkensBetweenTheBalls)
{
  if (!ViewLight::IsThere())
    return;
  this->desk.view.resize(300, 250); // a picture takes 64 frames
  this->desk.Settle();
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
  const auto done = [this]
  {
    EXPECT_TRUE(this->desk.view.IsWaiting() || this->Samples() >= 256) << "for scripts to wait";
    return this->Samples() >= 256;
  };
  ASSERT_TRUE(QTest::qWaitFor(done, 120'000));
  this->desk.Settle();
  EXPECT_FALSE(this->desk.view.IsWaiting());
  const unsigned long long frames = this->desk.view.Frames();
  QTest::qWait(250);
  EXPECT_EQ(this->desk.view.Frames(), frames) << "nothing is drawn when it is done";
  const QImage traced = this->desk.Picture("LightTraced");
  EXPECT_GT(this->Grey(traced, this->balls.left - glm::dvec3(0, this->balls.leftRadius, 0)), 100);

  this->desk.view.Moving();
  const ResourceUse paths = this->AtNextFrame([this] { return this->desk.UseOf("light, paths"); });
  EXPECT_EQ(paths.reason, "not PathTraced: no thread") << "given up while something moves";
  EXPECT_EQ(paths.bytes, 0U);
  ASSERT_TRUE(QTest::qWaitFor([this] { return this->Samples() > 0; }, 120'000))
    << "and begin anew at rest";
}

/// After 64 frames, or 256 paths beside 8 frames of what is kept, one more is a sample in hundreds:
/// below a level. A single frame has a hundredth of them, and its noise is ten times as large.
TEST_F(ViewLightOfBalls, PicturesAreOfSettledLight)
{
  if (!ViewLight::IsThere())
    return;
  this->desk.view.resize(160, 120);
  this->desk.Settle();
  for (const ViewLight::Mode mode : { ViewLight::AmbientOcclusion, ViewLight::Traced })
  {
    this->Light().SetMode(mode);
    const QImage single = this->AtNextFrame([this] { return this->desk.view.grabFramebuffer(); });
    this->Light().SetMode(ViewLight::Plain); // what was kept is forgotten
    this->Light().SetMode(mode);
    const QImage picture = this->desk.Picture("LightSettled");
    const QImage again = this->desk.Picture("LightSettledAgain");
    EXPECT_LT(Difference(picture, again), 0.5) << mode;
    EXPECT_GT(Difference(picture, single), 1.0) << mode;
    this->desk.view.Moving();
    EXPECT_LT(Difference(picture, this->desk.Picture("LightSettledMoving")), 0.5)
      << mode << ": as at rest";
  }
}

TEST_F(ViewLightOfBalls, WhoWaitsForAPictureHearsOfItAndMayGiveItUp)
{
  if (!ViewLight::IsThere())
    return;
  this->desk.view.resize(160, 120);
  this->desk.Settle();
  for (const ViewLight::Mode mode : { ViewLight::AmbientOcclusion, ViewLight::Traced })
  {
    this->Light().SetMode(mode);
    std::vector<double> shares;
    const auto few = [&](double share)
    {
      shares.push_back(share);
      return shares.size() < 3;
    };
    EXPECT_THROW(this->desk.view.Picture(few), Cancelled) << mode;
    EXPECT_EQ(shares.size(), 3U) << mode << ": and is not asked again";
    EXPECT_LT(shares.back(), 1.0) << mode;
    EXPECT_TRUE(this->desk.view.IsWaiting()) << mode << ": it goes on as ever";

    shares.clear();
    this->desk.view.DrawNow(
      [&](double share)
      {
        shares.push_back(share);
        return true;
      });
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end())) << mode;
    EXPECT_GT(shares.at(0), 0.0) << mode;
    EXPECT_NEAR(shares.back(), 1.0, 1.0 / 63.0) << mode << ": but for the last frame";
    this->Light().SetMode(ViewLight::Plain);
  }
}

/// Also while it is another view's context that is current, whose own has the same names.
TEST_F(ViewLightOfBalls, LeavesNothingOnTheGPU)
{
  if (!ViewLight::IsThere())
    return;
  this->desk.view.resize(160, 120);
  this->desk.scene.Looks().SetSkin(true); // translucent: the pass has buffers for it, too
  this->desk.Settle();
  SceneDesk other;
  other.AddScan(this->balls.image, BallsHash);
  other.scene.Looks().SetSkin(true);
  other.Settle();
  const auto before = this->OnTheGPU(this->desk.view), elsewhere = this->OnTheGPU(other.view);
  for (const ViewLight::Mode mode : { ViewLight::AmbientOcclusion, ViewLight::Traced })
  {
    this->Light().SetMode(mode);
    this->desk.Settle();
    EXPECT_NE(this->OnTheGPU(this->desk.view), before) << mode;
    other.view.makeCurrent();
    const QOpenGLContext* current = QOpenGLContext::currentContext();
    this->Light().SetMode(ViewLight::Plain);
    EXPECT_EQ(QOpenGLContext::currentContext(), current) << mode;
    EXPECT_EQ(this->OnTheGPU(other.view), elsewhere) << mode;
    EXPECT_EQ(this->OnTheGPU(this->desk.view), before) << mode << ": at once";
    this->desk.Settle();
    EXPECT_EQ(this->OnTheGPU(this->desk.view), before) << mode << ": and after plain frames";
  }
}

} // namespace
} // namespace hasp::testing
