#ifndef CellLabels_h
#define CellLabels_h

#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <optional>

class vtkMatrix4x4;

namespace hasp
{

/// What is said of one label; labels of which nothing is said are drawn where they are, in the
/// actor's colour.
struct CellLabel
{
  bool visible = true;
  std::optional<glm::vec4> color; ///< RGBA in [0, 1]
  std::optional<glm::dmat4> pose; ///< rigid, in the actor's data coordinates: mm
};

/// By number. A type of its own so that it can be declared without GLM: VTK's wrappers would parse
/// that for minutes.
struct CellLabels : std::map<std::uint16_t, CellLabel>
{
};

/// The matrix as a pose. Throws std::invalid_argument, with what is wrong, unless it is rigid:
/// rotation columns orthonormal within 1e-4 and right-handed, last row 0 0 0 1, everything finite.
VTKHASPRENDERINGISOSURFACE_EXPORT glm::dmat4 RigidPose(vtkMatrix4x4* matrix);

/// Whether one of the labels lets the background through: colour with alpha < 1.
VTKHASPRENDERINGISOSURFACE_EXPORT bool AnyTranslucent(const CellLabels& labels);

} // namespace hasp

#endif
