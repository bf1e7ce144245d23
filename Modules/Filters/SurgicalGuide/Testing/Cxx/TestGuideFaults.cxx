#include "GuideFixture.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <functional>
#include <limits>
#include <random>

using namespace guidetest;

namespace
{

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

TEST(GuideFilter, WhatLiesFarOffIsToldBeforeBoneIsMeasured)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(2), 0);
  const auto refusal = [&](const std::function<void(hasp::GuideRecipe&)>& spoil)
  {
    auto recipe = Band();
    recipe.spacingMm = 0.6;
    spoil(recipe);
    Answer answer(ct, recipe);
    EXPECT_LE(answer.share, 0.2);
    return answer.error;
  };
  const auto says = [](const std::string& text, const char* words)
  { EXPECT_NE(text.find(words), std::string::npos) << text; };
  says(refusal([](auto& r) { r.slots[0].point.y = -400; }),
    "slots[0] does not meet the guide: it is over 3");
  says(refusal([](auto& r) { r.holes[1].point.x = 300; }),
    "holes[1] does not meet the guide: it is over 2");
  // Not that the grid that reaches so far is too large.
  says(refusal(
         [](auto& r)
         {
           r.slots[0].point.y = -400;
           r.slots[0].guidingHeightMm = 12;
         }),
    "slots[0] does not meet the guide: it is over 3");
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
    r.edgeRadiusMm = 0.4 * (n % 2);
    r.clearanceMm = 0;
    r.spacingMm = 0.6 + 0.1 * any(random);
    for (int p = 0; p < 2 + n % 3; ++p)
      r.landmarks.push_back(OnSkull(x(random), y(random)));
    r.withdrawal = glm::normalize(glm::dvec3(0.3 * any(random), 0.3 * any(random), 1));
    r.widthMm = 4 + 2 * size(random);
    r.thicknessMm = size(random) + 0.5;
    r.gapMm = 0.2 * size(random);
    if (n % 2)
      r.slots = { { r.landmarks[0], glm::normalize(glm::dvec3(any(random), any(random), 0.1)), 1.5,
        3 * size(random), 10, n % 4 == 1 ? 10.0 : 0.0 } };
    if (n % 3)
      r.holes = { { r.landmarks[1], r.withdrawal, 1.5, 10, n % 2 ? 9.0 : 0.0 } };
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
