#include "Evaluation/Flip.h"
#include "FlipPairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{

using hasp::Flip;
using Picture = std::vector<glm::vec3>;

double Mean(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

struct Published
{
  int pair;
  double pixelsPerDegree, mean;
  struct Pixel
  {
    int number;
    float value;
  };
  std::vector<Pixel> pixels;
};

/// Printed by the reference implementation of the paper's authors (FLIP.h of NVlabs/flip 1.6, C++)
/// for these pairs. It adds in float, which leaves 1.4e-5 in a pixel.
TEST(Flip, IsWhatTheAuthorsImplementationPrints)
{
  const std::vector<Published> published{ { 0, 67.020645, 0.682636697,
                                            { { 256, 0.4255033F }, { 775, 0.5180767F },
                                              { 1294, 0.6140742F }, { 1813, 0.6959357F },
                                              { 2332, 0.7655154F }, { 2851, 0.8185384F } } },
    { 0, 30, 0.677409167,
      { { 256, 0.4196953F }, { 775, 0.5083476F }, { 1294, 0.6055387F }, { 1813, 0.6887593F },
        { 2332, 0.7595718F }, { 2851, 0.8209960F } } },
    { 1, 67.020645, 0.452501316,
      { { 166, 0.3540241F }, { 507, 0.4362323F }, { 847, 0.6876770F }, { 1187, 0.2903816F },
        { 1528, 0.1958650F }, { 1868, 0.2385450F } } },
    { 1, 30, 0.601229380,
      { { 166, 0.0823794F }, { 507, 0.8127077F }, { 847, 0.5105008F }, { 1187, 0.2394708F },
        { 1528, 0.2320688F }, { 1868, 0.3199567F } } },
    { 2, 67.020645, 0.201619235,
      { { 186, 0.4803249F }, { 567, 0.0000000F }, { 947, 0.0885306F }, { 1327, 0.0907906F },
        { 1708, 0.0000000F }, { 2088, 0.8844749F } } },
    { 2, 30, 0.141442116,
      { { 186, 0.3084254F }, { 567, 0.0000000F }, { 947, 0.0002767F }, { 1327, 0.0001462F },
        { 1708, 0.0000000F }, { 2088, 0.5577896F } } },
    { 3, 67.020645, 0.449840235,
      { { 192, 0.5853139F }, { 583, 0.3630302F }, { 974, 0.7106450F }, { 1365, 0.2835391F },
        { 1756, 0.3304816F }, { 2147, 0.2372585F } } },
    { 3, 30, 0.738525534,
      { { 192, 0.6401026F }, { 583, 0.8040644F }, { 974, 0.5560745F }, { 1365, 0.9664875F },
        { 1756, 0.5376996F }, { 2147, 0.7730235F } } } };
  const std::vector<hasp::FlipPair> pairs = hasp::FlipPairs();
  for (const Published& p : published)
  {
    const auto& [width, reference, test] = pairs[p.pair];
    const std::vector<float> flip = Flip(reference, test, width, { p.pixelsPerDegree });
    EXPECT_NEAR(Mean(flip), p.mean, 2e-6) << p.pair << " at " << p.pixelsPerDegree;
    for (const auto& [number, value] : p.pixels)
      EXPECT_NEAR(flip[number], value, 5e-5) << p.pair << ", pixel " << number;
  }
}

/// Without edges only the colours count: HyAB of CIELab with Hunt's effect, to the power 0.7.
TEST(Flip, OfFlatColoursIsTheClosedForm)
{
  const auto flat = [](const glm::vec3& colour) { return Picture(20 * 15, colour); };
  const auto of = [&](const glm::vec3& a, const glm::vec3& b)
  { return Flip(flat(a), flat(b), 20)[137]; };
  // CIELab of sRGB's green and blue, as tables have it: the largest distance there is.
  const glm::dvec3 green(87.7347, -86.1827, 83.1793), blue(32.2970, 79.1875, -107.8602);
  const auto hunt = [](const glm::dvec3& c)
  { return glm::dvec3(c.x, 0.01 * c.x * c.y, 0.01 * c.x * c.z); };
  const glm::dvec3 off = hunt(green) - hunt(blue);
  const double largest = std::pow(std::abs(off.x) + std::hypot(off.y, off.z), 0.7);
  const double share = std::pow(100.0, 0.7) / largest; // lightness of white, no chroma
  // The table has four decimals and another last digit of the white point.
  EXPECT_NEAR(of(glm::vec3(0), glm::vec3(1)), 0.95 + (share - 0.4) / 0.6 * 0.05, 1e-4);
  EXPECT_NEAR(of({ 0, 1, 0 }, { 0, 0, 1 }), 1.0, 1e-6);
  const double dark = 10.0 / 255.0 / 12.92; // linear; so dark that CIELab is linear too
  EXPECT_NEAR(of(glm::vec3(0), glm::vec3(10.0F / 255.0F)),
    0.95 / 0.4 * std::pow(903.2963 * dark, 0.7) / largest, 1e-5);
}

TEST(Flip, EqualPicturesAreZeroAndOthersAreNot)
{
  for (const auto& [width, reference, test] : hasp::FlipPairs())
  {
    for (const float value : Flip(reference, reference, width))
      EXPECT_EQ(value, 0.0F);
    Picture nearly = reference;
    nearly[nearly.size() / 2 + width / 2] = glm::vec3(0.5F);
    const std::vector<float> flip = Flip(reference, nearly, width);
    EXPECT_GT(flip[nearly.size() / 2 + width / 2], 0.01F);
    EXPECT_EQ(flip.front(), 0.0F); // farther away than any filter reaches
  }
}

TEST(Flip, DoesNotMindWhichIsTheReferenceNorWhichWayRowsRun)
{
  for (const auto& [width, reference, test] : hasp::FlipPairs())
  {
    const std::vector<float> flip = Flip(reference, test, width);
    EXPECT_EQ(flip, Flip(test, reference, width));
    const auto turned = [](auto picture)
    {
      std::reverse(picture.begin(), picture.end());
      return picture;
    };
    const std::vector<float> back = turned(Flip(turned(reference), turned(test), width));
    for (std::size_t n = 0; n < flip.size(); ++n)
      EXPECT_NEAR(back[n], flip[n], 1e-5) << n; // sums in another order, in float between passes
  }
}

/// A finer pattern is less visible: that is what tells FLIP from a difference of values.
TEST(Flip, FadesWithThePatternsFrequency)
{
  const auto stripes = [](int side, int shift)
  {
    return hasp::DrawFlipPicture(
      64, 64, [=](int x, int) { return glm::vec3((x / side + shift) % 2 ? 0.3F : 0.7F); });
  };
  const auto seen = [&](int side) { return Mean(Flip(stripes(side, 0), stripes(side, 1), 64)); };
  EXPECT_LT(seen(1), 0.3 * seen(4));
  EXPECT_LT(seen(4), seen(16));
}

TEST(Flip, RefusesWhatIsNoPairOfPictures)
{
  const Picture a(12, glm::vec3(0.5F)), b(8, glm::vec3(0.5F));
  EXPECT_THROW(Flip(a, b, 4), std::invalid_argument);
  EXPECT_THROW(Flip(a, a, 5), std::invalid_argument);
  EXPECT_THROW(Flip(a, a, 0), std::invalid_argument);
  EXPECT_THROW(Flip({}, {}, 4), std::invalid_argument);
  for (const double degrees : { 0.0, -67.0, 1e9, std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(Flip(a, a, 4, { degrees }), std::invalid_argument);
  for (const float value : { -0.01F, 1.01F, std::numeric_limits<float>::quiet_NaN(),
         std::numeric_limits<float>::infinity() })
  {
    Picture spoiled = a;
    spoiled[7].y = value;
    EXPECT_THROW(Flip(a, spoiled, 4), std::invalid_argument) << value;
    EXPECT_THROW(Flip(spoiled, a, 4), std::invalid_argument) << value;
  }
}

} // namespace
