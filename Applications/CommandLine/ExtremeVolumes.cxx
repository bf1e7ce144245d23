#include "ExtremeVolumes.h"

#include "Grid/Trilinear.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>

namespace hasp
{
namespace
{

constexpr int Side = 24; // samples
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Centred on the world's origin and turned, which is the normal case.
GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1), 0.4, glm::normalize(glm::dvec3(1, 2, 3))));
  const glm::dvec3 half = 0.5 * spacing * glm::dvec3(dims - 1);
  return { dims, -(turned * half), spacing, turned };
}

using SampleOf = std::function<double(int i, int j, int k)>;

template <typename T>
vtkSmartPointer<vtkImageData> Make(const GridGeometry& grid, const SampleOf& sample)
{
  std::vector<T> samples;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        samples.push_back(static_cast<T>(sample(i, j, k)));
  return MakeImage(grid, samples);
}

/// The rule by itself: corners on both sides, all finite.
std::size_t CountByRule(vtkImageData* image, double isovalue)
{
  const AnyGridView grid = ViewImage(image);
  const glm::ivec3 cells = GeometryOf(grid).Cells();
  std::size_t count = 0;
  for (int k = 0; k < cells.z; ++k)
    for (int j = 0; j < cells.y; ++j)
      for (int i = 0; i < cells.x; ++i)
      {
        int inside = 0, finite = 0;
        for (const double c : std::visit(
               [&](const auto& view) {
                 return CellCorners(view, { i, j, k });
               },
               grid))
        {
          inside += c >= isovalue;
          finite += std::isfinite(c);
        }
        count += finite == 8 && inside > 0 && inside < 8;
      }
  return count;
}

/// A ball of half the volume's width, in voxels, `perVoxel` grey levels a voxel of depth.
SampleOf Ball(double perVoxel)
{
  return [perVoxel](int i, int j, int k)
  {
    const double middle = 0.5 * (Side - 1);
    return perVoxel * (0.4 * Side - std::hypot(i - middle, j - middle - 0.2, k - middle + 0.1));
  };
}

SampleOf Saturated(const SampleOf& sample, double low, double high)
{
  return [=](int i, int j, int k) { return std::clamp(sample(i, j, k), low, high); };
}

/// `value` at one sample in 64 of a ball.
SampleOf Spoiled(double value)
{
  return [value, ball = Ball(10.0)](int i, int j, int k)
  { return (i * 7 + j * 5 + k * 3) % 64 == 0 ? value : ball(i, j, k); };
}

SampleOf Noise(unsigned seed)
{
  auto random = std::make_shared<std::mt19937>(seed);
  return [random](int, int, int)
  { return std::uniform_real_distribution<double>(-100.0, 100.0)(*random); };
}

} // namespace

ExtremeVolume OrdinaryBall()
{
  return { "a ball", Make<std::int16_t>(Grid(glm::ivec3(Side), glm::dvec3(0.7)), Ball(100.0)), 0.0,
    0 };
}

std::vector<ExtremeVolume> ExtremeVolumes()
{
  const glm::ivec3 cube(Side);
  const GridGeometry plain = Grid(cube, glm::dvec3(0.7));
  constexpr std::size_t layer = std::size_t(Side - 1) * (Side - 1), all = layer * (Side - 1);
  const auto slope = [](int, int, int k) { return 10.0 * k; };
  const auto step = [](int, int, int k) { return k < Side / 2 ? -50.0 : 0.0; };
  const auto board = [](int i, int j, int k) { return (i + j + k) % 2 ? 100.0 : -100.0; };

  const auto plate = [](int, int, int k) { return k == Side / 2 ? 100.0 : -100.0; };

  std::vector<ExtremeVolume> list{
    { "isovalue equal to corner values", Make<std::int16_t>(plain, slope), 110.0, layer },
    { "flat block at the isovalue", Make<std::int16_t>(plain, [](int, int, int) { return 7.0; }),
      7.0, 0 },
    { "flat half at the isovalue", Make<std::int16_t>(plain, step), 0.0, layer },
    { "every cell active", Make<std::int16_t>(plain, board), 0.0, all },
    { "every cell active, unsigned 8 bits",
      Make<std::uint8_t>(
        plain, [&](int i, int j, int k) { return board(i, j, k) > 0 ? 255.0 : 0.0; }),
      128.0, all },
    { "a plate one sample thick", Make<std::int16_t>(plain, plate), 0.0, 2 * layer },
    { "no cell active: isovalue above all", Make<std::int16_t>(plain, Ball(100.0)), 30000.0, 0 },
    { "1 x N x M samples", Make<std::int16_t>(Grid({ 1, Side, Side }, glm::dvec3(1)), slope), 110.0,
      0 },
    { "int16 limits: a step from -32768 to 32767",
      Make<std::int16_t>(plain, Saturated(Ball(1e9), -32768, 32767)), 0.5, 0 },
    { "int16 limits: isovalue 32767",
      Make<std::int16_t>(plain, Saturated(Ball(1e9), -32768, 32767)), 32767.0, 0 },
    { "uint16 limits: a step from 0 to 65535",
      Make<std::uint16_t>(plain, Saturated(Ball(1e9), 0, 65535)), 65535.0, 0 },
    { "saddles with up to three roots (noise)", Make<float>(plain, Noise(5)), 0.0, 0 },
    { "NaN samples", Make<float>(plain, Spoiled(NaN)), 0.0, 0, false, true },
    { "infinite samples", Make<float>(plain, Spoiled(Infinity)), 0.0, 0, false, true },
    { "denormal samples, up to 1e-40", Make<float>(plain, Ball(1e-41)), 0.0, 0, true },
    { "samples up to 1e37", Make<float>(plain, Ball(1e36)), 0.0, 0 },
    { "isovalue of 1e6 in steps of 1",
      Make<float>(plain, [ball = Ball(1.0)](int i, int j, int k) { return 1e6 + ball(i, j, k); }),
      1e6, 0 },
    { "spacing 1e-6 mm", Make<std::int16_t>(Grid(cube, glm::dvec3(1e-6)), Ball(100.0)), 0.0, 0 },
    { "spacing 1e6 mm", Make<std::int16_t>(Grid(cube, glm::dvec3(1e6)), Ball(100.0)), 0.0, 0 },
    { "spacing 100:1", Make<std::int16_t>(Grid(cube, { 1.0, 1.0, 0.01 }), Ball(100.0)), 0.0, 0 },
  };
  for (ExtremeVolume& volume : list)
    if (volume.activeCells == 0)
      volume.activeCells = CountByRule(volume.image, volume.isovalue);
  return list;
}

} // namespace hasp
