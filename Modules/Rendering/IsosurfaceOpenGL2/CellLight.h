#ifndef CellLight_h
#define CellLight_h

#include "Isosurface/LightCache.h"

#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <memory>

class CellTracing;
struct CellScene;
class vtkRenderer;

/// The light of a mapper's traced picture, and what of it is kept from frame to frame; there while
/// it is asked for. Empty where Hasp was built without Embree. Threads: RENDER; rays use all cores
/// inside the call.
class CellLight
{
public:
  struct Wanted
  {
    bool ambientOcclusion, shadows;
    double distanceMm; ///< of ambient occlusion
    bool Any() const { return this->ambientOcclusion || this->shadows; }
  };
  /// Samples that are all that has changed since the cells were those of `time`.
  struct Edit
  {
    vtkMTimeType time;
    glm::ivec3 low, high;
  };

  /// Of the picture that was traced last, as often as it is drawn; time: of its cells. The first
  /// light of the scene casts the shadow. The two eyes of a renderer share what they can
  /// (hasp::LightEye). Throws std::invalid_argument.
  void Update(const CellTracing& tracing, const CellScene& scene, vtkRenderer* renderer,
    const Wanted& wanted, vtkMTimeType time, const Edit& edit);
  void Release() { *this = {}; }

  const hasp::PictureLight& Picture() const { return this->Pixels; }
  vtkMTimeType PictureTime() const { return this->Time; } ///< no two have the same
  std::size_t CacheBytes() const;
  /// What the second eye reads of the first one's picture; 0 while there is one eye.
  std::size_t SharedBytes() const;
  std::size_t PictureBytes() const { return this->Pixels.size() * sizeof(this->Pixels[0]); }
  double Milliseconds() const { return this->Spent; } ///< of the last picture

private:
  hasp::LightEye EyeOf(vtkRenderer* renderer, bool ofRig, vtkMTimeType picture);

  std::shared_ptr<hasp::LightCache> Cache;
  hasp::PictureLight Pixels;
  vtkMTimeType CellsTime = 0;
  vtkTimeStamp Time;

  // Of the last picture: when it was traced, for which eye of whom, and what that makes it.
  vtkMTimeType Seen = 0;
  vtkWeakPointer<vtkRenderer> Renderer;
  bool Left = true;
  hasp::LightEye Eye = hasp::LightEye::Alone;
  double Spent = 0.0;
};

#endif
