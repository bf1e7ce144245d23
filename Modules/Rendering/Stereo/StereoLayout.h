#pragma once
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hasp
{

/// How the eyes' pictures become one. SideBySide and TopBottom keep every pixel of each eye: the
/// result is twice as wide or high. TopBottom has the left eye on top.
enum class StereoLayout
{
  Mono,       ///< one eye between the two: no second eye is drawn
  SideBySide, ///< left eye on the left
  TopBottom,  ///< left eye on top
  Left,       ///< the left eye alone
  Right,      ///< the right eye alone
  Anaglyph    ///< red from the left eye's luminance, green and blue from the right eye
};

/// "mono", "side-by-side", "top-bottom", "left", "right", "anaglyph".
VTKHASPRENDERINGSTEREO_EXPORT const char* StereoLayoutName(StereoLayout layout);

/// The reverse. Throws std::invalid_argument with the name found and all that are known.
VTKHASPRENDERINGSTEREO_EXPORT StereoLayout StereoLayoutFromName(const std::string& name);

/// Whether the layout draws two eyes.
VTKHASPRENDERINGSTEREO_EXPORT bool NeedsSecondEye(StereoLayout layout);

/// Pixels of the composed picture for eyes of `eyeSize` pixels.
VTKHASPRENDERINGSTEREO_EXPORT glm::ivec2 ComposedSize(StereoLayout layout, glm::ivec2 eyeSize);

/// Puts two RGB pictures into one.
///
/// left, right  3 * eyeSize.x * eyeSize.y bytes, x fastest, rows from the bottom (VTK's order)
/// returns      3 * ComposedSize(...) bytes in the same order
///
/// Throws std::invalid_argument if the layout draws one eye or the sizes differ. Any thread.
VTKHASPRENDERINGSTEREO_EXPORT std::vector<std::uint8_t> ComposeStereo(StereoLayout layout,
  glm::ivec2 eyeSize, std::span<const std::uint8_t> left, std::span<const std::uint8_t> right);

} // namespace hasp
