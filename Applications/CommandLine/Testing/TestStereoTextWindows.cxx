// Text and textures in windows of X, whose contexts share nothing: each window shows what it shows
// alone.
#include "TestScreen.h"
#include "vtkHaspStereoWindows.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

constexpr int Width = 160, Height = 120;

std::vector<unsigned char> Picture(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Width - 1, Height - 1, 1, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

/// Two texts, one of which changes with the frame, before a plane with stripes on it.
struct Labels
{
  vtkNew<vtkTextActor> still, changing;
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkRenderer> renderer;

  Labels()
  {
    vtkNew<vtkImageData> stripes;
    stripes->SetDimensions(64, 64, 1);
    stripes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* sample = static_cast<unsigned char*>(stripes->GetScalarPointer());
    for (int n = 0; n < 64 * 64 * 3; ++n)
      sample[n] = n / 24 % 2 ? 200 : 40;
    vtkNew<vtkTexture> texture;
    texture->SetInputData(stripes);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetTexture(texture);
    this->renderer->AddActor(actor);
    this->still->SetInput("isovalue");
    this->still->SetPosition(10, 10);
    this->changing->SetPosition(10, 90);
    this->renderer->AddActor(this->still);
    this->renderer->AddActor(this->changing);
    this->renderer->ResetCamera();
  }
  void Say(int frame) { this->changing->SetInput(("frame " + std::to_string(frame)).c_str()); }
};

TEST(StereoTextWindows, EachWindowShowsItsOwn)
{
  TestScreen screen;
  if (screen.Display().empty())
    GTEST_SKIP() << "no Xvfb (Debian: xvfb)";
  setenv("DISPLAY", screen.Display().c_str(), 1);
  Labels labels;
  vtkNew<vtkRenderWindow> window[3];
  vtkNew<vtkHaspStereoWindows> windows;
  windows->SetRenderer(labels.renderer);
  for (auto& one : window)
  {
    one->SetSize(Width, Height);
    one->SetMultiSamples(0);
    ASSERT_TRUE(windows->AddWindow(one, "mono"));
  }
  for (int frame = 0; frame < 4; ++frame)
  {
    labels.Say(frame);
    ASSERT_TRUE(windows->Render());
    const auto first = Picture(window[0]);
    const auto brighter = [&](int than)
    { return std::count_if(first.begin(), first.end(), [&](int v) { return v > than; }); };
    EXPECT_GT(brighter(199), 3 * 2000) << "the stripes";
    EXPECT_GT(brighter(200), 3 * 50) << "the letters: smoothed, and thinner than a pixel";
    EXPECT_TRUE(Picture(window[1]) == first) << frame;
    EXPECT_TRUE(Picture(window[2]) == first) << frame;
  }
}

} // namespace
