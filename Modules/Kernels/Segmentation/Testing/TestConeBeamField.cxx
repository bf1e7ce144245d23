#include "Segmentation/ConeBeamField.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace
{

hasp::BlockGrid Blocks(const glm::ivec3& count, const glm::dvec3& edgeMm)
{
  return { count, glm::ivec3(1), count, edgeMm };
}

template <typename Value>
hasp::BlockData Data(const hasp::BlockGrid& grid, const Value& value)
{
  hasp::BlockData data;
  for (int z = 0; z < grid.count.z; ++z)
    for (int y = 0; y < grid.count.y; ++y)
      for (int x = 0; x < grid.count.x; ++x)
      {
        data.weight.push_back(1.0);
        data.value.push_back(value(glm::dvec3(x, y, z) * grid.edgeMm));
      }
  return data;
}

TEST(ConeBeamField, ALinearFieldIsKeptAlsoWhereNothingIsKnown)
{
  const hasp::BlockGrid grid = Blocks({ 12, 9, 7 }, { 10.0, 10.0, 14.0 });
  const auto linear = [](const glm::dvec3& p)
  { return 1.0 + 0.002 * p.x - 0.001 * p.y + 0.0005 * p.z; };
  hasp::BlockData data = Data(grid, linear);
  const std::vector<double> truth = data.value;
  for (std::size_t n = 0; n < truth.size(); ++n)
    if (n % 12 > 6 && n % 12 < 10) // a gap of 30 mm
    {
      data.weight[n] = 0.0;
      data.value[n] = 1e6;
    }
  std::vector<double> field(grid.Size(), 1.0);
  hasp::FitThinPlate(grid, data, 60.0, 1e-8, field, {});
  for (std::size_t n = 0; n < truth.size(); ++n)
    EXPECT_NEAR(field[n], truth[n], 5e-4) << n; // the pull against slopes, 1e-4 of the plate's
}

TEST(ConeBeamField, AWaveOfTheLengthIsHalved)
{
  const hasp::BlockGrid grid = Blocks({ 120, 2, 2 }, glm::dvec3(10.0));
  const auto wave = [](const glm::dvec3& p)
  { return std::cos(glm::two_pi<double>() * p.x / 60.0); };
  hasp::BlockData data = Data(grid, wave);
  std::vector<double> field(grid.Size());
  hasp::FitThinPlate(grid, data, 60.0, 1e-8, field, {});
  // Second differences of 6 blocks a wave are (3 / pi)^2 of the second derivative.
  const double expected = 1.0 / (1.0 + std::pow(3.0 / glm::pi<double>(), 4.0));
  EXPECT_NEAR(field[60], expected * data.value[60], 0.01);
}

TEST(ConeBeamField, ABlurKeepsTheSumAndItsWidthInMm)
{
  const hasp::BlockGrid grid = Blocks({ 41, 31, 25 }, { 2.0, 3.0, 4.0 });
  std::vector<double> values(grid.Size());
  const glm::ivec3 middle(20, 15, 12);
  values[grid.Offset(middle)] = 1.0;
  hasp::BlurBlocks(grid, 8.0, values);
  double sum = 0.0;
  glm::dvec3 squares(0.0);
  for (int z = 0; z < 25; ++z)
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 41; ++x)
      {
        const double v = values[grid.Offset({ x, y, z })];
        const glm::dvec3 off = glm::dvec3(glm::ivec3(x, y, z) - middle) * grid.edgeMm;
        sum += v;
        squares += v * off * off;
      }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(std::sqrt(squares[a]), 8.0, 0.15) << a; // cut off at three deviations
}

TEST(ConeBeamField, RowsAreTheFieldBetweenTheBlocks)
{
  hasp::GridGeometry geometry;
  geometry.dims = { 23, 17, 11 };
  const hasp::BlockGrid grid = hasp::MakeBlocks(geometry, 4.0);
  EXPECT_EQ(grid.count, glm::ivec3(6, 5, 3));
  const auto linear = [](const glm::dvec3& p) { return 2.0 * p.x - p.y + 0.5 * p.z; };
  std::vector<double> values;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 6; ++x)
        values.push_back(linear(glm::dvec3(x, y, z) * 4.0 + 1.5)); // the middle of 4 samples
  const hasp::BlockField field(grid, values);
  std::vector<float> row;
  for (int k = 0; k < 11; ++k)
    for (int j = 0; j < 17; ++j)
    {
      field.Row(j, k, row);
      for (int i = 0; i < 23; ++i)
        ASSERT_NEAR(row[i], linear(glm::dvec3(i, j, k)), 1e-4);
    }
}

} // namespace
