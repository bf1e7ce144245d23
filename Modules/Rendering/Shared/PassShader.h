#ifndef PassShader_h
#define PassShader_h

#include "vtkHaspRenderingSharedModule.h" // for export macro

#include <string>

class vtkActor;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// A program put together from texts, with what VTK's render passes say of an actor's shader
/// (order-independent translucency, depth peeling, passes of others): they fill the
/// //VTK::DepthPeeling lines, and then `defines` the //Hasp::Defines lines. Bound, with the passes'
/// parameters set; null if it did not compile. VTK's shader cache owns it. Threads: RENDER, with
/// the context current.
VTKHASPRENDERINGSHARED_EXPORT vtkShaderProgram* ReadyPassShader(vtkOpenGLRenderWindow* window,
  vtkMapper* mapper, vtkActor* actor, std::string vertex, std::string fragment,
  const std::string& defines);

#endif
