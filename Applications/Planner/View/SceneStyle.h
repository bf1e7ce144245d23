#pragma once
#include "vtkInteractorStyleTrackballCamera.h"

#include <functional>

namespace hasp
{

/// VTK's trackball: left drag turns, Shift+left or middle moves, right or the wheel zooms,
/// Ctrl+left rolls. A double click starts no drag: the view may
/// be another size, elsewhere, before the button is up again. And no key does anything here:
/// SceneView has those, for VTK's own q and e end programs.
class SceneStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static SceneStyle* New();
  vtkTypeMacro(SceneStyle, vtkInteractorStyleTrackballCamera);
  std::function<bool()> isSecondPress; ///< of a double click; must be set

  void OnLeftButtonDown() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnChar() override {}
};

} // namespace hasp
