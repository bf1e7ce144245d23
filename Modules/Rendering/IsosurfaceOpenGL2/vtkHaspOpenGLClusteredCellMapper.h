/**
 * @class   vtkHaspOpenGLClusteredCellMapper
 * @brief   OpenGL 4.3 implementation of vtkHaspClusteredCellMapper.
 *
 * Cells go to the GPU once per extraction, packed as they are (4 to 6 bytes a cell of an
 * integer volume), and are pulled by the vertex shader; there are no vertex or index buffers.
 * Shader variants are compiled when a scene first needs them: unsigned or float corners, hardware
 * selection. They live in one window at a time: a mapper shared by two is uploaded anew whenever
 * the window changes. Give each window a mapper of its own.
 *
 * Threads: RENDER only. Errors: vtkErrorMacro, and nothing is drawn.
 */
#ifndef vtkHaspOpenGLClusteredCellMapper_h
#define vtkHaspOpenGLClusteredCellMapper_h

#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRenderingIsosurfaceOpenGL2Module.h" // for export macro

class VTKHASPRENDERINGISOSURFACEOPENGL2_EXPORT vtkHaspOpenGLClusteredCellMapper :
  public vtkHaspClusteredCellMapper
{
public:
  static vtkHaspOpenGLClusteredCellMapper* New();
  vtkTypeMacro(vtkHaspOpenGLClusteredCellMapper, vtkHaspClusteredCellMapper);

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ListResources(hasp::ResourceList& list) const override;

protected:
  vtkHaspOpenGLClusteredCellMapper();
  ~vtkHaspOpenGLClusteredCellMapper() override;

private:
  vtkHaspOpenGLClusteredCellMapper(const vtkHaspOpenGLClusteredCellMapper&) = delete;
  void operator=(const vtkHaspOpenGLClusteredCellMapper&) = delete;

  struct OpenGL;
  std::unique_ptr<OpenGL> GL;
};

#endif
