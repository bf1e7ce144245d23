#ifndef vtkHaspHeadlessWindows_h
#define vtkHaspHeadlessWindows_h

#include "vtkHaspRenderingHeadlessModule.h" // for export macro

#include <string> // for return values

/// Windows where there is no display. Functions, not classes: nothing is kept but VTK's factories.
/// RENDER thread.
namespace hasp
{

/// Makes vtkRenderWindow::New() return windows that need no display, if the environment variable
/// DISPLAY is unset or empty. Returns whether it did. Call it first thing in main(); again is free.
/// VTK < 9.4: vtkHaspEGLRenderWindow (see there for HASP_EGL_DEVICE), and interactors become
/// vtkGenericRenderWindowInteractor, because vtkXRenderWindowInteractor ends the process where
/// there is no X server. VTK >= 9.4: sets VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow if unset.
VTKHASPRENDERINGHEADLESS_EXPORT bool UseHeadlessWindows();

/// What would draw: "vendor, renderer, OpenGL version", from a window opened for the question;
/// empty if none could be opened (the window has reported why). About 0.1 s.
VTKHASPRENDERINGHEADLESS_EXPORT std::string DescribeOpenGL();

} // namespace hasp

#endif
