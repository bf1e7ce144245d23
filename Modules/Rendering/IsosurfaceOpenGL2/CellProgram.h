#ifndef CellProgram_h
#define CellProgram_h

#include "Isosurface/ClusteredCells.h"

class AttributeBuffers;
struct CellScene;
class vtkActor;
class vtkHaspClusteredCellMapper;
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// What the cells' shaders are to write.
enum class CellPass
{
  Shade,  ///< colour and depth
  Select, ///< what hardware selection asks for
  Hits,   ///< depth, and the number of the cell's frame, for blending
  Splats, ///< weighted normals and colours, for blending
  Traced  ///< what rays have met: ReadyTraced
};

/// The shader variants of the clustered cells. Each is put together and compiled when a scene first
/// needs it; VTK's shader cache owns them. Threads: RENDER, with the context current.
class CellProgram
{
public:
  /// The program for this scene, bound and with its uniforms set, or null if it did not compile.
  /// Render passes of VTK that have a say in the actor's shader (order-independent translucency,
  /// depth peeling, passes of others) get it: they fill the //VTK::DepthPeeling lines.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, vtkHaspClusteredCellMapper* mapper,
    vtkActor* actor, const CellScene& scene, const AttributeBuffers& attributes,
    vtkHardwareSelector* selector, CellPass pass);

  /// The program that shades a traced picture, likewise; lit: with its light.
  vtkShaderProgram* ReadyTraced(vtkOpenGLRenderWindow* window, vtkHaspClusteredCellMapper* mapper,
    vtkActor* actor, const CellScene& scene, vtkHardwareSelector* selector, bool lit);

  /// Time of the first compilation; 0 if that variant was never asked for.
  double CompileMilliseconds(CellPass pass) const
  {
    return this->Milliseconds[static_cast<int>(pass)];
  }

private:
  struct Variant;
  vtkShaderProgram* Ready(Variant& variant, vtkOpenGLRenderWindow* window,
    vtkHaspClusteredCellMapper* mapper, vtkActor* actor, const CellScene& scene,
    vtkHardwareSelector* selector);

  double Milliseconds[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
