// Samples changed in place: only the box that was marked is read again.
#include "AttributeTestScene.h"
#include "vtkHaspPickedCell.h"

#include "Isosurface/ClusteredCells.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using hasp::testing::CellTestScene;

constexpr int Size = 33;

struct EditScene : CellTestScene
{
  vtkSmartPointer<vtkImageData> Image;

  EditScene() : CellTestScene(60, 60)
  {
    const hasp::GridGeometry g{ glm::ivec3(Size), glm::dvec3(-16), { 1, 1, 1 }, glm::dmat3(1) };
    this->Image = hasp::MakeImage(
      g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 8), g, 100, 0));
    this->Mapper->SetInputData(this->Image);
    this->Look({ 0, -40, 0 }, { 0, 0, 0 }, 10, 100);
  }
  void Fill(const int box[6], short value)
  {
    auto* samples = static_cast<short*>(this->Image->GetScalarPointer());
    for (int k = box[4]; k <= box[5]; ++k)
      for (int j = box[2]; j <= box[3]; ++j)
        for (int i = box[0]; i <= box[1]; ++i)
          samples[(k * Size + j) * Size + i] = value;
  }
  std::vector<std::uint32_t> Corners() { return this->Mapper->GetCells().corners; }
};

class CellEdits : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellEdits, AMarkedBoxIsReadAndNothingElse)
{
  EditScene scene;
  scene.Draw();
  const auto before = scene.Corners();
  const int box[6] = { 12, 20, 4, 9, 12, 20 }; // in front of the ball
  const int elsewhere[6] = { 2, 3, 28, 30, 28, 30 };
  scene.Fill(box, 500);
  scene.Fill(elsewhere, 500);
  scene.Draw();
  EXPECT_EQ(scene.Corners(), before); // nobody said so
  scene.Mapper->MarkModified(box);
  scene.Draw();
  const auto point = scene.Point(30, 30);
  ASSERT_TRUE(point);
  EXPECT_LT(point->y, -12.0); // the block in front
  const auto withBox = scene.Corners();
  EXPECT_NE(withBox, before);

  scene.Mapper->MarkModified(elsewhere);
  scene.Draw();
  const auto edited = scene.Corners();
  EXPECT_NE(edited, withBox);
  scene.Image->GetPointData()->GetScalars()->Modified();
  scene.Image->Modified(); // from scratch
  scene.Draw();
  EXPECT_EQ(scene.Corners(), edited);
}

TEST_F(CellEdits, BoxesAddUpAndTheIsovalueMayMoveInBetween)
{
  EditScene scene;
  scene.Draw();
  const int one[6] = { 12, 20, 4, 9, 12, 20 }, two[6] = { 2, 3, 28, 40, -5, 30 };
  scene.Fill(one, 500);
  const int inside[6] = { 2, 3, 28, 32, 0, 30 }; // of the image
  scene.Fill(inside, 500);
  scene.Mapper->MarkModified(one);
  scene.Mapper->MarkModified(two);
  scene.Mapper->SetIsoValue(50);
  scene.Draw();
  const auto edited = scene.Corners();
  scene.Image->Modified();
  scene.Draw();
  EXPECT_EQ(scene.Corners(), edited);
}

TEST_F(CellEdits, AMarkSwallowsNoOtherPlaceOfTheImage)
{
  EditScene scene;
  scene.Draw();
  const int all[6] = { -2147483647 - 1, 2147483647, -2147483647 - 1, 2147483647, -2147483647 - 1,
    2147483647 };
  scene.Mapper->MarkModified(all); // more than there is
  scene.Draw();
  ASSERT_TRUE(scene.Point(30, 30));
  EXPECT_NEAR(scene.Point(30, 30)->y, -8.0, 0.1);
  scene.Image->SetSpacing(0.5, 0.5, 0.5);
  scene.Image->SetOrigin(-8, -8, -8);
  scene.Mapper->MarkModified(all);
  scene.Draw();
  ASSERT_TRUE(scene.Point(30, 30));
  EXPECT_NEAR(scene.Point(30, 30)->y, -4.0, 0.1);
}

TEST_F(CellEdits, BeforeTheFirstUpdateAMarkChangesNothing)
{
  EditScene scene;
  const int box[6] = { 0, 5, 0, 5, 0, 5 };
  scene.Mapper->MarkModified(box);
  scene.Draw();
  EXPECT_TRUE(scene.Point(30, 30));
}

TEST_F(CellEdits, LabelsAndColoursFollowInAnyExtent)
{
  hasp::testing::AttributeScene scene;
  vtkHaspClusteredCellMapper* mapper = scene.Mapper;
  vtkImageData* image = mapper->GetImage();
  image->SetExtent(5, 45, -3, 37, 100, 140);
  image->SetOrigin(-25, -17, -120); // where it was
  mapper->SetLabelArrayName("label");
  mapper->SetLabelColor(1, 1, 0, 0);
  mapper->SetScalarVisibility(true);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("height");
  EXPECT_EQ(scene.ColorAt({ -7, -13, 0 }), (std::array<int, 3>{ 255, 0, 0 }));
  const int box[6] = { 10, 16, -3, 4, 110, 130 };
  for (int k = box[4]; k <= box[5]; ++k)
    for (int j = box[2]; j <= box[3]; ++j)
      for (int i = box[0]; i <= box[1]; ++i)
        *static_cast<short*>(image->GetScalarPointer(i, j, k)) = 900;
  mapper->MarkModified(box);
  scene.Draw();
  const hasp::ClusteredCells edited = mapper->GetCells();
  const double from[3] = { 9, -100, 7.25 }, to[3] = { 9, 100, 7.25 };
  vtkNew<vtkHaspPickedCell> picked;
  ASSERT_TRUE(mapper->PickFirstCell(from, to, picked));
  EXPECT_EQ(picked->GetLabel(), 2);
  EXPECT_NEAR(picked->GetValue(), 7.25, 1e-5);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified(); // from scratch
  scene.Draw();
  const hasp::ClusteredCells& whole = mapper->GetCells();
  EXPECT_EQ(edited.corners, whole.corners);
  EXPECT_EQ(edited.labels, whole.labels);
  EXPECT_EQ(edited.colors, whole.colors);
  EXPECT_EQ(edited.firstColors, whole.firstColors);
}

TEST_F(CellEdits, AMarkMayReachAsFarAsIntegersDo)
{
  EditScene scene;
  int extent[6] = { 5, Size + 4, -5, Size - 6, 0, Size - 1 }; // the same samples, counted otherwise
  scene.Image->SetExtent(extent);
  ASSERT_TRUE(scene.Mapper->UpdateCells());
  const int box[6] = { 12, 20, 4, 9, 12, 20 };
  scene.Fill(box, 500);
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const int everything[6] = { least, most, least, most, least, most };
  scene.Mapper->MarkModified(everything);
  ASSERT_TRUE(scene.Mapper->UpdateCells());
  const auto edited = scene.Corners();
  scene.Image->Modified();
  ASSERT_TRUE(scene.Mapper->UpdateCells());
  EXPECT_EQ(scene.Corners(), edited);
}

TEST_F(CellEdits, AMarkDoesNotHideThatTheImageIsAnother)
{
  const int box[6] = { 0, 3, 0, 3, 0, 3 };
  for (const int type : { VTK_SHORT, VTK_FLOAT })
  {
    EditScene scene;
    ASSERT_TRUE(scene.Mapper->UpdateCells());
    scene.Image->SetDimensions(Size - 1, 20, Size); // as many blocks along x and z as before
    scene.Image->AllocateScalars(type, 1);
    scene.Image->GetPointData()->GetScalars()->Fill(-900);
    scene.Image->SetScalarComponentFromDouble(9, 9, 9, 0, 900);
    scene.Image->Modified();
    scene.Mapper->MarkModified(box);
    ASSERT_TRUE(scene.Mapper->UpdateCells());
    EXPECT_EQ(scene.Mapper->GetCells().geometry.dims, glm::ivec3(Size - 1, 20, Size));
    EXPECT_EQ(scene.Mapper->GetCells().Count(), 8U);
  }
}

} // namespace
