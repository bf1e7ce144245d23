// Blended normals against closed form: where trilinear ones have facets they are better, and they
// do not jump between cells.
#include "AttributeTestScene.h"

#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace
{

using hasp::testing::AttributeScene;
using hasp::testing::BytesOf;
using hasp::testing::CellTestScene;
using hasp::testing::ObliqueGrid;

class CellBlending : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// Normals are read from the picture: diffuse light from one axis after the other and its opposite.
struct NormalScene : CellTestScene
{
  std::array<vtkNew<vtkLight>, 6> Lights;
  vtkNew<vtkUnsignedCharArray> Picture;

  NormalScene(int size = 110) : CellTestScene(size, size)
  {
    this->Renderer->RemoveAllLights();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0, 0, 0);
    this->Actor->GetProperty()->SetAmbient(0);
    this->Actor->GetProperty()->SetDiffuse(1);
    this->Actor->GetProperty()->SetColor(1, 1, 1);
    // Each channel shows one component of the normal: in one picture where it is positive, in
    // another where it is negative.
    for (int n = 0; n < 6; ++n)
    {
      const int axis = n % 3;
      const double sign = n < 3 ? 1 : -1;
      this->Lights[n]->SetLightTypeToSceneLight();
      this->Lights[n]->SetPositional(false);
      this->Lights[n]->SetColor(axis == 0, axis == 1, axis == 2);
      this->Lights[n]->SetPosition(sign * (axis == 0), sign * (axis == 1), sign * (axis == 2));
      this->Lights[n]->SetFocalPoint(0, 0, 0);
      this->Renderer->AddLight(this->Lights[n]);
    }
  }

  /// Unit normals of all pixels, world directions; 0 at the background. 8 bits a component: each is
  /// right within 0.002, an angle within 0.2 degrees.
  std::vector<glm::dvec3> Normals()
  {
    const int* size = this->Window->GetSize();
    std::vector<glm::dvec3> normals(size[0] * size[1], glm::dvec3(0));
    for (int half = 0; half < 2; ++half)
    {
      for (int n = 0; n < 6; ++n)
        this->Lights[n]->SetSwitch(n / 3 == half);
      this->Draw();
      this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, this->Picture);
      for (std::size_t p = 0; p < normals.size(); ++p)
        for (int a = 0; a < 3; ++a)
          normals[p][a] += (half == 0 ? 1 : -1) * this->Picture->GetValue(3 * p + a) / 255.0;
    }
    for (std::size_t p = 0; p < normals.size(); ++p)
      normals[p] = this->Point(int(p) % size[0], int(p) / size[0]) ? glm::normalize(normals[p])
                                                                   : glm::dvec3(0);
    return normals;
  }
};

struct Errors
{
  double mean = 0.0; ///< angle to closed form, degrees
  double jump = 0.0; ///< mean angle between neighbouring pixels beyond that of closed form, degrees
};

double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::degrees(std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
}

Errors Measure(NormalScene& s, const hasp::AnalyticVolume& shape)
{
  const auto normals = s.Normals();
  const int width = s.Window->GetSize()[0];
  const auto truth = [&](std::size_t p) -> glm::dvec3
  {
    const glm::dvec3 at = *s.Point(int(p) % width, int(p) / width);
    glm::dvec3 slope;
    for (int a = 0; a < 3; ++a)
    {
      glm::dvec3 step(0);
      step[a] = 1e-4;
      slope[a] = shape.value(at + step) - shape.value(at - step);
    }
    return glm::normalize(slope);
  };
  Errors errors;
  int count = 0, pairs = 0;
  for (std::size_t p = 0; p + 1 < normals.size(); ++p)
  {
    if (normals[p] == glm::dvec3(0))
      continue;
    const glm::dvec3 right = truth(p);
    const double side = glm::dot(right, normals[p]) < 0 ? -1 : 1; // seen from inside
    errors.mean += Degrees(normals[p], side * right);
    ++count;
    if (normals[p + 1] == glm::dvec3(0) || int(p + 1) % width == 0)
      continue;
    const double turn = Degrees(normals[p], normals[p + 1]), owed = Degrees(right, truth(p + 1));
    if (owed > 5.0) // another part of the surface
      continue;
    errors.jump += std::max(0.0, turn - owed);
    ++pairs;
  }
  EXPECT_GT(count, 2000);
  errors.mean /= count;
  errors.jump /= pairs;
  return errors;
}

/// The shape in 8 bits of `steps` grey levels a mm, with uniform noise of +-noise levels.
vtkSmartPointer<vtkImageData> Coarse(
  const hasp::AnalyticVolume& shape, const hasp::GridGeometry& g, double steps, double noise)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  const auto exact = hasp::SampleAnalytic<float>(shape, g, 1, 0);
  std::vector<std::uint8_t> samples;
  for (const float value : exact)
    samples.push_back(static_cast<std::uint8_t>(
      std::clamp(std::round(128 + steps * value + uniform(random)), 0.0, 255.0)));
  return hasp::MakeImage(g, samples);
}

/// Without and with blending.
std::pair<Errors, Errors> Compare(
  const std::string& name, vtkImageData* image, double isovalue, const hasp::AnalyticVolume& shape)
{
  NormalScene s;
  s.Mapper->SetInputData(image);
  s.Mapper->SetIsoValue(isovalue);
  s.Look({ 30, -80, 25 }, { 0, 0, 0 }, 40, 130);
  s.Renderer->GetActiveCamera()->SetViewAngle(20);
  const Errors plain = Measure(s, shape);
  s.Mapper->BlendNormalsOn();
  const Errors blended = Measure(s, shape);
  std::cout << name << ": mean error " << plain.mean << " -> " << blended.mean << " degrees, jumps "
            << plain.jump << " -> " << blended.jump << "\n";
  return { plain, blended };
}

TEST_F(CellBlending, HalvesTheErrorOfNormalsWhereFacetsShow)
{
  const hasp::GridGeometry g = ObliqueGrid(36, { 1.0, 1.0, 1.0 });
  const hasp::AnalyticVolume ball = hasp::AnalyticSphere({ 0, 0, 0 }, 13);
  const hasp::AnalyticVolume torus = hasp::AnalyticTorus({ 0, 0, 0 }, { 0.3, -1, 0.2 }, 10, 4);
  struct Case
  {
    const char* name;
    const hasp::AnalyticVolume& shape;
    double steps, noise;
  };
  // Grey levels a mm: 4 is coarse, with facets; 20 with noise of 2 is a scanner's.
  for (const Case& c :
    { Case{ "sphere, 4 levels a mm", ball, 4, 0 }, Case{ "torus, 4 levels a mm", torus, 4, 0 },
      Case{ "sphere, noise", ball, 20, 2 }, Case{ "torus, noise", torus, 20, 2 } })
  {
    const auto [plain, blended] =
      Compare(c.name, Coarse(c.shape, g, c.steps, c.noise), 128, c.shape);
    EXPECT_LE(blended.mean, 0.5 * plain.mean) << c.name;
    EXPECT_LE(blended.jump, 0.5 * plain.jump) << c.name;
  }
}

// Exact samples: the trilinear gradient is good already. Blending must not spoil it: still fewer
// jumps.
TEST_F(CellBlending, DoesNotSpoilNormalsOfExactSamples)
{
  const hasp::GridGeometry g = ObliqueGrid(36, { 1.0, 1.0, 1.0 });
  const hasp::AnalyticVolume ball = hasp::AnalyticSphere({ 0, 0, 0 }, 13);
  const hasp::AnalyticVolume torus = hasp::AnalyticTorus({ 0, 0, 0 }, { 0.3, -1, 0.2 }, 10, 4);
  for (const auto* shape : { &ball, &torus })
  {
    const auto [plain, blended] = Compare("exact " + shape->name,
      hasp::MakeImage(g, hasp::SampleAnalytic<float>(*shape, g, 1, 0)), 0, *shape);
    EXPECT_LE(blended.mean, 0.5 * plain.mean);
    EXPECT_LE(blended.jump, 0.5 * plain.jump);
  }
}

TEST_F(CellBlending, LeavesDepthAsItWasAndCostsNothingWhileOff)
{
  AttributeScene s;
  s.Actor->GetProperty()->LightingOn();
  s.Draw();
  std::vector<double> before;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 120; ++x)
      before.push_back(s.Point(x, y) ? s.Point(x, y)->y : 1e9);
  EXPECT_EQ(BytesOf(s, "normal blending"), 0U);
  s.Mapper->BlendNormalsOn();
  s.Draw();
  EXPECT_EQ(BytesOf(s, "normal blending"), 120U * 100U * 24U);
  std::size_t n = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 120; ++x, ++n)
      // 24 bits of depth through a float texture: half a step each, 0.003 mm at 115 mm.
      ASSERT_NEAR(s.Point(x, y) ? s.Point(x, y)->y : 1e9, before[n], 0.006) << x << " " << y;
  s.Mapper->BlendNormalsOff();
  s.Draw();
  EXPECT_EQ(BytesOf(s, "normal blending"), 0U);
}

TEST_F(CellBlending, BlendsColoursAndKeepsLabelsThatMoveApart)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelColor(1, 1, 0, 0);
  s.Mapper->SetLabelColor(2, 0, 0, 1);
  s.Mapper->BlendNormalsOn();
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (std::array<int, 3>{ 255, 0, 0 }));
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (std::array<int, 3>{ 0, 0, 255 }));
  const auto middle = s.ColorAt({ -0.5, -15, 0.3 }); // between two cells of different labels
  EXPECT_GT(middle[0], 0);
  EXPECT_GT(middle[2], 0);
  EXPECT_NEAR(middle[0] + middle[2], 255, 2);
  vtkNew<vtkTransform> still; // a pose of its own, and in the same place: no blending across
  s.Mapper->SetLabelPose(2, still);
  for (double x = -3; x < 3; x += 0.25)
  {
    const auto color = s.ColorAt({ x, -std::sqrt(225 - x * x), 0.3 });
    EXPECT_TRUE(color[0] == 255 || color[2] == 255) << x;
    EXPECT_EQ(color[0] + color[2], 255) << x;
  }
}

TEST_F(CellBlending, HonoursClippingPlanesOtherActorsAndViewports)
{
  AttributeScene s;
  s.Actor->GetProperty()->SetColor(0, 1, 0);
  s.Mapper->BlendNormalsOn();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1, 0, 0);
  s.Mapper->AddClippingPlane(plane);
  s.Renderer->SetViewport(0.5, 0, 1, 1);
  s.Window->SetSize(240, 100);
  vtkNew<vtkActor> before;
  auto mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
  const hasp::GridGeometry small{ { 9, 9, 9 }, { 6, -24, -4 }, { 1, 1, 1 }, glm::dmat3(1) };
  mapper->SetInputData(hasp::MakeImage(small,
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 10, -20, 0 }, 3), small, 100, 0)));
  mapper->SetIsoValue(0);
  before->SetMapper(mapper);
  before->GetProperty()->SetColor(1, 0, 0);
  before->GetProperty()->LightingOff();
  before->GetProperty()->SetAmbient(0);
  s.Renderer->AddActor(before);
  EXPECT_EQ(s.ColorAt({ 4, -14.4, 0 }), (std::array<int, 3>{ 0, 255, 0 }));
  EXPECT_EQ(s.ColorAt({ 10, -23, 0 }), (std::array<int, 3>{ 255, 0, 0 }));
  EXPECT_EQ(s.ColorAt({ -14, 0, 0.0 }), (std::array<int, 3>{ 0, 0, 0 })) << "clipped away";
}

TEST_F(CellBlending, TranslucentSurfacesAreDrawnAsWithout)
{
  AttributeScene s;
  s.Actor->GetProperty()->SetOpacity(0.5);
  const auto without = s.ColorAt({ 0, -15, 0 });
  s.Mapper->BlendNormalsOn();
  EXPECT_EQ(s.ColorAt({ 0, -15, 0 }), without);
  EXPECT_EQ(BytesOf(s, "normal blending"), 0U);
}

} // namespace
