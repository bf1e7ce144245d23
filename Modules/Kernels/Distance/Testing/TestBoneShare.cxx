#include "Distance/BoneShare.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double Soft = 40.0, Threshold = 226.0;

/// A blurred ball, dense in its left half and spongy in its right one, and what a threshold makes
/// of it.
struct BlurredBall
{
  hasp::GridGeometry grid;
  std::vector<float> grey;
  std::vector<std::uint16_t> labels;
  double radius = 10.0;

  explicit BlurredBall(const glm::dvec3& spacing, double blurMm = 0.5)
  {
    this->grid.dims = glm::ivec3(28.0 / spacing) + 1;
    this->grid.spacing = spacing;
    this->grid.origin = glm::dvec3(-14.0, -14.0, -14.0);
    for (int k = 0; k < this->grid.dims.z; ++k)
      for (int j = 0; j < this->grid.dims.y; ++j)
        for (int i = 0; i < this->grid.dims.x; ++i)
        {
          const glm::dvec3 x = this->grid.IndexToWorld({ i, j, k });
          const double own = x.x < 0.0 ? 1000.0 : 300.0;
          const double inside =
            0.5 * std::erfc((glm::length(x) - this->radius) / (std::sqrt(2.0) * blurMm));
          this->grey.push_back(float(Soft + (own - Soft) * inside));
          this->labels.push_back(this->grey.back() >= Threshold ? 7 : 0);
        }
  }
  hasp::GridView<const float> Grey() const { return { this->grey.data(), this->grid }; }
  hasp::GridView<const std::uint16_t> Labels() const { return { this->labels.data(), this->grid }; }

  /// How far the isosurface lies outside of the ball: mean and root mean square over crossings of
  /// rows along x, without the middle where dense and spongy meet and where rows graze the ball.
  std::pair<double, double> Off(const std::vector<float>& values, float isovalue, bool dense) const
  {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (std::size_t n = 1; n < values.size(); ++n)
    {
      const int i = int(n % std::size_t(this->grid.dims.x));
      if (i == 0 || (values[n - 1] >= isovalue) == (values[n] >= isovalue))
        continue;
      const std::size_t row = n / std::size_t(this->grid.dims.x);
      const double t = (isovalue - values[n - 1]) / (values[n] - values[n - 1]);
      const glm::dvec3 x =
        this->grid.IndexToWorld({ i - 1 + t, double(row % std::size_t(this->grid.dims.y)),
          double(row / std::size_t(this->grid.dims.y)) });
      if (std::abs(x.x) < 5.0 || (x.x < 0.0) != dense)
        continue;
      const double off = glm::length(x) - this->radius;
      sum += off;
      squares += off * off;
      ++count;
    }
    EXPECT_GT(count, 100);
    return { sum / count, std::sqrt(squares / count) };
  }
};
} // namespace

TEST(BoneShare, RefusesWhatItCannotUse)
{
  const BlurredBall ball(glm::dvec3(1.0));
  hasp::BoneShareSettings settings;
  settings.depthMm = 0.0;
  EXPECT_THROW(hasp::ShareBone(ball.Grey(), ball.Labels(), settings), std::invalid_argument);
  settings = {};
  settings.leastStep = 0.0;
  EXPECT_THROW(hasp::ShareBone(ball.Grey(), ball.Labels(), settings), std::invalid_argument);
  settings = {};
  settings.softValue = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(hasp::ShareBone(ball.Grey(), ball.Labels(), settings), std::invalid_argument);
  const BlurredBall other(glm::dvec3(0.9));
  EXPECT_THROW(hasp::ShareBone(ball.Grey(), other.Labels()), std::invalid_argument);
  const std::vector<std::uint16_t> none(ball.labels.size(), 0);
  EXPECT_THROW(
    hasp::ShareBone(ball.Grey(), hasp::GridView<const std::uint16_t>{ none.data(), ball.grid }),
    std::runtime_error);
}

TEST(BoneShare, PutsDenseAndSpongySurfacesWhereTheyAre)
{
  for (const glm::dvec3 spacing : { glm::dvec3(0.8), glm::dvec3(0.5, 0.5, 1.0) })
  {
    const BlurredBall ball(spacing);
    // A ball has no cortex: its own value is that of its middle.
    hasp::BoneShareSettings settings;
    settings.depthMm = 2.0;
    const hasp::BoneShares made = hasp::ShareBone(ball.Grey(), ball.Labels(), settings);
    EXPECT_NEAR(made.softValue, Soft, 1.0);
    for (const bool dense : { true, false })
    {
      // What the blur takes of a ball's surface, sigma^2 / R, is 0.025 mm; the rest is the grid's.
      const auto [mean, rms] = ball.Off(made.shares, 0.5F, dense);
      EXPECT_LT(std::abs(mean), 0.05) << dense << " " << spacing.z;
      EXPECT_LT(rms, 0.08) << dense << " " << spacing.z;
      // The threshold lies 0.45 mm outside and 0.3 mm inside: what this is for.
      const double threshold = ball.Off(ball.grey, float(Threshold), dense).first;
      EXPECT_GT(dense ? threshold : -threshold, 0.2);
    }
  }
}

TEST(BoneShare, GivesVoxelsToTheLabelThatTheyContinue)
{
  BlurredBall ball(glm::dvec3(0.8));
  for (std::size_t n = 0; n < ball.labels.size(); ++n)
    if (ball.labels[n] != 0 && int(n % std::size_t(ball.grid.dims.x)) > ball.grid.dims.x / 2)
      ball.labels[n] = 9;
  const hasp::BoneShares made = hasp::ShareBone(ball.Grey(), ball.Labels());
  std::size_t grown = 0;
  for (std::size_t n = 0; n < ball.labels.size(); ++n)
  {
    if (made.shares[n] < 0.5F)
      EXPECT_EQ(made.labels[n], 0);
    else if (ball.labels[n] != 0)
      EXPECT_EQ(made.labels[n], ball.labels[n]); // never another's voxel
    else
      grown += made.labels[n] != 0;
  }
  EXPECT_GT(grown, 100U); // the fringe of spongy bone that the threshold left out
}

TEST(BoneShare, LeavesOutWhatIsNoBrighterThanSoftTissue)
{
  BlurredBall ball(glm::dvec3(1.0));
  for (std::size_t n = 0; n < ball.grey.size(); ++n)
    ball.grey[n] = float(Soft);
  const hasp::BoneShares made = hasp::ShareBone(ball.Grey(), ball.Labels());
  for (std::size_t n = 0; n < ball.grey.size(); ++n)
    EXPECT_EQ(made.shares[n], 0.0F);
}
