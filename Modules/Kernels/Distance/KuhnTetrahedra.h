#pragma once
#include <glm/vec3.hpp>

#include <utility>

namespace hasp
{

/// Corner c of a cell is at (c&1, c>>1&1, c>>2). The six tetrahedra 0, a, b, 7 walk from corner 0
/// to 7 along the axes in each order, and match across the faces of cells; odd orders have their
/// middle corners swapped, so that all are positively oriented.
inline constexpr int KuhnTetrahedra[6][4] = { { 0, 1, 3, 7 }, { 0, 5, 1, 7 }, { 0, 3, 2, 7 },
  { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 6, 4, 7 } };

inline glm::ivec3 CellCorner(int corner)
{
  return { corner & 1, corner >> 1 & 1, corner >> 2 };
}

/// How a surface passes between the corners of a positively oriented tetrahedron.
struct TetrahedronSides
{
  int inside = 0;     ///< corners inside; 0 and 4: no surface
  int corner[4];      ///< those inside first
  bool odd = false;   ///< corner is an odd permutation
  int crossings = 0;  ///< edges crossed: 3 or 4
  int crossing[4][2]; ///< places in `corner`, inside first: once round the surface,
                      ///< counter-clockwise seen from outside unless odd
};

inline TetrahedronSides SidesOf(const bool (&inside)[4])
{
  TetrahedronSides sides;
  for (int n = 0; n < 4; ++n)
    if (inside[n])
      sides.corner[sides.inside++] = n;
  for (int n = 0, at = sides.inside; n < 4; ++n)
    if (!inside[n])
      sides.corner[at++] = n;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b)
      sides.odd ^= sides.corner[a] > sides.corner[b];
  constexpr int one[3][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 } };
  constexpr int two[4][2] = { { 0, 2 }, { 0, 3 }, { 1, 3 }, { 1, 2 } };
  constexpr int three[3][2] = { { 0, 3 }, { 1, 3 }, { 2, 3 } };
  sides.crossings = sides.inside == 2 ? 4 : sides.inside % 4 == 0 ? 0 : 3;
  for (int n = 0; n < sides.crossings; ++n)
    for (int e = 0; e < 2; ++e)
      sides.crossing[n][e] = sides.inside == 1   ? one[n][e]
                             : sides.inside == 2 ? two[n][e]
                                                 : three[n][e];
  return sides;
}

} // namespace hasp
