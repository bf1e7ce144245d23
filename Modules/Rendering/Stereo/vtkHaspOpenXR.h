#ifndef vtkHaspOpenXR_h
#define vtkHaspOpenXR_h

#include "vtkHaspRenderingStereoModule.h" // for export macro

#include "vtkRenderWindow.h"           // for the view
#include "vtkRenderWindowInteractor.h" // for the view
#include "vtkRenderer.h"               // for the view
#include "vtkSmartPointer.h"           // for the view

#include <string>

/// Head-mounted displays through OpenXR: VTK's own window, which talks to the runtime. It draws
/// both eyes itself (parallel frusta and lenses are the runtime's business); nothing of ours stands
/// in between. For VTK >= 9.2 with the module RenderingOpenXR, and HASP_ENABLE_OPENXR. RENDER
/// thread.
namespace hasp
{

/// Why this build has no OpenXR output, and what to do; empty if it has.
VTKHASPRENDERINGSTEREO_EXPORT std::string WhyNoOpenXR();

/// VTK's three objects, made for each other: add the scene's props to the renderer, call
/// interactor->Initialize() (asks for the display; VTK reports what is missing), then Start().
struct OpenXRView
{
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindow> window;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor;
};

/// Throws std::runtime_error with WhyNoOpenXR() unless that is empty.
VTKHASPRENDERINGSTEREO_EXPORT OpenXRView MakeOpenXRView();

} // namespace hasp

#endif
