// Light that surfaces share, in the window of `hasp view`.
#include "ViewDesk.h"
#include "vtkHaspLightPass.h"

#include "vtkSmartPointer.h"

namespace
{

using namespace hasp;
using hasp::testing::Desk;
using hasp::testing::Size;

constexpr int Endless = 1 << 20; // more samples than any test waits for

LightChoices Paths(int samples)
{
  LightChoices light;
  light.pathSamples = samples;
  return light;
}

vtkHaspLightPass* PassOf(const Desk& desk)
{
  return vtkHaspLightPass::SafeDownCast(desk.renderer->GetPass());
}

std::size_t PictureBytes(const vtkHaspLightPass* pass)
{
  ResourceList list;
  pass->ListResources(list);
  return std::find_if(list.begin(), list.end(),
    [](const ResourceUse& use) { return use.resource == "light, picture"; })
    ->bytes;
}

TEST(ViewLight, PathsAreShownTenTimesASecondAndFindsAtOnce)
{
  Desk paths("cells", 80.0, Paths(Endless));
  for (int n = 0; n < 6; ++n) // beyond the frames in which what is kept gets better, too
  {
    ASSERT_EQ(paths.timers.size(), 1U) << n;
    EXPECT_EQ(paths.lastMs, 100) << n;
    const int id = *paths.timers.begin();
    paths.timers.clear();
    paths.Fire(id);
  }
  Desk finds("raycaching");
  ASSERT_FALSE(finds.timers.empty());
  EXPECT_EQ(finds.lastMs, 1);
}

TEST(ViewLight, ACompletePictureWaitsForItsPathsInOneFrame)
{
  constexpr int samples = 30;
  Desk desk("cells", 80.0, Paths(samples));
  struct Count
  {
    int frames = 0;
    void Add() { ++this->frames; }
  } count;
  desk.window->AddObserver(vtkCommand::EndEvent, &count, &Count::Add);
  double told = 0.0;
  desk.scene->SetFrameProgress([&](double share) { told = share; });
  desk.renderer->GetActiveCamera()->Azimuth(20); // begins anew
  desk.view->DrawComplete();
  EXPECT_EQ(PassOf(desk)->GetSamples(), samples);
  EXPECT_EQ(count.frames, 5); // four at rest, of which the first waits, and one for the text
  EXPECT_GT(told, 0.0);
  EXPECT_LE(told, 1.0);
  EXPECT_FALSE(PassOf(desk)->GetWaitForSamples()) << "a window that is turned must not wait";
  desk.scene->SetFrameProgress({});
}

TEST(ViewLight, WhatIsDroppedLeavesTheGpu)
{
  Desk desk("cells", 80.0, Paths(Endless));
  const vtkSmartPointer<vtkHaspLightPass> pass = PassOf(desk);
  ASSERT_TRUE(pass);
  const std::size_t before = PictureBytes(pass);
  desk.view.reset();
  desk.scene.reset();
  EXPECT_FALSE(desk.renderer->GetPass());
  EXPECT_GE(before - PictureBytes(pass), std::size_t(Size) * Size * 16); // its textures
}

} // namespace
