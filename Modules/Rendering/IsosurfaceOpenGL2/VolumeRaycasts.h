#ifndef VolumeRaycasts_h
#define VolumeRaycasts_h

#include "Grid/ResourceUse.h"
#include "VolumeRaycast.h"

#include <memory>
#include <vector>

/// The raycasts of a mapper, one a window that drew it. Threads: RENDER.
class VolumeRaycasts
{
public:
  /// Throws std::runtime_error where it cannot be drawn.
  void Draw(const RaycastVolume& volume, const RaycastSettings& settings, vtkMapper* mapper,
    vtkRenderer* renderer, vtkActor* actor);
  void MarkModified(const glm::ivec3& low, const glm::ivec3& high);
  void Release(vtkOpenGLRenderWindow* window);
  void Clear();
  void ListResources(hasp::ResourceList& list) const;

private:
  std::vector<std::unique_ptr<VolumeRaycast>> Contexts;
};

#endif
