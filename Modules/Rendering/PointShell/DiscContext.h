#ifndef DiscContext_h
#define DiscContext_h

#include "DiscBuffer.h"
#include "SplatTargets.h"
#include "WindowContext.h"

#include <string>

class vtkActor;
class vtkMapper;
class vtkRenderer;

/// What vtkHaspPointShellMapper holds in the OpenGL context of one window. Threads: RENDER.
class DiscContext
{
public:
  explicit DiscContext(vtkOpenGLRenderWindow* window) : Home(window) {}
  ~DiscContext() { this->Free(nullptr); }
  DiscContext(const DiscContext&) = delete;
  DiscContext& operator=(const DiscContext&) = delete;

  bool IsOf(vtkOpenGLRenderWindow* window) const { return this->Home.IsOf(window); }
  bool IsLost() const { return this->Home.IsLost(); }
  /// Null: the window it was made for. What died with its context is forgotten.
  void Free(vtkOpenGLRenderWindow* window);

  struct Look
  {
    double overlap;
    bool levels; ///< each in its colour
  };
  /// The context is current, discs has some. Throws std::runtime_error.
  void Draw(vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
    const std::shared_ptr<const Discs>& discs, const Look& look);

  DiscBuffer Buffer;
  SplatTargets Targets;
  double ShaderMilliseconds = 0.0, UploadMilliseconds = 0.0;
  std::string Complaint; ///< why the last drawing failed; empty if it did not

private:
  struct Pass;
  void DrawDiscs(const Pass& pass, bool hits);
  void Resolve(const Pass& pass);

  WindowContext Home;
};

#endif
