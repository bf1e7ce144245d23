#include "StereoOutput.h"

#include "LensTable.h"

#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void RequireSize(glm::ivec2 size)
{
  if (size.x < 1 || size.y < 1)
    throw std::invalid_argument("stereo: an output of " + std::to_string(size.x) + " x " +
                                std::to_string(size.y) + " pixels, must be at least 1 x 1");
}

bool Halves(const StereoOutput& output, StereoLayout layout)
{
  return output.layout == layout && output.resolution == StereoResolution::Half;
}

bool Turns(MirrorFlip flip, bool across)
{
  return flip == MirrorFlip::Both ||
         flip == (across ? MirrorFlip::Horizontal : MirrorFlip::Vertical);
}

glm::ivec2 Flip(MirrorFlip flip, glm::ivec2 size, glm::ivec2 pixel)
{
  return { Turns(flip, true) ? size.x - 1 - pixel.x : pixel.x,
    Turns(flip, false) ? size.y - 1 - pixel.y : pixel.y };
}

/// The eye that the first pixels belong to, or the other one.
StereoEye Place(const StereoOutput& output, bool second)
{
  return second != output.swapEyes ? StereoEye::Right : StereoEye::Left;
}

/// Along one axis: eye pixels whose middles lie at offset + step * (number + 1/2) of a view of
/// `size` pixels.
void SetAxis(EyeGrid& grid, int axis, int size, double offset, double step)
{
  const double eye = grid.size[axis];
  grid.scale[axis] = size / (step * eye);
  grid.shift[axis] = (0.5 * size - offset) / (0.5 * step * eye) - 1.0;
}

/// Rec. 601 luma in integers; the weights sum to 256, so white stays 255.
std::uint8_t Luminance(const std::array<int, 3>& rgb)
{
  return static_cast<std::uint8_t>((77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2] + 128) >> 8);
}

/// One eye's picture, through its lens if there is one.
struct EyePicture
{
  glm::ivec2 size;
  std::span<const std::uint8_t> rgb;
  const LensTable* lens;

  std::array<int, 3> At(glm::ivec2 pixel) const
  {
    if (this->lens)
      return SampleThroughLens(*this->lens, this->rgb, pixel);
    const std::uint8_t* at =
      &this->rgb[3 * (static_cast<std::size_t>(pixel.y) * this->size.x + pixel.x)];
    return { at[0], at[1], at[2] };
  }
};

EyePicture Require(const EyeGrid& grid, std::span<const std::uint8_t> rgb, const LensTable* lens)
{
  const std::size_t bytes = 3 * static_cast<std::size_t>(grid.size.x) * grid.size.y;
  if (rgb.size() != bytes)
    throw std::invalid_argument("stereo: an eye's picture of " + std::to_string(rgb.size()) +
                                " bytes, must have " + std::to_string(bytes));
  if (lens && lens->size != grid.size)
    throw std::invalid_argument("stereo: the lens table is of another size than the picture");
  return { grid.size, rgb, lens };
}

/// The pixel of the first or second eye's picture of `eyeSize`, inside or outside of it, that
/// `pixel` of the output shows or lies beside.
glm::ivec2 PixelOf(
  const StereoOutput& output, glm::ivec2 size, glm::ivec2 eyeSize, bool second, glm::ivec2 pixel)
{
  glm::ivec2 fromTop{ pixel.x, size.y - 1 - pixel.y };
  if (output.layout == StereoLayout::SideBySide)
    fromTop.x -= second ? eyeSize.x : 0;
  else if (output.layout == StereoLayout::TopBottom)
    fromTop.y -= second ? eyeSize.y : 0;
  else if (Halves(output, StereoLayout::Interlaced))
    fromTop.y >>= 1; // down, below 0 too
  else if (Halves(output, StereoLayout::Checkerboard))
    fromTop.x >>= 1;
  return Flip(output.flip, eyeSize, { fromTop.x, eyeSize.y - 1 - fromTop.y });
}

/// EyePixelAt for an eye's picture of `eyeSize`, unchecked.
EyePixel Locate(const StereoOutput& output, glm::ivec2 size, glm::ivec2 eyeSize, glm::ivec2 pixel)
{
  const glm::ivec2 fromTop{ pixel.x, size.y - 1 - pixel.y };
  bool second = false;
  if (output.layout == StereoLayout::SideBySide)
    second = fromTop.x >= eyeSize.x;
  else if (output.layout == StereoLayout::TopBottom)
    second = fromTop.y >= eyeSize.y;
  else if (output.layout == StereoLayout::Interlaced)
    second = (fromTop.y & 1) != 0;
  else if (output.layout == StereoLayout::Checkerboard)
    second = ((fromTop.x + fromTop.y) & 1) != 0;
  const glm::ivec2 from = PixelOf(output, size, eyeSize, second, pixel);
  if (NeedsSecondEye(output.layout))
    return { Place(output, second), from };
  return { output.layout == StereoLayout::Right ? StereoEye::Right : StereoEye::Left, from };
}

} // namespace

glm::ivec2 ComposedSize(const StereoOutput& output, glm::ivec2 viewSize)
{
  const bool full = output.resolution == StereoResolution::Full;
  return { viewSize.x * (full && output.layout == StereoLayout::SideBySide ? 2 : 1),
    viewSize.y * (full && output.layout == StereoLayout::TopBottom ? 2 : 1) };
}

EyeGrid GridOfEye(const StereoOutput& output, glm::ivec2 size, StereoEye eye)
{
  RequireSize(size);
  EyeGrid grid;
  grid.size = size;
  if (output.layout == StereoLayout::SideBySide)
    grid.size.x = (size.x + 1) / 2;
  else if (output.layout == StereoLayout::TopBottom)
    grid.size.y = (size.y + 1) / 2;
  else if (Halves(output, StereoLayout::Checkerboard))
  {
    grid.size.x = (size.x + 1) / 2;
    const bool turned = Turns(output.flip, true);
    SetAxis(grid, 0, size.x, turned ? size.x - 2 * grid.size.x : 0, 2.0);
  }
  else if (Halves(output, StereoLayout::Interlaced))
  {
    // Row k of an eye from the top is row 2 k + second of the output; in the middle of that row,
    // half a row above the middle of the pair (or, turned over, below).
    grid.size.y = (size.y + 1) / 2;
    const int second = eye != Place(output, false);
    const int lowest = Turns(output.flip, false) ? second : size.y + 1 - 2 * grid.size.y - second;
    SetAxis(grid, 1, size.y, lowest - 0.5, 2.0);
  }
  return grid;
}

EyePixel EyePixelAt(const StereoOutput& output, glm::ivec2 size, glm::ivec2 pixel)
{
  RequireSize(size);
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y)
    throw std::invalid_argument("stereo: pixel (" + std::to_string(pixel.x) + ", " +
                                std::to_string(pixel.y) + ") is not in the output");
  return Locate(output, size, GridOfEye(output, size, StereoEye::Left).size, pixel);
}

glm::ivec2 PixelOfEye(const StereoOutput& output, glm::ivec2 size, StereoEye eye, glm::ivec2 pixel)
{
  return PixelOf(
    output, size, GridOfEye(output, size, eye).size, eye != Place(output, false), pixel);
}

std::vector<std::uint8_t> ComposeStereo(const StereoOutput& output, glm::ivec2 size,
  std::span<const std::uint8_t> left, std::span<const std::uint8_t> right,
  const std::array<LensTable, 2>* lenses)
{
  if (!IsOnePicture(output.layout))
    throw std::invalid_argument(std::string("stereo layout '") + StereoLayoutName(output.layout) +
                                "' is two pictures: nothing to compose");
  std::array<EyePicture, 2> eyes{};
  const bool both = NeedsSecondEye(output.layout);
  if (both || output.layout != StereoLayout::Right)
    eyes[0] =
      Require(GridOfEye(output, size, StereoEye::Left), left, lenses ? &(*lenses)[0] : nullptr);
  if (both || output.layout == StereoLayout::Right)
    eyes[1] =
      Require(GridOfEye(output, size, StereoEye::Right), right, lenses ? &(*lenses)[1] : nullptr);
  const glm::ivec2 eyeSize = GridOfEye(output, size, StereoEye::Left).size;
  std::vector<std::uint8_t> result(3 * static_cast<std::size_t>(size.x) * size.y);
  std::uint8_t* to = result.data();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x, to += 3)
    {
      const EyePixel from = Locate(output, size, eyeSize, { x, y });
      const int eye = from.eye == StereoEye::Right;
      std::array<int, 3> rgb = eyes[eye].At(from.pixel);
      if (output.layout == StereoLayout::Anaglyph)
      {
        const int red = Luminance(rgb);
        rgb = eyes[1 - eye].At(from.pixel);
        rgb[0] = red;
      }
      for (int color = 0; color < 3; ++color)
        to[color] = static_cast<std::uint8_t>(rgb[color]);
    }
  return result;
}

} // namespace hasp
