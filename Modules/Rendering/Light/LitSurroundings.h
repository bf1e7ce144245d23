#ifndef LitSurroundings_h
#define LitSurroundings_h

#include "Light/LitScene.h"

#include "vtkType.h"

#include <array>

class vtkRenderer;

/// What lights a renderer's bodies from far away and from lamps. Threads: RENDER.
class LitSurroundings
{
public:
  /// The environment that the renderer has: its EnvironmentTexture, or daylight. Made anew when the
  /// texture's image or its direction changes. Throws std::invalid_argument on an image that is no
  /// environment, with the reason.
  const std::shared_ptr<const hasp::Environment>& Of(vtkRenderer* renderer);
  /// Black, without a table.
  static std::shared_ptr<const hasp::Environment> None();
  void Release() { *this = {}; }
  std::size_t Bytes() const { return this->Made ? this->Made->Bytes() : 0; }
  double Milliseconds() const { return this->Spent; }

private:
  struct Key
  {
    const void* image = nullptr;
    vtkMTimeType time = 0;
    std::array<double, 6> axes{};
    bool operator==(const Key&) const = default;
  };
  Key Last;
  std::shared_ptr<const hasp::Environment> Made;
  double Spent = 0.0;
};

/// The renderer's lights that are switched on, in the world. `linear`: are their colours sRGB?
std::vector<hasp::LitLamp> LampsOf(vtkRenderer* renderer, bool linear);

#endif
