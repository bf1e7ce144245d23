#include "Windows.h"

#include "Failure.h"
#include "VtkMessages.h"

#if HASP_WITH_HEADLESS
#include "vtkHaspHeadlessWindows.h"
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
