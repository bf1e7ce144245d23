#pragma once
#include "vtkGenericOpenGLRenderWindow.h"

#include <utility>
#include <vector>

class QOpenGLContext;
class QSurface;

namespace hasp
{

/// A window of VTK's in a widget of Qt's, which gives back the context that was current.
///
/// VTK's mappers hold buffers of one window. Drawn in another, they let go of the first one's, in
/// its context; VTK 9.1's generic window then leaves that context current, and all that the second
/// window draws from there on goes to the first. Threads: RENDER.
class QtRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static QtRenderWindow* New();
  vtkTypeMacro(QtRenderWindow, vtkGenericOpenGLRenderWindow);

  void PushContext() override;
  void PopContext() override;

protected:
  QtRenderWindow() = default;

private:
  std::vector<std::pair<QOpenGLContext*, QSurface*>> Before; ///< alive until they are popped
};

} // namespace hasp
