#include "vtkHaspSharpContour.h"

#include "Evaluation/MeshCheck.h"
#include "FilterErrors.h"
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspCsg.h"
#include "vtkHaspSolid.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

const double Origin[3] = { 0, 0, 0 }, Up[3] = { 0, 0, 1 };

/// A box of 8 x 6 x 4 mm with a slot of 1 mm, turned out of the grid's axes.
struct SlottedBox
{
  SlottedBox()
  {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const double axes[9] = { c, -s, 0, s, c, 0, 0, 0, 1 }, along[3] = { c, s, 0 };
    const double half[3] = { 4, 3, 2 };
    this->box->SetToBox(Origin, half, axes);
    this->slot->SetToSlab(Origin, along, 1.0);
    this->cut->SetOperationToDifference();
    this->cut->AddInputConnection(this->box->GetOutputPort());
    this->cut->AddInputConnection(this->slot->GetOutputPort());
    this->contour->SetInputConnection(this->cut->GetOutputPort());
  }
  hasp::MeshCheck Check()
  {
    EXPECT_EQ(ErrorsOfUpdate(this->contour), "");
    return hasp::CheckMesh(hasp::MakeTriangleMesh(this->contour->GetOutput()));
  }
  vtkNew<vtkHaspSolidSource> box, slot;
  vtkNew<vtkHaspCsg> cut;
  vtkNew<vtkHaspSharpContour> contour;
};

constexpr double SlottedMm3 = 8.0 * 6.0 * 4.0 - 1.0 * 6.0 * 4.0;

TEST(SharpContourFilter, KeepsEdgesWhereFlyingEdgesCutsThemOff)
{
  SlottedBox part;
  const hasp::MeshCheck sharp = part.Check();
  EXPECT_TRUE(sharp.Sound());
  EXPECT_EQ(sharp.pieces, 2U);
  EXPECT_NEAR(sharp.volumeMm3, SlottedMm3, 0.001 * SlottedMm3);
  EXPECT_LT(part.contour->GetNumberOfBlocksHeld(), part.contour->GetNumberOfBlocks());
  EXPECT_GT(part.contour->GetNumberOfBlocksHeld(), 0);
  part.contour->SetMethodToFlyingEdges();
  const hasp::MeshCheck plain = part.Check();
  EXPECT_TRUE(plain.Closed());
  EXPECT_GT(SlottedMm3 - plain.volumeMm3, 5.0 * std::abs(SlottedMm3 - sharp.volumeMm3));
  EXPECT_NEAR(plain.volumeMm3, SlottedMm3, 0.05 * SlottedMm3);
}

TEST(SharpContourFilter, AnImageOfDistancesIsASolid)
{
  const hasp::GridGeometry grid{ glm::ivec3(25), glm::dvec3(-6), glm::dvec3(0.5), glm::dmat3(1) };
  vtkNew<vtkHaspSharpContour> contour;
  contour->SetInputData(hasp::MakeImage(
    grid, hasp::SampleAnalytic<float>(hasp::AnalyticSphere(glm::dvec3(0), 4.0), grid, -1.0, 0.0)));
  EXPECT_EQ(ErrorsOfUpdate(contour), "");
  const auto check = hasp::CheckMesh(hasp::MakeTriangleMesh(contour->GetOutput()));
  EXPECT_TRUE(check.Sound());
  EXPECT_NEAR(check.volumeMm3, 4.0 / 3.0 * 3.14159265 * 64.0, 3.0);
}

TEST(SharpContourFilter, BoundsCutWhatHasNoEnd)
{
  vtkNew<vtkHaspSolidSource> half;
  half->SetToPlane(Origin, Up);
  vtkNew<vtkHaspSharpContour> contour;
  contour->SetInputConnection(half->GetOutputPort());
  EXPECT_NE(ErrorsOfUpdate(contour).find("SetBounds"), std::string::npos);
  EXPECT_EQ(contour->GetOutput()->GetNumberOfPoints(), 0);
  contour->SetBounds(-3, 3, -2, 2, -1, 1);
  EXPECT_EQ(ErrorsOfUpdate(contour), "");
  const auto check = hasp::CheckMesh(hasp::MakeTriangleMesh(contour->GetOutput()));
  EXPECT_TRUE(check.Sound());
  double bounds[6];
  contour->GetOutput()->GetBounds(bounds);
  const double asked[6] = { -3, 3, -2, 2, -1, 0 };
  for (int b = 0; b < 6; ++b)
    EXPECT_NEAR(bounds[b], asked[b], 1e-5) << b;
  // Its edges, 44 mm in all, are cut off by less than 0.01 mm to each side.
  EXPECT_NEAR(check.volumeMm3, 24.0, 44.0 * 0.01 * 0.01 / 2.0);
}

TEST(SharpContourFilter, BoundsThatAreNoneAreNamed)
{
  SlottedBox part;
  part.contour->SetBounds(-1, 1, 2, -2, -1, 1);
  EXPECT_NE(ErrorsOfUpdate(part.contour).find("Bounds along y"), std::string::npos);
  part.contour->SetBounds(-1, 1, -1, 1, std::nan(""), 1);
  EXPECT_NE(ErrorsOfUpdate(part.contour).find("Bounds along z"), std::string::npos);
  part.contour->SetBounds(-1, INFINITY, -1, 1, -1, 1);
  EXPECT_NE(ErrorsOfUpdate(part.contour).find("Bounds along x"), std::string::npos);
}

TEST(SharpContourFilter, NothingIsAnEmptyMesh)
{
  vtkNew<vtkHaspCsg> nothing;
  vtkNew<vtkHaspSolidSource> ball;
  ball->SetToCapsule(Origin, Origin, 1.0);
  nothing->AddInputConnection(ball->GetOutputPort());
  nothing->SetOperationToOffset();
  nothing->SetDistance(-5.0);
  vtkNew<vtkHaspSharpContour> contour;
  contour->SetInputConnection(nothing->GetOutputPort());
  for (const int method : { vtkHaspSharpContour::SharpContour, vtkHaspSharpContour::FlyingEdges })
  {
    contour->SetMethod(method);
    EXPECT_NE(WarningsOfUpdate(contour).find("the surface is empty"), std::string::npos);
    EXPECT_EQ(contour->GetOutput()->GetNumberOfPoints(), 0);
  }
  contour->SetInputConnection(ball->GetOutputPort());
  contour->SetBounds(5, 6, 5, 6, 5, 6);
  EXPECT_NE(WarningsOfUpdate(contour).find("inside the bounds"), std::string::npos);
  contour->SetBounds(1, -1, 1, -1, 1, -1);
  EXPECT_EQ(WarningsOfUpdate(contour), "");
}

TEST(SharpContourFilter, ATinySpacingIsRefusedBeforeTheWork)
{
  SlottedBox part;
  part.contour->SetSpacing(0.0005);
  const std::string said = ErrorsOfUpdate(part.contour);
  EXPECT_NE(said.find("triangles"), std::string::npos) << said;
  EXPECT_EQ(part.contour->GetOutput()->GetNumberOfPoints(), 0);
  part.contour->SetSpacing(0.2);
  const auto triangles = vtkIdType(part.Check().triangles);
  part.contour->SetMaximumNumberOfTriangles(triangles / 3);
  EXPECT_NE(ErrorsOfUpdate(part.contour).find("triangles"), std::string::npos);
  part.contour->SetMaximumNumberOfTriangles(triangles - 1); // the estimate may let it pass
  EXPECT_NE(ErrorsOfUpdate(part.contour).find("triangles"), std::string::npos);
  part.contour->SetMaximumNumberOfTriangles(3 * triangles);
  EXPECT_EQ(ErrorsOfUpdate(part.contour), "");
}

TEST(SharpContourFilter, WrongNumbersAreSaidBeforeMemoryIsTaken)
{
  SlottedBox part;
  const auto refused = [&](const char* word)
  {
    const std::string said = ErrorsOfUpdate(part.contour);
    EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_EQ(part.contour->GetOutput()->GetNumberOfPoints(), 0);
  };
  for (const double spacing : { 0.0, -1.0, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    part.contour->SetSpacing(spacing);
    refused("Spacing");
  }
  part.contour->SetSpacing(1e-10);
  refused("larger Spacing");
  part.contour->SetSpacing(0.004);
  part.contour->SetMethodToFlyingEdges();
  refused("larger Spacing");
  part.contour->SetMethodToSharpContour();
  part.contour->SetSpacing(0.4);
  part.contour->SetTolerance(0.5);
  refused("tolerance");
  part.contour->SetTolerance(0.01);
  EXPECT_TRUE(part.Check().Sound());
}

TEST(SharpContourFilter, AnAbortGivesNothing)
{
  SlottedBox part;
  const AbortAtOnce abort(part.contour);
  for (const int method : { vtkHaspSharpContour::SharpContour, vtkHaspSharpContour::FlyingEdges })
  {
    part.contour->SetMethod(method);
    EXPECT_EQ(ErrorsOfUpdate(part.contour), "");
    EXPECT_EQ(part.contour->GetOutput()->GetNumberOfPoints(), 0);
  }
}

} // namespace
