#ifndef WindowContext_h
#define WindowContext_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

/// The OpenGL context that a window had when this was made. Threads: RENDER.
class WindowContext
{
public:
  explicit WindowContext(vtkOpenGLRenderWindow* window)
    : Owner(window),
      CreationTime(window->GetContextCreationTime())
  {
  }

  /// Is this the context the window has now?
  bool IsOf(vtkOpenGLRenderWindow* window) const
  {
    return window && window->GetContextCreationTime() == this->CreationTime;
  }
  /// The window is gone, or has another context by now.
  bool IsLost() const { return !this->IsOf(this->Owner); }

  /// Null if it is gone.
  vtkOpenGLRenderWindow* Window() const { return this->Owner; }

  /// Calls release() with the context current, unless it is not this window's (null: the window it
  /// was made of): names may be others' by now. The context that was current stays so. Lost then.
  template <typename Release>
  void Leave(vtkOpenGLRenderWindow* window, const Release& release)
  {
    if (!window)
      window = this->Owner;
    if (this->IsOf(window))
    {
      window->PushContext();
      if (window->IsCurrent())
        release();
      window->PopContext();
    }
    this->CreationTime = 0;
  }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Owner;
  vtkMTimeType CreationTime; ///< of the context; unique
};

#endif
