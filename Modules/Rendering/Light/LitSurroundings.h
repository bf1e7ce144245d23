#ifndef LitSurroundings_h
#define LitSurroundings_h

#include "Light/LitScene.h"

#include "vtkType.h"

#include <array>
#include <string>

class vtkRenderer;

/// What lights a renderer's bodies from far away and from lamps. Threads: RENDER.
class LitSurroundings
{
public:
  /// Of a Radiance file, if one is named; else the renderer's EnvironmentTexture, or daylight. Made
  /// anew when the name, the texture's image or the directions change. Throws std::exception on
  /// what is no environment, with the reason.
  const std::shared_ptr<const hasp::Environment>& Of(
    vtkRenderer* renderer, const std::string& fileName);
  /// Black, without a table.
  static std::shared_ptr<const hasp::Environment> None();
  void Release() { *this = {}; }
  std::size_t Bytes() const { return this->Made ? this->Made->Bytes() : 0; }
  double Milliseconds() const { return this->Spent; }

private:
  struct Key
  {
    std::string fileName;
    const void* image = nullptr;
    vtkMTimeType time = 0;
    std::array<double, 6> axes{};
    bool operator==(const Key&) const = default;
  };
  Key Last;
  std::shared_ptr<const hasp::Environment> Made;
  std::string Fault; ///< of Last, if nothing could be made of it; it is not tried again
  double Spent = 0.0;
};

/// What radiance is multiplied by, so that the mean light makes a white surface 0.55; 1 in the
/// dark.
float ExposureFor(const hasp::Environment& far, const std::vector<hasp::LitLamp>& lamps);

/// The renderer's lights that are switched on, in the world. `linear`: are their colours sRGB?
std::vector<hasp::LitLamp> LampsOf(vtkRenderer* renderer, bool linear);

#endif
