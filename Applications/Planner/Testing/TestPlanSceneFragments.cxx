// Fragments of a plan in its scene.
#include "BallsScene.h"

#include "Planning/PlanLists.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkWeakPointer.h"

#include <QSignalSpy>

#include <glm/geometric.hpp>

namespace hasp::testing
{
namespace
{

TEST_F(PlanSceneOfBalls, FragmentsFollowTheirPosesAndNothingIsMadeAnew)
{
  this->AddBalls();
  vtkImageData* image = this->desk.scene.ImageOfFragment(this->left);
  vtkActor* actor = this->desk.ActorOf(this->left);
  ASSERT_TRUE(image && actor);
  EXPECT_EQ(vtkHaspClusteredCellMapper::SafeDownCast(actor->GetMapper())->GetImage(), image);
  EXPECT_NE(this->desk.scene.ImageOfFragment(this->right), image);
  QSignalSpy jobs(&this->desk.jobs, &JobQueue::Began);
  const PlanPose pose{ { 0, 0, 30 }, glm::angleAxis(0.5, glm::dvec3(0, 0, 1)) };
  this->desk.plan.Do(PoseFragments{ { { this->left, pose } } });
  const auto expectAt = [&](const PlanPose& at)
  {
    vtkMatrix4x4* matrix = actor->GetMatrix();
    const double from[4] = { 1.0, 2.0, 3.0, 1.0 };
    double to[4];
    matrix->MultiplyPoint(from, to);
    EXPECT_LT(glm::distance(at.Place({ 1, 2, 3 }), glm::dvec3(to[0], to[1], to[2])), 1e-12);
  };
  expectAt(pose);
  this->desk.plan.Undo();
  expectAt({});
  this->desk.plan.Redo();
  expectAt(pose);
  // A hand moves it: it stays there until the plan says otherwise.
  vtkNew<vtkMatrix4x4> hand;
  hand->SetElement(0, 3, 7.0);
  actor->SetUserMatrix(hand);
  this->desk.scene.Select(this->left);
  expectAt({ { 7, 0, 0 } });
  this->desk.plan.Undo();
  expectAt({});
  EXPECT_EQ(this->desk.ActorOf(this->left), actor);
  EXPECT_EQ(this->desk.scene.ImageOfFragment(this->left), image);
  this->desk.Settle();
  EXPECT_EQ(jobs.count(), 0);
}

TEST_F(PlanSceneOfBalls, ACutBonesPiecesAreShownApartWithPlaneFaces)
{
  this->AddBalls();
  vtkImageData* whole = this->desk.scene.ImageOfFragment(this->left);
  this->CutLeft();
  EXPECT_NE(this->desk.scene.PropOf(this->left), nullptr); // until its pieces are there
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused, QStringList());
  EXPECT_EQ(this->desk.scene.PropOf(this->left), nullptr);
  ASSERT_NE(this->desk.scene.PropOf(this->back), nullptr);
  ASSERT_NE(this->desk.scene.PropOf(this->front), nullptr);
  EXPECT_NE(
    this->desk.scene.ImageOfFragment(this->back), this->desk.scene.ImageOfFragment(this->front));
  this->desk.scene.SetVisible(this->cut, false);
  this->desk.plan.Do(PoseFragments{ { { this->front, { { 20, 0, 0 } } } } });
  this->desk.scene.LookFrom('R'); // onto the face of what was moved away, behind the other half
  this->desk.scene.SetVisible(this->back, false);
  this->desk.Picture("PlanSceneSawn");
  for (const glm::dvec3& aside : { glm::dvec3(0), glm::dvec3(0, 5, 3), glm::dvec3(0, -7, 2) })
  {
    const PlanScene::Place place = this->Under(this->balls.left + glm::dvec3(20.5, 0, 0) + aside);
    EXPECT_EQ(place.object, this->front);
    // Bone's values differ from sample to sample: by 100 a mm of up to 1,200.
    EXPECT_NEAR(place.inScan.x, this->balls.left.x + 0.5, 0.1);
    EXPECT_GT(-place.normal.x, std::cos(0.2));
  }
  this->desk.scene.SetVisible(this->back, true);
  // Undone: the whole as it was, and no piece.
  vtkWeakPointer<vtkProp3D> piece = this->desk.scene.PropOf(this->front);
  this->desk.plan.Undo(); // the pose
  this->desk.plan.Undo(); // the pieces
  EXPECT_EQ(this->desk.scene.ImageOfFragment(this->left), whole);
  EXPECT_NE(this->desk.scene.PropOf(this->left), nullptr);
  EXPECT_EQ(this->desk.scene.PropOf(this->front), nullptr);
  EXPECT_EQ(piece.Get(), nullptr);
}

TEST_F(PlanSceneOfBalls, WhatIsHiddenIsNotMade)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->left = this->desk.plan.NewId();
  this->desk.scene.SetVisible(this->left, false);
  this->desk.scene.SetVisible(1, false);
  this->desk.Add(Component(this->balls.left));
  this->desk.Add(CutAt(this->balls.left.x, this->left));
  this->desk.scene.SetVisible(3, false);
  PlanMirror mirror;
  mirror.volume = 1;
  this->desk.scene.SetVisible(4, false);
  this->desk.Add(mirror);
  this->desk.Add(PlanMeasure{ 0, "", MeasureKind::Distance, { {}, { 0, { 1, 2, 3 } } } });
  this->desk.scene.SetVisible(5, false);
  QSignalSpy jobs(&this->desk.jobs, &JobQueue::Began);
  this->desk.Settle();
  EXPECT_EQ(jobs.count(), 0);
  EXPECT_EQ(this->desk.scene.ImageOfFragment(this->left), nullptr);
  for (const char* called : { "fragment 2", "mirror 4" })
  {
    EXPECT_EQ(this->desk.UseOf(called).bytes, 0U);
    EXPECT_EQ(this->desk.UseOf(called).reason, "hidden") << called;
  }
  for (PlanId id = 1; id <= 5; ++id)
    EXPECT_EQ(this->desk.scene.PropOf(id), nullptr) << id;
  this->desk.scene.SetVisible(this->left, true);
  this->desk.Settle();
  EXPECT_EQ(jobs.count(), 1);
  EXPECT_NE(this->desk.scene.PropOf(this->left), nullptr);
  // Hidden again it is kept, off the graphics card.
  this->desk.view.DrawNow();
  EXPECT_GT(this->desk.UseOf("fragment 2, active cells, host").bytes, 0U);
  this->desk.scene.SetVisible(this->left, false);
  EXPECT_EQ(this->desk.scene.PropOf(this->left), nullptr);
  EXPECT_EQ(this->desk.UseOf("fragment 2, active cells, GPU").bytes, 0U);
  this->desk.scene.SetVisible(this->left, true);
  this->desk.Settle();
  EXPECT_EQ(jobs.count(), 1);
}

TEST_F(PlanSceneOfBalls, ResectedAndLockedFragmentsLookSo)
{
  this->AddBalls();
  this->desk.plan.Do(SetFragmentState{ { this->left } });
  EXPECT_LT(this->desk.ActorOf(this->left)->GetProperty()->GetOpacity(), 0.5);
  const double* red = this->desk.ActorOf(this->left)->GetProperty()->GetDiffuseColor();
  EXPECT_GT(red[0], red[1] + 0.2);
  PlanFragment locked = *FindPlanObject<PlanFragment>(this->desk.plan.Now(), this->right);
  locked.locked = true;
  locked.colour = { 0, 255, 0 };
  this->desk.plan.Do(ChangeObject<PlanFragment>{ locked });
  const double* green = this->desk.ActorOf(this->right)->GetProperty()->GetDiffuseColor();
  EXPECT_GT(green[1], 0.8);
  EXPECT_GT(green[2], 0.1);
  this->desk.Picture("PlanSceneResected");
  EXPECT_EQ(this->Under(this->balls.left).object, this->left); // and can be picked
}

TEST_F(PlanSceneOfBalls, APieceThatIsNotThereIsToldOnceAndTheOthersAreShown)
{
  this->AddBalls();
  this->CutLeft();
  const PlanId lost = this->desk.Add(PieceOf(this->left, { 0, 80, 0 }));
  this->desk.Settle();
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].startsWith(QString("fragment %1: source.seed is").arg(lost)))
    << this->desk.refused[0].toStdString();
  EXPECT_NE(this->desk.scene.PropOf(this->back), nullptr);
  EXPECT_EQ(this->desk.scene.PropOf(lost), nullptr);
  this->desk.plan.Do(RenameObject{ this->back, "x" });
  this->desk.Settle();
  EXPECT_EQ(this->desk.refused.size(), 1);
}

TEST_F(PlanSceneOfBalls, AJobThatWasGivenUpIsBegunAgainByTheNextChange)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->left = this->desk.Add(Component(this->balls.left));
  this->desk.jobs.CancelAll();
  this->desk.Settle();
  EXPECT_EQ(this->desk.scene.PropOf(this->left), nullptr);
  EXPECT_NE(this->desk.scene.ScanProp(), nullptr);
  this->desk.plan.Do(RenameObject{ this->left, "x" });
  this->desk.Settle();
  EXPECT_NE(this->desk.scene.PropOf(this->left), nullptr);
}

TEST_F(PlanSceneOfBalls, ASurfaceIsShownOnceItsTrianglesAreThere)
{
  const std::string hash(64, 'c');
  const PlanId surface = this->desk.Add(PlanSurface{ 0, "", hash });
  PlanFragment fragment;
  fragment.source = SurfaceSource{ surface };
  fragment.scanToPlanned.position = { 5, 0, 0 };
  const PlanId sherd = this->desk.Add(fragment);
  this->desk.Settle();
  EXPECT_EQ(this->desk.scene.PropOf(sherd), nullptr);
  EXPECT_EQ(this->desk.UseOf("fragment 2").reason, "its surface is not in memory");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(10.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->Update();
  this->desk.scene.PutSurface(hash, sphere->GetOutput());
  this->desk.Settle();
  ASSERT_NE(this->desk.scene.PropOf(sherd), nullptr);
  const PlanScene::Place place = this->Under({ 5, 0, 0 });
  EXPECT_EQ(place.object, sherd);
  EXPECT_NEAR(glm::length(place.inScan), 10.0, 0.05); // of 60 facets around
  EXPECT_NEAR(place.world.x - place.inScan.x, 5.0, 1e-9);
  EXPECT_GT(this->desk.UseOf("fragment 2, tree of picks").bytes, 0U);
}

} // namespace
} // namespace hasp::testing
