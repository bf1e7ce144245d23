#ifndef VolumeTextures_h
#define VolumeTextures_h

#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"

#include <vector>

/// A volume in an OpenGL context: its samples as 3D textures, as many as OpenGL's longest side asks
/// for, and its min-max blocks as another one. Samples are kept as they are, 8 bits
/// as 16; a second view of the same memory lets the driver interpolate. Not released with the
/// object: its context may be gone by then. Threads: RENDER, with the context current; the binding
/// of the active texture unit changes.
class VolumeTextures
{
public:
  /// Cells of one texture: it holds the samples [low, high], both included.
  struct Part
  {
    glm::ivec3 low, high;
    unsigned int exact, filtered;
  };

  ///@{
  /// Replaces what was there. longestSide: samples. Throws std::runtime_error if the GPU has no
  /// room.
  void UploadSamples(const hasp::AnyGridView& grid, int longestSide);
  void UploadBlocks(const hasp::MinMaxBlocks& blocks);
  ///@}
  ///@{
  /// What has changed of them, [low, high], both included.
  void UpdateSamples(const hasp::AnyGridView& grid, const glm::ivec3& low, const glm::ivec3& high);
  void UpdateBlocks(
    const hasp::MinMaxBlocks& blocks, const glm::ivec3& low, const glm::ivec3& high);
  ///@}
  void ReleaseBlocks();
  void Release();

  const std::vector<Part>& Parts() const { return this->SampleParts; }
  unsigned int Blocks() const { return this->BlockTexture; } ///< 0: none
  std::size_t SampleBytes() const { return this->SampleByteCount; }
  std::size_t BlockBytes() const { return this->BlockByteCount; }

private:
  std::vector<Part> SampleParts;
  unsigned int BlockTexture = 0;
  std::size_t SampleByteCount = 0, BlockByteCount = 0;
};

#endif
