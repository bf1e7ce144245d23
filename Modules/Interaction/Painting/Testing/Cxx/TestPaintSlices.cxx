// Painting in slices: the line of sight and the plane, in closed form; and the depth as a witness.
#include "PaintScene.h"
#include "SlicePlace.h"
#include "vtkHaspBrushProp.h"

#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageResliceMapper.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <array>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// About the origin, 40 mm each way; spacing differs, axes are turned about z, y runs backwards.
vtkSmartPointer<vtkImageData> Image(double degrees)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 43, 0, 20, -5, 35);
  image->SetSpacing(1.0, 2.0, 1.0);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), image->GetNumberOfPoints(), 100);
  const double a = degrees * std::numbers::pi / 180.0;
  const glm::dvec3 x(std::cos(a), std::sin(a), 0), y(std::sin(a), -std::cos(a), 0), z(0, 0, 1);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      image->GetDirectionMatrix()->SetElement(row, column,
        (column == 0    ? x
          : column == 1 ? y
                        : z)[row]);
  const glm::dvec3 origin = -(23.0 * x + 10.0 * 2.0 * y + 15.0 * z);
  image->SetOrigin(origin.x, origin.y, origin.z);
  return image;
}

struct SliceScene : PaintScene
{
  explicit SliceScene(vtkImageMapper3D* mapper)
  {
    this->slice->SetMapper(mapper);
    this->slice->GetProperty()->SetColorWindow(200);
    this->renderer->AddViewProp(this->slice);
    this->painter->SetSlice(this->slice);
    // From the side: the line of sight meets the plane at a slant.
    this->renderer->GetActiveCamera()->SetPosition(30, -40, 85);
  }
  vtkNew<vtkImageSlice> slice;
};

/// witness: the mapper writes depth. (vtkImageResliceMapper does not.)
void ExpectInPlane(
  SliceScene& scene, const glm::dvec3& point, const glm::dvec3& normal, bool witness)
{
  scene.Enable();
  const auto& pieces = scene.Drag({ { 95, 95 }, { 110, 105 } });
  ASSERT_EQ(pieces.size(), 1u);
  ASSERT_GT(pieces[0].points.size(), 3u);
  const SeenDepth view = vtkHaspBrushProp::ViewOf(scene.renderer);
  for (const glm::dvec3& at : pieces[0].points)
    EXPECT_LT(std::abs(glm::dot(at - point, normal)), 1e-9);
  // On the line of sight through the first pixel's middle.
  const glm::dvec3 near = view.Unproject({ 95.5, 95.5 }, 0),
                   far = view.Unproject({ 95.5, 95.5 }, 1);
  const glm::dvec3 along = glm::normalize(far - near);
  EXPECT_LT(glm::length(glm::cross(pieces[0].points[0] - near, along)), 1e-9);
  // And what is seen is that slice: its depth says the same, to the depth's steps.
  if (!witness)
    return;
  scene.painter->SetSlice(nullptr);
  double seen[3];
  ASSERT_TRUE(scene.painter->GetPlace(95, 95, seen));
  EXPECT_LT(glm::length(glm::dvec3(seen[0], seen[1], seen[2]) - pieces[0].points[0]), 0.01);
}

TEST(PaintSlices, ASliceOfATurnedImageIsPaintedInItsPlane)
{
  for (int orientation = 0; orientation < 3; ++orientation)
  {
    const auto image = Image(30.0);
    vtkNew<vtkImageSliceMapper> mapper;
    mapper->SetInputData(image);
    mapper->SetOrientation(orientation);
    mapper->SetSliceNumber(orientation == 0 ? 25 : orientation == 1 ? 9 : 17);
    SliceScene scene(mapper);
    if (orientation != 2)
      scene.renderer->GetActiveCamera()->SetPosition(60, -60, 50);
    const double index[3] = { orientation == 0 ? 22.0 : 0.0, orientation == 1 ? 9.0 : 0.0,
      orientation == 2 ? 22.0 : 0.0 };
    // By the image's own word: the extent begins at 3, 0, -5.
    double point[3];
    image->TransformContinuousIndexToPhysicalPoint(index[0] + 3, index[1], index[2] - 5, point);
    glm::dvec3 normal;
    for (int row = 0; row < 3; ++row)
      normal[row] = image->GetDirectionMatrix()->GetElement(row, orientation);
    ExpectInPlane(scene, { point[0], point[1], point[2] }, normal, true);
  }
}

TEST(PaintSlices, AnObliqueSliceIsPaintedInItsPlane)
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.3, 1)), point(1, 2, 3);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(point.x, point.y, point.z);
  plane->SetNormal(5.0 * normal.x, 5.0 * normal.y, 5.0 * normal.z); // of any length
  vtkNew<vtkImageResliceMapper> mapper;
  mapper->SetInputData(Image(30.0));
  mapper->SetSlicePlane(plane);
  SliceScene scene(mapper);
  ExpectInPlane(scene, point, normal, false);
}

TEST(PaintSlices, APropThatIsMovedTakesItsSliceAlong)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Image(0.0));
  mapper->SetSliceNumber(15);
  SliceScene scene(mapper);
  vtkNew<vtkTransform> moved;
  moved->Translate(2, 3, 5);
  moved->RotateX(20.0);
  scene.slice->SetUserTransform(moved);
  double point[3], zero[3] = { 0, 0, 0 }; // slice 15 is the middle one
  moved->TransformPoint(zero, point);
  double normal[3], z[3] = { 0, 0, 1 };
  moved->TransformNormal(z, normal);
  ExpectInPlane(scene, { point[0], point[1], point[2] }, { normal[0], normal[1], normal[2] }, true);
}

TEST(PaintSlices, ASliceThatFollowsTheCameraIsWhereItIsSeen)
{
  vtkNew<vtkImageResliceMapper> mapper;
  mapper->SetInputData(Image(30.0));
  mapper->SliceFacesCameraOn();
  mapper->SliceAtFocalPointOn();
  SliceScene scene(mapper);
  ExpectInPlane(scene, glm::dvec3(0.0), glm::normalize(glm::dvec3(30, -40, 85)), false);
}

TEST(PaintSlices, OutsideTheImageThereIsNothingToPaintOn)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Image(0.0));
  mapper->SetSliceNumber(15);
  SliceScene scene(mapper);
  scene.renderer->GetActiveCamera()->SetPosition(0, 0, Distance);
  scene.Enable();
  const double mm = scene.PixelMm(Distance);
  // x: 20 mm each way and half a voxel; y: 20 mm and half of 2 mm.
  for (const auto& [x, y] :
    { std::pair(20.4, 0.0), std::pair(20.6, 0.0), std::pair(0.0, 20.9), std::pair(0.0, 21.1) })
  {
    double at[3];
    const glm::ivec2 pixel = glm::ivec2(glm::floor(100.0 + glm::dvec2(x, y) / mm));
    const glm::dvec2 middle = mm * (glm::dvec2(pixel) + 0.5 - 100.0);
    const bool inside = middle.x < 20.5 && middle.y < 21.0;
    EXPECT_EQ(scene.painter->GetPlace(pixel.x, pixel.y, at), inside) << x << " " << y;
  }
  // A drag that leaves and comes back is two pieces.
  EXPECT_EQ(scene.Drag({ { 100, 100 }, { 199, 100 }, { 100, 120 } }).size(), 2u);
}

TEST(PaintSlices, NoDepthIsAskedAndOtherThingsInTheViewAreNotInTheWay)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Image(0.0));
  mapper->SetSliceNumber(15);
  SliceScene scene(mapper);
  scene.renderer->AddActor(BallActor(10.0, { 0, 0, 20 }));
  scene.Enable();
  for (const glm::dvec3& point : scene.Drag({ { 95, 95 }, { 105, 105 } })[0].points)
    EXPECT_LT(std::abs(point.z), 1e-9);
  ResourceList list;
  scene.painter->ListResources(list);
  EXPECT_EQ(list.at(0).bytes, 0u);
}

TEST(PaintSlices, AnotherSliceWithinADragIsAnotherPiece)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Image(0.0));
  mapper->SetSliceNumber(15);
  SliceScene scene(mapper);
  scene.Enable();
  scene.Press({ 90, 100 });
  scene.Hover({ 100, 100 });
  mapper->SetSliceNumber(16); // 1 mm on: less than the brush's radius
  scene.window->Render();
  scene.Hover({ 110, 100 });
  scene.Release({ 110, 100 });
  const auto& pieces = scene.painter->GetPieces();
  ASSERT_EQ(pieces.size(), 2u);
  for (const glm::dvec3& point : pieces[0].points)
    EXPECT_NEAR(point.z, 0.0, 1e-9);
  for (const glm::dvec3& point : pieces[1].points)
    EXPECT_NEAR(point.z, 1.0, 1e-9);
}

TEST(PaintSlices, TheLeftEyesLineOfSightIsTheOneThatIsAsked)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Image(0.0));
  mapper->SetSliceNumber(25); // 10 mm before the focal point
  SliceScene scene(mapper);
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(0, 0, Distance);
  camera->SetEyeAngle(8.0);
  scene.window->SetStereoTypeToAnaglyph();
  scene.window->StereoRenderOn();
  scene.Enable();
  double slice[3], seen[3];
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, slice));
  EXPECT_LT(slice[0], -0.5);
  // As the depth of its own picture says.
  scene.painter->SetSlice(nullptr);
  ASSERT_TRUE(scene.painter->GetPlace(100, 100, seen));
  EXPECT_NEAR(slice[0], seen[0], 0.01);
  EXPECT_NEAR(slice[2], seen[2], 0.01);
}

TEST(PaintSlices, ASliceThatHasGoneIsNoSurface)
{
  PaintScene scene;
  scene.renderer->AddActor(BallActor(20.0));
  {
    vtkNew<vtkImageSlice> slice;
    scene.painter->SetSlice(slice);
  }
  scene.Enable();
  EXPECT_TRUE(scene.Drag({ { 100, 100 }, { 110, 100 } }).empty());
  scene.painter->SetSlice(nullptr);
  EXPECT_EQ(scene.Drag({ { 100, 100 }, { 110, 100 } }).size(), 1u);
}

} // namespace
