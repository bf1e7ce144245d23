#include "ImageSteps.h"

#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiThreader.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

const glm::dvec3 Spacing(0.8, 1.0, 2.0);

hasp::GridGeometry Grid(const glm::ivec3& dims)
{
  hasp::GridGeometry grid;
  grid.dims = dims;
  grid.spacing = Spacing;
  return grid;
}

/// An image of value(index).
template <typename T, typename Value>
vtkSmartPointer<vtkImageData> Image(const glm::ivec3& dims, const Value& value)
{
  std::vector<T> samples;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        samples.push_back(static_cast<T>(value(glm::ivec3(i, j, k))));
  return hasp::MakeImage(Grid(dims), samples);
}

float At(vtkImageData* image, const glm::ivec3& index)
{
  return image->GetScalarComponentAsFloat(index.x, index.y, index.z, 0);
}

TEST(ImageSteps, AGaussianOfAPointIsAsWideAsToldInMmAlongEachAxis)
{
  const glm::ivec3 dims(41, 33, 21), middle(20, 16, 10);
  const auto point =
    Image<std::int16_t>(dims, [&](const glm::ivec3& at) { return at == middle ? 10000 : 0; });
  for (const double sigmaMm : { 1.5, 2.5 })
  {
    const auto out = hasp::ApplyStep(point, hasp::GaussianStep{ sigmaMm });
    ASSERT_EQ(out->GetScalarType(), VTK_FLOAT);
    double sum = 0.0;
    glm::dvec3 squares(0.0);
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i)
        {
          const double v = At(out, { i, j, k });
          const glm::dvec3 off = glm::dvec3(glm::ivec3(i, j, k) - middle) * Spacing;
          sum += v;
          squares += v * off * off;
        }
    EXPECT_NEAR(sum, 10000.0, 0.1);
    for (int a = 0; a < 3; ++a) // what is cut off at 4 deviations, and sums of few samples: 1 %
      EXPECT_NEAR(std::sqrt(squares[a] / sum), sigmaMm, 0.01 * sigmaMm) << a;
    // The whole shape, at the density's peak and one voxel off.
    const double peak = 10000.0 * Spacing.x * Spacing.y * Spacing.z /
                        std::pow(2.0 * 3.14159265358979 * sigmaMm * sigmaMm, 1.5);
    EXPECT_NEAR(At(out, middle) / peak, 1.0, 0.02);
    EXPECT_NEAR(At(out, middle + glm::ivec3(0, 2, 0)) / At(out, middle),
      std::exp(-0.5 * 4.0 / (sigmaMm * sigmaMm)), 1e-3);
  }
}

TEST(ImageSteps, AConstantStaysUpToTheBorder)
{
  const auto constant = Image<std::int16_t>({ 9, 8, 7 }, [](const glm::ivec3&) { return -750; });
  for (const auto& out : { hasp::ApplyStep(constant, hasp::GaussianStep{ 3.0 }),
         hasp::ApplyStep(constant, hasp::MedianStep{ 2.0 }),
         hasp::ApplyStep(constant, hasp::EdgePreservingStep{}),
         hasp::ApplyStep(constant, hasp::ConeBeamStep{ .insideAbove = -1000.0 }) })
    for (vtkIdType p = 0; p < out->GetNumberOfPoints(); ++p)
      ASSERT_NEAR(out->GetPointData()->GetScalars()->GetComponent(p, 0), -750.0, 1e-3) << p;
}

TEST(ImageSteps, AMedianTakesASpikeAndKeepsAPlane)
{
  const glm::ivec3 dims(15, 14, 13), spike(7, 7, 6);
  const auto plane = [](const glm::ivec3& at) { return 3 * at.x - 2 * at.y + 5 * at.z; };
  const auto image = Image<std::int16_t>(
    dims, [&](const glm::ivec3& at) { return at == spike ? 30000 : plane(at); });
  const auto out = hasp::ApplyStep(image, hasp::MedianStep{ 1.0 }); // 3 x 3 x 3: a voxel of 2 mm
  for (int k = 1; k < 12; ++k)
    for (int j = 1; j < 13; ++j)
      for (int i = 1; i < 14; ++i)
      {
        // Where the spike is among the 27, the median moves on by one in their order.
        const glm::ivec3 off = glm::abs(glm::ivec3(i, j, k) - spike);
        const bool near = std::max({ off.x, off.y, off.z }) <= 1;
        ASSERT_NEAR(At(out, { i, j, k }), plane({ i, j, k }), near ? 2.0 : 0.0)
          << i << " " << j << " " << k;
      }
}

TEST(ImageSteps, AStepStaysInPlaceAndNoiseGoesBesideIt)
{
  const glm::ivec3 dims(24, 20, 12);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 20.0);
  const auto image = Image<std::int16_t>(dims,
    [&](const glm::ivec3& at) { return std::lround((at.x < 12 ? 0 : 1000) + noise(random)); });
  const auto out = hasp::ApplyStep(image, hasp::EdgePreservingStep{ 150.0, 4 });
  double squares = 0.0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
      {
        const double off = At(out, { i, j, k }) - (i < 12 ? 0.0 : 1000.0);
        ASSERT_LT(std::abs(off), 100.0) << i; // the step is where it was, in one voxel
        squares += off * off;
      }
  const double left = std::sqrt(squares / (dims.x * dims.y * dims.z));
  EXPECT_LT(left, 8.0);
  // With an edge above the step, it is no edge.
  const auto blurred = hasp::ApplyStep(image, hasp::EdgePreservingStep{ 2000.0, 4 });
  EXPECT_GT(At(blurred, { 11, 10, 6 }), 150.0);
}

TEST(ImageSteps, NeighboursFartherOffCountLess)
{
  const glm::ivec3 middle(4, 4, 4);
  const auto point =
    Image<float>(glm::ivec3(9), [&](const glm::ivec3& at) { return at == middle ? 1000 : 0; });
  const auto out = hasp::ApplyStep(point, hasp::EdgePreservingStep{ 2000.0, 1 });
  const float x = At(out, middle + glm::ivec3(1, 0, 0)), y = At(out, middle + glm::ivec3(0, 1, 0)),
              z = At(out, middle + glm::ivec3(0, 0, 1));
  EXPECT_GT(z, 0.0F);
  EXPECT_NEAR(x / z, Spacing.z / Spacing.x, 1e-3); // 0.8, 1 and 2 mm away
  EXPECT_NEAR(y / z, Spacing.z / Spacing.y, 1e-3);
}

TEST(ImageSteps, GridAndInputStayForEachKindOfStep)
{
  const auto make = [](auto sample)
  {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> any(0, 200);
    const auto image = Image<decltype(sample)>(
      { 12, 11, 10 }, [&](const glm::ivec3& at) { return (at.x > 3 ? 30 : 0) + any(random) / 4; });
    image->SetExtent(5, 16, -3, 7, 100, 109);
    image->SetOrigin(10.0, 20.0, -30.0);
    const double c = std::cos(0.4), s = std::sin(0.4);
    image->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, -1); // a mirror, too
    image->GetPointData()->GetScalars()->SetName("Grey");
    return image;
  };
  const auto check = [](const vtkSmartPointer<vtkImageData>& image)
  {
    vtkNew<vtkImageData> before;
    before->DeepCopy(image);
    const auto same = [&](vtkImageData* out)
    {
      EXPECT_EQ(0, std::memcmp(out->GetExtent(), before->GetExtent(), 6 * sizeof(int)));
      for (const vtkIdType p : { vtkIdType(0), vtkIdType(700), before->GetNumberOfPoints() - 1 })
        for (int a = 0; a < 3; ++a)
          EXPECT_EQ(out->GetPoint(p)[a], before->GetPoint(p)[a]);
      for (int e = 0; e < 9; ++e)
        EXPECT_EQ(
          out->GetDirectionMatrix()->GetData()[e], before->GetDirectionMatrix()->GetData()[e]);
      EXPECT_EQ(out->GetScalarType(), VTK_FLOAT);
      EXPECT_STREQ(out->GetPointData()->GetScalars()->GetName(), "Grey");
      EXPECT_NE(out->GetScalarPointer(), image->GetScalarPointer());
      EXPECT_EQ(0, std::memcmp(image->GetScalarPointer(), before->GetScalarPointer(),
                     before->GetNumberOfPoints() * before->GetScalarSize()));
      EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1);
    };
    same(hasp::ApplyStep(image, hasp::GaussianStep{ 1.0 }));
    same(hasp::ApplyStep(image, hasp::MedianStep{ 1.0 }));
    same(hasp::ApplyStep(image, hasp::EdgePreservingStep{ 10.0, 2 }));
    same(hasp::ApplyStep(image, hasp::ConeBeamStep{ .insideAbove = 20.0 }));
  };
  check(make(std::int16_t()));
  check(make(std::uint16_t()));
  check(make(std::uint8_t()));
  check(make(float()));
}

// Directions do not matter to what is computed: the same samples come out as of an upright image.
TEST(ImageSteps, ATurnedImageGivesTheSamplesOfAnUprightOne)
{
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 100.0F);
  const auto image = Image<float>({ 12, 11, 10 }, [&](const glm::ivec3&) { return noise(random); });
  vtkNew<vtkImageData> turned;
  turned->DeepCopy(image);
  turned->SetExtent(-7, 4, 2, 12, -20, -11);
  turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, -1);
  const auto same = [&](const auto& step)
  {
    const auto a = hasp::ApplyStep(image, step), b = hasp::ApplyStep(turned, step);
    EXPECT_EQ(0, std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), 1320 * sizeof(float)));
  };
  same(hasp::GaussianStep{ 1.0 });
  same(hasp::MedianStep{ 1.0 });
  same(hasp::EdgePreservingStep{ 50.0, 3 });
  same(hasp::ConeBeamStep{});
}

TEST(ImageSteps, AnyNumberOfThreadsGivesTheSameBytes)
{
  std::mt19937 random(4);
  std::normal_distribution<float> noise(0.0F, 100.0F);
  const auto image = Image<float>({ 22, 21, 20 }, [&](const glm::ivec3&) { return noise(random); });
  const int usual = vtkMultiThreader::GetGlobalDefaultNumberOfThreads();
  const auto same = [&](const auto& step)
  {
    vtkMultiThreader::SetGlobalDefaultNumberOfThreads(1);
    const auto one = hasp::ApplyStep(image, step);
    vtkMultiThreader::SetGlobalDefaultNumberOfThreads(5);
    const auto five = hasp::ApplyStep(image, step);
    EXPECT_EQ(
      0, std::memcmp(one->GetScalarPointer(), five->GetScalarPointer(), 9240 * sizeof(float)));
  };
  same(hasp::GaussianStep{ 1.0 });
  same(hasp::MedianStep{ 1.0 });
  same(hasp::EdgePreservingStep{ 50.0, 3 });
  vtkMultiThreader::SetGlobalDefaultNumberOfThreads(usual);
}

TEST(ImageSteps, ThinImagesPass)
{
  for (const glm::ivec3 dims : { glm::ivec3(1), glm::ivec3(9, 8, 1), glm::ivec3(1, 1, 5) })
  {
    const auto image =
      Image<std::int16_t>(dims, [](const glm::ivec3& at) { return 10 * at.x + 1; });
    for (const auto& out : { hasp::ApplyStep(image, hasp::GaussianStep{ 2.0 }),
           hasp::ApplyStep(image, hasp::MedianStep{ 1.0 }),
           hasp::ApplyStep(image, hasp::EdgePreservingStep{}),
           hasp::ApplyStep(image, hasp::ConeBeamStep{}) })
      for (vtkIdType p = 0; p < out->GetNumberOfPoints(); ++p)
      {
        const double value = out->GetPointData()->GetScalars()->GetComponent(p, 0);
        EXPECT_TRUE(value >= 1.0 - 1e-3 && value <= 10.0 * dims.x) << value;
      }
  }
}

template <typename Step>
std::string Refusal(vtkImageData* image, const Step& step)
{
  try
  {
    hasp::ApplyStep(image, step);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(ImageSteps, ATooLargeMedianSaysTheLargestThatWillDo)
{
  const auto image = Image<std::int16_t>({ 18, 18, 18 }, [](const glm::ivec3& at) { return at.x; });
  const std::string said = Refusal(image, hasp::MedianStep{ 10.0 });
  const std::size_t at = said.find("take ");
  ASSERT_NE(at, std::string::npos) << said;
  const double largest = std::stod(said.substr(at + 5));
  EXPECT_EQ(Refusal(image, hasp::MedianStep{ largest }), "");
  EXPECT_NE(Refusal(image, hasp::MedianStep{ largest + 2e-3 }).find("4096"), std::string::npos);
}

TEST(ImageSteps, NonsenseIsRefused)
{
  const auto image = Image<std::int16_t>({ 40, 40, 40 }, [](const glm::ivec3& at) { return at.x; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { 0.0, -1.0, 10.5, nan })
  {
    EXPECT_NE(Refusal(image, hasp::GaussianStep{ bad }).find("sigmaMm is"), std::string::npos);
    EXPECT_NE(Refusal(image, hasp::MedianStep{ bad }).find("radiusMm is"), std::string::npos);
  }
  EXPECT_NE(Refusal(image, hasp::MedianStep{ 10.0 }).find("4096"), std::string::npos);
  EXPECT_NE(Refusal(image, hasp::EdgePreservingStep{ nan, 4 }).find("edge is"), std::string::npos);
  for (const int bad : { 0, 101 })
    EXPECT_NE(
      Refusal(image, hasp::EdgePreservingStep{ 10.0, bad }).find("[1, 100]"), std::string::npos);
  EXPECT_NE(
    Refusal(image, hasp::ConeBeamStep{ .fieldMm = 9.0 }).find("fieldMm"), std::string::npos);
  EXPECT_NE(Refusal(image, hasp::ConeBeamStep{ .insideAbove = 100.0 }).find("insideAbove"),
    std::string::npos);
  vtkNew<vtkImageData> empty;
  EXPECT_NE(Refusal(empty, hasp::GaussianStep{}), "");
  EXPECT_NE(Refusal(nullptr, hasp::GaussianStep{}), "");
}

TEST(ImageSteps, CancelEndsAndProgressGrowsToOne)
{
  const auto image = Image<std::int16_t>({ 40, 30, 20 }, [](const glm::ivec3& at) { return at.x; });
  const auto check = [&](const auto& step)
  {
    double last = 0.0;
    int calls = 0;
    hasp::ApplyStep(image, step,
      [&](double share)
      {
        EXPECT_GE(share, last);
        last = share;
        ++calls;
        return true;
      });
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls, 3);
    int asked = 0; // not at once: while VTK's filter runs
    EXPECT_THROW(
      hasp::ApplyStep(image, step, [&](double) { return ++asked < 3; }), hasp::Cancelled);
    EXPECT_EQ(asked, 3);
    const auto thrown = [](double share) -> bool
    { return share > 0.0 ? throw std::domain_error("theirs") : true; };
    EXPECT_THROW(hasp::ApplyStep(image, step, thrown), std::domain_error);
  };
  check(hasp::GaussianStep{ 2.0 });
  check(hasp::MedianStep{ 1.0 });
  check(hasp::EdgePreservingStep{});
  check(hasp::ConeBeamStep{});
}

} // namespace
