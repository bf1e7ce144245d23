// Private to CellPacketWalk.cxx, and compiled there once an instruction set: the corners of active
// cells, one cell a lane, from the bits of their cluster. What Decode of CellSegment.h gives.
#if defined(HASP_CELL_PACKET_CORNERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HASP_CELL_PACKET_CORNERS_INL
#undef HASP_CELL_PACKET_CORNERS_INL
#else
#define HASP_CELL_PACKET_CORNERS_INL
#endif

#include "Isosurface/CellLanes-inl.h"
#include "Isosurface/CellSegment.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

using cells::Kind;

/// 64 bytes to look up in, by lane.
class ByteTable
{
public:
  HWY_INLINE explicit ByteTable(const void* bytes) : Bytes(static_cast<const std::uint32_t*>(bytes))
  {
  }
  /// The word that byte n of the table lies in.
  HWY_INLINE Words WordOf(Words n) const
  {
    if constexpr (Lanes == 16)
      return hn::TableLookupLanes(
        hn::LoadU(words, this->Bytes), hn::IndicesFromVec(words, hn::ShiftRight<2>(n)));
    else
      return hn::GatherIndex(words, this->Bytes, hn::BitCast(ints, hn::ShiftRight<2>(n)));
  }
  HWY_INLINE Words operator[](Words n) const
  {
    const Words shift = hn::ShiftLeft<3>(hn::And(n, hn::Set(words, 3U)));
    return hn::And(hn::Shr(this->WordOf(n), shift), hn::Set(words, 255U));
  }

private:
  const std::uint32_t* Bytes;
};

/// Where the corners of a cluster are stored. By slice and row, the corners in the rows before and
/// the row's corners at x = 0..7; for a cell's own row and the next in both its slices. What
/// PlacesOfPairs counts, a cell's row of 8 bits in place of its slice of 64.
struct CornerTables
{
  struct Slice
  {
    alignas(64) std::uint64_t before[8], row[8], beforeNext[8], nextRow[8];
  };
  Slice low, high;
  std::uint32_t slices[16]; ///< corners before each of 9 slices

  HWY_INLINE explicit CornerTables(const CellCluster& cluster)
  {
    std::uint64_t cells[10] = {}; // of the slices -1 to 8
    std::copy(cluster.active.begin(), cluster.active.end(), cells + 1);
    this->slices[0] = 0;
    std::copy(cluster.cornersBefore.begin(), cluster.cornersBefore.end(), this->slices + 1);
    Fill(this->low, cells);
    Fill(this->high, cells + 1);
  }

private:
  HWY_INLINE static void Fill(Slice& slice, const std::uint64_t* cells)
  {
    const hn::CappedTag<std::uint64_t, 8> d;
    const hn::Repartition<std::uint8_t, decltype(d)> bytes;
    const auto column = hn::Set(d, 0x8080808080808080U);
    for (std::size_t z = 0; z < 8; z += hn::Lanes(d))
    {
      const auto touching = hn::Or(hn::LoadU(d, cells + z), hn::LoadU(d, cells + z + 1));
      const auto wide = hn::Or(touching, hn::ShiftLeft<1>(hn::AndNot(column, touching)));
      const auto square = hn::Or(wide, hn::ShiftLeft<8>(wide));
      const auto edge = hn::ShiftRight<7>(hn::And(touching, column)); // corners at x = 8
      const auto inRow = hn::BitCast(d, hn::PopulationCount(hn::BitCast(bytes, square))) +
                         hn::Or(edge, hn::ShiftLeft<8>(edge));
      auto until = inRow + hn::ShiftLeft<8>(inRow);
      until = until + hn::ShiftLeft<16>(until);
      until = until + hn::ShiftLeft<32>(until);
      const auto nextRow =
        hn::Or(hn::ShiftRight<8>(square), hn::ShiftLeft<56>(hn::ShiftRight<56>(wide)));
      hn::Store(hn::ShiftLeft<8>(until), d, slice.before + z);
      hn::Store(square, d, slice.row + z);
      hn::Store(until, d, slice.beforeNext + z);
      hn::Store(nextRow, d, slice.nextRow + z);
    }
  }
};

/// 32 bits of the stream a lane, from bit n on.
HWY_INLINE Words LoadBits(const std::uint32_t* stream, Words n)
{
  const auto load = [&](const auto& half) HWY_ATTR
  {
    const auto bit = hn::PromoteTo(longs, half);
    const auto offset = hn::BitCast(hn::RebindToSigned<decltype(longs)>(), hn::ShiftRight<3>(bit));
    const auto loaded =
      hn::GatherOffset(longs, reinterpret_cast<const std::uint64_t*>(stream), offset);
    return hn::TruncateTo(halfWords, hn::Shr(loaded, hn::And(bit, hn::Set(longs, 7U))));
  };
  return hn::Combine(words, load(hn::UpperHalf(halfWords, n)), load(hn::LowerHalf(halfWords, n)));
}

/// The 8 corners of an active cell a lane minus the isovalue, x fastest. Lanes that are not `on`
/// read any corners of the cluster.
template <Kind kind>
HWY_INLINE void Decode(const CellStore& store, const CellCluster& cluster,
  const CornerTables& tables, Ints placeOf, Mask on, Floats (&corners)[8])
{
  const Words place = hn::BitCast(words, placeOf), row = hn::ShiftRight<3>(place),
              slice = hn::ShiftRight<6>(place);
  const Words ones = hn::Set(words, 1U);
  const Words left = hn::Shl(ones, hn::And(place, hn::Set(words, 7U))) - ones;
  const ByteTable slices(tables.slices);
  const auto at =
    [&](const Words& before, const std::uint64_t* rowsBefore, const std::uint64_t* rows) HWY_ATTR
  {
    const Words count = before + ByteTable(rowsBefore)[row] +
                        hn::PopulationCount(hn::And(ByteTable(rows)[row], left));
    return hn::IfThenElseZero(hn::RebindMask(words, on), count);
  };
  const Words beforeLow = slices.WordOf(hn::ShiftLeft<2>(slice)),
              beforeHigh = slices.WordOf(hn::ShiftLeft<2>(slice + ones));
  const Words pairs[4] = { at(beforeLow, tables.low.before, tables.low.row),
    at(beforeLow, tables.low.beforeNext, tables.low.nextRow),
    at(beforeHigh, tables.high.before, tables.high.row),
    at(beforeHigh, tables.high.beforeNext, tables.high.nextRow) };
  const std::uint32_t* stream = store.corners + cluster.firstWord;

  for (int p = 0; p < 4; ++p)
  {
    if constexpr (kind == Kind::Float32)
    {
      const Floats isovalue = Splat(store.isovalue);
      const auto* samples = reinterpret_cast<const float*>(stream);
      const Ints n = hn::BitCast(ints, pairs[p]);
      corners[2 * p] = hn::GatherIndex(floats, samples, n) - isovalue;
      corners[2 * p + 1] = hn::GatherIndex(floats, samples + 1, n) - isovalue;
    }
    else if constexpr (kind == Kind::Compact)
    {
      const Words pair = hn::GatherOffset(words, stream, hn::BitCast(ints, pairs[p]));
      const Words byte = hn::Set(words, 255U);
      const auto level = [&](const Words& code) HWY_ATTR
      { return hn::GatherIndex(floats, store.levels.data(), hn::BitCast(ints, code)); };
      corners[2 * p] = level(hn::And(pair, byte));
      corners[2 * p + 1] = level(hn::And(hn::ShiftRight<8>(pair), byte));
    }
    else
    {
      const auto width = static_cast<int>(cluster.place.x >> 26U);
      const Words bits = pairs[p] * hn::Set(words, static_cast<std::uint32_t>(width));
      const Words pair = LoadBits(stream, bits);
      const Words mask = hn::Set(words, (1U << width) - 1U);
      const std::uint32_t base = cluster.place.y >> 16U;
      const Ints added = Splat(
        kind == Kind::Int16 ? std::int32_t(static_cast<std::int16_t>(base)) : std::int32_t(base));
      const Floats isovalue = Splat(store.isovalue);
      const auto sample = [&](const Words& code) HWY_ATTR
      { return hn::ConvertTo(floats, hn::BitCast(ints, hn::And(code, mask)) + added) - isovalue; };
      corners[2 * p] = sample(pair);
      corners[2 * p + 1] = sample(hn::ShiftRightSame(pair, width));
    }
  }
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
