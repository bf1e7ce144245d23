#pragma once
#include "Grid/TriangleMesh.h"

#include <string>

namespace hasp
{

/// The mesh of a part that must be one piece without hollows, without its crumbs: pieces of less
/// than a hundredth of the largest one's volume. Throws std::runtime_error "WHO: …" with all
/// volumes and the remedy if it falls into pieces or encloses a hollow, and "WHO: nothing is left"
/// if there is none. Any thread; O(triangles).
TriangleMesh OnePiece(const TriangleMesh& mesh, const std::string& who, const std::string& remedy);

} // namespace hasp
