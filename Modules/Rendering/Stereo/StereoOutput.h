#pragma once
#include "StereoLayout.h"
#include "StereoRig.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Which eye's which pixel each pixel of an output shows. Integers alone, so that the GPU (glsl/
/// vtkHaspStereoOutputFS.glsl) and the CPU (ComposeStereo) give the same bytes. Pixels are counted
/// from the lower left corner. Plain values and pure functions; any thread.
namespace hasp
{

struct LensTable;

/// What each eye is drawn with.
///
/// Side by side and top-bottom: Full is a picture twice as wide or high as the view, Half squeezes
/// each eye to half of it ("half SBS"); a screen's own aspect stays either way.
/// Interlaced: Full draws all of each eye and shows every second row of it. Half draws those rows
/// alone, sampled at the same places: half the work, the same points of the scene; what is lost is
/// the rows a filter over several of them (multi-sampling, line width) would have used.
/// Checkerboard: Half draws one pixel for each two columns, sampled between them: half the work,
/// and each pixel shows what is half a pixel beside it.
enum class StereoResolution
{
  Full,
  Half
};

/// For displays that are seen in a mirror. Each eye's picture is turned within its own pixels, so
/// that eyes stay where they are: no side, row or field changes hands.
enum class MirrorFlip
{
  None,
  Horizontal, ///< left is right
  Vertical,   ///< top is bottom
  Both        ///< half a turn
};

struct StereoOutput
{
  StereoLayout layout = StereoLayout::SideBySide;
  StereoResolution resolution = StereoResolution::Full;
  MirrorFlip flip = MirrorFlip::None;
  bool swapEyes = false; ///< each eye takes the other's pixels; mono, left and right stay
};

/// One eye's picture and how it lies in the view: device x or y of the eye's picture =
/// scale * that of the view + shift, both in [-1,1].
struct EyeGrid
{
  glm::ivec2 size{ 1 }; ///< pixels
  glm::dvec2 scale{ 1.0 };
  glm::dvec2 shift{ 0.0 };
};

/// An eye, and a pixel of its picture.
struct EyePixel
{
  StereoEye eye;
  glm::ivec2 pixel;
};

/// Pixels of the output for a view of `viewSize` pixels.
VTKHASPRENDERINGSTEREO_EXPORT glm::ivec2 ComposedSize(
  const StereoOutput& output, glm::ivec2 viewSize);

/// The picture that an eye needs for an output of `size` pixels, each >= 1 (else throws
/// std::invalid_argument). Halves of odd sizes are rounded up; the second eye then lacks its last
/// column on the right, or its lowest row.
VTKHASPRENDERINGSTEREO_EXPORT EyeGrid GridOfEye(
  const StereoOutput& output, glm::ivec2 size, StereoEye eye);

/// Whose pixel is shown at `pixel` of the output, before a lens. Anaglyph, where both eyes share a
/// pixel: the left eye. Dual windows and quad buffers: the left eye; the right one has the same
/// pixel in its own window or buffer. With swapped eyes it is the right one in all of these.
/// `pixel` in [0, size), else throws std::invalid_argument.
VTKHASPRENDERINGSTEREO_EXPORT EyePixel EyePixelAt(
  const StereoOutput& output, glm::ivec2 size, glm::ivec2 pixel);

/// The pixel of one eye's picture at any `pixel`, as if that eye's part of the output went on
/// beyond its borders, and below those of the other eye: what a drag that began in that eye has
/// reached. It is EyePixelAt where the pixel is the eye's.
VTKHASPRENDERINGSTEREO_EXPORT glm::ivec2 PixelOfEye(
  const StereoOutput& output, glm::ivec2 size, StereoEye eye, glm::ivec2 pixel);

/// Puts the eyes' RGB pictures into one: the second implementation of what the GPU does.
///
/// left, right  3 bytes a pixel of GridOfEye's size, x fastest, rows from the bottom (VTK's order).
///              A layout of one eye reads only that eye's (mono: left).
/// lenses       left, right: what MakeLensTable gives for the eyes' sizes; null: no lens
/// returns      3 * size.x * size.y bytes in the same order
///
/// Throws std::invalid_argument for layouts that are not one picture, or if sizes differ.
VTKHASPRENDERINGSTEREO_EXPORT std::vector<std::uint8_t> ComposeStereo(const StereoOutput& output,
  glm::ivec2 size, std::span<const std::uint8_t> left, std::span<const std::uint8_t> right,
  const std::array<LensTable, 2>* lenses = nullptr);

} // namespace hasp
