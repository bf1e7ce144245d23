#ifndef CellTracing_h
#define CellTracing_h

#include "Isosurface/CellTracer.h"

#include "vtkType.h"

struct CellScene;

/// A mapper's ray tracer and the last picture it traced; there when first asked for. Empty where
/// Hasp was built without Embree. Threads: RENDER; tracing uses all cores inside the call.
class CellTracing
{
public:
  static bool Available();

  /// Makes the tree if there is none of these cells, which must live and stay as they are until the
  /// next Update or Release. Throws std::runtime_error, also where tracing is not available.
  void Update(const hasp::ClusteredCells& cells, vtkMTimeType time);
  /// Traces the pixels of the scene's viewport that the cells may cover.
  void Trace(const CellScene& scene);
  void Release() { *this = {}; }

  bool Ready() const { return this->Tracer != nullptr; }
  std::size_t TreeBytes() const;
  std::size_t PictureBytes() const;
  double TreeMilliseconds() const { return this->Milliseconds; }

  /// Of the last picture; gradients have the depth as their fourth number, over 1 where nothing is.
  const hasp::TracedPicture& Picture() const { return this->Traced; }
  /// Its lowest left pixel in the viewport.
  const glm::ivec2& Origin() const { return this->First; }

private:
  std::shared_ptr<const hasp::CellTracer> Tracer;
  vtkMTimeType CellsTime = 0;
  double Milliseconds = 0.0;
  glm::dvec3 Low{ 0.0 }, High{ 0.0 }; ///< of all clusters, in index coordinates
  hasp::TracedPicture Traced;
  glm::ivec2 First{ 0 };
};

#endif
