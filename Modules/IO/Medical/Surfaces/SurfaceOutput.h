#pragma once
#include "Files/AtomicFile.h"
#include "Grid/TriangleMesh.h"
#include "vtkHaspPartLabel.h"

#include <string>
#include <vector>

namespace hasp
{

/// Collects small pieces for a file.
class PieceWriter
{
public:
  explicit PieceWriter(AtomicFile& output) : Output(output) {}
  template <typename T>
  void Add(const T& value)
  {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    this->Add(bytes, sizeof(T));
  }
  void Add(const char* bytes, std::size_t size)
  {
    this->Piece.insert(this->Piece.end(), bytes, bytes + size);
    if (this->Piece.size() >= std::size_t(1) << 20)
      this->Flush();
  }
  void Flush()
  {
    this->Output.Write(this->Piece.data(), this->Piece.size());
    this->Piece.clear();
  }

private:
  AtomicFile& Output;
  std::vector<char> Piece;
};

/// One function a format; WriteSurface picks. `narrow`: the points are float32.
void WriteStl(const TriangleMesh& mesh, bool narrow, const PartLabel& label, PieceWriter& into);
void WritePly(const TriangleMesh& mesh, bool narrow, const PartLabel& label, PieceWriter& into);
void WriteObj(const TriangleMesh& mesh, bool narrow, const PartLabel& label, PieceWriter& into);

struct NamedMesh
{
  std::string name; ///< may be empty
  TriangleMesh mesh;
};

/// The bytes of a .3mf. Throws std::runtime_error for what lib3mf refuses.
std::vector<char> EncodeThreeMf(const std::vector<NamedMesh>& meshes, const PartLabel& label);

} // namespace hasp
