#pragma once
#include <string>

class vtkRenderWindow;

namespace hasp
{

/// Call before the first window. From here on windows need no display; a build without
/// HASP_ENABLE_EGL needs one. Throws Failure: CannotDraw if there is none. RENDER thread.
void ChooseWindows();

/// For a window on a screen. Call before the first one: VTK's X window would end the process where
/// there is no display. Throws Failure: CannotDraw, with what to do. RENDER thread; 1 ms.
void RequireDisplay();

/// Opens the window's OpenGL. Throws Failure: CannotDraw without. RENDER thread.
void RequireOpenGL(vtkRenderWindow* window);

/// "vendor, renderer, OpenGL version" of what draws; empty in a build without HASP_ENABLE_EGL.
/// Throws Failure: CannotDraw if no window opens. RENDER thread; 0.1 s.
std::string OpenGLName();

} // namespace hasp
