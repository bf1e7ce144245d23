#ifndef OpenGLVersion_h
#define OpenGLVersion_h

#include "HaspGL.h"

#include <string>

/// Of a context. What VTK itself needs, 3.2, shows what rays on the CPU have met; cells are
/// rasterised, and volumes raycast, by what came with 4.3: storage buffers, compute shaders, views
/// of textures. Threads: RENDER.
struct OpenGLVersion
{
  GLint major = 0, minor = 0;

  static OpenGLVersion OfCurrentContext()
  {
    OpenGLVersion version;
    glGetIntegerv(GL_MAJOR_VERSION, &version.major);
    glGetIntegerv(GL_MINOR_VERSION, &version.minor);
    return version;
  }
  /// Empty if it rasterises and raycasts; else why it does not do `what`: "raycasting needs OpenGL
  /// 4.3, and this window has 3.3".
  std::string Lack(const std::string& what) const
  {
    if (this->major > 4 || (this->major == 4 && this->minor >= 3))
      return {};
    return what + " needs OpenGL 4.3, and this window has " + std::to_string(this->major) + "." +
           std::to_string(this->minor);
  }
};

#endif
