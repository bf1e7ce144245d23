#ifndef RendererSwitch_h
#define RendererSwitch_h

#include "OpenGLVersion.h"
#include "RendererChoice.h"

#include "vtkWeakPointer.h"

#include <chrono>
#include <vector>

class vtkRenderer;

/// Which renderer of a mapper draws the frame at hand; in Automatic, by what was measured for the
/// vtkRenderer (viewport). Threads: RENDER, with the context current.
class RendererSwitch
{
public:
  struct Frame
  {
    int wanted;     ///< vtkHaspClusteredCellMapper::Renderers
    bool traceable; ///< the cells have no more than their surface
    vtkRenderer* renderer;
    bool hides; ///< the pass is opaque and writes depth
    OpenGLVersion openGL;
    bool softwareOpenGL;
    std::size_t cells;
    bool lit = false; ///< light is asked for that takes rays
  };
  bool IsTraced(const Frame& frame);
  /// Why that frame cannot be drawn as wanted, and what to do; empty if it can.
  const std::string& Refusal() const { return this->RefusalText; }
  /// The answer of the last IsTraced, and why.
  std::string Text() const;
  /// Can a later frame be traced, as far as is known now?
  bool MayTrace(int wanted) const;
  /// Is the time of this frame wanted?
  bool Measures() const { return this->Measuring >= 0; }

  /// Around the drawing of a frame; waits for OpenGL before and after if the time is wanted.
  void Start();
  void Finish();

private:
  struct Viewer
  {
    vtkWeakPointer<vtkRenderer> renderer;
    hasp::RendererChoice choice;
  };
  std::vector<Viewer> Viewers;
  int Last = -1, Measuring = -1; ///< of Viewers, or none
  std::string Reason = "nothing drawn", RefusalText;
  std::chrono::steady_clock::time_point Begin;
};

#endif
