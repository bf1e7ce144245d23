// What else a plan holds in its scene: blades, measures, ghosts, label maps, surfaces; and views of
// it.
#include "BallsScene.h"

#include "vtkHaspLabelFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkActor2DCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <QFile>
#include <QSignalSpy>

#include <glm/geometric.hpp>

namespace hasp::testing
{
namespace
{

TEST_F(PlanSceneOfBalls, LooksFromEachSideOnWhatIsShown)
{
  this->AddBalls();
  this->desk.scene.SetVisible(this->left, false);
  struct From
  {
    char side;
    glm::dvec3 towards;
  };
  for (const From& from :
    { From{ 'A', { 0, -1, 0 } }, From{ 'P', { 0, 1, 0 } }, From{ 'L', { 1, 0, 0 } },
      From{ 'R', { -1, 0, 0 } }, From{ 'S', { 0, 0, 1 } }, From{ 'I', { 0, 0, -1 } } })
  {
    this->desk.scene.LookFrom(from.side);
    const PlanScene::Place place = this->Under(this->balls.right);
    EXPECT_EQ(place.object, this->right);
    EXPECT_GT(glm::dot(glm::normalize(place.world - this->balls.right), from.towards), 0.9)
      << from.side;
    // All of it is seen, and it fills the picture: its rim is near the edge.
    const QPoint middle = this->desk.PixelOf(this->balls.right);
    EXPECT_LT(std::abs(middle.x() - 300), 40);
    EXPECT_LT(std::abs(middle.y() - 250), 40);
    int above = 0;
    while (this->desk.scene.PlaceAt(middle.x(), middle.y() + above) && above < 250)
      ++above;
    EXPECT_GT(above, 100) << from.side;
    EXPECT_LT(above, 240) << from.side;
  }
}

TEST_F(PlanSceneOfBalls, ABladeIsSeenThroughAndIsItsBox)
{
  this->AddBalls();
  this->cut = this->desk.Add(CutAt(-30.0, this->left));
  this->desk.Settle();
  ASSERT_NE(this->desk.scene.PropOf(this->cut), nullptr);
  const double opacity = this->desk.ActorOf(this->cut)->GetProperty()->GetOpacity();
  EXPECT_LT(opacity, 0.5);
  const double* bounds = this->desk.ActorOf(this->cut)->GetBounds();
  const double expected[6] = { -30.5, -29.5, -30.0, 30.0, -30.0, 30.0 };
  for (int n = 0; n < 6; ++n)
    EXPECT_NEAR(bounds[n], expected[n], 1e-9) << n;
  this->desk.scene.LookFrom('R'); // it stands before the left ball, from here
  EXPECT_EQ(this->Under(this->balls.left).object, this->left);
  this->desk.scene.Select(this->cut);
  EXPECT_GT(this->desk.ActorOf(this->cut)->GetProperty()->GetOpacity(), opacity);
  PlanCut moved = CutAt(this->balls.left.x, this->left);
  moved.id = this->cut;
  this->desk.plan.Do(ChangeObject<PlanCut>{ moved });
  EXPECT_NEAR(this->desk.ActorOf(this->cut)->GetBounds()[0], -16.5, 1e-9);
  this->desk.view.Renderer()->GetActiveCamera()->Azimuth(50.0);
  this->desk.Picture("PlanSceneBlade");
}

/// What is written over the view.
std::string TextIn(SceneDesk& desk)
{
  vtkActor2DCollection* all = desk.view.Renderer()->GetActors2D();
  all->InitTraversal();
  while (vtkActor2D* actor = all->GetNextActor2D())
    if (auto* text = vtkTextActor::SafeDownCast(actor); text && text->GetVisibility())
      return text->GetInput();
  return {};
}

TEST_F(PlanSceneOfBalls, AMeasureSaysItsValueAndFollowsItsFragments)
{
  this->AddBalls();
  const glm::dvec3 a(-16, -12, 0), b(15, -7, 0);
  PlanMeasure measure{ 0, "", MeasureKind::Distance, { { this->left, a }, { this->right, b } } };
  const PlanId length = this->desk.Add(measure);
  this->desk.Settle();
  EXPECT_EQ(TextIn(this->desk), QString("%1 mm").arg(glm::distance(a, b), 0, 'f', 2).toStdString());
  EXPECT_NE(this->desk.scene.PropOf(length), nullptr);
  this->desk.Picture("PlanSceneMeasure");
  const glm::dvec3 shift(0, 0, 12);
  this->desk.plan.Do(PoseFragments{ { { this->right, { shift } } } });
  const std::string moved =
    QString("%1 mm").arg(glm::distance(a, b + shift), 0, 'f', 2).toStdString();
  EXPECT_EQ(TextIn(this->desk), moved);
  vtkNew<vtkMatrix4x4> hand; // before it is a step of the plan
  hand->SetElement(0, 3, 31.0);
  this->desk.ActorOf(this->right)->SetUserMatrix(hand);
  this->desk.view.DrawNow();
  EXPECT_EQ(TextIn(this->desk),
    QString("%1 mm").arg(glm::distance(a, b + glm::dvec3(31, 0, 0)), 0, 'f', 2).toStdString());
  this->desk.scene.SetVisible(length, false);
  EXPECT_EQ(TextIn(this->desk), "");
}

TEST_F(PlanSceneOfBalls, AnAngleIsMeasuredAtItsSecondPoint)
{
  this->desk.Add(PlanMeasure{
    0, "", MeasureKind::Angle, { { 0, { 20, 0, 0 } }, { 0, { 0, 0, 0 } }, { 0, { 10, 0, 10 } } } });
  this->desk.Settle();
  EXPECT_EQ(TextIn(this->desk), "45.0 deg");
  this->desk.Picture("PlanSceneAngle");
}

// Mirrored at a plane between the balls: each lies where the other's place is mirrored. Of a grid
// of 1 mm the box is within a spacing.
TEST_F(PlanSceneOfBalls, AGhostLiesMirroredAndIsMadeOnce)
{
  this->AddBalls();
  PlanMirror mirror;
  mirror.fragments = { this->right };
  mirror.plane = MirrorPlane{ { 0, 0, 0 }, { 1, 0, 0 } };
  const PlanId ghost = this->desk.Add(mirror);
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused, QStringList());
  vtkActor* actor = this->desk.ActorOf(ghost);
  ASSERT_NE(actor, nullptr);
  EXPECT_LT(actor->GetProperty()->GetOpacity(), 0.5);
  const glm::dvec3 middle(-this->balls.right.x, this->balls.right.y, this->balls.right.z);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(actor->GetBounds()[2 * axis], middle[axis] - this->balls.rightRadius, 1.0);
    EXPECT_NEAR(actor->GetBounds()[2 * axis + 1], middle[axis] + this->balls.rightRadius, 1.0);
  }
  this->desk.Picture("PlanSceneGhost");
  QSignalSpy jobs(&this->desk.jobs, &JobQueue::Began);
  this->desk.plan.Do(RenameObject{ ghost, "ghost" });
  this->desk.plan.Do(PoseFragments{ { { this->right, { { 9, 0, 0 } } } } });
  this->desk.Settle();
  EXPECT_EQ(jobs.count(), 0);
  EXPECT_EQ(this->desk.ActorOf(ghost), actor);
  mirror.id = ghost;
  mirror.fragments = { this->left };
  this->desk.plan.Do(ChangeObject<PlanMirror>{ mirror });
  this->desk.Settle();
  EXPECT_NEAR(this->desk.ActorOf(ghost)->GetBounds()[1], 28.0, 1.0);
}

TEST_F(PlanSceneOfBalls, WhatCannotBeMirroredIsTold)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  PlanMirror mirror;
  mirror.volume = 1;
  mirror.isovalue = 30'000.0;
  const PlanId ghost = this->desk.Add(mirror);
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].startsWith("mirror 2: "))
    << this->desk.refused[0].toStdString();
  EXPECT_EQ(this->desk.scene.PropOf(ghost), nullptr);
}

/// A label map of the balls' scan, as bytes of a .nrrd: label 1 is what is right of 0.
std::string LabelBytes(const TwoBalls& balls, const QString& folder)
{
  std::vector<std::uint16_t> labels(balls.grid.Size());
  std::size_t n = 0;
  for (int k = 0; k < balls.grid.dims.z; ++k)
    for (int j = 0; j < balls.grid.dims.y; ++j)
      for (int i = 0; i < balls.grid.dims.x; ++i)
        labels[n++] = balls.grid.IndexToWorld({ i, j, k }).x > 0.0 ? 1 : 2;
  const QString path = folder + "/test.nrrd";
  WriteLabels(MakeImage(balls.grid, labels), {}, path.toStdString());
  QFile file(path);
  file.open(QIODevice::ReadOnly);
  return file.readAll().toStdString();
}

TEST_F(PlanSceneOfBalls, LabelsAreShownOfTheMapThatThePlanKeeps)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  const std::string blob =
    this->desk.plan.StoreBlob(LabelBytes(this->balls, this->desk.folder.path()));
  const PlanId segmentation = this->desk.Add(PlanSegmentation{ 0, "", 1, blob, {} });
  PlanFragment fragment;
  fragment.source = LabelSource{ segmentation, 1, 226.0, 1.0 };
  const PlanId one = this->desk.Add(fragment);
  fragment.source = LabelSource{ segmentation, 7, 226.0, 1.0 };
  const PlanId none = this->desk.Add(fragment);
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].startsWith(QString("fragment %1: no bone is left").arg(none)));
  EXPECT_EQ(this->Under(this->balls.right).object, one);
  EXPECT_NEAR(this->balls.Distance(this->Under(this->balls.right).world), 0.0, 0.1);
  EXPECT_GT(this->desk.UseOf("label map " + blob.substr(0, 8)).bytes, 0U);
  // A recipe's step: the map must be made anew, and is not yet.
  this->desk.plan.Do(AddSegmentationStep{ segmentation, ThresholdStep{} });
  this->desk.Settle();
  EXPECT_EQ(this->desk.UseOf("label map " + blob.substr(0, 8)).reason, "not listed");
  EXPECT_NE(this->desk.scene.PropOf(one), nullptr); // what was there stays meanwhile
}

TEST_F(PlanSceneOfBalls, ADamagedLabelMapIsTold)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  const std::string blob = this->desk.plan.StoreBlob("no label map");
  const PlanId segmentation = this->desk.Add(PlanSegmentation{ 0, "", 1, blob, {} });
  PlanFragment fragment;
  fragment.source = LabelSource{ segmentation, 1, 226.0, 1.0 };
  const PlanId one = this->desk.Add(fragment);
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].startsWith("fragment 3: "))
    << this->desk.refused[0].toStdString();
  EXPECT_FALSE(this->desk.refused[0].contains(this->desk.folder.path()));
  EXPECT_EQ(this->desk.scene.PropOf(one), nullptr);
}

} // namespace
} // namespace hasp::testing
