#include "vtkHaspEGLRenderWindow.h"
#include "vtkHaspHeadlessWindows.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace
{

TEST(EGLRenderWindow, WithoutADriverSaysOnceWhatToInstallAndLives)
{
  // GLVND finds no driver where this names no file.
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent/egl-driver.json", 1);
  setenv("DISPLAY", "", 1);
  ASSERT_TRUE(hasp::UseHeadlessWindows());
  vtkNew<vtkRenderWindow> window;
  int errors = 0;
  std::string said;
  struct Seen
  {
    int& count;
    std::string& text;
  } seen{ errors, said };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&seen);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* message)
    {
      auto* s = static_cast<Seen*>(data);
      ++s->count;
      s->text += static_cast<const char*>(message);
    });
  window->AddObserver(vtkCommand::ErrorEvent, command);

  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->SetSize(40, 30);
  window->Render();
  window->Render();
  EXPECT_EQ(errors, 1);
  EXPECT_NE(said.find("libgl1-mesa-dri"), std::string::npos) << said;
  EXPECT_EQ(window->SupportsOpenGL(), 0);

  vtkNew<vtkUnsignedCharArray> pixels;
  EXPECT_EQ(window->GetPixelData(0, 0, 9, 9, 1, pixels), VTK_ERROR);
}

} // namespace
