#include "vtkHaspSolid.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspSolidSweep.h"

#include "Distance/SolidShapes.h"
#include "FilterErrors.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>

namespace
{

using Place = std::array<double, 3>;

double At(vtkHaspSolidAlgorithm* of, const Place& place)
{
  of->Update();
  return of->GetOutput()->EvaluateDistance(place.data());
}

std::array<double, 6> BoundsOf(vtkHaspSolidAlgorithm* of)
{
  of->Update();
  std::array<double, 6> bounds;
  of->GetOutput()->GetBounds(bounds.data());
  return bounds;
}

const Place O{ 0, 0, 0 }, X{ 1, 0, 0 }, Y{ 0, 1, 0 }, Z{ 0, 0, 1 };

TEST(SolidSource, MistakesAreNamedAsTheyAre)
{
  vtkNew<vtkHaspSolidSource> source;
  const auto said = [&](const std::function<void()>& set) { return ErrorsOf(source, set); };
  const Place half{ 1, 1, 1 };
  const double longAxis[9] = { 2, 0, 0, 0, 1, 0, 0, 0, 1 };
  EXPECT_NE(
    said([&] { source->SetToBox(O.data(), half.data(), longAxis); }).find("axis 0 has length 2"),
    std::string::npos);
  const double skew[9] = { 1, 0.6, 0, 0, 0.8, 0, 0, 0, 1 };
  EXPECT_NE(said([&] { source->SetToBox(O.data(), half.data(), skew); })
              .find("axes 0 and 1 have the dot product 0.6"),
    std::string::npos);
  EXPECT_NE(said([&] { source->SetToText("Ab", O.data(), X.data(), Y.data(), 3.0, 0.5); })
              .find("character 2 has no letter; capitals"),
    std::string::npos);
  ErrorsOfUpdate(source);
  EXPECT_NE(source->GetErrorCode(), 0UL) << "there is no shape";
}

TEST(SolidSource, EachShapeIsWhereItIsSaid)
{
  vtkNew<vtkHaspSolidSource> source;
  const Place far{ 0, 0, 10 }, half{ 1, 2, 3 };
  ASSERT_TRUE(source->SetToPlane(O.data(), Z.data()));
  EXPECT_EQ(At(source, { 5, 5, 2 }), 2.0);
  EXPECT_EQ(BoundsOf(source)[4], -std::numeric_limits<double>::infinity());
  ASSERT_TRUE(source->SetToSlab(O.data(), Z.data(), 1.0));
  EXPECT_EQ(At(source, { 5, 5, -2 }), 1.5);
  ASSERT_TRUE(source->SetToBox(O.data(), half.data()));
  EXPECT_EQ(BoundsOf(source), (std::array<double, 6>{ -1, 1, -2, 2, -3, 3 }));
  const double turned[9] = { 0, -1, 0, 1, 0, 0, 0, 0, 1 }; // its first axis along y
  ASSERT_TRUE(source->SetToBox(O.data(), half.data(), turned));
  EXPECT_NEAR(At(source, { 0, 3, 0 }), 2.0, 1e-12);
  EXPECT_NEAR(At(source, { 3, 0, 0 }), 1.0, 1e-12);
  ASSERT_TRUE(source->SetToRoundedBox(O.data(), half.data(), 0.5, turned));
  EXPECT_NEAR(At(source, { 0, 3, 0 }), 2.0, 1e-12);
  ASSERT_TRUE(source->SetToRoundedBox(O.data(), half.data(), 0.5));
  EXPECT_NEAR(At(source, { 1, 2, 3 }), 0.5 * (std::sqrt(3.0) - 1.0), 1e-12);
  ASSERT_TRUE(source->SetToCylinder(O.data(), far.data(), 2.0));
  EXPECT_NEAR(At(source, { 3, 0, 5 }), 1.0, 1e-12);
  EXPECT_NEAR(At(source, { 0, 0, 11 }), 1.0, 1e-12);
  ASSERT_TRUE(source->SetToCapsule(O.data(), far.data(), 2.0));
  EXPECT_NEAR(At(source, { 0, 0, 13 }), 1.0, 1e-12);
  ASSERT_TRUE(source->SetToStadium(O.data(), far.data(), X.data(), 2.0, 1.0));
  EXPECT_NEAR(At(source, { 1.5, 0, 5 }), 1.0, 1e-12);
  EXPECT_NEAR(At(source, { 0, 3, 5 }), 1.0, 1e-12);
  ASSERT_TRUE(source->SetToText("HH", O.data(), X.data(), Y.data(), 6.0, 1.0));
  const auto two = BoundsOf(source);
  EXPECT_NEAR(two[1] - two[0], vtkHaspSolidSource::GetTextWidth("HH", 6.0) + 1.0, 1e-9);
  ASSERT_TRUE(source->SetToText("I", O.data(), X.data(), Y.data(), 6.0, 1.0));
  const auto text = BoundsOf(source);
  EXPECT_NEAR(text[2], -0.5, 0.01);
  EXPECT_NEAR(text[3], 6.5, 0.01);
}

TEST(SolidSource, WhatIsRefusedLeavesTheShapeThatWasThere)
{
  vtkNew<vtkHaspSolidSource> source;
  EXPECT_NE(ErrorsOfUpdate(source).find("SetTo"), std::string::npos);
  EXPECT_EQ(source->GetOutput()->GetSolid(), nullptr);
  ASSERT_TRUE(source->SetToCapsule(O.data(), O.data(), 2.0));
  const auto refused = [&](const auto& set)
  { EXPECT_NE(ErrorsOf(source, [&] { EXPECT_FALSE(set()); }), ""); };
  refused([&] { return source->SetToCapsule(O.data(), O.data(), 0.0); });
  refused([&] { return source->SetToPlane(O.data(), O.data()); });
  refused([&] { return source->SetToSlab(O.data(), Z.data(), -1.0); });
  const double skewed[9] = { 1, 1, 0, 0, 1, 0, 0, 0, 1 };
  refused([&] { return source->SetToBox(O.data(), Place{ 1, 1, 1 }.data(), skewed); });
  refused([&] { return source->SetToText("secret?", O.data(), X.data(), Y.data(), 6.0, 1.0); });
  EXPECT_EQ(
    ErrorsOf(source, [&] { source->SetToText("secret?", O.data(), X.data(), Y.data(), 6.0, 1.0); })
      .find("secret"),
    std::string::npos);
  EXPECT_EQ(At(source, { 3, 0, 0 }), 1.0);
}

TEST(Solid, IsSharedByItsCopies)
{
  vtkNew<vtkHaspSolid> solid, shallow, deep;
  EXPECT_EQ(solid->EvaluateDistance(O.data()), std::numeric_limits<double>::infinity());
  solid->SetSolid(hasp::MakeCapsule({ 1, 2, 3 }, { 1, 2, 3 }, 2.0));
  shallow->ShallowCopy(solid);
  deep->DeepCopy(solid);
  EXPECT_EQ(shallow->GetSolid(), solid->GetSolid());
  EXPECT_EQ(deep->GetSolid(), solid->GetSolid());
  Place gradient;
  deep->EvaluateGradient(Place{ 5, 2, 3 }.data(), gradient.data());
  EXPECT_EQ(gradient, X);
  deep->Initialize();
  EXPECT_EQ(deep->GetNumberOfFaces(), 0);
  double bounds[6];
  deep->GetBounds(bounds);
  EXPECT_GT(bounds[0], bounds[1]);
}

/// Lines through these points, one after the other; closed if told so.
vtkSmartPointer<vtkPolyData> Lines(
  const std::vector<std::vector<glm::dvec3>>& lines, bool closed = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(line.size()) + closed);
    for (const glm::dvec3& p : line)
      cells->InsertCellPoint(points->InsertNextPoint(&p.x));
    if (closed)
      cells->InsertCellPoint(first);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

TEST(SolidSweep, ATubeFollowsItsLines)
{
  vtkNew<vtkHaspSolidSweep> sweep;
  sweep->SetRadius(0.5);
  const std::vector<glm::dvec3> corner = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 } };
  sweep->SetInputData(Lines({ corner, { { 0, 0, 9 }, { 1, 0, 9 } } }));
  EXPECT_NEAR(At(sweep, { 2, 2, 0 }), 1.5, 1e-12);
  EXPECT_NEAR(At(sweep, { 0.5, 0, 8 }), 0.5, 1e-12);
  sweep->SetInputData(Lines({ corner }, true));
  EXPECT_NEAR(At(sweep, { 2, 2, 0 }), -0.5, 1e-12);
  sweep->SetRadius(-1.0);
  EXPECT_NE(ErrorsOfUpdate(sweep), "");
  EXPECT_EQ(sweep->GetOutput()->GetSolid(), nullptr);
  sweep->SetRadius(1.0);
  vtkNew<vtkPolyData> none;
  sweep->SetInputData(none);
  EXPECT_NE(ErrorsOfUpdate(sweep).find("no lines"), std::string::npos);
}

TEST(SolidSweep, ABandLiesOnItsSurface)
{
  const hasp::GridGeometry grid{ glm::ivec3(41), glm::dvec3(-20), glm::dvec3(1), glm::dmat3(1) };
  const auto ball = hasp::AnalyticSphere(glm::dvec3(0), 15.0);
  vtkNew<vtkHaspSolidSource> exact;
  ASSERT_TRUE(exact->SetToCapsule(O.data(), O.data(), 15.0));
  std::vector<glm::dvec3> path;
  for (double a = -0.5; a < 0.51; a += 0.05)
    path.emplace_back(15.0 * std::sin(a), 0.0, 15.0 * std::cos(a));
  vtkNew<vtkHaspSolidSweep> band;
  band->SetInputData(Lines({ path }));
  band->SetWidth(4.0);
  band->SetRange(0.2, 1.2);
  for (const bool sampled : { false, true })
  {
    if (sampled) // the same as an image of signed distances
      band->SetSurfaceData(
        hasp::MakeImage(grid, hasp::SampleAnalytic<float>(ball, grid, -1.0, 0.0)));
    else
      band->SetSurfaceConnection(exact->GetOutputPort());
    EXPECT_EQ(ErrorsOfUpdate(band), "") << sampled;
    const double tolerance = sampled ? 0.02 : 1e-9;
    EXPECT_NEAR(At(band, { 0, 0, 15.7 }), -0.5, tolerance) << sampled;
    EXPECT_NEAR(At(band, { 0, 0, 16.5 }), 0.3, tolerance) << sampled;
    EXPECT_NEAR(At(band, { 0, 0, 15.0 }), 0.2, tolerance) << sampled;
    EXPECT_NEAR(At(band, { 0, 2.5, 15.7 }), 0.5, 0.03) << sampled;
  }
  band->SetInputData(Lines({ { { 0, 0, 20 }, { 0, 1, 20 } } }));
  EXPECT_NE(ErrorsOfUpdate(band), "") << "it is off the surface";
}

} // namespace
