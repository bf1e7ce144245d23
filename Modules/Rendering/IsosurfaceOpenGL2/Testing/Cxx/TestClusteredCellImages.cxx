// Images change, share samples or are broken, and the mapper sees it.
#include "BallScene.h"

#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <gtest/gtest.h>

namespace
{

using hasp::testing::Ball;
using hasp::testing::BallScene;

class CellImages : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellImages, ThatShareSamplesAreToldApart)
{
  BallScene scene;
  const auto small = Ball(20, 1, 8);
  vtkNew<vtkImageData> large;
  large->ShallowCopy(small);
  large->SetSpacing(2, 2, 2);
  large->SetOrigin(-19, -19, -19);
  small->GetPointData()->GetScalars()->Modified(); // the MTime of both
  ASSERT_EQ(small->GetMTime(), large->GetMTime());
  scene.Mapper->SetInputData(small);
  scene.Draw();
  const auto near = scene.Point(30, 30);
  scene.Mapper->SetInputData(large);
  scene.Draw();
  const auto far = scene.Point(30, 30);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(near->y, -8.0, 0.1);
  EXPECT_NEAR(far->y, -16.0, 0.2);
}

TEST_F(CellImages, ThatChangeAreSeenAndBrokenOnesAreAnError)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  vtkImageData* image = scene.Mapper->GetImage();
  // Other scalars: the middle is empty.
  vtkNew<vtkShortArray> nothing;
  nothing->SetNumberOfValues(image->GetNumberOfPoints());
  nothing->FillValue(-5);
  const vtkSmartPointer<vtkDataArray> ball = image->GetPointData()->GetScalars();
  image->GetPointData()->SetScalars(nothing);
  EXPECT_FALSE(scene.Shows());
  EXPECT_EQ(hasp::testing::FindResource(scene.Mapper, "active cells, GPU").bytes, 0U);
  image->GetPointData()->SetScalars(ball);
  EXPECT_TRUE(scene.Shows());
  // An extent without samples for it: an error, not a crash.
  scene.Mapper->SetGlobalWarningDisplay(false);
  image->SetDimensions(20, 20, 4000);
  EXPECT_FALSE(scene.Shows());
  scene.Mapper->SetGlobalWarningDisplay(true);
  image->SetDimensions(20, 20, 20);
  EXPECT_TRUE(scene.Shows());
  // Single slices and single voxels have no surface, and that is no error.
  image->SetDimensions(400, 20, 1);
  EXPECT_FALSE(scene.Shows());
  EXPECT_TRUE(scene.Mapper->UpdateCells());
  scene.Mapper->SetInputData(Ball(1, 1, 8));
  EXPECT_FALSE(scene.Shows());
  EXPECT_TRUE(scene.Mapper->UpdateCells());
}

} // namespace
