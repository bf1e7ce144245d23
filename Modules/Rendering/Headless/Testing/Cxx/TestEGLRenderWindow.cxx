#include "vtkHaspEGLRenderWindow.h"
#include "vtkHaspHeadlessWindows.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <string>

namespace
{

/// Sets HASP_EGL_DEVICE for one scope.
struct DeviceWish
{
  explicit DeviceWish(const char* value) { setenv("HASP_EGL_DEVICE", value, 1); }
  ~DeviceWish() { unsetenv("HASP_EGL_DEVICE"); }
};

/// Collects what a window reports instead of printing it.
struct Errors
{
  std::string text;

  explicit Errors(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* message)
      { static_cast<Errors*>(self)->text += static_cast<const char*>(message); });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }
};

/// The colour in the middle of a window that shows a plain background, or {-1,-1,-1}.
std::array<int, 3> DrawPlain(vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.4, 0.6);
  window->SetMultiSamples(0);
  window->SetSize(40, 30);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixel;
  const bool read = window->GetPixelData(20, 15, 20, 15, 1, pixel) == VTK_OK;
  window->RemoveRenderer(renderer);
  if (!read || pixel->GetNumberOfValues() != 3)
    return { -1, -1, -1 };
  return { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) };
}

constexpr std::array<int, 3> backgroundColour = { 51, 102, 153 }; // 255 * (0.2, 0.4, 0.6)
constexpr std::array<int, 3> nothing = { -1, -1, -1 };

TEST(EGLRenderWindow, RefusesADeviceThatIsNoneAndSaysWhatIsLegal)
{
  for (const char* wish : { "banana", "-1", "1x", "99999999999999" })
  {
    const DeviceWish device(wish);
    vtkNew<vtkHaspEGLRenderWindow> window;
    const Errors errors(window);
    EXPECT_EQ(DrawPlain(window), nothing) << wish;
    EXPECT_EQ(window->SupportsOpenGL(), 0);
    EXPECT_NE(errors.text.find(wish), std::string::npos) << errors.text;
    EXPECT_NE(errors.text.find("surfaceless"), std::string::npos) << errors.text;
  }
}

TEST(EGLRenderWindow, RefusesADeviceThatIsNotThereAndRecovers)
{
  vtkNew<vtkHaspEGLRenderWindow> window;
  const Errors errors(window);
  {
    const DeviceWish device("99");
    EXPECT_EQ(DrawPlain(window), nothing);
    EXPECT_NE(errors.text.find("HASP_EGL_DEVICE=99"), std::string::npos) << errors.text;
    EXPECT_STREQ(window->ReportCapabilities(), window->GetOpenGLSupportMessage().c_str());
  }
  EXPECT_EQ(DrawPlain(window), nothing) << "a window that failed stays off until it is finalized";
  window->Finalize();
  EXPECT_EQ(DrawPlain(window), backgroundColour);
}

TEST(EGLRenderWindow, DrawsAndSaysWhatDraws)
{
  vtkNew<vtkHaspEGLRenderWindow> window;
  EXPECT_EQ(DrawPlain(window), backgroundColour);
  const std::string report = window->ReportCapabilities();
  EXPECT_NE(report.find("OpenGL vendor string"), std::string::npos) << report;
  EXPECT_NE(report.find("OpenGL renderer string"), std::string::npos) << report;
}

TEST(EGLRenderWindow, SurfacelessAndDeviceDrawTheSame)
{
  // Device 0 is there wherever any driver is: Mesa lists its CPU renderer as a device.
  for (const char* wish : { "surfaceless", "0" })
  {
    const DeviceWish device(wish);
    vtkNew<vtkHaspEGLRenderWindow> window;
    EXPECT_EQ(DrawPlain(window), backgroundColour) << wish;
    std::ostringstream text;
    window->Print(text);
    EXPECT_NE(
      text.str().find(*wish == '0' ? "EGL device 0" : "EGL surfaceless"), std::string::npos);
  }
}

TEST(EGLRenderWindow, WindowsComeGoAndTakeTurns)
{
  vtkNew<vtkHaspEGLRenderWindow> lasting;
  EXPECT_EQ(DrawPlain(lasting), backgroundColour);
  for (int n = 0; n < 10; ++n)
  {
    vtkNew<vtkHaspEGLRenderWindow> passing;
    EXPECT_EQ(DrawPlain(passing), backgroundColour);
    EXPECT_FALSE(lasting->IsCurrent());
    EXPECT_EQ(DrawPlain(lasting), backgroundColour);
  }
}

TEST(EGLRenderWindow, ContextsAreBorrowedAndComeBack)
{
  vtkNew<vtkHaspEGLRenderWindow> first, second;
  EXPECT_EQ(DrawPlain(first), backgroundColour);
  EXPECT_EQ(DrawPlain(second), backgroundColour);
  first->PushContext();
  EXPECT_TRUE(first->IsCurrent());
  first->PushContext();
  first->PopContext();
  EXPECT_TRUE(first->IsCurrent());
  first->PopContext();
  EXPECT_TRUE(second->IsCurrent());
  first->PopContext(); // one too many does nothing
  EXPECT_TRUE(second->IsCurrent());
}

TEST(EGLRenderWindow, SharesObjectsWithAnother)
{
  vtkNew<vtkHaspEGLRenderWindow> first, second;
  second->SetSharedRenderWindow(first);
  EXPECT_EQ(DrawPlain(second), backgroundColour);
  EXPECT_EQ(DrawPlain(first), backgroundColour);
}

TEST(HeadlessWindows, AreUsedOnlyWithoutADisplay)
{
  const char* before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  setenv("DISPLAY", ":9", 1);
  EXPECT_FALSE(hasp::UseHeadlessWindows());
  setenv("DISPLAY", "", 1);
  EXPECT_TRUE(hasp::UseHeadlessWindows());
  EXPECT_TRUE(hasp::UseHeadlessWindows()) << "again is free";
  vtkNew<vtkRenderWindow> window;
  EXPECT_TRUE(window->IsA("vtkHaspEGLRenderWindow"));
  vtkNew<vtkRenderWindowInteractor> interactor;
  EXPECT_TRUE(interactor->IsA("vtkGenericRenderWindowInteractor"));
  EXPECT_NE(hasp::DescribeOpenGL().find("OpenGL "), std::string::npos);
  setenv("DISPLAY", kept.c_str(), 1);
}

} // namespace
