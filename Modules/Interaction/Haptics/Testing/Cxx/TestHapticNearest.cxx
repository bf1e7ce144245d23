// How far a hand is from what it could take: volumes of any spacing, props that are turned.
#include "HapticProps.h"
#include "HapticRenderScene.h"

#include <glm/gtc/quaternion.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double Radius = 5.0;
constexpr double SpacingMm[] = { 0.8, 0.5, 1.7 };
const glm::dvec3 Middle(12.0, -4.0, 7.0); // of the ball, in the image's coordinates

/// A ball beside the middle of a volume, whose samples lie apart otherwise along each of three skew
/// axes.
vtkSmartPointer<vtkActor> SkewBallActor()
{
  const glm::ivec3 dims(19, 29, 11);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dims.x, dims.y, dims.z);
  image->SetSpacing(SpacingMm);
  const glm::dmat3 axes =
    glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1.0, -2.0, 0.5))));
  const glm::dvec3 half =
    0.5 * glm::dvec3(dims - 1) * glm::dvec3(SpacingMm[0], SpacingMm[1], SpacingMm[2]);
  const glm::dvec3 origin = Middle - axes * (half + glm::dvec3(1.2, -1.2, 2.0));
  image->SetOrigin(origin.x, origin.y, origin.z);
  double rows[9];
  for (int n = 0; n < 9; ++n)
    rows[n] = axes[n % 3][n / 3];
  image->SetDirectionMatrix(rows);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    glm::dvec3 p;
    image->GetPoint(n, &p.x);
    values->InsertNextValue(static_cast<float>(-glm::length(p - Middle)));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIsoValue(-Radius);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(30, 2, -9);
  actor->RotateWXYZ(70.0, 0.3, 1.0, -0.7);
  return actor;
}

/// The least reach within which a tool is.
double DistanceOf(const HapticProps& props, const glm::dvec3& point)
{
  double out = 0.0, in = 100.0;
  EXPECT_GE(props.Nearest(point, in), 0);
  while (in - out > 1e-6)
  {
    const double reach = 0.5 * (in + out);
    (props.Nearest(point, reach) >= 0 ? in : out) = reach;
  }
  return in;
}

class Nearest : public ::testing::TestWithParam<bool>
{
};

// Closed form: a ball's distance. A dynamic shell's is that of the cells which its surface crosses,
// a static one's that of its points.
TEST_P(Nearest, IsInMillimetresOfTheWorld)
{
  HapticProps props;
  props.dynamicShells = this->GetParam();
  const auto ground = BallActor(4.0), ball = SkewBallActor();
  props.AddTouchable(ground);
  props.AddTool({ ball });
  std::vector<std::string> faults;
  do
    props.Update(faults);
  while (!props.Complete());
  ASSERT_TRUE(faults.empty()) << faults[0];
  const double cell = glm::length(glm::dvec3(SpacingMm[0], SpacingMm[1], SpacingMm[2]));
  const glm::dvec3 middle = Pose(ball).Place(Middle);
  for (const glm::dvec3& way : { glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
         glm::dvec3(-1, -1, 1), glm::dvec3(2, -1, -2), glm::dvec3(-1, 3, 0) })
    for (const double far : { 1.0, 4.0, 9.0, 30.0 }) // from the middle
    {
      const double truth = std::abs(far - Radius);
      const double seen = DistanceOf(props, middle + far * glm::normalize(way));
      EXPECT_LE(seen, truth + (this->GetParam() ? 1e-6 : 0.3)) << far;
      EXPECT_GE(seen, truth - (this->GetParam() ? cell : 0.2)) << far;
    }
}

INSTANTIATE_TEST_SUITE_P(Dynamic, Nearest, ::testing::Bool());

} // namespace
