#ifndef CellBuffers_h
#define CellBuffers_h

#include "Isosurface/ClusterCulling.h"

#include <functional>

/// Active cells on the GPU: clusters and corners as they are, and an empty vertex array. Nothing is
/// allocated before Upload. Threads: RENDER, with the context current.
class CellBuffers
{
public:
  /// Replaces what was there. Throws std::runtime_error if the GPU has no memory for it.
  void Upload(const hasp::ClusteredCells& cells);
  void Release();
  bool Uploaded() const { return this->VertexArray != 0; }
  std::size_t Bytes() const { return this->ByteCount; }

  /// Draws clusters, given by number in ascending order, `verticesPerCell` vertices a cell, as
  /// `primitive` (GL_POINTS, GL_TRIANGLES). A storage block has a largest size: clusters are bound
  /// in parts, and before each `setFirstWord(word of the first corner bound)` is called.
  void Draw(const std::vector<std::uint32_t>& clusters, unsigned int primitive, int verticesPerCell,
    const std::function<void(int)>& setFirstWord) const;

private:
  /// Clusters [first, end) and their corners fit a storage block each.
  struct Part
  {
    std::size_t first, end, firstWord, endWord;
  };
  void Divide(const hasp::ClusteredCells& cells);

  unsigned int Clusters = 0, Corners = 0, VertexArray = 0;
  std::size_t ByteCount = 0;
  std::vector<Part> Parts;
  std::vector<std::uint16_t> CellCounts; ///< of each cluster
};

#endif
