#ifndef RendererChoice_h
#define RendererChoice_h

#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro

#include <cstddef>
#include <string>

namespace hasp
{

/// Which of two renderers is the faster one for a scene, found out by drawing: first two traced
/// frames, then three rasterised ones. The last of each counts, for the first compiles and culling
/// needs two to settle. The first rasterised frame decides at once if it takes a second more than
/// four times the traced one, the second one if it takes four times as long. The verdict holds
/// until the cells or the pixels become twice or half as many. Any thread, one at a time.
class VTKHASPRENDERINGISOSURFACE_EXPORT RendererChoice
{
public:
  /// Is the next frame of so many cells and pixels to be traced?
  bool Trace(std::size_t cells, std::size_t pixels);
  /// What that frame took, waited for to its end. Without meaning, and ignored, once decided.
  void Note(double milliseconds);
  bool Decided() const { return this->Step == Steps; }
  /// Not decided, or for tracing.
  bool MayTrace() const { return !this->Decided() || this->TraceWins(); }
  /// The verdict and both times, or how far measuring has come.
  std::string Text() const;

private:
  bool TraceWins() const { return this->TraceMilliseconds < this->RasterMilliseconds; }

  static constexpr int TracedSteps = 2, Steps = 5;
  int Step = 0;
  std::size_t Cells = 0, Pixels = 0;
  double TraceMilliseconds = 0.0, RasterMilliseconds = 0.0;
};

} // namespace hasp

#endif
