#include "VolumeTextures.h"

#include "HaspGL.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace
{

/// How samples of a type are kept, sent, and read by the driver's interpolation.
struct Format
{
  GLenum exact, filtered, send, type;
};

template <typename T>
Format FormatOf()
{
  if constexpr (std::is_same_v<T, std::int16_t>)
    return { GL_R16I, GL_R16_SNORM, GL_RED_INTEGER, GL_SHORT };
  else if constexpr (std::is_same_v<T, std::uint16_t>)
    return { GL_R16UI, GL_R16, GL_RED_INTEGER, GL_UNSIGNED_SHORT };
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return { GL_R16UI, GL_R16, GL_RED_INTEGER, GL_UNSIGNED_BYTE }; // 8 bits are interpolated to 8
  else
    return { GL_R32F, GL_R32F, GL_RED, GL_FLOAT };
}

/// While one lives, uploads read a part of a larger grid.
class UnpackScope
{
public:
  UnpackScope(const glm::ivec3& size, const glm::ivec3& low)
  {
    const GLint values[] = { 1, size.x, size.y, low.x, low.y, low.z };
    for (int n = 0; n < Count; ++n)
    {
      glGetIntegerv(Names[n], &this->Before[n]);
      glPixelStorei(Names[n], values[n]);
    }
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->BufferBefore);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  }
  ~UnpackScope()
  {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(this->BufferBefore));
    for (int n = 0; n < Count; ++n)
      glPixelStorei(Names[n], this->Before[n]);
  }
  UnpackScope(const UnpackScope&) = delete;
  UnpackScope& operator=(const UnpackScope&) = delete;

private:
  static constexpr int Count = 6;
  static constexpr GLenum Names[Count] = { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES };
  GLint Before[Count], BufferBefore;
};

void ForgetErrors()
{
  for (int old = 0; old < 32 && glGetError() != GL_NO_ERROR; ++old) // somebody else's; a lost
  {                                                                 // context has no end of them
  }
}

void SetFilter(GLint filter)
{
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : { GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R })
    glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
}

/// A texture that is bound; 0 if there is no room.
GLuint MakeTexture(GLenum format, const glm::ivec3& size)
{
  ForgetErrors();
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_3D, name);
  glTexStorage3D(GL_TEXTURE_3D, 1, format, size.x, size.y, size.z);
  SetFilter(GL_NEAREST);
  if (glGetError() == GL_NO_ERROR)
    return name;
  glDeleteTextures(1, &name);
  return 0;
}

/// The same memory, read by another format and interpolated.
GLuint MakeFilteredView(GLuint texture, GLenum format)
{
  GLuint view = 0;
  glGenTextures(1, &view);
  glTextureView(view, GL_TEXTURE_3D, texture, format, 0, 1, 0, 1);
  glBindTexture(GL_TEXTURE_3D, view);
  SetFilter(GL_LINEAR);
  return view;
}

[[noreturn]] void ThrowNoRoom(std::size_t bytes, const char* what)
{
  throw std::runtime_error(
    "the GPU has no room for " + std::to_string(bytes >> 10) + " KiB of " + what);
}

} // namespace

void VolumeTextures::UploadSamples(const hasp::AnyGridView& grid, int longestSide)
{
  this->Release();
  const glm::ivec3 size = hasp::GeometryOf(grid).dims;
  if (glm::any(glm::lessThan(size, glm::ivec3(2))))
    return; // no cells
  const Format format =
    std::visit([]<typename T>(const hasp::GridView<const T>&) { return FormatOf<T>(); }, grid);
  const std::size_t sampleBytes = format.exact == GL_R32F ? 4 : 2;
  const int step = longestSide - 1; // neighbours share the samples between them
  for (int z = 0; z < size.z - 1; z += step)
    for (int y = 0; y < size.y - 1; y += step)
      for (int x = 0; x < size.x - 1; x += step)
      {
        const glm::ivec3 low(x, y, z), high = glm::min(low + step, size - 1);
        const glm::ivec3 samples = high - low + 1;
        const std::size_t bytes = sampleBytes * samples.x * samples.y * samples.z;
        const GLuint exact = MakeTexture(format.exact, samples);
        if (!exact)
        {
          this->Release();
          ThrowNoRoom(bytes, "samples");
        }
        this->SampleParts.push_back({ low, high, exact, MakeFilteredView(exact, format.filtered) });
        this->SampleByteCount += bytes;
      }
  this->UpdateSamples(grid, glm::ivec3(0), size - 1);
}

void VolumeTextures::UpdateSamples(
  const hasp::AnyGridView& grid, const glm::ivec3& low, const glm::ivec3& high)
{
  for (const Part& part : this->SampleParts)
  {
    const glm::ivec3 from = glm::max(low, part.low), to = glm::min(high, part.high);
    if (glm::any(glm::greaterThan(from, to)))
      continue;
    const UnpackScope unpack(hasp::GeometryOf(grid).dims, from);
    const glm::ivec3 at = from - part.low, size = to - from + 1;
    glBindTexture(GL_TEXTURE_3D, part.exact);
    std::visit(
      [&]<typename T>(const hasp::GridView<const T>& view)
      {
        const Format format = FormatOf<T>();
        glTexSubImage3D(GL_TEXTURE_3D, 0, at.x, at.y, at.z, size.x, size.y, size.z, format.send,
          format.type, view.data);
      },
      grid);
  }
  glBindTexture(GL_TEXTURE_3D, 0);
}

void VolumeTextures::UploadBlocks(const hasp::MinMaxBlocks& blocks)
{
  this->ReleaseBlocks();
  if (blocks.Count() == 0)
    return;
  this->BlockTexture = MakeTexture(GL_RG32F, blocks.Blocks());
  if (!this->BlockTexture)
    ThrowNoRoom(blocks.Bytes(), "min-max blocks");
  this->BlockByteCount = blocks.Bytes();
  this->UpdateBlocks(blocks, glm::ivec3(0), blocks.Blocks() - 1);
}

void VolumeTextures::UpdateBlocks(
  const hasp::MinMaxBlocks& blocks, const glm::ivec3& low, const glm::ivec3& high)
{
  const glm::ivec3 size = high - low + 1;
  if (!this->BlockTexture || glm::any(glm::lessThan(size, glm::ivec3(1))))
    return;
  const UnpackScope unpack(blocks.Blocks(), low);
  glBindTexture(GL_TEXTURE_3D, this->BlockTexture);
  glTexSubImage3D(
    GL_TEXTURE_3D, 0, low.x, low.y, low.z, size.x, size.y, size.z, GL_RG, GL_FLOAT, blocks.Data());
  glBindTexture(GL_TEXTURE_3D, 0);
}

void VolumeTextures::ReleaseBlocks()
{
  if (this->BlockTexture)
    glDeleteTextures(1, &this->BlockTexture);
  this->BlockTexture = 0;
  this->BlockByteCount = 0;
}

void VolumeTextures::Release()
{
  for (const Part& part : this->SampleParts)
    for (const GLuint name : { part.filtered, part.exact })
      glDeleteTextures(1, &name);
  this->ReleaseBlocks();
  *this = {};
}
