/**
 * @class   vtkHaspOpenGLRayCachingMapper
 * @brief   OpenGL implementation of vtkHaspRayCachingMapper.
 *
 * Rays are cast on the CPU; what the cache holds of each level of detail goes to the GPU when it
 * has changed and is drawn as clustered cells are. Where a pass hides what is behind it, the depth
 * of the picture is read back to find holes.
 *
 * Threads: RENDER only. Errors: vtkErrorMacro, and nothing is drawn.
 */
#ifndef vtkHaspOpenGLRayCachingMapper_h
#define vtkHaspOpenGLRayCachingMapper_h

#include "vtkHaspRayCachingMapper.h"
#include "vtkHaspRenderingIsosurfaceOpenGL2Module.h" // for export macro

struct CellScene;

class VTKHASPRENDERINGISOSURFACEOPENGL2_EXPORT vtkHaspOpenGLRayCachingMapper :
  public vtkHaspRayCachingMapper
{
public:
  static vtkHaspOpenGLRayCachingMapper* New();
  vtkTypeMacro(vtkHaspOpenGLRayCachingMapper, vtkHaspRayCachingMapper);

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void SetRenderer(int renderer) override;
  std::string GetModeChoice() const override;
  bool IsRefining() const override;
  void ListResources(hasp::ResourceList& list) const override;

protected:
  vtkHaspOpenGLRayCachingMapper();
  ~vtkHaspOpenGLRayCachingMapper() override;

private:
  vtkHaspOpenGLRayCachingMapper(const vtkHaspOpenGLRayCachingMapper&) = delete;
  void operator=(const vtkHaspOpenGLRayCachingMapper&) = delete;

  void UpdateCache();
  struct Pass;
  void DrawCells(const Pass& pass, bool lit);
  void SampleCache(const Pass& pass);
  void CastRays(const Pass& pass, const CellScene& scene);
  void DrawCache(const Pass& pass);
  void DrawWhole(vtkRenderer* renderer, vtkActor* actor);
  void DrawStandIn(vtkRenderer* renderer, vtkActor* actor, const std::string& lack);
  void DrawRaycast(vtkRenderer* renderer, vtkActor* actor);

  struct OpenGL;
  std::unique_ptr<OpenGL> GL;
};

#endif
