#include "Windows.h"

#include "Failure.h"
#include "VtkMessages.h"

#if HASP_WITH_HEADLESS
#include "vtkHaspHeadlessWindows.h"
#endif

#include "vtkOpenGLRenderWindow.h"

#if HASP_WITH_VIEW
#include <X11/Xlib.h>
#endif

#include <cstdlib>

namespace hasp
{

void ChooseWindows()
{
#if HASP_WITH_HEADLESS
  unsetenv("DISPLAY"); // VTK's X window would end the process where DISPLAY is wrong
  UseHeadlessWindows();
#else
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
    throw Failure(ExitCode::CannotDraw,
      "no display, and this build draws only with one; set DISPLAY or build with HASP_ENABLE_EGL");
#endif
}

#if HASP_WITH_VIEW
void RequireDisplay()
{
  static const std::string remedy =
    "; set DISPLAY to one (over ssh: ssh -X), or draw a picture without: hasp render";
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
    throw Failure(ExitCode::CannotDraw, "no display: DISPLAY is not set" + remedy);
  Display* display = XOpenDisplay(nullptr);
  if (!display)
    throw Failure(ExitCode::CannotDraw, "the display that DISPLAY names cannot be opened" + remedy);
  int code = 0, event = 0, error = 0;
  const bool openGL = XQueryExtension(display, "GLX", &code, &event, &error);
  XCloseDisplay(display);
  if (!openGL)
    throw Failure(ExitCode::CannotDraw, "the display that DISPLAY names has no OpenGL" + remedy);
}
#endif

void RequireOpenGL(vtkRenderWindow* window)
{
  if (auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(window))
    openGL->Initialize();
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  if (!window->SupportsOpenGL())
    throw Failure(ExitCode::CannotDraw, "cannot draw: OpenGL 3.2 or later is needed");
}

std::string OpenGLName()
{
#if HASP_WITH_HEADLESS
  const std::string name = DescribeOpenGL();
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  if (name.empty())
    throw Failure(ExitCode::CannotDraw, "cannot draw: no OpenGL");
  return name;
#else
  return {};
#endif
}

} // namespace hasp
