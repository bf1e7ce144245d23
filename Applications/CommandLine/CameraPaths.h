#pragma once
#include "IsosurfaceView.h"

#include <string>
#include <vector>

namespace hasp
{

/// A recorded way of the camera, or of the isovalue, frame by frame. The same frames every time.
class CameraPath
{
public:
  /// From the view as it is now, which must outlive the path.
  explicit CameraPath(IsosurfaceView& view);

  /// `degrees` a frame around the volume's middle.
  void Orbit(int frame, double degrees = 1.0);
  /// Towards a place, to `nearest` mm from it, in `frames` frames.
  void Fly(int frame, int frames, const glm::dvec3& target, double nearest);
  /// A head that is not held still: up to 5 mm and 3 degrees around the first pose, in sines of
  /// 23 to 41 frames.
  void Jitter(int frame);
  /// The picture moves by parts of a pixel, in [-0.5, 0.5]: for accumulation.
  void ShiftPixels(double x, double y);

private:
  void Place(const glm::dvec3& position, const glm::dvec3& focus);

  IsosurfaceView& View;
  glm::dvec3 Position, Focus, Up;
};

} // namespace hasp
