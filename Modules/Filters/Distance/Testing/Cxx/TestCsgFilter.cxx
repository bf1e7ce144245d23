#include "vtkHaspCsg.h"

#include "FilterErrors.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspSignedDistance.h"
#include "vtkHaspSolid.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

const double Origin[3] = { 0, 0, 0 };

/// Two balls of radius 2, at the origin and at x = 3, into one filter.
struct TwoBalls
{
  TwoBalls()
  {
    const double second[3] = { 3, 0, 0 };
    this->one->SetToCapsule(Origin, Origin, 2.0);
    this->other->SetToCapsule(second, second, 2.0);
    this->csg->AddInputConnection(this->one->GetOutputPort());
    this->csg->AddInputConnection(this->other->GetOutputPort());
  }
  double At(double x, double y = 0.0)
  {
    this->csg->Update();
    const double place[3] = { x, y, 0 };
    return this->csg->GetOutput()->EvaluateDistance(place);
  }
  vtkNew<vtkHaspSolidSource> one, other;
  vtkNew<vtkHaspCsg> csg;
};

TEST(CsgFilter, JoinsAsItIsTold)
{
  TwoBalls balls;
  EXPECT_NEAR(balls.At(6), 1.0, 1e-12);
  EXPECT_NEAR(balls.At(-3), 1.0, 1e-12);
  balls.csg->SetOperationToIntersection();
  EXPECT_NEAR(balls.At(-1), 2.0, 1e-12);
  EXPECT_NEAR(balls.At(1.5), -0.5, 1e-12);
  balls.csg->SetOperationToDifference();
  EXPECT_NEAR(balls.At(1.5), 0.5, 1e-12);
  EXPECT_NEAR(balls.At(-1), -1.0, 1e-12);
  balls.csg->SetOperationToSmoothUnion();
  balls.csg->SetRadius(0.8);
  EXPECT_NEAR(balls.At(1.5, std::sqrt(4 - 2.25)), -0.2, 1e-12); // on both: r / 4 more
  EXPECT_NEAR(balls.At(-3), 1.0, 1e-12);
  balls.csg->SetOperationToOffset();
  balls.csg->SetDistance(0.5);
  EXPECT_NEAR(balls.At(6), 0.5, 1e-12);
  balls.csg->SetOperationToShell();
  balls.csg->SetRange(-0.5, 0.25);
  EXPECT_NEAR(balls.At(-2), -0.25, 1e-12);
  EXPECT_NEAR(balls.At(-1), 0.5, 1e-12);
  balls.csg->SetOperationToUnion();
  EXPECT_NEAR(balls.At(-3), 1.0, 1e-12);
}

TEST(CsgFilter, ADifferenceOfOnePartIsThePart)
{
  TwoBalls balls;
  balls.csg->RemoveInputConnection(0, balls.other->GetOutputPort());
  balls.csg->SetOperationToDifference();
  balls.csg->Update();
  EXPECT_EQ(balls.csg->GetOutput()->GetSolid(), balls.one->GetOutput()->GetSolid());
}

TEST(CsgFilter, FollowsWhatIsUpstream)
{
  TwoBalls balls;
  EXPECT_NEAR(balls.At(6), 1.0, 1e-12);
  const auto before = balls.csg->GetOutput()->GetSolid();
  EXPECT_NEAR(balls.At(6), 1.0, 1e-12);
  EXPECT_EQ(balls.csg->GetOutput()->GetSolid(), before) << "nothing has changed";
  const double place[3] = { 4, 0, 0 };
  balls.other->SetToCapsule(place, place, 1.5);
  EXPECT_NEAR(balls.At(6), 0.5, 1e-12);
}

/// Signed distances of a ball, as vtkHaspSignedDistance gives.
vtkSmartPointer<vtkImageData> BallImage()
{
  const hasp::GridGeometry grid{ glm::ivec3(25), glm::dvec3(-6), glm::dvec3(0.5), glm::dmat3(1) };
  return hasp::MakeImage(
    grid, hasp::SampleAnalytic<float>(hasp::AnalyticSphere(glm::dvec3(0), 4.0), grid, -1.0, 0.0));
}

TEST(CsgFilter, AnImageOfDistancesIsAPartAndReadOnce)
{
  const auto image = BallImage();
  vtkNew<vtkHaspSolidSource> slab;
  const double up[3] = { 0, 0, 1 };
  slab->SetToSlab(Origin, up, 1.0);
  vtkNew<vtkHaspCsg> cut;
  cut->SetOperationToDifference();
  cut->AddInputData(image);
  cut->AddInputConnection(slab->GetOutputPort());
  const auto at = [&](double x, double z)
  {
    cut->Update();
    const double place[3] = { x, 0, z };
    return cut->GetOutput()->EvaluateDistance(place);
  };
  EXPECT_NEAR(at(0, 0), 0.5, 1e-6);
  EXPECT_NEAR(at(5, 2), std::sqrt(29.0) - 4.0, 0.02);
  // Samples that change unsaid are not seen: the image is not read again for another saw.
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
    values[v] += 1.0F;
  slab->SetToSlab(Origin, up, 2.0);
  EXPECT_NEAR(at(5, 2), std::sqrt(29.0) - 4.0, 0.02);
  EXPECT_NEAR(at(0, 0), 1.0, 1e-6);
  image->Modified();
  EXPECT_NEAR(at(5, 2), std::sqrt(29.0) - 3.0, 0.02);
}

TEST(CsgFilter, AnOffsetBeyondTheBorderIsWarnedOf)
{
  vtkNew<vtkHaspCsg> offset; // of a ball that ends 2 mm before the border
  offset->AddInputData(BallImage());
  offset->SetOperationToOffset();
  offset->SetDistance(1.9);
  EXPECT_EQ(WarningsOfUpdate(offset), "");
  offset->SetDistance(2.5);
  const std::string said = WarningsOfUpdate(offset);
  EXPECT_NE(said.find("input 0 reaches to 2 mm from the border"), std::string::npos) << said;
  EXPECT_NE(said.find("2.5 mm"), std::string::npos) << said;
  EXPECT_NE(said.find("SetMargin(2.5)"), std::string::npos) << said;
  EXPECT_NE(offset->GetOutput()->GetSolid(), nullptr);
  offset->SetOperationToShell();
  offset->SetRange(-1.0, 2.5);
  EXPECT_NE(WarningsOfUpdate(offset).find("2.5 mm"), std::string::npos) << "also what is known";
  offset->SetRange(-1.0, 1.0);
  EXPECT_EQ(WarningsOfUpdate(offset), "");
  offset->SetOperationToUnion();
  EXPECT_EQ(WarningsOfUpdate(offset), "");
}

TEST(CsgFilter, AMarginKeepsOffsetsRound)
{
  const hasp::GridGeometry scan{ glm::ivec3(21), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  const hasp::AnalyticVolume ball = hasp::AnalyticSphere(glm::dvec3(10), 8.0);
  vtkNew<vtkHaspSignedDistance> bone;
  bone->SetInputData(hasp::MakeImage(scan, hasp::SampleAnalytic<float>(ball, scan, 80.0, 226.0)));
  bone->SetInputKindToGrey();
  bone->SetMargin(4.0);
  vtkNew<vtkHaspCsg> offset;
  offset->AddInputConnection(bone->GetOutputPort());
  offset->SetOperationToOffset();
  offset->SetDistance(4.0);
  EXPECT_EQ(WarningsOfUpdate(offset), "");
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 out =
      glm::normalize(glm::dvec3(std::sin(n * 1.1), std::cos(n * 2.3), std::sin(n * 0.7 + 1.0)));
    const glm::dvec3 place = glm::dvec3(10) + 12.0 * out; // far from its surface: 0.2 voxels
    EXPECT_NEAR(offset->GetOutput()->EvaluateDistance(&place.x), 0.0, 0.2);
  }
}

TEST(CsgFilter, AnOffsetAsFarAsNoSampleIsRefused)
{
  const auto image = BallImage();
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
    values[v] = std::clamp(values[v], -1.5F, 1.5F); // a narrow band
  vtkNew<vtkHaspCsg> offset;
  offset->AddInputData(image);
  offset->SetOperationToOffset();
  const auto refused = [&](double mm, const char* where)
  {
    offset->SetDistance(mm);
    const std::string said = ErrorsOfUpdate(offset);
    EXPECT_NE(said.find(where), std::string::npos) << said;
    EXPECT_NE(said.find("-1.5 to 1.5 mm"), std::string::npos) << said;
    EXPECT_NE(said.find("NarrowBand"), std::string::npos) << said;
    EXPECT_EQ(offset->GetOutput()->GetSolid(), nullptr);
  };
  refused(1.5, "1.5 mm outside");
  refused(3.0, "3 mm outside");
  refused(-1.5, "1.5 mm inside");
  refused(-5.0, "5 mm inside");
  for (const double known : { -1.4, 0.0, 1.4 })
  {
    offset->SetDistance(known);
    EXPECT_EQ(ErrorsOfUpdate(offset), "") << known;
  }
  offset->SetOperationToShell();
  offset->SetRange(0.0, 2.0);
  EXPECT_NE(ErrorsOfUpdate(offset), "");
  offset->SetRange(-2.0, 1.0);
  EXPECT_NE(ErrorsOfUpdate(offset), "");
  offset->SetRange(-1.0, 1.0);
  EXPECT_EQ(ErrorsOfUpdate(offset), "");
}

TEST(CsgFilter, SaysWhichInputIsWrongAndWhatToDo)
{
  TwoBalls balls;
  vtkNew<vtkHaspSolid> empty;
  balls.csg->AddInputData(empty);
  EXPECT_NE(ErrorsOfUpdate(balls.csg).find("input 2: there is no solid"), std::string::npos);
  EXPECT_EQ(balls.csg->GetOutput()->GetSolid(), nullptr);

  vtkNew<vtkHaspCsg> csg;
  const hasp::GridGeometry grid{ glm::ivec3(4), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  csg->AddInputData(hasp::MakeImage(grid, std::vector<std::int16_t>(64, 5)));
  const std::string said = ErrorsOfUpdate(csg);
  EXPECT_NE(said.find("input 0"), std::string::npos) << said;
  EXPECT_NE(said.find("short"), std::string::npos) << said;
  EXPECT_NE(said.find("vtkHaspSignedDistance"), std::string::npos) << said;
  csg->RemoveAllInputs();
  std::vector<float> grey(64);
  for (std::size_t v = 0; v < grey.size(); ++v)
    grey[v] = 100.0F * float(v % 2);
  csg->AddInputData(hasp::MakeImage(grid, grey));
  EXPECT_NE(ErrorsOfUpdate(csg).find("input 0"), std::string::npos) << "grey values are refused";
  for (const float all : { INFINITY, -INFINITY })
  {
    csg->RemoveAllInputs();
    csg->AddInputData(hasp::MakeImage(grid, std::vector<float>(64, all)));
    EXPECT_NE(ErrorsOfUpdate(csg).find(all > 0 ? "nothing is inside" : "everything is inside"),
      std::string::npos);
  }
  // Coverage, and a scan that somebody scaled: bright is inside.
  for (const bool isCoverage : { true, false })
  {
    auto image = BallImage();
    auto* values = static_cast<float*>(image->GetScalarPointer());
    for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
      values[v] = isCoverage ? std::clamp(0.5F - 2.0F * values[v], 0.0F, 1.0F)
                             : std::clamp(-0.25F * values[v], -0.5F, 0.5F);
    csg->RemoveAllInputs();
    csg->AddInputData(image);
    EXPECT_NE(ErrorsOfUpdate(csg).find("vtkHaspSignedDistance"), std::string::npos) << isCoverage;
    EXPECT_EQ(csg->GetOutput()->GetSolid(), nullptr);
  }
  csg->RemoveAllInputs();
  vtkNew<vtkPolyData> mesh;
  csg->AddInputData(mesh);
  EXPECT_NE(ErrorsOfUpdate(csg), "");

  balls.csg->RemoveInputConnection(0, 2);
  balls.csg->SetOperationToSmoothUnion();
  balls.csg->SetRadius(0.0);
  EXPECT_NE(ErrorsOfUpdate(balls.csg), "");
  balls.csg->SetOperationToShell();
  balls.csg->SetRange(1.0, 0.0);
  EXPECT_NE(ErrorsOfUpdate(balls.csg), "");
  balls.csg->SetOperationToOffset();
  balls.csg->SetDistance(std::nan(""));
  EXPECT_NE(ErrorsOfUpdate(balls.csg), "");
}

} // namespace
