#pragma once
#include "vtkInteractorStyleTrackballCamera.h"

namespace hasp
{

/// VTK's trackball camera without its keys, and deaf to timers: by VTK's default any timer turns
/// the camera on while a button is down. RENDER thread.
class ViewStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewStyle* New();
  vtkTypeMacro(ViewStyle, vtkInteractorStyleTrackballCamera);
  void OnChar() override {}
  void OnTimer() override {}
};

} // namespace hasp
