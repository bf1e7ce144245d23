#pragma once
#include <QColor>
#include <QString>

#include <glm/vec3.hpp>

#include <array>

namespace hasp
{

/// The three planes of the patient's world (LPS), each with its colour.
enum class SliceAxis
{
  Axial,   ///< red frame
  Coronal, ///< green
  Sagittal ///< yellow
};

inline constexpr std::array<SliceAxis, 3> SliceAxes{ SliceAxis::Axial, SliceAxis::Coronal,
  SliceAxis::Sagittal };

/// How such a plane is shown, as radiologists do: the patient's right side is at the screen's left,
/// anterior is up in axial slices and left in sagittal ones, superior is up in the others. Unit
/// vectors of the world; right x up = towardsViewer.
struct SliceFrame
{
  glm::dvec3 right, up, towardsViewer;
  glm::dvec3 next; ///< along the plane's normal: S, A, R
  int normalAxis;  ///< of the world: 0 x (L), 1 y (P), 2 z (S)
  QColor colour;
};

/// Any thread.
const SliceFrame& FrameOf(SliceAxis axis);

/// "L", "R", "P", "A", "S" or "I": the side of the patient that a direction of the world points to
/// most. Any thread.
QString SideLetter(const glm::dvec3& direction);

} // namespace hasp
