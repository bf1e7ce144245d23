// Random transplants: sound meshes, or an error that says what is wrong.
#include "CutFixture.h"
#include "Evaluation/MeshCheck.h"
#include "GuideFixture.h"
#include "MitreGuide.h"
#include "TransplantBuilder.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <gtest/gtest.h>

#include <random>
#include <string>

using namespace cuttest;

namespace
{

enum class Kind
{
  Plain,    ///< corners of up to 40 degrees
  Extreme,  ///< of up to 125: over 60 at a cut are refused
  Straight, ///< of less than a hundredth of a degree
  Doubled,  ///< two places in one
  TooShort, ///< a donor for two of its segments
  Turned    ///< rolled, from the other tip, oblique stumps
};
constexpr int Kinds = 6;

struct Trial
{
  hasp::TransplantRecipe recipe;
  BoneScan jaw;
};

/// A rod of 7 mm, 240 mm along z: the donor.
double RodDistance(const glm::dvec3& p)
{
  return glm::length(p - glm::dvec3(0, 0, std::clamp(p.z, -113.0, 113.0))) - 7.0;
}

class Dice
{
public:
  explicit Dice(unsigned seed) : Random(seed) {}
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  glm::dvec3 Direction()
  {
    const double z = this->In(-1, 1), angle = this->In(0, 6.2831853), r = std::sqrt(1 - z * z);
    return { r * std::cos(angle), r * std::sin(angle), z };
  }
  /// Turned by an angle to any side.
  glm::dvec3 Turned(const glm::dvec3& way, double degrees)
  {
    const glm::dvec3 axis = glm::normalize(glm::cross(way, this->Direction()));
    return glm::dvec3(glm::rotate(glm::dmat4(1), glm::radians(degrees), axis) * glm::dvec4(way, 0));
  }

private:
  std::mt19937 Random;
};

/// Stumps are balls of 11 mm around the path's ends.
BoneScan StumpsOf(const hasp::TransplantRecipe& recipe)
{
  const glm::dvec3 a = recipe.path.front(), b = recipe.path.back();
  BoneScan scan;
  scan.grid.spacing = glm::dvec3(3.0);
  const glm::dvec3 low = glm::min(a, b) - 16.0, high = glm::max(a, b) + 16.0;
  scan.grid.origin = low;
  scan.grid.dims = glm::ivec3(glm::ceil((high - low) / 3.0)) + 1;
  const hasp::AnalyticVolume volume{ "stumps",
    [a, b](const glm::dvec3& p)
    { return 11.0 - std::min(glm::distance(p, a), glm::distance(p, b)); },
    1.0 };
  scan.samples = hasp::SampleAnalytic<std::int16_t>(volume, scan.grid, 1000, 226);
  return scan;
}

Trial MakeTrial(int number)
{
  Dice dice(1000u + unsigned(number));
  const Kind kind = Kind(number % Kinds);
  Trial trial;
  hasp::TransplantRecipe& r = trial.recipe;
  const int segments = 1 + (number / Kinds + number) % 4;
  const double most = kind == Kind::Extreme ? 125.0 : kind == Kind::Straight ? 0.01 : 40.0;
  glm::dvec3 way = dice.Direction();
  r.path = { 30.0 * dice.Direction() };
  for (int n = 0; n < segments; ++n)
  {
    r.path.push_back(r.path.back() + dice.In(24.0, 30.0) * way);
    r.outward.push_back(glm::normalize(glm::cross(way, dice.Direction())));
    way = dice.Turned(way, dice.In(0.0, most));
  }
  if (kind == Kind::Doubled)
    r.path[r.path.size() / 2] = r.path[r.path.size() / 2 - 1];
  const auto saw = [&](std::size_t from, std::size_t to)
  {
    glm::dvec3 normal = glm::normalize(r.path[to] - r.path[from]);
    if (!(glm::length(normal) > 0.5))
      normal = { 1, 0, 0 };
    if (kind == Kind::Turned)
      normal = dice.Turned(normal, dice.In(0.0, 50.0));
    const glm::dvec3 along = glm::normalize(glm::cross(normal, dice.Direction()));
    r.resection.cuts.push_back({ { r.path[from], normal, along, 40, 40, 3.0 }, 8.0 });
  };
  saw(0, 1);
  saw(r.path.size() - 1, r.path.size() - 2);
  r.resection.spacingMm = 1.5;
  r.leastSegmentMm = 15.0;
  r.donor.axis = { { 0, 0, -120 }, { 0, 0, 120 } };
  r.donor.lateral = { 1, 0, 0 };
  r.donor.radiusMm = 7.5;
  r.donor.keepMm = kind == Kind::TooShort ? 120.0 - 10.0 * segments : 12.0;
  r.kerfMm = 2.0;
  r.betweenMm = dice.In(0.0, 20.0);
  if (kind == Kind::Turned)
  {
    r.rollDeg = dice.In(-180.0, 180.0);
    r.fromLastTip = true;
  }
  r.guide.spacingMm = 1.0;
  r.guide.beyondMm = 8.0;
  trial.jaw = StumpsOf(r);
  return trial;
}

void ExpectSound(const hasp::TriangleMesh& mesh)
{
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
}

/// Whether an error is one of ours and says which value to change.
void ExpectNamed(const std::string& text)
{
  bool named = false;
  for (const char* key : { "path[", "segments[", "joints[", "cuts[", "slots[", "donor", "holes[",
         "landmarks[", "outward[", "withdrawal" })
    named = named || text.find(key) != std::string::npos;
  EXPECT_TRUE(named) << text;
}

class TransplantTrials : public testing::TestWithParam<int>
{
};

TEST_P(TransplantTrials, AreSoundOrSayWhatIsWrong)
{
  const BoneScan rod = ScanOf(RodDistance, { 12, 12, 125 }, { 1.5, 1.5, 2.0 }, 0.0);
  int made = 0, guides = 0;
  for (int n = 0; n < 2 * Kinds; ++n)
  {
    const int number = 2 * Kinds * this->GetParam() + n;
    SCOPED_TRACE("trial " + std::to_string(number));
    const Trial trial = MakeTrial(number);
    const Kind kind = Kind(number % Kinds);
    try
    {
      const hasp::MadeTransplant transplant =
        hasp::MakeTransplant({ trial.jaw.View(), {}, 1 }, { rod.View(), {}, 1 }, trial.recipe);
      ++made;
      EXPECT_NE(kind, Kind::Doubled);
      EXPECT_NE(kind, Kind::TooShort);
      ASSERT_EQ(transplant.segments.size(), trial.recipe.path.size() - 1);
      for (std::size_t s = 0; s < transplant.segments.size(); ++s)
      {
        ExpectSound(transplant.segments[s].mesh);
        ExpectSound(transplant.onDonor[s]);
      }
      const hasp::GuideRecipe recipe =
        hasp::MakeMitreGuideRecipe(transplant.plan, rod.View(), 226.0, trial.recipe.guide).recipe;
      if (n >= Kinds)
        continue; // a guide takes as long as all the rest
      guidetest::Answer answer(hasp::MakeImage(rod.grid, rod.samples), recipe);
      if (answer.error.empty())
      {
        ++guides;
        ExpectSound(hasp::MakeTriangleMesh(answer.Guide()));
      }
      else
        ExpectNamed(answer.error);
    }
    catch (const std::exception& error)
    {
      ExpectNamed(error.what());
    }
  }
  std::printf("%d of %d transplants made, and %d guides\n", made, 2 * Kinds, guides);
  EXPECT_GE(made, 4);   // of eight that can be
  EXPECT_GE(guides, 1); // of four that are tried
}

INSTANTIATE_TEST_SUITE_P(Seeds, TransplantTrials, testing::Range(0, 2));

} // namespace
