#ifndef CellTracing_h
#define CellTracing_h

#include "Isosurface/CellTracer.h"

#include "vtkTimeStamp.h"
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
  /// Traces the pixels of the scene's viewport that the cells may cover; nothing if the last
  /// picture is of the same view and was traced after `since`. lit: with what light needs.
  void Trace(const CellScene& scene, vtkMTimeType since, bool lit);
  void Release() { *this = {}; }

  bool Ready() const { return this->Tracer != nullptr; }
  std::size_t TreeBytes() const;
  std::size_t PictureBytes() const;
  double TreeMilliseconds() const { return this->Milliseconds; }
  double PictureMilliseconds() const { return this->TraceMilliseconds; }

  /// There while Ready().
  const hasp::CellTracer& GetTracer() const { return *this->Tracer; }
  const hasp::PictureView& GetView() const { return this->View; } ///< of the last picture

  /// Of the last picture; gradients have the depth as their fourth number, over 1 where nothing is.
  const hasp::TracedPicture& Picture() const { return this->Traced; }
  /// When it was traced; no two pictures have the same.
  vtkMTimeType PictureTime() const { return this->Time; }
  /// Its lowest left pixel in the viewport.
  const glm::ivec2& Origin() const { return this->First; }

private:
  std::shared_ptr<const hasp::CellTracer> Tracer;
  vtkMTimeType CellsTime = 0;
  double Milliseconds = 0.0;
  glm::dvec3 Low{ 0.0 }, High{ 0.0 }; ///< of all clusters, in index coordinates
  hasp::TracedPicture Traced;
  glm::ivec2 First{ 0 };
  hasp::PictureView View; ///< of the picture
  vtkTimeStamp Time;
  double TraceMilliseconds = 0.0;
};

#endif
