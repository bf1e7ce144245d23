// The plan that the repository has of its phantom, in its scene, with its parts.
#include "SceneDesk.h"

#include "Evaluation/TrilinearTruth.h"
#include "Grid/Phantom.h"
#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <QFile>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>

namespace hasp::testing
{
namespace
{

constexpr PlanId Jaw = 2, FrontCut = 3, LeftJaw = 5, RightRamus = 6, Tumour = 7, Guide = 8;

std::vector<PlanEdit> EditsOfThePhantom()
{
  QFile file(HASP_PLAN_EDITS);
  file.open(QIODevice::ReadOnly);
  return ParseEdits(file.readAll().toStdString());
}

/// A tetrahedron as STL.
std::string SomeStl(float size)
{
  const float corners[4][3] = { { 0, -90, -95 }, { size, -90, -95 }, { 0, -90 - size, -95 },
    { 0, -90, -95 + size } };
  const int sides[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  std::string bytes(80, ' ');
  const std::uint32_t count = 4;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& side : sides)
  {
    bytes.append(12, '\0');
    for (const int corner : side)
      bytes.append(reinterpret_cast<const char*>(corners[corner]), 12);
    bytes.append(2, '\0');
  }
  return bytes;
}

class PlanSceneOfThePhantom : public ::testing::Test
{
protected:
  PlanSceneOfThePhantom()
  {
    const std::vector<PlanEdit> edits = EditsOfThePhantom();
    this->desk.plan.Do(edits);
    ShelfScan scan;
    scan.image = MakeImage(this->grid, this->samples);
    scan.passport.hash = this->desk.plan.Now().volumes.front().hash;
    scan.passport.hounsfield = true;
    this->desk.scans.Put(scan);
    this->desk.Settle();
  }
  void KeepGuide(const std::string& bytes)
  {
    DerivedPart part;
    part.object = Guide;
    part.inputs = PartInputs(this->desk.plan.Now(), Guide);
    part.bytes = this->desk.plan.StoreBlob(bytes);
    this->desk.plan.KeepMade(part);
    this->desk.Settle();
  }

  void ExpectPicksOnTheScan();

  SceneDesk desk;
  GridGeometry grid = PhantomGrid({ 1, 1, 1 });
  std::vector<std::int16_t> samples = SamplePhantom(this->grid);
};

// Bone that is all of one fragment is drawn and picked as the scan's own trilinear surface, which
// is found in another way (FirstTrilinearHit) along the normal of the place: a tenth of a voxel at
// most.
void PlanSceneOfThePhantom::ExpectPicksOnTheScan()
{
  this->desk.scene.LookFrom('L');
  int met = 0;
  const GridView<const std::int16_t> scan{ this->samples.data(), this->grid };
  for (int y = 100; y < 400; y += 29)
    for (int x = 100; x < 500; x += 31)
    {
      const auto place = this->desk.scene.PlaceAt(x, y);
      if (!place || place->object != LeftJaw)
        continue;
      const glm::dvec3 out = 2.0 * place->normal; // before it, where there is no other bone
      const auto judge = FirstTrilinearHit(scan, 226.0, place->inScan + out, -out);
      ASSERT_TRUE(judge.has_value());
      EXPECT_LT(glm::distance(judge->position, place->inScan), 0.1);
      ++met;
    }
  EXPECT_GT(met, 10);
}

// The whole plan: pieces, one resected, blades; a guide that is made, goes out of date, and comes
// back; a damaged one.
TEST_F(PlanSceneOfThePhantom, ItsPiecesAndItsGuideAreThere)
{
  ASSERT_EQ(this->desk.refused, QStringList());
  this->desk.Picture("PlanScenePhantomA");
  this->desk.scene.LookFrom('R');
  this->desk.Picture("PlanScenePhantomR");
  EXPECT_EQ(this->desk.scene.ScanProp(), nullptr);
  EXPECT_EQ(this->desk.scene.PropOf(Jaw), nullptr);
  for (const PlanId piece : { LeftJaw, RightRamus, Tumour })
    ASSERT_NE(this->desk.scene.PropOf(piece), nullptr) << piece;
  EXPECT_LT(this->desk.ActorOf(Tumour)->GetProperty()->GetOpacity(), 0.5);
  EXPECT_EQ(this->desk.ActorOf(LeftJaw)->GetProperty()->GetOpacity(), 1.0);
  EXPECT_EQ(this->desk.scene.PropOf(Guide), nullptr);
  EXPECT_EQ(this->desk.UseOf("guide 8").reason, "it has not been made");
  this->ExpectPicksOnTheScan();

  this->KeepGuide(SomeStl(20.0F));
  ASSERT_NE(this->desk.scene.PropOf(Guide), nullptr);
  EXPECT_EQ(this->desk.ActorOf(Guide)->GetProperty()->GetOpacity(), 1.0);
  this->desk.scene.ShowAll();
  this->desk.Picture("PlanScenePhantomGuide");
  PlanCut cut = *FindPlanObject<PlanCut>(this->desk.plan.Now(), FrontCut);
  cut.blade.kerfMm = 1.2;
  this->desk.plan.Do(ChangeObject<PlanCut>{ cut });
  EXPECT_LT(this->desk.ActorOf(Guide)->GetProperty()->GetOpacity(), 0.5);
  EXPECT_NE(this->desk.scene.PropOf(LeftJaw), nullptr); // the old pieces, until the new are there
  this->desk.plan.Undo();
  EXPECT_EQ(this->desk.ActorOf(Guide)->GetProperty()->GetOpacity(), 1.0);
  vtkActor* before = this->desk.ActorOf(Guide);
  this->KeepGuide("no mesh");
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].startsWith("guide 8 cannot be shown: "))
    << this->desk.refused[0].toStdString();
  EXPECT_EQ(this->desk.ActorOf(Guide), before); // as out of date
  EXPECT_LT(this->desk.ActorOf(Guide)->GetProperty()->GetOpacity(), 0.5);
}

} // namespace
} // namespace hasp::testing
