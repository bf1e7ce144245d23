/**
 * @class   vtkHaspOpenGLClusteredCellMapper
 * @brief   OpenGL implementation of vtkHaspClusteredCellMapper.
 *
 * Cells go to the GPU once per extraction, packed as they are (4 to 6 bytes a cell of an
 * integer volume), and are pulled by the vertex shader; there are no vertex or index buffers.
 * Shader variants are compiled when a scene first needs them: unsigned or float corners, hardware
 * selection. Each window that draws the mapper holds buffers of its own until it releases them;
 * going from one to the other uploads nothing.
 *
 * Occlusion culling: see OcclusionCulling.h of this folder. It works where what is drawn hides what
 * is behind it; translucent passes, depth peeling and hardware selection draw all that is in view.
 *
 * All of this takes OpenGL 4.3 (OpenGLVersion.h). What rays meet on the CPU is drawn as textures by
 * shaders of GLSL 1.50, on any OpenGL that VTK can use.
 *
 * Threads: RENDER only. Errors: vtkErrorMacro, and nothing is drawn; what OpenGL refuses is tried
 * again each time, and said once in a row.
 */
#ifndef vtkHaspOpenGLClusteredCellMapper_h
#define vtkHaspOpenGLClusteredCellMapper_h

#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRenderingIsosurfaceOpenGL2Module.h" // for export macro

class CellContext;
class CellLight;
struct CellDraws;
struct CellScene;
enum class CellPass;
class vtkShaderProgram;

class VTKHASPRENDERINGISOSURFACEOPENGL2_EXPORT vtkHaspOpenGLClusteredCellMapper :
  public vtkHaspClusteredCellMapper
{
public:
  static vtkHaspOpenGLClusteredCellMapper* New();
  vtkTypeMacro(vtkHaspOpenGLClusteredCellMapper, vtkHaspClusteredCellMapper);

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void SetRenderer(int renderer) override;
  std::string GetRendererChoice() const override;
  using Superclass::ListResources;
  void ListResources(hasp::ResourceList& list) const override;

protected:
  vtkHaspOpenGLClusteredCellMapper();
  ~vtkHaspOpenGLClusteredCellMapper() override;

  /// Largest storage block to bind; cells that take more are drawn in parts. What the driver says,
  /// unless a subclass knows better. At least hasp::LeastBlockBytes. The context is current.
  virtual std::size_t GetStorageBlockBytes() const;

private:
  vtkHaspOpenGLClusteredCellMapper(const vtkHaspOpenGLClusteredCellMapper&) = delete;
  void operator=(const vtkHaspOpenGLClusteredCellMapper&) = delete;

  struct Pass;
  CellDraws InView(const Pass& pass, double margin);
  vtkShaderProgram* ReadyProgram(const Pass& pass, CellPass what);
  void DrawCells(
    const Pass& pass, vtkShaderProgram* program, const CellDraws& draws, bool occlusion);
  bool NeedsRasterizer() const;
  void NoteLight(bool lacking);
  const CellLight* UpdateLight(const CellScene& scene, vtkRenderer* renderer);
  void DrawTraced(CellContext& context, vtkRenderer* renderer, vtkActor* actor);
  void DrawRasterized(CellContext& context, vtkRenderer* renderer, vtkActor* actor);

  struct OpenGL;
  std::unique_ptr<OpenGL> GL;
};

#endif
