#include "Evaluation/GuideGap.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/AnalyticVolumes.h"
#include "Planning/GuideRecipe.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>

namespace
{

/// An ellipsoid of bone, 1000 HU per mm at its surface's distance: closed-form truth.
hasp::AnalyticVolume Skull()
{
  // Bounds of an ellipsoid's distance: f = (|p/r| - 1) |p/r| / |p/r^2| has unit gradient at 0.
  const glm::dvec3 r(30, 26, 22);
  return { "ellipsoid",
    [r](const glm::dvec3& p)
    {
      const double k = glm::length(p / r);
      return k > 0 ? -(k - 1) * k / glm::length(p / (r * r)) : 20.0;
    },
    2.0 };
}

vtkSmartPointer<vtkImageData> ScanOf(
  const hasp::AnalyticVolume& bone, const glm::dvec3& spacing, double angle)
{
  const glm::dmat3 d(glm::rotate(glm::dmat4(1), angle, glm::normalize(glm::dvec3(1, -2, 3))));
  hasp::GridGeometry grid;
  grid.dims = glm::ivec3(glm::ceil(glm::dvec3(76) / spacing)) + 1;
  grid.spacing = spacing;
  grid.direction = d;
  grid.origin = -(d * (0.5 * spacing * glm::dvec3(grid.Cells())));
  return hasp::MakeImage(grid, hasp::SampleAnalytic<std::int16_t>(bone, grid, 200, 226));
}

glm::dvec3 OnSkull(double x, double y)
{
  return { x, y, 22 * std::sqrt(1 - x * x / 900 - y * y / 676) };
}

/// A band over the top of the ellipsoid with a slot and two holes.
hasp::GuideRecipe Band()
{
  hasp::GuideRecipe r;
  r.landmarks = { OnSkull(-9, 2), OnSkull(0, 3), OnSkull(9, 0) };
  r.withdrawal = { 0, 0, 1 };
  r.spacingMm = 0.5;
  r.widthMm = 12;
  r.slots = { { OnSkull(0, 3), { 0, 1, 0 }, 1.2, 12 } };
  r.holes = { { OnSkull(-9, 2), { 0, 0, 1 }, 2.0 }, { OnSkull(9, 0), { 0, 0, 1 }, 2.0 } };
  return r;
}

/// The guide as it comes back from a binary STL file.
hasp::TriangleMesh ThroughFile(vtkPolyData* guide)
{
  const std::string path = testing::TempDir() + "TestGuideFilter.stl";
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(guide);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff();
  reader->Update();
  std::remove(path.c_str());
  return hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput()));
}

/// What the filter answers: its mesh, and the error it reported, if any.
struct Answer
{
  vtkNew<vtkHaspGuideFilter> filter;
  std::string error;

  explicit Answer(vtkImageData* ct, const hasp::GuideRecipe& recipe)
  {
    vtkNew<vtkCallbackCommand> keep;
    keep->SetClientData(this);
    keep->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Answer*>(self)->error += static_cast<const char*>(text); });
    this->filter->AddObserver(vtkCommand::ErrorEvent, keep);
    this->filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
    this->filter->SetInputData(ct);
    this->filter->SetRecipe(recipe);
    this->filter->Update();
  }
  vtkPolyData* Guide() { return this->filter->GetOutput(); }
};

void ExpectRefused(const std::function<void(hasp::GuideRecipe&)>& spoil, const std::string& part)
{
  static const auto ct = ScanOf(Skull(), glm::dvec3(2), 0);
  auto recipe = Band();
  recipe.spacingMm = 0.6;
  spoil(recipe);
  Answer answer(ct, recipe);
  EXPECT_EQ(answer.Guide()->GetNumberOfPoints(), 0);
  EXPECT_NE(answer.error.find(part), std::string::npos) << part << " in: " << answer.error;
}

class GuideFilterOnGrids : public testing::TestWithParam<std::tuple<glm::dvec3, double>>
{
};

TEST_P(GuideFilterOnGrids, FitsWithinATwentiethOfAMillimetre)
{
  const auto [spacing, angle] = GetParam();
  const auto ct = ScanOf(Skull(), spacing, angle);
  const auto recipe = Band();
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.Guide());
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
  EXPECT_EQ(int(check.points) - int(check.triangles / 2), 2 - 2 * 3); // a slot and two holes
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  hasp::GuideGapSettings settings;
  settings.gapMm = recipe.gapMm;
  const auto gap = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings);
  EXPECT_GT(gap.innerWallMm2, 100);
  EXPECT_GE(gap.share, 0.95); // the bar
  EXPECT_GT(gap.p5, recipe.gapMm - 0.05);
  EXPECT_LT(gap.p50, recipe.gapMm + 0.05);
  EXPECT_GT(gap.leastAnywhere, recipe.gapMm - 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scans, GuideFilterOnGrids,
  testing::Values(std::make_tuple(glm::dvec3(1), 0.0),
    std::make_tuple(glm::dvec3(0.957, 0.957, 1.5), 0.6),
    std::make_tuple(glm::dvec3(0.6, 0.6, 3), 0.3)));

TEST(GuideFilter, KeepsItsDistanceToTheClosedFormSphere)
{
  // Against the sphere itself, not its trilinear surface: that lies up to h^2 / (8 R) (1/R + 1/R),
  // 0.01 mm, inside.
  const auto sphere = hasp::AnalyticSphere({}, 25);
  const auto ct = ScanOf(sphere, glm::dvec3(1), 0.4);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.holes.clear();
  for (auto& p : recipe.landmarks)
    p = 25.0 * glm::normalize(p);
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  double inner = 0, outer = 0, innerArea = 0, outerArea = 0;
  const auto mesh = hasp::MakeTriangleMesh(answer.Guide());
  for (const auto& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a), middle = (a + b + c) / 3.0;
    const double facing = glm::dot(glm::normalize(n), glm::normalize(middle));
    const double area = 0.5 * glm::length(n), d = glm::length(middle) - 25;
    EXPECT_GT(d, recipe.gapMm - 0.05);
    EXPECT_LT(d, recipe.gapMm + recipe.thicknessMm + 0.05);
    (facing < -0.98 ? inner : outer) += facing < -0.98 || facing > 0.98 ? area * d : 0;
    (facing < -0.98 ? innerArea : outerArea) += std::abs(facing) > 0.98 ? area : 0;
  }
  EXPECT_NEAR(inner / innerArea, recipe.gapMm, 0.02);
  EXPECT_NEAR(outer / outerArea, recipe.gapMm + recipe.thicknessMm, 0.04);
}

TEST(GuideFilter, LiftsOffAlongTheWithdrawalDirection)
{
  // Around a sphere's side the bone is undercut: below the equator nothing may remain.
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.holes.clear();
  recipe.landmarks = { { 20, 0, 0 }, { 0, 20, 0 } };
  recipe.landmarks.insert(recipe.landmarks.begin() + 1, 20.0 * glm::normalize(glm::dvec3(1, 1, 0)));
  recipe.widthMm = 16;
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  double deepest = 0, highest = 0;
  for (const auto& p : hasp::MakeTriangleMesh(answer.Guide()).points)
  {
    const double fromAxis = std::hypot(p.x, p.y);
    deepest = std::min(deepest, p.z);
    highest = std::max(highest, p.z);
    if (p.z < 0) // outside the shadow of the sphere and its gap
    {
      EXPECT_GT(fromAxis, 20 + recipe.gapMm - 0.1);
    }
  }
  EXPECT_LT(deepest, -2); // the tube reaches below the equator, beside the shadow
  EXPECT_GT(highest, 5);
}

TEST(GuideFilter, EveryOutlineMakesOnePiece)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1.5), 0.2);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.landmarks = { OnSkull(-9, -8), OnSkull(9, -8), OnSkull(9, 8), OnSkull(-9, 8) };
  recipe.holes = { { OnSkull(9, 8), { 0, 0, 1 }, 2 } };
  recipe.widthMm = 8;
  recipe.spacingMm = 0.6;
  const std::pair<hasp::GuideOutline, int> outlines[] = { { hasp::GuideOutline::Open, 1 },
    { hasp::GuideOutline::Closed, 2 }, { hasp::GuideOutline::Filled, 1 } };
  for (const auto& [outline, handles] : outlines)
  {
    recipe.outline = outline;
    Answer answer(ct, recipe);
    ASSERT_EQ(answer.error, "");
    const auto check = hasp::CheckMesh(hasp::MakeTriangleMesh(answer.Guide()));
    EXPECT_TRUE(check.Sound());
    EXPECT_EQ(int(check.points) - int(check.triangles / 2), 2 - 2 * handles);
  }
}

TEST(GuideFilter, AGapOfZeroTouchesAndNoMore)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1), 0.2);
  auto recipe = Band();
  recipe.gapMm = 0;
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.Guide());
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
  hasp::GuideGapSettings settings;
  settings.gapMm = 0;
  const auto gap = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings);
  EXPECT_GE(gap.share, 0.95);
  EXPECT_GT(gap.least, -0.05);
}

TEST(GuideFilter, WhatCannotBeMadeIsNamed)
{
  using R = hasp::GuideRecipe;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRefused([=](R& r) { r.gapMm = nan; }, "gapMm is nan");
  ExpectRefused([](R& r) { r.thicknessMm = 0; }, "thicknessMm is 0");
  ExpectRefused([](R& r) { r.landmarks[1] = r.landmarks[0]; }, "landmarks[0] and landmarks[1]");
  ExpectRefused([](R& r) { r.landmarks[2].x = 500; }, "landmarks[2] (500, 0");
  ExpectRefused([](R& r) { r.landmarks[1].z += 5; }, "landmarks[1] is");
  ExpectRefused([](R& r) { r.landmarks[1] = { 0, 0, 0 }; }, "landmarks[1] is");
  ExpectRefused([](R& r) { r.isovalue = 30000; }, "landmarks[0] is inf mm from bone");
  ExpectRefused([](R& r) { r.gapMm = 9; }, "nothing is left");
  ExpectRefused([](R& r) { r.slots[0].point.y = 30; }, "slots[0] does not meet the guide");
  ExpectRefused([](R& r) { r.holes[1].point.x = -30; }, "holes[1] does not meet the guide");
  ExpectRefused([](R& r) { r.slots[0].lengthMm = 100; }, "pieces");
  ExpectRefused([](R& r) { r.withdrawal = { 0, 0, -1 }; }, "nothing is left");
  ExpectRefused(
    [](R& r)
    {
      r.spacingMm = 0.05;
      r.widthMm = 100;
    },
    "raise spacingMm");
}

TEST(GuideFilter, RandomRecipesOnNoisyBoneAreSoundOrNamed)
{
  std::mt19937 random(29);
  std::normal_distribution<double> noise(0, 40); // HU, on a step of 200 per mm
  auto ct = ScanOf(Skull(), { 1.5, 1.5, 2.5 }, 0.9);
  auto* hu = static_cast<short*>(ct->GetScalarPointer());
  for (vtkIdType n = 0; n < ct->GetNumberOfPoints(); ++n)
    hu[n] = static_cast<short>(hu[n] + noise(random));
  std::uniform_real_distribution<double> x(-16, 16), y(-13, 13), size(1.0, 4.0), any(-1, 1);
  int made = 0;
  for (int n = 0; n < 6; ++n)
  {
    hasp::GuideRecipe r;
    r.spacingMm = 0.6 + 0.1 * any(random);
    for (int p = 0; p < 2 + n % 3; ++p)
      r.landmarks.push_back(OnSkull(x(random), y(random)));
    r.withdrawal = glm::normalize(glm::dvec3(0.3 * any(random), 0.3 * any(random), 1));
    r.widthMm = 4 + 2 * size(random);
    r.thicknessMm = size(random) + 0.5;
    r.gapMm = 0.2 * size(random);
    if (n % 2)
      r.slots = { { r.landmarks[0], glm::normalize(glm::dvec3(any(random), any(random), 0.1)), 1.5,
        3 * size(random) } };
    if (n % 3)
      r.holes = { { r.landmarks[1], r.withdrawal, 1.5 } };
    Answer answer(ct, r);
    EXPECT_NE(answer.error.empty(), answer.Guide()->GetNumberOfPolys() == 0);
    if (!answer.error.empty())
      continue;
    ++made;
    const auto mesh = ThroughFile(answer.Guide());
    EXPECT_TRUE(hasp::CheckMesh(mesh).Sound()) << n;
    EXPECT_EQ(hasp::CheckMesh(mesh).pieces, 1U) << n;
#if HASP_WITH_CGAL
    EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U) << n;
#endif
  }
  EXPECT_GE(made, 3);
}

TEST(GuideFilter, BoneOverheadBlocksTheWay)
{
  // A second ball far above the first: outside the working grid, but in the way.
  const auto ct = ScanOf({ "two balls",
                           [](const glm::dvec3& p)
                           {
                             return std::max(14 - glm::length(p + glm::dvec3(0, 0, 18)),
                               12 - glm::length(p - glm::dvec3(0, 0, 24)));
                           },
                           1 },
    glm::dvec3(1.5), 0);
  hasp::GuideRecipe recipe;
  recipe.spacingMm = 0.6;
  recipe.landmarks = { { -3, 0, -18 + std::sqrt(196 - 9.0) },
    { 3, 0, -18 + std::sqrt(196 - 9.0) } };
  recipe.widthMm = 10;
  Answer answer(ct, recipe);
  EXPECT_NE(answer.error.find("nothing is left"), std::string::npos) << answer.error;
}

TEST(GuideFilter, CancellingMidwayLeavesNothing)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1.5), 0);
  for (const double share : { 0.05, 0.3, 0.7, 0.95 })
  {
    vtkNew<vtkHaspGuideFilter> filter;
    filter->SetInputData(ct);
    filter->SetRecipe(Band());
    vtkNew<vtkCallbackCommand> stop;
    double at = share;
    stop->SetClientData(&at);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* self = static_cast<vtkHaspGuideFilter*>(caller);
        if (self->GetProgress() >= *static_cast<double*>(data))
          self->AbortExecuteOn();
      });
    const auto id = filter->AddObserver(vtkCommand::ProgressEvent, stop);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << share;
    // And again to the end.
    filter->RemoveObserver(id);
    filter->AbortExecuteOff();
    filter->Modified();
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(GuideFilter, ImagesItCannotReadAreRefused)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->AllocateScalars(VTK_DOUBLE, 1);
  Answer answer(image, Band());
  EXPECT_NE(answer.error.find("double"), std::string::npos) << answer.error;
}

} // namespace
