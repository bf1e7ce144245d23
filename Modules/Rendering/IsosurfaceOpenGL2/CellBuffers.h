#ifndef CellBuffers_h
#define CellBuffers_h

#include "Isosurface/ClusteredCells.h"

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

  /// Draws all cells, in ranges no larger than a storage block may be; `beforeRange(firstCell)`
  /// sets the uniform of that name.
  void Draw(const std::function<void(int)>& beforeRange) const;

private:
  unsigned int Cells = 0, Clusters = 0, VertexArray = 0;
  std::size_t CellBytes = 0, ClusterBytes = 0, BytesPerCell = 0;
};

#endif
