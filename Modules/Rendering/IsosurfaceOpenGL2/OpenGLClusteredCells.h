#ifndef OpenGLClusteredCells_h
#define OpenGLClusteredCells_h
// Private to vtkHaspOpenGLClusteredCellMapper.

#include "CellContext.h"
#include "CellLight.h"
#include "CellTracing.h"
#include "RendererSwitch.h"
#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "vtkOpenGLRenderWindow.h"

#include <memory>
#include <vector>

/// What the mapper keeps from frame to frame.
struct vtkHaspOpenGLClusteredCellMapper::OpenGL
{
  std::vector<std::unique_ptr<CellContext>> Contexts; ///< of windows that drew this mapper
  CellTracing Tracing;
  CellLight Light;
  bool Unlit = false; ///< the last frame lacked the light that was asked for
  RendererSwitch Switch;

  /// The context of the window, which is current.
  CellContext& Of(vtkOpenGLRenderWindow* window)
  {
    std::erase_if(this->Contexts, [](const auto& context) { return context->IsLost(); });
    for (const auto& context : this->Contexts)
      if (context->IsOf(window))
        return *context;
    return *this->Contexts.emplace_back(std::make_unique<CellContext>(window));
  }

  void Free(vtkOpenGLRenderWindow* window)
  {
    for (const auto& context : this->Contexts)
      if (context->IsOf(window))
        context->Free(window);
    std::erase_if(this->Contexts, [](const auto& context) { return context->IsLost(); });
  }
};

#endif
