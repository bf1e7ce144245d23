#ifndef CellContext_h
#define CellContext_h

#include "AttributeBuffers.h"
#include "CellBuffers.h"
#include "CellProgram.h"
#include "EyeCulling.h"
#include "NormalBlending.h"
#include "OcclusionCulling.h"
#include "OpenGLVersion.h"
#include "TracedCells.h"
#include "WindowContext.h"

#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <string>

/// What a mapper holds in the OpenGL context of one window. It is made when the window first draws
/// the mapper. Threads: RENDER.
class CellContext
{
public:
  explicit CellContext(vtkOpenGLRenderWindow* window);
  /// Lets go of everything; what died with its context is forgotten, for its names may be others'
  /// by now. The context that was current stays so.
  ~CellContext();
  CellContext(const CellContext&) = delete;
  CellContext& operator=(const CellContext&) = delete;

  /// Is this the context the window has now?
  bool IsOf(vtkOpenGLRenderWindow* window) const { return this->Home.IsOf(window); }
  /// The window is gone, or has another context by now.
  bool IsLost() const { return this->Home.IsLost(); }
  /// To be called for a window that is being deleted: it is no longer behind the weak pointer.
  void Free(vtkOpenGLRenderWindow* window);

  /// Brings the buffers up to date; the context must be current. Throws std::runtime_error.
  void Upload(const hasp::ClusteredCells& cells, vtkMTimeType time, std::size_t blockBytes);
  /// Frees what rasterising needs, unless it was used in this frame of the window or the last one.
  void ReleaseUnusedBuffers();
  /// When the window began the frame at hand.
  vtkMTimeType GetFrameTime() const { return this->Frame; }
  /// Likewise for culling, which needs memory of its own.
  OcclusionCulling& UseCulling(const hasp::ClusteredCells& cells);

  CellBuffers Buffers;
  AttributeBuffers Attributes;
  NormalBlending Blending;
  CellProgram Program;
  OcclusionCulling Culling;
  EyeCulling Eyes;
  TracedCells Traced;
  const OpenGLVersion Version;
  const bool SoftwareOpenGL;
  double UploadMilliseconds = 0.0, CullingMilliseconds = 0.0;
  std::string Complaint; ///< why the last drawing failed; empty if it did not

private:
  WindowContext Home;
  vtkMTimeType CellsTime = 0; ///< of what is uploaded
  vtkTimeStamp BuffersUsed;
  vtkTimeStamp Frame, FrameBefore; ///< when they began
  unsigned long FrameObserver;

  void BeginFrame();
};

#endif
