#ifndef VolumeRaycasts_h
#define VolumeRaycasts_h

#include "Grid/ResourceUse.h"
#include "VolumeRaycast.h"

#include <memory>
#include <string>
#include <vector>

/// The raycasts of a mapper, one a window that drew it. Threads: RENDER.
class VolumeRaycasts
{
public:
  /// True if it was drawn. Throws std::runtime_error the first time it says why it was not.
  bool Draw(const RaycastVolume& volume, const RaycastSettings& settings, vtkMapper* mapper,
    vtkRenderer* renderer, vtkActor* actor);
  void MarkModified(const glm::ivec3& low, const glm::ivec3& high);
  void Release(vtkOpenGLRenderWindow* window);
  void Clear();
  void ListResources(hasp::ResourceList& list) const;

private:
  std::vector<std::unique_ptr<VolumeRaycast>> Contexts;
  std::string Refusal; ///< what was said last
};

#endif
