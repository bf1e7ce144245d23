#ifndef LabelPalette_h
#define LabelPalette_h

#include "Segmentation/LabelMap.h"

#include "vtkHaspInteractionPaintingModule.h" // for export macro

#include <glm/vec3.hpp>

namespace hasp
{

/// A colour of its own for each label, red, green and blue in [0, 1], for as long as nobody has
/// chosen one: 0 (nothing) is grey, 1 bone, and the hues of 2, 3, 4 ... lie as far from those
/// before them as they can (by the golden angle). Any thread.
VTKHASPINTERACTIONPAINTING_EXPORT glm::dvec3 PaletteColour(Label label);

/// Is the number a label, [0, 65535], and each component in [0, 1]? NaN is not.
VTKHASPINTERACTIONPAINTING_EXPORT bool IsColour(int label, const glm::dvec3& colour);

} // namespace hasp

#endif
