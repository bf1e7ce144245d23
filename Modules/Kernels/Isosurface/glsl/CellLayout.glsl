// How an active cell is packed. GLSL and C++ compile this same text (C++ through ClusteredCells.h).
//
// A cell is one word of place and its 8 corner samples, x fastest:
//   word 0      cluster index << 9 | z << 6 | y << 3 | x    (x, y, z: place inside the 8^3 cluster)
//   integers    words 1..4, two 16-bit samples each, the lower half first     (20 bytes)
//   floats      words 1..8                                                    (36 bytes)
// A cluster is two words: origin x | y << 16, origin z | flags << 16, in units of 8 cells.

const uint HaspIntegerCellWords = 5u;
const uint HaspFloatCellWords = 9u;

HASP_FUNCTION uint HaspCellCluster(uint word)
{
  return word >> 9u;
}

HASP_FUNCTION uvec3 HaspCellInCluster(uint word)
{
  return uvec3(word & 7u, (word >> 3u) & 7u, (word >> 6u) & 7u);
}

HASP_FUNCTION uvec3 HaspClusterOrigin(uvec2 cluster)
{
  return uvec3(cluster.x & 0xFFFFu, cluster.x >> 16u, cluster.y & 0xFFFFu) * 8u;
}
