#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <limits>
#include <vector>

namespace hasp
{

/// A ray in index coordinates of the volume: origin + t * direction, tMin <= t <= tMax. direction
/// need not be unit but must not be 0; t counts in its length.
struct CellRay
{
  glm::dvec3 origin{ 0.0 }, direction{ 0.0, 0.0, 1.0 };
  double tMin = 0.0;
  double tMax = std::numeric_limits<double>::infinity();
};

/// What a camera sees, without any scene graph.
struct PictureView
{
  glm::dmat4 indexToClip{ 1.0 }; ///< index coordinates to OpenGL clip coordinates
  glm::ivec2 size{ 0 };          ///< pixels, each >= 0; rays go through their centres
  /// In index coordinates; plane . (p, 1) >= 0 is kept. Near and far plane of indexToClip always
  /// cut and need not be here.
  std::vector<glm::dvec4> planes;

  bool operator==(const PictureView&) const = default;
};

/// The rays of a view's pixels, cut by its planes, from the camera's matrix alone. Any thread.
class PictureRays
{
public:
  /// Throws std::invalid_argument if indexToClip cannot be inverted.
  explicit PictureRays(const PictureView& view);

  /// place: in pixels from the view's lower left corner; the centre of the first is (0.5, 0.5).
  /// False where the planes leave nothing; else tMin and tMax are finite in every view with a near
  /// and a far plane.
  bool Of(const glm::dvec2& place, CellRay& ray) const;

  /// What Of computes with.
  const glm::dmat4& GetToIndex() const { return this->ToIndex; }
  const glm::dvec2& GetPixelSize() const { return this->PixelSize; }
  const std::vector<glm::dvec4>& GetPlanes() const { return this->Planes; }

private:
  glm::dmat4 ToIndex;
  glm::dvec2 PixelSize; ///< of a picture from -1 to 1
  std::vector<glm::dvec4> Planes;
};

} // namespace hasp
