// Where known points are in the windows of a room, against closed form: every layout, several
// heads, screens and a head-mounted display.
#include "StereoTestScene.h"
#include "vtkHaspStereoCamera.h"

#include "vtkMatrix4x4.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

using hasp::StereoEye;
using hasp::StereoLayout;
using stereotest::Bytes;

using Places = std::array<glm::dvec2, 2>; // left eye, right eye; device coordinates of the screen

/// What a viewer sees on a display of each kind: whose a pixel is, and where on the screen. Written
/// from the displays' descriptions, not from our code.
struct Display
{
  StereoLayout layout;
  glm::ivec2 size;

  /// How much of a white ball on black an eye sees there.
  double Light(const std::uint8_t* rgb, int x, int y, bool right) const
  {
    const int top = this->size.y - 1 - y;
    const double bright = rgb[1];
    switch (this->layout)
    {
      case StereoLayout::SideBySide:
        return (2 * x >= this->size.x) == right ? bright : 0.0;
      case StereoLayout::TopBottom:
        return (2 * top >= this->size.y) == right ? bright : 0.0;
      case StereoLayout::Interlaced:
        return (top % 2 == 1) == right ? bright : 0.0;
      case StereoLayout::Checkerboard:
        return ((top + x) % 2 == 1) == right ? bright : 0.0;
      case StereoLayout::Anaglyph:
        return right ? bright : rgb[0];
      default:
        return bright;
    }
  }
  /// Where the middle of pixel (x, y) is on the screen, [-1,1].
  glm::dvec2 Place(int x, int y) const
  {
    glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / glm::dvec2(this->size);
    if (this->layout == StereoLayout::SideBySide)
      at.x = std::fmod(2.0 * at.x, 1.0);
    else if (this->layout == StereoLayout::TopBottom)
      at.y = std::fmod(2.0 * at.y, 1.0);
    return 2.0 * at - 1.0;
  }
  glm::dvec2 Middle(const Bytes& rgb, bool right) const
  {
    glm::dvec2 sum(0.0);
    double count = 0.0;
    for (int y = 0; y < this->size.y; ++y)
      for (int x = 0; x < this->size.x; ++x)
      {
        const double light = this->Light(&rgb[3 * (y * this->size.x + x)], x, y, right);
        sum += light * this->Place(x, y);
        count += light;
      }
    return sum / count;
  }
};

constexpr double Radius = 18.0; // mm in the room: discs 40 to 60 pixels wide

/// The outline of a ball is an ellipse, and its middle not that of the ball: with the depth z and
/// the tangents of the ball's middle it is at tangent * z^2 / (z^2 - radius^2).
double Outline(double depth)
{
  return depth * depth / (depth * depth - Radius * Radius);
}

/// One unlit ball in a room of a screen 520 mm wide; the room lies askew in the world, at half
/// size.
class RoomScene
{
public:
  explicit RoomScene(const hasp::StereoWindow& settings, glm::ivec2 s)
    : size(s),
      window(stereotest::MakeWindow(s)),
      other(stereotest::MakeWindow(s))
  {
    this->window->StereoCapableWindowOn();
    this->window->SetMultiSamples(4); // an outline that fills pixels in part is known better
    this->other->SetMultiSamples(4);
    this->windows->SetRenderer(this->renderer);
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        matrix->SetElement(row, column, this->roomToWorld[column][row]);
    this->windows->SetRoomToWorld(matrix);
    this->layout = settings.output.layout;
    if (this->layout == StereoLayout::DualWindow)
      EXPECT_TRUE(this->windows->AddDualWindow(this->window, this->other, settings));
    else
      EXPECT_TRUE(this->windows->AddWindow(this->window, settings));
  }

  Places Found(const hasp::StereoHead& head, const glm::dvec3& roomPoint)
  {
    this->renderer->RemoveAllViewProps();
    const auto ball =
      stereotest::MakeBall(this->roomToWorld * glm::dvec4(roomPoint, 1.0), 0.5 * Radius);
    ball->GetProperty()->LightingOff();
    this->renderer->AddActor(ball);
    this->windows->SetHead(head);
    EXPECT_TRUE(this->windows->Render());
    const Display display{ this->layout, this->size };
    const Bytes left = stereotest::Picture(this->window);
    const Bytes right =
      this->layout == StereoLayout::DualWindow
        ? stereotest::Picture(this->other)
        : stereotest::Picture(this->window, StereoLayout::QuadBuffer == this->layout);
    return { display.Middle(left, false), display.Middle(right, true) };
  }

private:
  glm::ivec2 size;
  StereoLayout layout;
  vtkSmartPointer<vtkRenderWindow> window, other;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHaspStereoWindows> windows;
  glm::dmat4 roomToWorld = glm::scale(
    glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(5, -7, 90)), 1.1, glm::dvec3(1, 2, -1)),
    glm::dvec3(0.5));
};

const hasp::StereoHead Heads[] = {
  { { 0, 0, 600 } },
  { { 140, -60, 520 } },
  { { -180, 90, 700 }, glm::normalize(glm::dvec3(1, 0.35, 0.1)) }, // tilted
  { { 20, 30, 450 }, glm::normalize(glm::dvec3(1, -0.2, -0.3)), 70 },
};
const glm::dvec3 Points[] = { { 0, 0, 0 }, { 60, -35, 90 }, { -55, 40, -160 } };

// The bar is 0.5 pixel. A disc of 40 pixels and more has its middle known to 0.05; to twice that
// where an eye has half of the pixels, and a disparity is the difference of two.
constexpr double Bar = 0.2;

class StereoDisparity :
  public testing::TestWithParam<std::tuple<StereoLayout, hasp::StereoResolution>>
{
};

TEST_P(StereoDisparity, IsClosedFormOnAScreen)
{
  const glm::ivec2 size{ 640, 400 };
  hasp::StereoWindow settings;
  settings.output.layout = std::get<0>(GetParam());
  settings.output.resolution = std::get<1>(GetParam());
  settings.screen.emplace(); // 520 x 325 mm: 1.23 pixels a mm
  RoomScene scene(settings, size);
  double worst = 0.0;
  for (const hasp::StereoHead& head : Heads)
    for (const glm::dvec3& point : Points)
    {
      const hasp::StereoRig rig{ *settings.screen, head };
      const Places found = scene.Found(head, point);
      const glm::dvec2 half = 0.5 * glm::dvec2(size);
      const auto seen = [&](StereoEye eye)
      {
        const double depth = hasp::EyePosition(head, eye).z - point.z;
        const glm::dvec3 middle(point.x, point.y, point.z + depth - depth / Outline(depth));
        return half * hasp::ProjectToScreen(rig, eye, middle);
      };
      const glm::dvec2 left = seen(StereoEye::Left), right = seen(StereoEye::Right);
      const glm::dvec2 disparity = half * (found[1] - found[0]);
      worst = std::max(worst, glm::length(disparity - (right - left)));
      EXPECT_LT(glm::length(half * found[0] - left), Bar);
      EXPECT_LT(glm::length(half * found[1] - right), Bar);
      if (head.right.y == 0.0)
      {
        EXPECT_LT(std::abs(disparity.y), Bar) << "a level head sees both eyes' points level";
      }
    }
  EXPECT_LT(worst, Bar);
  RecordProperty("disparity_max", std::to_string(worst));
  std::cout << "largest error of a disparity: " << worst << " pixel\n";
}

TEST_P(StereoDisparity, IsClosedFormInAHeadMountedDisplay)
{
  const glm::ivec2 size{ 640, 400 };
  hasp::StereoWindow settings;
  settings.output.layout = std::get<0>(GetParam());
  settings.output.resolution = std::get<1>(GetParam());
  const hasp::FieldOfView out{ 0.65, 0.5, 0.4, 0.5 }, in{ 0.5, 0.65, 0.4, 0.5 };
  settings.hmd = hasp::StereoHmd{ { out, in } };
  RoomScene scene(settings, size);
  double worst = 0.0;
  for (hasp::StereoHead head : Heads)
  {
    head.up = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), head.right));
    const glm::dvec3 back = glm::cross(head.right, head.up);
    for (const glm::dvec3& off : Points)
    {
      const glm::dvec3 point = head.position - 520.0 * back + off;
      const Places found = scene.Found(head, point);
      glm::dvec2 truth[2];
      for (int eye = 0; eye < 2; ++eye)
      {
        const hasp::FieldOfView& f = settings.hmd->fields[eye];
        const glm::dvec3 seen =
          point - head.position - (eye - 0.5) * head.eyeSeparationMm * head.right;
        const double depth = -glm::dot(seen, back);
        const double x = glm::dot(seen, head.right) / depth * Outline(depth);
        const double y = glm::dot(seen, head.up) / depth * Outline(depth);
        truth[eye] = { (2 * x + f.left - f.right) / (f.left + f.right),
          (2 * y + f.down - f.up) / (f.up + f.down) };
        truth[eye] *= 0.5 * glm::dvec2(size);
        EXPECT_LT(glm::length(0.5 * glm::dvec2(size) * found[eye] - truth[eye]), Bar);
      }
      const glm::dvec2 disparity = 0.5 * glm::dvec2(size) * (found[1] - found[0]);
      worst = std::max(worst, glm::length(disparity - (truth[1] - truth[0])));
      EXPECT_LT(std::abs(disparity.y), Bar) << "a display's eyes are always level";
    }
  }
  EXPECT_LT(worst, Bar);
  RecordProperty("disparity_max", std::to_string(worst));
  std::cout << "largest error of a disparity: " << worst << " pixel\n";
}

std::string NameOf(
  const testing::TestParamInfo<std::tuple<StereoLayout, hasp::StereoResolution>>& info)
{
  std::string name = hasp::StereoLayoutName(std::get<0>(info.param));
  std::erase(name, '-');
  return name + (std::get<1>(info.param) == hasp::StereoResolution::Half ? "_half" : "_full");
}

INSTANTIATE_TEST_SUITE_P(OnePicture, StereoDisparity,
  testing::Combine(testing::Values(StereoLayout::SideBySide, StereoLayout::TopBottom,
                     StereoLayout::Interlaced, StereoLayout::Checkerboard),
    testing::Values(hasp::StereoResolution::Full, hasp::StereoResolution::Half)),
  NameOf);
INSTANTIATE_TEST_SUITE_P(WholeEyes, StereoDisparity, // where the resolution says nothing
  testing::Combine(
    testing::Values(StereoLayout::Anaglyph, StereoLayout::DualWindow, StereoLayout::QuadBuffer),
    testing::Values(hasp::StereoResolution::Full)),
  NameOf);

} // namespace
