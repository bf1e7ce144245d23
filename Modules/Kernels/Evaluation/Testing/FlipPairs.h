#pragma once
// Pairs of pictures from formulas, in sRGB. Also what the reference implementation was given.
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace hasp
{

struct FlipPair
{
  int width;
  std::vector<glm::vec3> reference, test;
};

template <typename ColorOf>
std::vector<glm::vec3> DrawFlipPicture(int width, int height, const ColorOf& colorOf)
{
  std::vector<glm::vec3> picture;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.push_back(colorOf(x, y));
  return picture;
}

/// In [0,1): a fixed generator, so that pictures do not hang on a library's.
class FlipNoise
{
public:
  float operator()()
  {
    this->State = this->State * 1664525U + 1013904223U;
    return float(this->State >> 8) / 16777216.0F;
  }

private:
  std::uint32_t State = 12345U;
};

/// Gradients of all channels, shifted in hue; a checkerboard that turned over and grew; an edge
/// moved by 3 pixels; coloured noise.
inline std::vector<FlipPair> FlipPairs()
{
  const auto gradient = [](float shift)
  {
    return DrawFlipPicture(64, 48,
      [shift](int x, int y) {
        return glm::vec3(float(x) / 63.0F, float(y) / 47.0F, shift + 0.5F * float(x + y) / 110.0F);
      });
  };
  const auto checker = [](int side, float low, float high)
  {
    return DrawFlipPicture(
      50, 40, [=](int x, int y) { return glm::vec3((x / side + y / side) % 2 ? low : high); });
  };
  const auto edge = [](int place)
  {
    return DrawFlipPicture(40, 56,
      [place](int x, int y)
      { return 2 * x + y < place ? glm::vec3(0.9F, 0.85F, 0.7F) : glm::vec3(0.1F, 0.05F, 0.2F); });
  };
  FlipNoise noise;
  const auto speckle = [&noise](int, int)
  {
    const float r = noise(), g = noise();
    return glm::vec3(r, g, noise());
  };
  const std::vector<glm::vec3> a = DrawFlipPicture(48, 48, speckle);
  return { { 64, gradient(0.0F), gradient(0.4F) },
    { 50, checker(4, 0.2F, 0.8F), checker(5, 0.75F, 0.25F) }, { 40, edge(60), edge(66) },
    { 48, a, DrawFlipPicture(48, 48, speckle) } };
}

} // namespace hasp
