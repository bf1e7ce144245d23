#include "Studies/FractureCaseMaker.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using glm::dvec3;
using hasp::FractureCaseChoices;
using hasp::FractureSettings;
using hasp::GridGeometry;
using hasp::GridView;
using hasp::Label;
using hasp::MadeFractureCase;

/// A shell of bone, 24 mm across, in soft tissue.
struct Shell
{
  GridGeometry grid;
  std::vector<std::int16_t> samples;
  std::vector<std::uint8_t> named;

  explicit Shell(double spacing = 0.75)
  {
    const int n = int(44.0 / spacing);
    this->grid.dims = { n, n, n };
    this->grid.spacing = dvec3(spacing);
    this->grid.origin = dvec3(-0.5 * spacing * (n - 1));
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
        {
          const double r = glm::length(this->grid.IndexToWorld({ i, j, k }));
          this->samples.push_back(r < 12.0 && r > 8.0 ? 1000 : 40);
          this->named.push_back(r < 12.0 && r > 8.0);
        }
  }
  GridView<const std::int16_t> View() const { return { this->samples.data(), this->grid }; }
  MadeFractureCase Make(int pieces, const FractureCaseChoices& choices) const
  {
    return hasp::MakeFractureCase(this->View(),
      hasp::ScatteredPieces(this->grid, this->named, pieces, choices.seed), this->named, choices);
  }
};

std::size_t CountOf(const std::vector<Label>& labels, Label label)
{
  return std::size_t(std::count(labels.begin(), labels.end(), label));
}

TEST(FractureCaseMaker, NonsenseIsRefused)
{
  const Shell shell(1.0);
  const auto made = [&](auto change)
  {
    FractureCaseChoices choices;
    change(choices);
    return shell.Make(1, choices);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(made([](auto& c) { c.shiftMm = -1.0; }), std::invalid_argument);
  EXPECT_THROW(made([&](auto& c) { c.turnDegrees = nan; }), std::invalid_argument);
  EXPECT_THROW(made([](auto& c) { c.lostChips = 21; }), std::invalid_argument);
  EXPECT_THROW(made([](auto& c) { c.chipMm = 0.0; }), std::invalid_argument);
  EXPECT_THROW(made([](auto& c) { c.spacingMm = dvec3(0.5); }), std::invalid_argument);
  EXPECT_THROW(made([](auto& c) { c.noiseHU = -1.0; }), std::invalid_argument);
  EXPECT_THROW(hasp::ScatteredPieces(shell.grid, shell.named, 0, 1), std::invalid_argument);
  EXPECT_THROW(
    hasp::ScatteredPieces(shell.grid, std::vector<std::uint8_t>(shell.named.size(), 0), 2, 1),
    std::invalid_argument);
  EXPECT_THROW(hasp::MakeFractureCase(shell.View(), {}, shell.named, {}), std::runtime_error);
}

TEST(FractureCaseMaker, PiecesMoveAsFarAndTurnAsMuchAsAsked)
{
  const Shell shell;
  FractureCaseChoices choices;
  choices.shiftMm = 4.5;
  choices.turnDegrees = 40.0;
  const MadeFractureCase made = shell.Make(3, choices);
  ASSERT_EQ(made.truth.fragments.size(), 3U);
  EXPECT_EQ(made.truth.fixed, (std::vector<Label>{ 2 }));
  for (const hasp::FractureCaseFragment& fragment : made.truth.fragments)
  {
    const dvec3& middle = fragment.centroidAnatomicalMm;
    EXPECT_NEAR(glm::distance(fragment.anatomicalToFractured.Place(middle), middle), 4.5, 1e-9);
    EXPECT_NEAR(
      glm::degrees(glm::length(hasp::RotationVector(fragment.anatomicalToFractured.orientation))),
      40.0, 1e-9);
    EXPECT_EQ(fragment.voxelsAnatomical, CountOf(made.intact.truth, fragment.label));
    EXPECT_EQ(fragment.voxelsFractured, CountOf(made.fractured.truth, fragment.label));
    EXPECT_GE(fragment.startMostMm, fragment.startMeanMm);
  }
  EXPECT_NO_THROW(hasp::ValidateFractureCase(made.truth));
}

TEST(FractureCaseMaker, TheTruthBringsEachVoxelBackIntoItsBone)
{
  const Shell shell;
  FractureCaseChoices choices;
  choices.turnDegrees = 12.0;
  choices.crackMm = 0.0;
  const MadeFractureCase made = shell.Make(2, choices);
  const GridGeometry& grid = made.truth.geometry;
  std::size_t asked = 0, back = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
      {
        const Label label =
          made.fractured.truth[(std::size_t(k) * grid.dims.y + j) * grid.dims.x + i];
        if (label < 3)
          continue;
        const glm::ivec3 at(glm::round(grid.WorldToIndex(
          hasp::TrueReduction(made.truth, label).Place(grid.IndexToWorld({ i, j, k })))));
        bool found = false; // at the voxel or beside it: its surface is a voxel's share
        for (int n = 0; n < 27; ++n)
        {
          const glm::ivec3 near = at + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
          found = found ||
                  made.intact
                      .truth[(std::size_t(near.z) * grid.dims.y + near.y) * grid.dims.x + near.x] ==
                    label;
        }
        ++asked;
        back += found;
      }
  EXPECT_GT(asked, 500U);
  EXPECT_GT(double(back), 0.98 * double(asked)); // 226 HU lies outside of half a voxel
}

TEST(FractureCaseMaker, ChipsAndErosionTakeBoneAway)
{
  const Shell shell;
  FractureCaseChoices choices;
  choices.shiftMm = choices.turnDegrees = choices.crackMm = 0.0;
  const MadeFractureCase whole = shell.Make(2, choices);
  EXPECT_EQ(whole.fractured.truth, whole.intact.truth);
  EXPECT_EQ(whole.fractured.samples, whole.intact.samples);
  choices.lostChips = 2;
  choices.chipMm = 5.0;
  const MadeFractureCase chipped = shell.Make(2, choices);
  std::size_t lost = 0, others = 0;
  for (std::size_t v = 0; v < whole.intact.truth.size(); ++v)
    if (const Label label = chipped.fractured.truth[v]; label != whole.intact.truth[v])
      ++(label == 0 ? lost : others);
  EXPECT_LE(10 * others, lost); // where the chip's blurred rim meets the fracture's
  // At most two boxes of 5 mm with blur, at the least a part of one in a shell of 4 mm.
  EXPECT_LT(double(lost) * 0.421875, 2.0 * 6.0 * 6.0 * 6.0);
  EXPECT_GT(double(lost) * 0.421875, 10.0);
  EXPECT_EQ(chipped.intact.truth, whole.intact.truth);
}

TEST(FractureCaseMaker, ACoarserScannerHasItsVoxelsAndTheSameBones)
{
  const Shell shell;
  FractureCaseChoices choices;
  choices.spacingMm = { 1.0, 1.0, 1.5 };
  choices.blurMm = dvec3(0.2);
  choices.noiseHU = 20.0;
  const MadeFractureCase made = shell.Make(4, choices);
  EXPECT_NEAR(made.truth.geometry.spacing.z, 1.5, 1e-12);
  EXPECT_EQ(made.fractured.truth.size(), made.truth.geometry.Size());
  EXPECT_EQ(made.fractured.geometry.dims, made.intact.geometry.dims);
  for (const hasp::FractureCaseFragment& fragment : made.truth.fragments)
    EXPECT_GT(fragment.voxelsFractured, 50U);
  const MadeFractureCase again = shell.Make(4, choices);
  EXPECT_EQ(again.fractured.samples, made.fractured.samples); // seeded
  choices.seed = 2;
  EXPECT_NE(shell.Make(4, choices).fractured.truth, made.fractured.truth);
}

TEST(FractureCaseMaker, AShortLongBoneBreaksToo)
{
  Shell shell;
  for (int k = 0, n = shell.grid.dims.x; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const dvec3 p = shell.grid.IndexToWorld({ i, j, k });
        const bool bone = std::hypot(p.x, p.y) < 5.0 && std::abs(p.z) < 20.0;
        const std::size_t v = (std::size_t(k) * n + j) * n + i;
        shell.samples[v] = bone ? 1000 : -1000;
        shell.named[v] = bone;
      }
  const MadeFractureCase made = shell.Make(2, {});
  for (const hasp::FractureCaseFragment& fragment : made.truth.fragments)
    EXPECT_GT(fragment.voxelsAnatomical, 200U);
}

} // namespace
