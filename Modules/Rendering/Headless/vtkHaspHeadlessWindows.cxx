#include "vtkHaspHeadlessWindows.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
#include "vtkHaspEGLRenderWindow.h"
#endif
#if VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <cstdlib>

namespace hasp
{

bool UseHeadlessWindows()
{
  const char* display = std::getenv("DISPLAY");
  if (display && *display)
    return false;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  vtkHaspEGLRenderWindow::InstallFactoryOverride();
#else
  setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow", 0);
#endif
  return true;
}

std::string DescribeOpenGL()
{
  vtkNew<vtkRenderWindow> any;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (!window)
    return {};
  window->OffScreenRenderingOn();
  window->Initialize();
  int major = 0, minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major == 0)
    return {};
  const auto text = [](GLenum name)
  {
    const GLubyte* value = glGetString(name);
    return std::string(value ? reinterpret_cast<const char*>(value) : "?");
  };
  return text(GL_VENDOR) + ", " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

} // namespace hasp
