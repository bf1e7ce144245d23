#pragma once
#include "vtkWeakPointer.h"

class vtkRenderer;

/// While one lives, a renderer's frames are of one eye: whoever draws in them reads it from the
/// active camera's LeftEye. Frames of a window without VTK's stereo would all be the left one's:
/// vtkRenderWindow::Render sets LeftEye before each, so this sets it when the renderer begins. The
/// left eye is drawn first; mappers that keep something between frames (vtkHaspRayCachingMapper)
/// then share it between both. Afterwards the camera has its left eye again. Threads: RENDER.
class DrawnEye
{
public:
  DrawnEye(vtkRenderer* renderer, bool left);
  ~DrawnEye();
  DrawnEye(const DrawnEye&) = delete;
  DrawnEye& operator=(const DrawnEye&) = delete;

private:
  class Observer;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Tag;
};
