// What is in memory of scans and surfaces: what the plan names, and no more.
#include "StepsDesk.h"

#include "Grid/TriangleMesh.h"
#include "Steps/SurfaceShelf.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

using namespace hasp;
using namespace hasp::testing;

namespace
{

const std::string Named(64, 'a'), Other(64, 'b');

SurfaceShelf::Mesh Tetrahedron()
{
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->points = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, { 0, 0, 10 } };
  mesh->triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  return mesh;
}

TEST(ScanShelf, KeepsWhatThePlanNamesAndNothingElse)
{
  StepsDesk desk(ScanOfBar()); // volume 1
  const std::string bar = desk.Now().volumes.at(0).hash;
  ShelfScan other;
  other.image = ScanOfBar();
  other.passport.hash = Other;
  ScanShelf& shelf = desk.planner.scans;
  shelf.Put(other);
  ASSERT_TRUE(shelf.Find(bar) && shelf.Find(Other));
  shelf.KeepOnly(desk.Now());
  EXPECT_TRUE(shelf.Find(bar));
  EXPECT_TRUE(shelf.OfVolume(desk.Now(), 1));
  EXPECT_TRUE(shelf.Missing(desk.Now()).empty());
  EXPECT_FALSE(shelf.Find(Other));
}

TEST(SurfaceShelf, KeepsWhatThePlanNamesAndNothingElse)
{
  StepsDesk desk(ScanOfBar());
  SurfaceShelf& shelf = SurfaceShelf::Of(desk.planner);
  desk.planner.plan.Do(AddObject<PlanSurface>{ { desk.planner.plan.NewId(), "", Named } });
  shelf.Put(Named, Tetrahedron());
  shelf.Put(Other, Tetrahedron());
  shelf.KeepOnly(desk.Now());
  EXPECT_TRUE(shelf.Find(Named));
  EXPECT_TRUE(shelf.Missing(desk.Now()).empty());
  EXPECT_FALSE(shelf.Find(Other));
  desk.planner.plan.BeginNew(); // another plan
  EXPECT_FALSE(shelf.Find(Named));
}

} // namespace
