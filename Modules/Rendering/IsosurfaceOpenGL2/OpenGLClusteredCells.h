#ifndef OpenGLClusteredCells_h
#define OpenGLClusteredCells_h
// Private to vtkHaspOpenGLClusteredCellMapper.

#include "CellContext.h"
#include "CellLight.h"
#include "CellTracing.h"
#include "RendererSwitch.h"
#include "WindowContexts.h"
#include "vtkHaspOpenGLClusteredCellMapper.h"

/// What the mapper keeps from frame to frame.
struct vtkHaspOpenGLClusteredCellMapper::OpenGL
{
  WindowContexts<CellContext> Contexts;
  CellTracing Tracing;
  CellLight Light;
  bool Unlit = false; ///< the last frame lacked the light that was asked for
  RendererSwitch Switch;
};

#endif
