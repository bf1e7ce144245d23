// How active cells are packed. GLSL and C++ compile this same text (C++ through ClusteredCells.h).
//
// A cluster is up to 8^3 cells, HaspClusterWords words (CellCluster of ClusteredCells.h):
//   words 0..15   which cells are active: bit y << 3 | x of the 64 bits of slice z, words 2z and 2z + 1
//   words 16..19  how many of its corners lie before corner slices 1..8, 16 bits each, the lower half first
//   word 20       where its corners begin, in words of the corner stream
//   word 21       number of its first active cell; cells count on in the order of the bits
//   word 22       origin x | y << 13, in units of 8 cells; width << 26: bits of a corner in the stream
//   word 23       origin z, in units of 8 cells; base << 16: what is added to a 16-bit corner
//
// Corners are stored once a cluster, x fastest, and only where an active cell of the cluster touches them;
// so their places follow from the cells' bits, and there is neither an index nor a corner mask.
// Width is 32 for floats, 8 for compact cells, else the fewest bits that hold the cluster's range.

const uint HaspClusterWords = 24u;

HASP_FUNCTION uvec3 HaspClusterOrigin(uvec2 place) // words 22 and 23
{
  return uvec3(place.x & 0x1FFFu, (place.x >> 13u) & 0x1FFFu, place.y & 0x1FFFu) * 8u;
}

HASP_FUNCTION uint HaspCornerWidth(uvec2 place)
{
  return place.x >> 26u;
}

HASP_FUNCTION uint HaspCornerBase(uvec2 place)
{
  return place.y >> 16u;
}

HASP_FUNCTION uint HaspLowBits(uint count) // count ones, 0..32
{
  return count < 32u ? (1u << count) - 1u : 0xFFFFFFFFu;
}

HASP_FUNCTION uint HaspCountBits(uvec2 bits)
{
  return uint(bitCount(bits.x)) + uint(bitCount(bits.y));
}

// Place y << 3 | x of the n-th (from 0) of the set bits; there must be more than n.
HASP_FUNCTION uint HaspSelectBit(uvec2 bits, uint n)
{
  uint place = 0u, word = bits.x, low = uint(bitCount(bits.x));
  if (n >= low)
  {
    n -= low;
    word = bits.y;
    place = 32u;
  }
  for (uint span = 16u; span > 0u; span >>= 1u)
  {
    uint below = uint(bitCount(word & HaspLowBits(span)));
    if (n >= below)
    {
      n -= below;
      word >>= span;
      place += span;
    }
  }
  return place;
}

// Which of the 9x9 corners of a slice are stored, from the cells that touch it (those of the cell slices
// below and above it, or-ed): 8x8 of them as bits like the cells', those at x = 8 by y, those at y = 8 by x.
HASP_FUNCTION uvec2 HaspCornerSquare(uvec2 cells)
{
  uvec2 wide = cells | ((cells & 0x7F7F7F7Fu) << 1u);
  return uvec2(wide.x | (wide.x << 8u), wide.y | (wide.y << 8u) | (wide.x >> 24u));
}

HASP_FUNCTION uint HaspCornerColumn(uvec2 cells)
{
  uvec2 last = (((cells >> 7u) & 0x01010101u) * 0x01020408u) >> 24u; // gathers 4 bits of a column each
  uint column = last.x | (last.y << 4u);
  return column | (column << 1u);
}

HASP_FUNCTION uint HaspCornerRow(uvec2 cells)
{
  uint row = cells.y >> 24u;
  return row | (row << 1u);
}

// How many corners of the slice are stored before the one at x, y (0..8 each), whose cells are given. The one
// at x + 1, if it is stored too, is the next.
HASP_FUNCTION uint HaspCornersBefore(uvec2 cells, uint x, uint y)
{
  uint place = min(8u * y + x, 64u);
  uvec2 below = uvec2(HaspLowBits(min(place, 32u)), HaspLowBits(max(place, 32u) - 32u));
  uint count = HaspCountBits(HaspCornerSquare(cells) & below) +
    uint(bitCount(HaspCornerColumn(cells) & HaspLowBits(min(y, 8u))));
  return y < 8u ? count : count + uint(bitCount(HaspCornerRow(cells) & HaspLowBits(x)));
}
