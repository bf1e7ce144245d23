#include "vtkHaspSignedDistance.h"

#include "Distance/CoverageDistance.h"
#include "Distance/Testing/AnalyticCoverage.h"
#include "FilterErrors.h"
#include "vtkHaspCoverage.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{

const hasp::GridGeometry Grid{ glm::ivec3(44), glm::dvec3(-15.1, -14.7, -15.3), glm::dvec3(0.7),
  glm::dmat3(1) };
const hasp::AnalyticVolume Ball = hasp::AnalyticSphere(glm::dvec3(0), 9.0);

std::vector<float> SamplesOf(vtkImageData* image)
{
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  return { values, values + image->GetNumberOfPoints() };
}

/// RMS in voxels within three voxels of the ball.
double ErrorOf(vtkHaspSignedDistance* filter)
{
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  vtkImageData* out = filter->GetOutput();
  EXPECT_EQ(out->GetNumberOfPoints(), vtkIdType(Grid.Size()));
  return hasp::ErrorOf(SamplesOf(out), Ball, Grid, 2.1).rms;
}

TEST(SignedDistanceFilter, OfCoverageIsTrueBelowAVoxel)
{
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetInputData(hasp::MakeImage(Grid, hasp::AnalyticCoverage(Ball, Grid)));
  const double measured = ErrorOf(filter); // Automatic finds coverage
  EXPECT_LT(measured, 0.01);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "SignedDistance");
  filter->SetInputKindToCoverage();
  EXPECT_EQ(ErrorOf(filter), measured);
  filter->SetTransformToChamfer();
  const double chamfer = ErrorOf(filter);
  EXPECT_GT(chamfer, 5.0 * measured);
  filter->SetTransformToEuclidean();
  EXPECT_GT(ErrorOf(filter), chamfer);
}

TEST(SignedDistanceFilter, GreyValuesAreMeasuredAsTheyAre)
{
  // As wide as a scanner blurs: over three voxels, in [0,1], so that it might be coverage.
  const hasp::AnalyticVolume blurred{ "",
    [](const glm::dvec3& p) { return std::clamp(0.5 + Ball.value(p) / 2.1, 0.0, 1.0); }, 1 };
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetInputData(hasp::MakeImage(Grid, hasp::SampleAnalytic<float>(blurred, Grid, 1, 0)));
  EXPECT_LT(ErrorOf(filter), 0.02); // Automatic finds that it is none
  filter->SetInputKindToCoverage();
  EXPECT_NE(ErrorsOfUpdate(filter), "") << "coverage that is none is refused";
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputKindToGrey();
  filter->SetIsoValue(0.5);
  EXPECT_LT(ErrorOf(filter), 0.02);
  // Integers are not guessed at.
  filter->SetInputData(
    hasp::MakeImage(Grid, hasp::SampleAnalytic<std::int16_t>(blurred, Grid, 2000, -1000)));
  filter->SetIsoValue(0.0);
  EXPECT_LT(ErrorOf(filter), 0.02);
  filter->SetInputKindToAutomatic();
  EXPECT_NE(ErrorsOfUpdate(filter).find("SetInputKindToGrey"), std::string::npos);
  EXPECT_NE(filter->GetErrorCode(), 0UL);
  filter->SetInputData( // a scan in floats
    hasp::MakeImage(Grid, hasp::SampleAnalytic<float>(blurred, Grid, 2000, -1000)));
  EXPECT_NE(ErrorsOfUpdate(filter).find("SetInputKindToGrey"), std::string::npos);
  filter->SetInputKindToGrey();
  EXPECT_LT(ErrorOf(filter), 0.02);
  EXPECT_EQ(filter->GetErrorCode(), 0UL);
}

TEST(SignedDistanceFilter, LabelsAreAMask)
{
  const hasp::AnalyticVolume two{ "",
    [](const glm::dvec3& p) { return Ball.value(p) > 0 ? 5.0 : 2.0; }, 1 };
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetInputData(hasp::MakeImage(Grid, hasp::SampleAnalytic<std::uint8_t>(two, Grid, 1, 0)));
  filter->SetInputKindToLabels();
  filter->SetLabel(5);
  const double antiAliased = ErrorOf(filter);
  EXPECT_LT(antiAliased, 0.5);
  filter->SetTransformToEuclidean();
  EXPECT_LT(ErrorOf(filter), 0.5);
  filter->SetTransformToChamfer();
  EXPECT_LT(ErrorOf(filter), 0.5);
  const float inside = SamplesOf(filter->GetOutput())[22 * (1 + 44 + 44 * 44)];
  EXPECT_LT(inside, -7.5F); // of 9 mm, by <3,4,5>

  filter->SetLabel(2); // the other way round
  filter->Update();
  EXPECT_GT(SamplesOf(filter->GetOutput())[22 * (1 + 44 + 44 * 44)], 7.5F);
}

TEST(SignedDistanceFilter, ANarrowBandIsTheSameWithinFourVoxels)
{
  for (const int transform : { vtkHaspSignedDistance::AntiAliased, vtkHaspSignedDistance::Euclidean,
         vtkHaspSignedDistance::Chamfer })
  {
    vtkNew<vtkHaspSignedDistance> filter;
    filter->SetInputData(hasp::MakeImage(Grid, hasp::AnalyticCoverage(Ball, Grid)));
    filter->SetTransform(transform);
    filter->Update();
    const std::vector<float> all = SamplesOf(filter->GetOutput());
    filter->NarrowBandOn();
    filter->Update();
    const std::vector<float> band = SamplesOf(filter->GetOutput());
    ASSERT_EQ(band.size(), all.size());
    double worst = 0.0;
    for (std::size_t v = 0; v < all.size(); ++v)
      worst = std::max<double>(worst, std::abs(band[v] - std::clamp(all[v], -2.8F, 2.8F)));
    EXPECT_LT(worst, 0.02) << transform; // at its very end the band meets +-4 voxels
  }
}

/// The ball cut by the end of a scan that stops 3.15 mm off its middle.
TEST(SignedDistanceFilter, AMarginGivesRoomAndClosesWhatGoesOn)
{
  hasp::GridGeometry scan = Grid;
  scan.dims.x = 27;                                                        // -15.1 ... 3.1 mm
  const double end = scan.origin.x + (scan.dims.x - 0.5) * scan.spacing.x; // of its voxels
  const auto coverage = hasp::MakeImage(scan, hasp::AnalyticCoverage(Ball, scan));
  const auto grey = hasp::MakeImage(scan, hasp::SampleAnalytic<std::int16_t>(Ball, scan, 100, 50));
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetMargin(6.0);
  for (const bool isGrey : { false, true })
  {
    filter->SetInputData(isGrey ? grey : coverage);
    filter->SetInputKind(isGrey ? vtkHaspSignedDistance::Grey : vtkHaspSignedDistance::Coverage);
    filter->SetIsoValue(50.0);
    ASSERT_EQ(ErrorsOfUpdate(filter), "");
    const hasp::GridGeometry made = hasp::ImageGeometry(filter->GetOutput());
    const std::vector<float> distance = SamplesOf(filter->GetOutput());
    EXPECT_EQ(made.dims, scan.dims + 2 * 10); // 6 / 0.7, up, and one
    EXPECT_NEAR(glm::distance(made.IndexToWorld(glm::dvec3(10)), scan.origin), 0.0, 1e-12);
    int disc = 0;
    for (int k = 0; k < made.dims.z; ++k)
      for (int j = 0; j < made.dims.y; ++j)
        for (int i = 0; i < made.dims.x; ++i)
        {
          const glm::dvec3 p = made.IndexToWorld({ i, j, k });
          const float value = distance[(std::size_t(k) * made.dims.y + j) * made.dims.x + i];
          if (p.x > end && std::hypot(p.y, p.z) < 6.0) // of the disc's 8.3 mm
          {
            ++disc;
            EXPECT_NEAR(value, p.x - end, 0.02) << isGrey;
          }
          if (p.x < -4.0) // nearer to the ball than to the disc
          {
            EXPECT_NEAR(value, glm::length(p) - 9.0, 0.175) << isGrey; // far: a quarter of a voxel
          }
        }
    EXPECT_GT(disc, 1000);
  }
}

TEST(SignedDistanceFilter, AMarginIsForAllKindsAndTransforms)
{
  const hasp::AnalyticVolume block{ "", [](const glm::dvec3& p) { return p.x > 0.0 ? 1.0 : -1.0; },
    1 }; // to the scan's end
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetInputData(
    hasp::MakeImage(Grid, hasp::SampleAnalytic<std::uint8_t>(block, Grid, 1, 1)));
  filter->SetLabel(2);
  filter->SetIsoValue(1.5);
  filter->SetMargin(2.1);
  for (const int kind : { vtkHaspSignedDistance::Labels, vtkHaspSignedDistance::Grey })
    for (int transform = 0; transform < 3; ++transform)
    {
      filter->SetInputKind(kind);
      filter->SetTransform(transform);
      ASSERT_EQ(ErrorsOfUpdate(filter), "");
      const std::vector<float> distance = SamplesOf(filter->GetOutput());
      const int side = 44 + 2 * 4;
      ASSERT_EQ(distance.size(), std::size_t(side * side * side));
      const std::size_t last = (std::size_t(26) * side + 26) * side + side - 1; // of its x axis
      EXPECT_NEAR(distance[last], 3.5 * 0.7, 0.3) << kind << " " << transform;
      EXPECT_NEAR(distance[last - 6], -2.5 * 0.7, 0.3) << kind << " " << transform;
    }
  for (const double bad : { -1.0, std::nan(""), 1e300, 1e4 })
  {
    filter->SetMargin(bad);
    EXPECT_NE(ErrorsOfUpdate(filter).find("margin"), std::string::npos) << bad;
  }
}

TEST(SignedDistanceFilter, AnAbortGivesNothing)
{
  vtkNew<vtkHaspSignedDistance> filter;
  filter->SetInputData(hasp::MakeImage(Grid, hasp::AnalyticCoverage(Ball, Grid)));
  const AbortAtOnce abort(filter);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
