#pragma once
#include <string>

namespace hasp
{

/// Call before the first window. From here on windows need no display; a build without
/// HASP_ENABLE_EGL needs one. Throws Failure: CannotDraw if there is none. RENDER thread.
void ChooseWindows();

/// "vendor, renderer, OpenGL version" of what draws; empty in a build without HASP_ENABLE_EGL.
/// Throws Failure: CannotDraw if no window opens. RENDER thread; 0.1 s.
std::string OpenGLName();

} // namespace hasp
