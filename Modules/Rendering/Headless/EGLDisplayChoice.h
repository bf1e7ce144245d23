#pragma once
#include <EGL/egl.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which EGL display to draw on. RENDER thread.
namespace hasp
{

/// What HASP_EGL_DEVICE asks for. Unset or empty: automatic.
struct EGLDeviceWish
{
  bool surfaceless = false;    ///< Mesa's display without devices or surfaces
  std::optional<int> device{}; ///< index into eglQueryDevicesEXT, software devices counted too
};

/// Reads "", "surfaceless" or a number >= 0. Throws std::invalid_argument that lists them.
EGLDeviceWish ReadEGLDeviceWish(std::string_view text);

/// Is this the extension string of a device that computes on the CPU?
bool IsSoftwareDevice(std::string_view extensions);

/// A display to try and what to call it in a message.
struct EGLCandidate
{
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string name;
};

/// Displays in the order to try: what is wished for and nothing else; or by default each hardware
/// device, then surfaceless. None is initialised yet. Empty where EGL has no driver at all.
std::vector<EGLCandidate> ListEGLCandidates(const EGLDeviceWish& wish);

} // namespace hasp
