#pragma once
#include <array>

class vtkRenderer;

namespace hasp
{

struct SceneLayers;

/// Where a plan is seen from at first: from the front, all of it in sight; again when there is
/// bone, and when the fragments of a plan that was opened are there, which fill the view then. From
/// then on, and as soon as the user has moved it, the camera is the user's.
///
/// Threads: RENDER.
class FirstLook
{
public:
  void Begin(bool awaitsFragments); ///< of another plan
  void Follow(vtkRenderer* renderer, const SceneLayers& layers);

private:
  using Look = std::array<double, 10>;
  static Look LookOf(vtkRenderer* renderer);

  enum
  {
    Nothing,
    Something,
    Bone
  } Seen = Nothing;
  bool AwaitsFragments = false;
  Look Put{}; ///< here
};

} // namespace hasp
