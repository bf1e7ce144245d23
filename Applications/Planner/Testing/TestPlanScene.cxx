// What is seen of a plan: when it is made, what is under the pointer, and when it goes.
#include "BallsScene.h"

#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkWeakPointer.h"

#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <vector>

namespace hasp::testing
{
namespace
{

/// Colours that are neither black nor the background's: of the middle of the picture.
bool ShowsBone(const QImage& picture, const QPoint& fromLowerLeft)
{
  const QColor pixel =
    picture.pixelColor(fromLowerLeft.x(), picture.height() - 1 - fromLowerLeft.y());
  return pixel.red() > pixel.blue() + 5; // bone is warm, the background is cold
}

TEST_F(PlanSceneOfBalls, NothingIsThereOfAnEmptyPlan)
{
  EXPECT_EQ(this->desk.Props(), 0U);
  EXPECT_EQ(this->desk.scene.ScanProp(), nullptr);
  EXPECT_EQ(this->desk.scene.ShownVolume(), 0U);
  EXPECT_EQ(this->desk.scene.ShownImage(), nullptr);
  EXPECT_FALSE(this->desk.scene.PlaceAt(300, 250));
  this->desk.scene.LookFrom('L');
  this->desk.scene.ShowAll();
  ResourceList list;
  this->desk.scene.ListResources(list);
  ASSERT_FALSE(list.empty());
  for (const ResourceUse& use : list)
    EXPECT_EQ(use.bytes, 0U) << use.resource;
  EXPECT_EQ(this->desk.UseOf("scan's isosurface").reason, "the plan has no scan");
}

TEST_F(PlanSceneOfBalls, WhatIsNotInMemoryIsNotShownUntilItIs)
{
  const PlanId volume = this->desk.Add(PlanVolume{ 0, "", BallsHash });
  this->desk.Add(Component(this->balls.left));
  this->desk.Settle();
  EXPECT_EQ(this->desk.Props(), 0U);
  EXPECT_EQ(this->desk.UseOf("scan's isosurface").reason, "the scan is not in memory");
  EXPECT_EQ(this->desk.UseOf("fragment 2").reason, "its label map or its scan is not there");
  ShelfScan scan;
  scan.image = this->balls.image;
  scan.passport.hash = BallsHash;
  this->desk.scans.Put(scan);
  this->desk.Settle();
  EXPECT_NE(this->desk.scene.PropOf(2), nullptr);
  EXPECT_EQ(this->desk.scene.ShownVolume(), volume);
  EXPECT_EQ(this->desk.refused, QStringList());
}

TEST_F(PlanSceneOfBalls, TheScanIsShownUntilItsFragmentsAre)
{
  QSignalSpy changed(&this->desk.scene, &PlanScene::PropsChanged);
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  EXPECT_GE(changed.count(), 1);
  ASSERT_NE(this->desk.scene.ScanProp(), nullptr);
  EXPECT_TRUE(this->desk.scene.IsVisible(1));
  EXPECT_EQ(this->desk.scene.PropOf(1), this->desk.scene.ScanProp());
  EXPECT_EQ(this->desk.scene.Isovalue(), 226.0);
  const QImage picture = this->desk.Picture("PlanSceneScan");
  EXPECT_TRUE(ShowsBone(picture, this->desk.PixelOf(this->balls.left)));
  EXPECT_TRUE(ShowsBone(picture, this->desk.PixelOf(this->balls.right)));
  EXPECT_FALSE(ShowsBone(picture, { 5, 5 }));

  this->left = this->desk.Add(Component(this->balls.left));
  EXPECT_NE(this->desk.scene.ScanProp(), nullptr); // its fragment is being made
  this->desk.Settle();
  EXPECT_EQ(this->desk.scene.ScanProp(), nullptr);
  EXPECT_FALSE(this->desk.scene.IsVisible(1));
  ASSERT_NE(this->desk.scene.PropOf(this->left), nullptr);
  const QImage one = this->desk.Picture("PlanSceneFragment");
  EXPECT_TRUE(ShowsBone(one, this->desk.PixelOf(this->balls.left)));
  EXPECT_FALSE(ShowsBone(one, this->desk.PixelOf(this->balls.right)));
  this->desk.scene.SetVisible(1, true);
  EXPECT_NE(this->desk.scene.ScanProp(), nullptr);
  this->desk.scene.SetVisible(1, false);
  EXPECT_EQ(this->desk.scene.ScanProp(), nullptr);
}

TEST_F(PlanSceneOfBalls, AMovingIsovalueIsFoundByRaysAndARestingOneByCells)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  QSignalSpy told(&this->desk.scene, &PlanScene::IsovalueChanged);
  const auto mapper = [&] { return this->desk.ActorOf(1)->GetMapper(); };
  EXPECT_TRUE(vtkHaspClusteredCellMapper::SafeDownCast(mapper()));
  EXPECT_EQ(this->desk.UseOf("ray cache").bytes, 0U);

  this->desk.scene.SetIsovalue(400.0, true);
  auto* rays = vtkHaspRayCachingMapper::SafeDownCast(mapper());
  ASSERT_TRUE(rays);
  EXPECT_EQ(rays->GetIsoValue(), 400.0);
  this->desk.view.DrawNow();
  EXPECT_NE(this->desk.UseOf("drawn by").reason, "not listed"); // rays, or what is cheaper
  this->desk.scene.SetIsovalue(500.0, true);
  EXPECT_EQ(mapper(), rays); // the same, with what it has found
  const PlanScene::Place moving = this->Under(this->balls.right);
  EXPECT_NEAR(this->balls.Distance(moving.world), -274.0 / BallValuePerMm, 0.1);

  this->desk.scene.SetIsovalue(500.0, false);
  auto* cells = vtkHaspClusteredCellMapper::SafeDownCast(mapper());
  ASSERT_TRUE(cells);
  EXPECT_EQ(cells->GetIsoValue(), 500.0);
  this->desk.view.DrawNow();
  EXPECT_EQ(this->desk.UseOf("ray cache").reason, "the isovalue rests");
  EXPECT_EQ(this->desk.UseOf("drawn by").reason, "not listed");
  EXPECT_GT(this->desk.UseOf("active cells, host").bytes, 0U);
  EXPECT_EQ(this->desk.scene.Isovalue(), 500.0);
  ASSERT_EQ(told.count(), 2);
  EXPECT_EQ(told.at(1).at(0).toDouble(), 500.0);
}

// A ball's trilinear surface is off by a spacing^2 / 8 radius along each axis: 0.04 mm; samples are
// rounded to 0.005 mm. A tenth of a voxel is 0.1 mm.
TEST_F(PlanSceneOfBalls, PlacesAreOnTheClosedFormsSurface)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  const auto check = [&](PlanId object, const glm::dvec3& moved)
  {
    const glm::dvec3 seen = this->balls.right + moved;
    int met = 0;
    for (const glm::dvec3& aside :
      { glm::dvec3(0), glm::dvec3(5, 0, 0), glm::dvec3(-3, 0, 6), glm::dvec3(2, 0, -7) })
    {
      const PlanScene::Place place = this->Under(seen + aside);
      EXPECT_EQ(place.object, object);
      EXPECT_NEAR(glm::distance(place.world, seen), this->balls.rightRadius, 0.1);
      EXPECT_NEAR(this->balls.Distance(place.inScan), 0.0, 0.1);
      const glm::dvec3 normal = glm::normalize(place.world - seen);
      EXPECT_GT(glm::dot(place.normal, normal), std::cos(0.07)); // cells of 1 mm on a radius of 10
      EXPECT_LT(place.world.y, seen.y); // seen from the front, not from behind
      met += place.object == object;
    }
    EXPECT_EQ(met, 4);
  };
  check(0, {});
  this->right = this->desk.Add(Component(this->balls.right));
  this->desk.Settle();
  check(this->right, {});
  const PlanPose pose{ { 3, -4, 5 }, glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 1, 0))) };
  this->desk.plan.Do(PoseFragments{ { { this->right, pose } } });
  this->desk.scene.LookFrom('A');
  check(this->right, pose.Place(this->balls.right) - this->balls.right);
  const PlanScene::Place place = this->Under(pose.Place(this->balls.right));
  EXPECT_LT(glm::distance(pose.Place(place.inScan), place.world), 1e-6);
}

TEST_F(PlanSceneOfBalls, WhatThePlanHasNoMoreIsReleased)
{
  this->AddBalls();
  this->desk.Add(CutAt(0.0, this->left));
  this->desk.Add(PlanMeasure{ 0, "", MeasureKind::Distance, { {}, { 0, { 1, 2, 3 } } } });
  this->desk.view.DrawNow();
  std::vector<vtkWeakPointer<vtkProp3D>> props;
  for (PlanId id = 2; id <= 5; ++id)
    props.emplace_back(this->desk.scene.PropOf(id));
  for (const auto& prop : props)
    ASSERT_NE(prop.Get(), nullptr);
  while (this->desk.plan.Document().history.ToUndo())
    this->desk.plan.Undo();
  for (const auto& prop : props)
    EXPECT_EQ(prop.Get(), nullptr);
  EXPECT_EQ(this->desk.Props(), 0U);
  ResourceList list;
  this->desk.scene.ListResources(list);
  for (const ResourceUse& use : list)
    EXPECT_EQ(use.bytes, 0U) << use.resource;
}

TEST_F(PlanSceneOfBalls, AnotherPlanBeginsAnew)
{
  this->AddBalls();
  this->desk.scene.Select(this->left);
  this->desk.scene.SetVisible(this->right, false);
  this->desk.scene.SetIsovalue(300.0);
  this->desk.plan.BeginNew();
  EXPECT_EQ(this->desk.Props(), 0U);
  EXPECT_EQ(this->desk.scene.Selected(), 0U);
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Add(Component(this->balls.right)); // 2: was the left one
  this->desk.Settle();
  EXPECT_EQ(this->desk.scene.Isovalue(), 226.0);
  EXPECT_EQ(this->Under(this->balls.right).object, 2U);
}

TEST_F(PlanSceneOfBalls, TheSelectedGlowsAndARemovedOneIsNoLongerSelected)
{
  this->AddBalls();
  QSignalSpy told(&this->desk.scene, &PlanScene::SelectedChanged);
  const QPoint at = this->desk.PixelOf(this->balls.left);
  const auto shade = [&](const char* name)
  {
    const QImage picture = this->desk.Picture(name);
    return picture.pixelColor(at.x(), picture.height() - 1 - at.y());
  };
  const QColor before = shade("PlanSceneBalls");
  this->desk.scene.Select(this->left);
  const QColor selected = shade("PlanSceneSelected");
  EXPECT_GT(selected.red(), before.red());
  EXPECT_LT(selected.blueF() / selected.redF(), before.blueF() / before.redF());
  this->desk.scene.Select(this->left);
  EXPECT_EQ(told.count(), 1);
  this->desk.plan.Undo(); // the right one
  this->desk.plan.Undo();
  EXPECT_EQ(this->desk.scene.Selected(), 0U);
  EXPECT_EQ(told.count(), 2);
}

} // namespace
} // namespace hasp::testing
