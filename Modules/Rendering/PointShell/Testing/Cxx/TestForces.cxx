#include "DiscScene.h"
#include "vtkHaspForceArrows.h"

#include "vtkDoubleArray.h"
#include "vtkMapper.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

namespace
{

struct Arrows
{
  vtkNew<vtkHaspForceArrows> Actor;
  hasp::testing::DiscScene Scene;

  Arrows()
  {
    this->Scene.Hear(this->Actor);
    this->Scene.Renderer->AddActor(this->Actor);
  }
  int Lit()
  {
    int lit = 0;
    for (const glm::ivec3& color : this->Scene.Colors())
      lit += color != glm::ivec3(0);
    return lit;
  }
  /// An arrow along x from the origin: how far it reaches.
  double Reach() { return this->Actor->GetBounds()[1]; }
};

TEST(ForceArrows, NothingIsMadeWhileThereIsNone)
{
  Arrows arrows;
  EXPECT_EQ(arrows.Lit(), 0);
  EXPECT_EQ(arrows.Actor->GetMapper(), nullptr);
  arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 0, 0, 0 } } }); // a force of 0 has no direction
  EXPECT_EQ(arrows.Lit(), 0);
  EXPECT_EQ(arrows.Actor->GetMapper(), nullptr);
  arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 0, 2, 0 } } });
  EXPECT_GT(arrows.Lit(), 100);
  arrows.Actor->SetArrows({});
  EXPECT_EQ(arrows.Actor->GetMapper(), nullptr);
  EXPECT_EQ(arrows.Lit(), 0);
  EXPECT_TRUE(arrows.Scene.Errors.empty());
}

TEST(ForceArrows, AreAsLongAsTheirForces)
{
  Arrows arrows;
  arrows.Actor->SetMmPerNewton(4.0);
  arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 2, 0, 0 } } });
  EXPECT_NEAR(arrows.Reach(), 8.0, 1e-5);
  EXPECT_NEAR(arrows.Actor->GetBounds()[3], 0.8, 1e-5); // the head is a fifth across
  EXPECT_NEAR(arrows.Actor->GetBounds()[0], 0.0, 1e-5); // and nothing is behind the point
  arrows.Actor->SetMmPerNewton(1.0);
  EXPECT_NEAR(arrows.Reach(), 2.0, 1e-5);
  arrows.Actor->SetMaximumMm(1.5);
  EXPECT_NEAR(arrows.Reach(), 1.5, 1e-5);
  arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 1, 0, 0 } } }); // below the cap
  EXPECT_NEAR(arrows.Reach(), 1.0, 1e-5);
  arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 1, 0, 0 } }, { { 5, 5, -5 }, { 0, 0, -3 } } });
  EXPECT_EQ(arrows.Actor->GetNumberOfArrows(), 2);
  EXPECT_NEAR(arrows.Actor->GetBounds()[4], -5.0 - 1.5, 1e-5);
  EXPECT_TRUE(arrows.Scene.Errors.empty());
}

TEST(ForceArrows, WhatIsNotFiniteIsRefused)
{
  for (const double bad : { double(NAN), double(INFINITY) })
  {
    Arrows arrows;
    arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 1, 0, 0 } } });
    arrows.Actor->SetArrows({ { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 0 }, { 0, bad, 0 } } });
    EXPECT_EQ(arrows.Actor->GetMapper(), nullptr);
    EXPECT_EQ(arrows.Actor->GetNumberOfArrows(), 0);
    ASSERT_EQ(arrows.Scene.Errors.size(), 1U);
    EXPECT_NE(arrows.Scene.Errors[0].find("Force 1 of 2 is not finite"), std::string::npos);
    arrows.Actor->SetArrows({ { { bad, 0, 0 }, { 1, 0, 0 } } });
    EXPECT_EQ(arrows.Scene.Errors.size(), 2U);
    arrows.Actor->SetArrows({});
    arrows.Actor->SetMmPerNewton(bad);
    arrows.Actor->SetMmPerNewton(0.0);
    arrows.Actor->SetMaximumMm(bad);
    arrows.Actor->SetMaximumMm(-1.0);
    EXPECT_EQ(arrows.Scene.Errors.size(), 6U);
    EXPECT_EQ(arrows.Actor->GetMmPerNewton(), 10.0);
    EXPECT_EQ(arrows.Actor->GetMaximumMm(), 0.0);
  }
}

TEST(ForceArrows, ComeFromArraysToo)
{
  Arrows arrows;
  vtkNew<vtkPoints> at;
  at->InsertNextPoint(0, 0, 0);
  vtkNew<vtkDoubleArray> forces;
  forces->SetNumberOfComponents(3);
  forces->InsertNextTuple3(0.5, 0, 0);
  arrows.Actor->SetArrows(at, forces);
  EXPECT_NEAR(arrows.Reach(), 5.0, 1e-5);
  at->InsertNextPoint(1, 0, 0);
  arrows.Actor->SetArrows(at, forces); // one force for two points
  EXPECT_EQ(arrows.Actor->GetNumberOfArrows(), 0);
  EXPECT_EQ(arrows.Scene.Errors.size(), 1U);
}

} // namespace
