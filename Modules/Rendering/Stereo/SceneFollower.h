#ifndef SceneFollower_h
#define SceneFollower_h

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

class vtkRenderWindow;

/// A renderer that shows in another window what a scene's renderer has: its props, its lights if
/// it has any, background, camera, and what its pictures are made with. Not followed: a render pass
/// set by SetPass (it belongs to one window), the viewport and the layer. Threads: RENDER.
class SceneFollower
{
public:
  explicit SceneFollower(vtkRenderWindow* window);
  ~SceneFollower();
  SceneFollower(const SceneFollower&) = delete;
  SceneFollower& operator=(const SceneFollower&) = delete;

  /// Makes the renderer show what `scene` shows now.
  void Follow(vtkRenderer* scene);
  vtkRenderer* Renderer() const { return this->Own; }

private:
  void FollowProps(vtkRenderer* scene);
  void FollowLook(vtkRenderer* scene);

  vtkNew<vtkRenderer> Own;
};

#endif
