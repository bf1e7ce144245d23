#ifndef CellBuffers_h
#define CellBuffers_h

#include "CellDraws.h"

#include <functional>

/// Active cells on the GPU: clusters and corners as they are, and an empty vertex array. Nothing is
/// allocated before Upload. Threads: RENDER, with the context current.
class CellBuffers
{
public:
  /// Replaces what was there, divided for storage blocks of blockBytes (DivideClusters). Throws
  /// std::runtime_error if the GPU has no memory for it.
  void Upload(const hasp::ClusteredCells& cells, std::size_t blockBytes);
  void Release();
  bool Uploaded() const { return this->VertexArray != 0; }
  std::size_t Bytes() const { return this->ByteCount; }
  const std::vector<hasp::ClusterPart>& Parts() const { return this->PartList; }

  /// Binds the clusters of a part as storage block 0 and their corners as 1.
  void Bind(const hasp::ClusterPart& part) const;
  /// A vertex array for draws that pull their vertices from storage blocks.
  void BindVertexArray() const;
  /// Unbinds storage blocks and vertex array.
  void Unbind() const;

  /// Draws all ranges; each is bound, then `prepare` is called, then it is drawn. In batches: no
  /// more than two of 20,000 cells wait at a time, for software OpenGL keeps some 300 bytes a cell
  /// that waits, and never gives them back.
  void Draw(const CellDraws& draws, const std::function<void(const DrawRange&)>& prepare,
    bool inBatches) const;

private:
  unsigned int Clusters = 0, Corners = 0, VertexArray = 0;
  std::size_t ByteCount = 0;
  std::vector<hasp::ClusterPart> PartList;
  std::vector<std::uint16_t> CellCounts; ///< of each cluster
};

#endif
