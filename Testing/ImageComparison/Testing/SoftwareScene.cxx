#include "SoftwareScene.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace
{

const glm::dvec3 backgroundColour = { 0.1, 0.15, 0.2 };

struct Ball
{
  glm::dvec2 center;
  double radius;
  double parallax; ///< how far `eye` moves it
  glm::dvec3 colour;
};

/// Lambert from the upper left, a little ambient light; false beside the ball.
bool ShadeBall(const Ball& ball, const SoftwareScene& scene, glm::dvec2 at, glm::dvec3& colour)
{
  const glm::dvec2 d = (at - ball.center - glm::dvec2(scene.eye * ball.parallax, 0)) / ball.radius;
  const double rest = 1 - glm::dot(d, d);
  if (rest < 0)
    return false;
  const glm::dvec3 normal(d, std::sqrt(rest));
  const double light = std::max(0.0, glm::dot(normal, glm::normalize(glm::dvec3(-1, 1, 2))));
  colour = scene.shade * (0.15 + 0.8 * light) * ball.colour;
  return true;
}

glm::dvec3 Sample(const SoftwareScene& scene, glm::dvec2 at)
{
  const Ball nearBall{ { 80, 70 }, 45, 1, { 0.9, 0.85, 0.7 } };
  const Ball farBall{ { 125, 85 }, 40, 0.5, { 0.4, 0.6, 0.9 } };
  at -= glm::dvec2(scene.shiftX, scene.shiftY);
  glm::dvec3 colour = backgroundColour;
  if (scene.withBar && std::abs(at.x - 30) < 4 && std::abs(at.y - 75) < 20)
    colour = scene.shade * glm::dvec3(0.8, 0.3, 0.3);
  ShadeBall(scene.wrongDepth ? nearBall : farBall, scene, at, colour);
  ShadeBall(scene.wrongDepth ? farBall : nearBall, scene, at, colour);
  return colour;
}

} // namespace

hasp::RGBPicture SoftwareScene::Draw() const
{
  hasp::RGBPicture picture(this->width, this->height);
  for (int y = 0; y < this->height; ++y)
    for (int x = 0; x < this->width; ++x)
    {
      glm::dvec3 sum(0);
      for (int s = 0; s < 16; ++s)
        sum += Sample(*this, { x + (s % 4 + 0.5) / 4, y + (s / 4 + 0.5) / 4 });
      for (int c = 0; c < 3; ++c)
        picture.At(x, y)[c] =
          static_cast<std::uint8_t>(std::lround(std::min(1.0, sum[c] / 16) * 255));
    }
  return picture;
}

hasp::RGBPicture DrawStereo(double leftEye, double rightEye)
{
  SoftwareScene scene;
  scene.eye = leftEye;
  const hasp::RGBPicture left = scene.Draw();
  scene.eye = rightEye;
  const hasp::RGBPicture right = scene.Draw();
  hasp::RGBPicture both(2 * scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y)
  {
    std::memcpy(both.At(0, y), left.At(0, y), 3 * scene.width);
    std::memcpy(both.At(scene.width, y), right.At(0, y), 3 * scene.width);
  }
  return both;
}

hasp::RGBPicture AddRendererNoise(hasp::RGBPicture picture, std::uint32_t seed)
{
  // Each changed channel moves 3.5 levels in the mean, so 0.06 / 3.5 of the channels change.
  std::mt19937 random(seed);
  std::bernoulli_distribution changes(0.06 / 3.5);
  std::uniform_int_distribution<int> level(1, 6);
  std::bernoulli_distribution up(0.5);
  for (std::uint8_t& value : picture.pixels)
    if (changes(random))
    {
      const int moved = value + (up(random) ? 1 : -1) * level(random);
      value = static_cast<std::uint8_t>(std::clamp(moved, 0, 255));
    }
  return picture;
}
