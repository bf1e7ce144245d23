#include "Planning/Osteotomy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace
{

std::string Refusal(const std::function<void(hasp::Osteotomy&)>& spoil)
{
  hasp::Osteotomy cut{ { 10, -20, 30 }, { 0.6, 0.8, 0 }, { 0, 0, 1 }, 25, 15, 0.5 };
  spoil(cut);
  try
  {
    hasp::ValidateOsteotomy(cut, "cuts[2]");
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

TEST(Osteotomy, RangesAreNamed)
{
  using O = hasp::Osteotomy;
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Refusal([=](O& c) { c.point.y = nan; }),
    "cuts[2]: point[1] is nan, must be in [-4000, 4000] mm");
  EXPECT_EQ(Refusal([=](O& c) { c.point.z = inf; }),
    "cuts[2]: point[2] is inf, must be in [-4000, 4000] mm");
  EXPECT_EQ(Refusal([](O& c) { c.normal *= 1.002; }),
    "cuts[2]: normal's length is 1.002, must be 1 within 0.001");
  EXPECT_EQ(Refusal([=](O& c) { c.along.x = nan; }),
    "cuts[2]: along's length is nan, must be 1 within 0.001");
  EXPECT_EQ(Refusal([](O& c) { c.along = c.normal; }),
    "cuts[2]: along: its cosine with normal is 1, must be 0 within 0.001");
  EXPECT_EQ(Refusal([](O& c) { c.widthMm = 0; }), "cuts[2]: widthMm is 0, must be in (0, 500]");
  EXPECT_EQ(Refusal([](O& c) { c.depthMm = 501; }), "cuts[2]: depthMm is 501, must be in (0, 500]");
  EXPECT_EQ(Refusal([=](O& c) { c.kerfMm = nan; }), "cuts[2]: kerfMm is nan, must be in (0, 5]");
  EXPECT_EQ(Refusal([](O& c) { c.kerfMm = 5.1; }), "cuts[2]: kerfMm is 5.1, must be in (0, 5]");
}

TEST(Osteotomy, LimitsThemselvesAreLegal)
{
  using O = hasp::Osteotomy;
  EXPECT_EQ(Refusal([](O&) {}), "");
  EXPECT_EQ(Refusal([](O& c) { c = {}; }), "");
  EXPECT_EQ(Refusal([](O& c) { c.point = { -4000, 4000, 0 }; }), "");
  EXPECT_EQ(Refusal([](O& c) { c.widthMm = c.depthMm = 500, c.kerfMm = 5; }), "");
  EXPECT_EQ(Refusal([](O& c) { c.normal *= 1.0009; }), "");
}

} // namespace
