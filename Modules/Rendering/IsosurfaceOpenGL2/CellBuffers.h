#ifndef CellBuffers_h
#define CellBuffers_h

#include "Isosurface/ClusterCulling.h"

#include <functional>

/// Active cells on the GPU: two shader storage buffers and an empty vertex array. Nothing is
/// allocated before Upload. Threads: RENDER, with the context current.
class CellBuffers
{
public:
  /// Replaces what was there. Throws std::runtime_error if the GPU has no memory for it.
  void Upload(const hasp::ClusteredCells& cells);
  void Release();
  bool Uploaded() const { return this->VertexArray != 0; }
  std::size_t Bytes() const { return this->CellBytes + this->ClusterBytes; }

  /// Draws the ranges, `verticesPerCell` vertices each, as `primitive` (GL_POINTS, GL_TRIANGLES). A
  /// storage block has a largest size: cells are bound in parts, and before each
  /// `setFirstCell(cell)` is called.
  void Draw(const std::vector<hasp::CellRange>& ranges, unsigned int primitive, int verticesPerCell,
    const std::function<void(int)>& setFirstCell) const;

private:
  unsigned int Cells = 0, Clusters = 0, VertexArray = 0;
  std::size_t CellBytes = 0, ClusterBytes = 0, BytesPerCell = 0;
};

#endif
