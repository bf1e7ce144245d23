#pragma once
#include <EGL/egl.h>

#include <string>

/// An OpenGL core context that belongs to no surface. RENDER thread.
namespace hasp
{

class EGLContextHandle
{
public:
  EGLContextHandle() = default;
  ~EGLContextHandle() { this->Destroy(); }
  EGLContextHandle(const EGLContextHandle&) = delete;
  EGLContextHandle& operator=(const EGLContextHandle&) = delete;

  /// Opens the display HASP_EGL_DEVICE asks for, or the best there is, and the newest core context
  /// from OpenGL 4.6 down to 3.2 on it. `shared`: a context to share objects with, or
  /// EGL_NO_CONTEXT. Throws std::runtime_error that says what was tried and what is missing.
  void Create(EGLContext shared);
  void Destroy();

  /// False, and nothing changed, if there is no context.
  bool MakeCurrent();
  void ReleaseCurrent();
  bool IsCurrent() const;

  bool IsValid() const { return this->Context != EGL_NO_CONTEXT; }
  EGLContext GetContext() const { return this->Context; }
  EGLDisplay GetDisplay() const { return this->Display; }
  /// "EGL device 0", "EGL surfaceless" or empty.
  const std::string& GetName() const { return this->Name; }

private:
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
  std::string Name;
};

} // namespace hasp
