// Labels: colour, visibility and rigid pose of each, drawn in one pass; depth, clipping, selection
// and bounds go along.
#include "AttributeTestScene.h"
#include "CellLabels.h"
#include "ErrorCounter.h"
#include "Isosurface/CellAttributes.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using hasp::testing::AttributeScene;
using hasp::testing::ErrorCounter;
using Color = std::array<int, 3>;

class CellLabels : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// Turned by 180 degrees around z, 30 mm to the right, 8 up.
vtkSmartPointer<vtkTransform> Away()
{
  auto away = vtkSmartPointer<vtkTransform>::New();
  away->Translate(30, 0, 8);
  away->RotateZ(180);
  return away;
}

TEST_F(CellLabels, CostNothingUntilSomethingIsSaid)
{
  AttributeScene s;
  s.Draw();
  const auto bare = s.Mapper->GetCells().Bytes();
  for (const char* name : { "cell labels, host", "cell labels, GPU" })
    EXPECT_EQ(BytesOf(s, name), 0U) << name;
  s.Mapper->SetLabelArrayName("label");
  s.Draw();
  EXPECT_EQ(BytesOf(s, "cell labels, host"), 2 * s.Mapper->GetCells().Count());
  EXPECT_EQ(BytesOf(s, "cell labels, GPU"), 0U) << "they are not drawn in any other way";
  s.Mapper->SetLabelColor(1, 1, 0, 0);
  s.Draw();
  EXPECT_GT(BytesOf(s, "cell labels, GPU"), 2 * s.Mapper->GetCells().Count());
  s.Mapper->ClearLabels();
  s.Draw();
  EXPECT_EQ(BytesOf(s, "cell labels, GPU"), 0U);
  s.Mapper->SetLabelArrayName("");
  s.Draw();
  EXPECT_EQ(s.Mapper->GetCells().Bytes(), bare);
}

TEST_F(CellLabels, HaveColours)
{
  AttributeScene s;
  s.Actor->GetProperty()->SetColor(0, 1, 1);
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelColor(1, 1, 0, 0);
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 255, 0, 0 }));
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 0, 255, 255 })) << "nothing was said of label 2";
  s.Mapper->SetLabelColor(2, 0, 0, 1);
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 0, 0, 255 }));
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 255, 0, 0 }));
}

TEST_F(CellLabels, AreReadAgainInABoxThatIsMarked)
{
  AttributeScene s;
  s.Actor->GetProperty()->SetColor(0, 1, 1);
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelColor(1, 1, 0, 0);
  s.Mapper->SetLabelColor(2, 0, 0, 1);
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 0, 0, 255 }));
  const void* extracted = s.Mapper->GetCells().corners.data();
  vtkImageData* image = s.Mapper->GetImage();
  auto* label = vtkUnsignedShortArray::SafeDownCast(image->GetPointData()->GetArray("label"));
  const auto paint = [&](int value, const glm::ivec3& low, const glm::ivec3& high)
  {
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          label->SetValue((k * 41 + j) * 41 + i, static_cast<unsigned short>(value));
    label->Modified();
    const int box[6] = { low.x, high.x, low.y, high.y, low.z, high.z };
    s.Mapper->MarkLabelsModified(box);
  };
  // Samples at the place (7, -13, 0) mm.
  paint(1, { 25, 4, 18 }, { 29, 9, 22 });
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 255, 0, 0 }));
  EXPECT_EQ(s.ColorAt({ 7, -11, 7 }), (Color{ 0, 0, 255 }));
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 255, 0, 0 }));
  paint(2, { 25, 4, 18 }, { 29, 9, 22 }); // two boxes before a picture
  paint(3, { 11, 4, 18 }, { 15, 9, 22 });
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 0, 0, 255 }));
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 0, 255, 255 })) << "nothing was said of label 3";
  ASSERT_TRUE(s.Mapper->UpdateCells());
  EXPECT_EQ(s.Mapper->GetCells().corners.data(), extracted) << "no samples were read";
  hasp::ClusteredCells truth = s.Mapper->GetCells();
  hasp::AddLabels(truth, hasp::ViewPointArray(image, label));
  EXPECT_EQ(s.Mapper->GetCells().labels, truth.labels);
  // An edit of samples behind one of labels: all is as if it had been there from the start.
  paint(2, { 11, 4, 18 }, { 15, 9, 22 });
  auto* samples = static_cast<short*>(image->GetScalarPointer(27, 7, 20));
  *samples = static_cast<short>(-*samples - 50);
  const int one[6] = { 27, 27, 7, 7, 20, 20 };
  s.Mapper->MarkModified(one);
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 0, 0, 255 }));
  truth = s.Mapper->GetCells();
  hasp::AddLabels(truth, hasp::ViewPointArray(image, label));
  EXPECT_EQ(s.Mapper->GetCells().labels, truth.labels);
}

TEST_F(CellLabels, CanBeHidden)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  const int all = s.Covered();
  s.Mapper->SetLabelVisibility(1, false);
  const int half = s.Covered();
  EXPECT_GT(half, all / 3);
  EXPECT_LT(half, 2 * all / 3);
  s.Mapper->SetLabelVisibility(2, false);
  EXPECT_EQ(s.Covered(), 0);
  s.Mapper->SetLabelVisibility(1, true);
  s.Mapper->SetLabelVisibility(2, true);
  EXPECT_EQ(s.Covered(), all);
}

// Closed form: the ball, and the half ball where the pose takes it.
TEST_F(CellLabels, APoseTakesItsCellsAlongExactly)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelPose(2, Away());
  s.Look({ 12, -150, 4 }, { 12, 0, 4 }, 40, 300);
  s.Draw();
  int still = 0, moved = 0;
  double worst = 0.0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 120; ++x)
      if (const auto p = s.Point(x, y))
      {
        const bool right = p->x > 10;
        // Away and back: (30 - x, -y, z - 8). The half with x >= 0 lies at x <= 30 now.
        const glm::dvec3 ball = right ? glm::dvec3(30 - p->x, -p->y, p->z - 8) : *p;
        worst = std::max(worst, std::abs(glm::length(ball) - 15));
        (right ? moved : still) += 1;
        EXPECT_LT(right ? -ball.x : ball.x, 1.01) << "of the other half"; // to the end of a cell
      }
  EXPECT_GT(still, 200);
  EXPECT_GT(moved, 200);
  // int16 hundredths of a mm and the trilinear cell: 1 mm^2 / (8 * 15 mm) * 2; depth in 24 bits:
  // 0.01.
  EXPECT_LT(worst, 0.03);
}

// Second implementation: an actor of its own for each half, the other half hidden.
TEST_F(CellLabels, APoseLooksLikeAnActorsMatrix)
{
  AttributeScene one, two;
  vtkNew<vtkActor> other;
  auto mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
  mapper->SetInputData(one.Mapper->GetImage());
  mapper->SetIsoValue(0);
  other->SetMapper(mapper);
  vtkNew<vtkPlane> plane; // in world coordinates: the same for both, not carried along
  plane->SetNormal(0, 0.6, 0.8);
  plane->SetOrigin(0, -5, 0);
  one.Mapper->AddClippingPlane(plane);
  two.Mapper->SetInputData(one.Mapper->GetImage());
  two.Mapper->AddClippingPlane(plane);
  mapper->AddClippingPlane(plane);

  one.Mapper->SetLabelArrayName("label");
  one.Mapper->SetLabelPose(2, Away());
  two.Mapper->SetLabelArrayName("label");
  two.Mapper->SetLabelVisibility(2, false);
  mapper->SetLabelArrayName("label");
  mapper->SetLabelVisibility(1, false);
  other->SetUserTransform(Away());
  two.Renderer->AddActor(other);
  for (AttributeScene* s : { &one, &two })
  {
    s->Look({ 40, -140, 30 }, { 12, 0, 4 }, 40, 300);
    for (vtkActor* actor : { s->Actor.GetPointer(), other.GetPointer() })
    {
      actor->GetProperty()->LightingOn();
      actor->GetProperty()->SetSpecular(0.5);
      actor->GetProperty()->SetSpecularPower(20);
    }
    s->Draw();
  }
  vtkNew<vtkUnsignedCharArray> a, b;
  one.Window->GetPixelData(0, 0, 119, 99, 1, a);
  two.Window->GetPixelData(0, 0, 119, 99, 1, b);
  int differ = 0, seen = 0;
  for (vtkIdType n = 0; n < a->GetNumberOfValues(); ++n)
  {
    seen += a->GetValue(n) > 0;
    differ += std::abs(a->GetValue(n) - b->GetValue(n)) > 1; // rounding of 8 bits
  }
  EXPECT_GT(seen, 3000);
  // The matrices are multiplied in another order; a pixel at the border may fall to the other side.
  EXPECT_LE(differ, 9);
}

TEST_F(CellLabels, APickNamesThePosedCellAndItsPoint)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelPose(2, Away());
  s.Look({ 12, -150, 4 }, { 12, 0, 4 }, 40, 300);
  s.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(s.Renderer);
  selector->SetArea(0, 0, 119, 99);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_TRUE(selector->CaptureBuffers());
  int picks = 0;
  for (unsigned y = 2; y < 100; y += 4)
    for (unsigned x = 2; x < 120; x += 4)
    {
      const auto truth = s.Point(int(x), int(y));
      const unsigned pixel[2] = { x, y };
      const auto info = selector->GetPixelInformation(pixel);
      ASSERT_EQ(info.Valid, truth.has_value());
      if (!truth)
        continue;
      const auto [from, way] = s.Ray(int(x), int(y));
      const glm::dvec3 to = from + 400.0 * way;
      vtkNew<vtkHaspPickedCell> picked, first;
      ASSERT_TRUE(s.Mapper->PickCell(info.AttributeID, &from.x, &to.x, picked));
      EXPECT_LT(
        glm::distance(glm::make_vec3(picked->GetPosition()), *truth), 0.02); // 24 bits of depth
      EXPECT_EQ(picked->GetLabel(), truth->x > 10 ? 2 : 1);
      ASSERT_TRUE(s.Mapper->PickFirstCell(&from.x, &to.x, first));
      EXPECT_NEAR(first->GetT(), picked->GetT(), 1e-6);
      const glm::dvec3 ball =
        truth->x > 10 ? glm::dvec3(30 - truth->x, -truth->y, truth->z - 8) : *truth;
      const glm::dvec3 normal =
        glm::normalize(truth->x > 10 ? glm::dvec3(-ball.x, -ball.y, ball.z) : ball);
      EXPECT_GT(glm::dot(glm::make_vec3(picked->GetNormal()), normal), 0.99);
      ++picks;
    }
  EXPECT_GT(picks, 50);
}

/// The halves of the ball, as labels 65534 and 65535, apart; all labels from `first` to 65533 have
/// a pose, too. With and without blended normals.
std::vector<unsigned char> HalvesApart(int first)
{
  AttributeScene s;
  vtkDataArray* label = s.Mapper->GetImage()->GetPointData()->GetArray("label");
  for (vtkIdType n = 0; n < label->GetNumberOfTuples(); ++n)
    label->SetComponent(n, 0, label->GetComponent(n, 0) + 65533);
  s.Mapper->SetLabelArrayName("label");
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 10);
  for (int n = first; n < 65534; ++n)
    s.Mapper->SetLabelPose(n, up);
  vtkNew<vtkTransform> left;
  left->Translate(-20, 0, -8);
  s.Mapper->SetLabelPose(65534, left);
  s.Mapper->SetLabelPose(65535, Away());
  s.Actor->GetProperty()->LightingOn();
  std::vector<unsigned char> colors;
  for (const bool blended : { false, true })
  {
    s.Mapper->SetBlendNormals(blended);
    s.Draw();
    vtkNew<vtkUnsignedCharArray> rgb;
    s.Window->GetPixelData(0, 0, 119, 99, 1, rgb);
    colors.insert(colors.end(), rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  }
  return colors;
}

// What is not moved at all is a frame, too: 65536 poses make 65537.
TEST_F(CellLabels, EachOfAllMayHaveAPose)
{
  const auto truth = HalvesApart(65534);
  EXPECT_GT(std::count_if(truth.begin(), truth.end(), [](int c) { return c > 0; }), 6000);
  EXPECT_EQ(HalvesApart(1), truth);
  EXPECT_EQ(HalvesApart(0), truth);
}

TEST_F(CellLabels, BoundsHoldWhatPosesCarryAway)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelPose(2, Away());
  double bounds[6];
  s.Mapper->GetBounds(bounds);
  const double truth[6] = { -20, 50, -20, 20, -20, 28 };
  for (int n = 0; n < 6; ++n)
    EXPECT_NEAR(bounds[n], truth[n], 1e-9) << n;
}

TEST_F(CellLabels, ATranslucentLabelLetsTheOtherThrough)
{
  AttributeScene s;
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelColor(1, 1, 0, 0);
  s.Mapper->SetLabelColor(2, 0, 1, 0, 0.5);
  EXPECT_TRUE(s.Actor->HasTranslucentPolygonalGeometry());
  EXPECT_EQ(s.ColorAt({ -7, -13, 0 }), (Color{ 255, 0, 0 }));
  const Color green = s.ColorAt({ 7, -13, 0 }); // two layers of half: 1 - 1/4
  EXPECT_EQ(green[0], 0);
  EXPECT_NEAR(green[1], 191, 3);
  s.Mapper->SetLabelColor(2, 0, 1, 0);
  EXPECT_FALSE(s.Actor->HasTranslucentPolygonalGeometry());
  EXPECT_EQ(s.ColorAt({ 7, -13, 0 }), (Color{ 0, 255, 0 }));
}

TEST_F(CellLabels, WhatCannotBeIsRefused)
{
  AttributeScene s;
  vtkNew<ErrorCounter> errors;
  s.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  s.Mapper->SetLabelArrayName("label");
  s.Draw();
  vtkNew<vtkTransform> bad;
  const auto refused = [&]
  {
    s.Mapper->SetLabelPose(1, bad);
    bad->Identity();
  };
  bad->Scale(1, 1, 1.01);
  refused();
  bad->Scale(1, 1, -1);
  refused();
  bad->Translate(std::nan(""), 0, 0);
  refused();
  vtkNew<vtkMatrix4x4> projection;
  projection->SetElement(3, 0, 0.1);
  s.Mapper->SetLabelPose(1, projection);
  s.Mapper->SetLabelPose(-1, bad);
  s.Mapper->SetLabelVisibility(65536, true);
  s.Mapper->SetLabelColor(1, 1, 0, 2);
  s.Mapper->SetLabelColor(1, 1, std::nan(""), 0);
  EXPECT_EQ(errors->Count, 8);
  EXPECT_TRUE(s.Mapper->GetLabels().empty());
  errors->Count = 0;
  s.Mapper->SetLabelArrayName("nothing");
  EXPECT_EQ(s.Covered(), 0);
  EXPECT_EQ(errors->Count, 1);
  s.Mapper->SetLabelArrayName("label");
  EXPECT_GT(s.Covered(), 100);
  EXPECT_EQ(errors->Count, 1);
}

} // namespace
