#include "EGLContextHandle.h"

#include "EGLDisplayChoice.h"

#include <EGL/eglext.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace hasp
{
namespace
{

EGLContext CreateNewestContext(EGLDisplay display, EGLContext shared)
{
  constexpr EGLint versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 3 }, { 3, 3 }, { 3, 2 } };
  for (const auto& [major, minor] : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, major, EGL_CONTEXT_MINOR_VERSION,
      minor, EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, shared, attributes);
    if (context != EGL_NO_CONTEXT)
      return context;
  }
  return EGL_NO_CONTEXT;
}

std::string LastError()
{
  std::ostringstream text;
  text << "EGL error 0x" << std::hex << eglGetError();
  return text.str();
}

} // namespace

void EGLContextHandle::Create(EGLContext shared)
{
  this->Destroy();
  const char* asked = std::getenv("HASP_EGL_DEVICE");
  const auto candidates = ListEGLCandidates(ReadEGLDeviceWish(asked ? asked : ""));
  std::string tried;
  for (const EGLCandidate& candidate : candidates)
  {
    // Displays are shared by the whole process: initialised as often as one likes, never
    // terminated.
    if (!eglInitialize(candidate.display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
    {
      tried += "\n  " + candidate.name + ": does not start, " + LastError();
      continue;
    }
    this->Context = CreateNewestContext(candidate.display, shared);
    this->Display = candidate.display;
    this->Name = candidate.name;
    if (this->MakeCurrent())
      return;
    tried +=
      "\n  " + candidate.name + ": no OpenGL 3.2 core context without a surface, " + LastError();
    this->Destroy();
  }
  throw std::runtime_error(
    "no OpenGL without a display." +
    (tried.empty() ? "\n  EGL has no driver" +
                       (asked ? " for HASP_EGL_DEVICE=" + std::string(asked) : std::string()) + "."
                   : tried) +
    "\n  Install a driver (Debian: libegl1 libgl1-mesa-dri, or the graphics card's own)" +
    (asked ? ", or unset HASP_EGL_DEVICE." : "."));
}

void EGLContextHandle::Destroy()
{
  if (this->IsCurrent())
    this->ReleaseCurrent();
  if (this->IsValid())
    eglDestroyContext(this->Display, this->Context);
  this->Context = EGL_NO_CONTEXT;
  this->Display = EGL_NO_DISPLAY;
  this->Name.clear();
}

bool EGLContextHandle::MakeCurrent()
{
  return this->IsValid() && (this->IsCurrent() || (eglBindAPI(EGL_OPENGL_API) &&
                                                    eglMakeCurrent(this->Display, EGL_NO_SURFACE,
                                                      EGL_NO_SURFACE, this->Context)));
}

void EGLContextHandle::ReleaseCurrent()
{
  if (this->IsCurrent())
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EGLContextHandle::IsCurrent() const
{
  // Which context is current is a question per API, and a new thread starts with OpenGL ES.
  return this->IsValid() && eglBindAPI(EGL_OPENGL_API) && eglGetCurrentContext() == this->Context;
}

} // namespace hasp
