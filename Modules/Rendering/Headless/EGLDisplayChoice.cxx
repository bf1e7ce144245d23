#include "EGLDisplayChoice.h"

#include <EGL/eglext.h>

#include <charconv>
#include <stdexcept>

namespace hasp
{
namespace
{

template <typename Function>
Function Load(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool Has(std::string_view extensions, std::string_view name)
{
  for (std::size_t at = 0; (at = extensions.find(name, at)) != std::string_view::npos; ++at)
  {
    const std::size_t end = at + name.size();
    if ((at == 0 || extensions[at - 1] == ' ') &&
        (end == extensions.size() || extensions[end] == ' '))
      return true;
  }
  return false;
}

std::string_view ClientExtensions()
{
  const char* text = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return text ? text : "";
}

std::vector<EGLDeviceEXT> ListDevices()
{
  const std::string_view client = ClientExtensions();
  const bool listed =
    Has(client, "EGL_EXT_device_base") || Has(client, "EGL_EXT_device_enumeration");
  const auto query = Load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!listed || !query || !query(0, nullptr, &count) || count <= 0)
    return {};
  std::vector<EGLDeviceEXT> devices(count);
  if (!query(count, devices.data(), &count))
    return {};
  devices.resize(count);
  return devices;
}

} // namespace

EGLDeviceWish ReadEGLDeviceWish(std::string_view text)
{
  if (text.empty())
    return {};
  if (text == "surfaceless")
    return { .surfaceless = true };
  int index = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size() || index < 0)
    throw std::invalid_argument("HASP_EGL_DEVICE is '" + std::string(text) +
                                "', must be a device number from 0 on, or 'surfaceless', or unset");
  return { .device = index };
}

bool IsSoftwareDevice(std::string_view extensions)
{
  return Has(extensions, "EGL_MESA_device_software");
}

std::vector<EGLCandidate> ListEGLCandidates(const EGLDeviceWish& wish)
{
  std::vector<EGLCandidate> candidates;
  const std::string_view client = ClientExtensions();
  const auto open = Load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!open)
    return candidates;

  const auto describe = Load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!wish.surfaceless && Has(client, "EGL_EXT_platform_device"))
  {
    const std::vector<EGLDeviceEXT> devices = ListDevices();
    for (int d = 0; d < static_cast<int>(devices.size()); ++d)
    {
      const char* text = describe ? describe(devices[d], EGL_EXTENSIONS) : nullptr;
      const bool wanted = wish.device ? d == *wish.device : !IsSoftwareDevice(text ? text : "");
      if (wanted)
        candidates.push_back({ open(EGL_PLATFORM_DEVICE_EXT, devices[d], nullptr),
          "EGL device " + std::to_string(d) });
    }
  }
  if (!wish.device && Has(client, "EGL_MESA_platform_surfaceless"))
    candidates.push_back(
      { open(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "EGL surfaceless" });
  std::erase_if(candidates, [](const EGLCandidate& c) { return c.display == EGL_NO_DISPLAY; });
  return candidates;
}

} // namespace hasp
