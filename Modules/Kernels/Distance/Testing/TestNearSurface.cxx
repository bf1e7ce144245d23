#include "Distance/NearSurface.h"
#include "Testing/RandomSolid.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <atomic>

namespace
{

hasp::GridGeometry Around(const glm::ivec3& dims, const glm::dvec3& spacing, double angle = 0.4)
{
  hasp::GridGeometry g;
  g.dims = dims;
  g.spacing = spacing;
  g.direction = glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::dvec3(2, 1, -2)));
  g.origin = -g.direction * (0.5 * glm::dvec3(g.Cells()) * spacing);
  return g;
}

/// Counts how often it is asked, on any thread.
class Counting : public hasp::ImplicitSolid
{
public:
  explicit Counting(hasp::SolidPointer part, double steep = 1.0)
    : Part(std::move(part)),
      Steep(steep)
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    this->Asked.fetch_add(1, std::memory_order_relaxed);
    return this->Steep * this->Part->At(x);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override { return this->Part->SampleAt(x); }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return this->Part->FaceAt(face, x);
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return this->Part->Bounds(); }
  double Steepness() const noexcept override { return this->Steep; }

  mutable std::atomic<std::size_t> Asked{ 0 };

private:
  hasp::SolidPointer Part;
  double Steep;
};

/// Against every sample asked on its own.
void ExpectAsIfAllWereAsked(
  const hasp::ImplicitSolid& solid, const hasp::GridGeometry& g, double band)
{
  const auto values = hasp::DenseValues(hasp::EvaluateNearSurface(solid, g, band));
  ASSERT_EQ(values.size(), g.Size());
  std::size_t n = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        ASSERT_EQ(values[n++], glm::clamp(static_cast<float>(solid.At(g.IndexToWorld({ i, j, k }))),
                                 static_cast<float>(-band), static_cast<float>(band)));
}

TEST(NearSurface, RefusesWhatIsNoGridOrBand)
{
  const auto ball = hasp::MakeCapsule({}, {}, 2);
  const auto grid = Around({ 9, 9, 9 }, { 1, 1, 1 });
  for (const double band : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
    EXPECT_THROW(hasp::EvaluateNearSurface(*ball, grid, band), std::invalid_argument);
  EXPECT_THROW(
    hasp::EvaluateNearSurface(*ball, Around({ 9, 0, 9 }, { 1, 1, 1 }), 1), std::invalid_argument);
  EXPECT_THROW(hasp::EvaluateNearSurface(*ball, Around({ 20000, 20000, 20000 }, { 1, 1, 1 }), 1),
    std::invalid_argument);
}

TEST(NearSurface, IsAsIfEverySampleWereAsked)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto solid = hasp::RandomSolid(seed, 2);
    ExpectAsIfAllWereAsked(*solid, Around({ 61, 41, 30 }, { 0.15, 0.2, 0.5 }), 0.4);
  }
  const auto ball = hasp::MakeCapsule({}, {}, 2);
  ExpectAsIfAllWereAsked(*ball, Around({ 1, 1, 1 }, { 1, 1, 1 }), 0.5);
  ExpectAsIfAllWereAsked(*ball, Around({ 8, 16, 64 }, { 1, 1, 1 }), 1);
  ExpectAsIfAllWereAsked(*ball, Around({ 200, 1, 3 }, { 0.05, 5, 5 }), 0.2);      // 100 : 1
  ExpectAsIfAllWereAsked(*ball, Around({ 70, 70, 70 }, { 0.05, 0.05, 0.05 }), 9); // all in the band
}

TEST(NearSurface, BlocksAreWholeAndInOrder)
{
  // A ball through the last samples of 9 x 10 x 11: what a block holds over the end is outside.
  const auto ball = hasp::MakeCapsule({}, {}, 5);
  const auto field = hasp::EvaluateNearSurface(*ball, Around({ 9, 10, 11 }, { 1, 1, 1 }), 2);
  EXPECT_EQ(field.blocks, glm::ivec3(2));
  ASSERT_EQ(field.near.size(), 8u);
  for (std::uint32_t n = 0; n < 8; ++n)
  {
    EXPECT_EQ(field.near[n], n);
    const glm::ivec3 first = field.FirstSample(n);
    EXPECT_EQ(first, 8 * glm::ivec3(n & 1, n >> 1 & 1, n >> 2));
    for (int s = 0; s < 512; ++s)
    {
      const glm::ivec3 at = first + glm::ivec3(s % 8, s / 8 % 8, s / 64);
      ASSERT_TRUE((at.x < 9 && at.y < 10 && at.z < 11) || field.values[n * 512 + s] == 2.0F);
    }
  }
}

TEST(NearSurface, LeavesOutLessOfWhatIsSteep)
{
  const Counting steep(hasp::MakeCapsule({}, {}, 2), 3.0);
  ExpectAsIfAllWereAsked(steep, Around({ 64, 64, 64 }, { 0.2, 0.2, 0.2 }), 0.3);
}

TEST(NearSurface, AsksOnlyNearTheSurface)
{
  // A ball of 20 mm in a cube of 102 mm at 0.4 mm: in 16.8 million samples, of which a shell of
  // 4 pi R^2 and both bands of 1 mm and of a block's reach on each side holds a tenth.
  const Counting ball(hasp::MakeCapsule({}, {}, 20));
  const auto field =
    hasp::EvaluateNearSurface(ball, Around({ 256, 256, 256 }, { 0.4, 0.4, 0.4 }), 1.0);
  const double pi = 3.14159265358979, reach = 1.0 + 0.5 * 7 * 0.4 * std::sqrt(3.0);
  const double most = 4 * pi / 3 * (std::pow(20 + reach, 3) - std::pow(20 - reach, 3)) / 0.064;
  EXPECT_LT(double(field.near.size()) * 512, 1.05 * most);
  EXPECT_LT(double(ball.Asked), 1.05 * most + 32 * 32 * 32 + 64);
  EXPECT_LT(double(ball.Asked), 0.25 * 256 * 256 * 256);
  EXPECT_EQ(field.values.size(), field.near.size() * 512);
}

TEST(NearSurface, HoldsAPartOfAMetreThinnerThanItsSamples)
{
  const auto plate = hasp::MakeBox({}, glm::dmat3(1), { 500, 4, 0.05 });
  ExpectAsIfAllWereAsked(*plate, Around({ 2600, 40, 16 }, { 0.4, 0.4, 0.4 }, 0.0), 0.8);
}

TEST(NearSurface, CanBeCancelledAndTellsHowFarItIs)
{
  const auto ball = hasp::MakeCapsule({}, {}, 20);
  const auto g = Around({ 256, 256, 256 }, { 0.4, 0.4, 0.4 });
  double last = -1.0;
  hasp::EvaluateNearSurface(*ball, g, 1.0,
    [&](double share)
    {
      EXPECT_GT(share, last);
      EXPECT_LE(share, 1.0);
      last = share;
      return true;
    });
  EXPECT_GT(last, 0.5);
  EXPECT_THROW(hasp::EvaluateNearSurface(*ball, g, 1.0, [](double share) { return share < 0.3; }),
    hasp::Cancelled);
}

} // namespace
