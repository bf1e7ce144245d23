#ifndef CellProgram_h
#define CellProgram_h

#include "Isosurface/ClusteredCells.h"

struct CellScene;
class vtkActor;
class vtkHaspClusteredCellMapper;
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// The shader variants of the clustered cells. Each is put together and compiled when a scene first
/// needs it; VTK's shader cache owns them. Threads: RENDER, with the context current.
class CellProgram
{
public:
  /// The program for this scene, bound and with its uniforms set, or null if it did not compile.
  /// Render passes of VTK that have a say in the actor's shader (order-independent translucency,
  /// depth peeling) get it: they fill the //VTK::DepthPeeling lines.
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, vtkHaspClusteredCellMapper* mapper,
    vtkActor* actor, const CellScene& scene, vtkHardwareSelector* selector);

  /// The program that shades a traced picture, likewise. Opaque surfaces only: no pass has a say.
  vtkShaderProgram* ReadyTraced(
    vtkOpenGLRenderWindow* window, const CellScene& scene, vtkHardwareSelector* selector);

  /// Time of the first compilation; 0 if that variant was never asked for.
  double ShadeMilliseconds() const { return this->Milliseconds[0]; }
  double SelectMilliseconds() const { return this->Milliseconds[1]; }
  double TracedMilliseconds() const { return this->Milliseconds[2]; }

private:
  double Milliseconds[3] = { 0.0, 0.0, 0.0 };
};

#endif
