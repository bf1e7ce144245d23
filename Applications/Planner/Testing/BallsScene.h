#pragma once
#include "SceneDesk.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

namespace hasp::testing
{

/// Two balls of bone as a plan.
class PlanSceneOfBalls : public ::testing::Test
{
protected:
  void AddBalls()
  {
    this->desk.AddScan(this->balls.image, BallsHash); // 1
    this->left = this->desk.Add(Component(this->balls.left));
    this->right = this->desk.Add(Component(this->balls.right));
    this->desk.Settle();
  }
  /// Cuts the left ball at its middle.
  void CutLeft()
  {
    this->cut = this->desk.Add(CutAt(this->balls.left.x, this->left));
    const PlanId first = this->desk.plan.NewId();
    PlanFragment back = PieceOf(this->left, this->balls.left - glm::dvec3(6, 0, 0));
    PlanFragment front = PieceOf(this->left, this->balls.left + glm::dvec3(6, 0, 0));
    back.id = first;
    front.id = first + 1;
    this->desk.plan.Do({ AddObject<PlanFragment>{ back }, AddObject<PlanFragment>{ front } });
    this->back = back.id;
    this->front = front.id;
  }
  /// What is under the middle of a ball as it is seen now.
  PlanScene::Place Under(const glm::dvec3& middle)
  {
    const QPoint at = this->desk.PixelOf(middle);
    const auto place = this->desk.scene.PlaceAt(at.x(), at.y());
    EXPECT_TRUE(place.has_value());
    return place.value_or(PlanScene::Place{ 0, {}, {}, {} });
  }

  SceneDesk desk;
  TwoBalls balls;
  PlanId left = 0, right = 0, cut = 0, back = 0, front = 0;
};

} // namespace hasp::testing
