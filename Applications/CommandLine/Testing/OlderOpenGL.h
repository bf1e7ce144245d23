#pragma once
#include <cstdlib>
#include <utility>
#include <vector>

/// Variables that programs which are run see, while one lives.
class EnvironmentScope
{
public:
  using Variables = std::vector<std::pair<const char*, const char*>>;
  explicit EnvironmentScope(Variables variables) : Set(std::move(variables))
  {
    for (const auto& [name, value] : this->Set)
      setenv(name, value, true);
  }
  ~EnvironmentScope()
  {
    for (const auto& [name, value] : this->Set)
      unsetenv(name);
  }
  EnvironmentScope(const EnvironmentScope&) = delete;
  EnvironmentScope& operator=(const EnvironmentScope&) = delete;

private:
  Variables Set;
};

/// Mesa makes itself older, and compiles no later shader where its cache has none.
inline const EnvironmentScope::Variables OlderOpenGL = { { "MESA_GL_VERSION_OVERRIDE", "3.3" },
  { "MESA_GLSL_VERSION_OVERRIDE", "330" }, { "MESA_SHADER_CACHE_DISABLE", "true" } };

/// Mesa draws without a display, where there is another driver, too.
inline const EnvironmentScope::Variables MesasOpenGL = { { "HASP_EGL_DEVICE", "surfaceless" } };
