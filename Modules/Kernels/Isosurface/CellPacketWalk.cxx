#include "Isosurface/CellPacket.h"

// This file is compiled once for each instruction set, and Highway chooses at run time: 16 rays
// side by side, or 8; where fewer would fit they go by themselves.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Isosurface/CellPacketWalk.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET & (HWY_AVX2 | HWY_AVX3)
#include "Isosurface/CellPacketCorners-inl.h"
#include "Isosurface/CellPacketRoots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

/// Lanes rays of a packet, from the first on, through box n in step: WalkBox's ways and arithmetic.
template <Kind kind>
class LaneWalk
{
public:
  HWY_INLINE LaneWalk(const CellStore& store, std::uint32_t n, CellPacket& packet, int first)
    : Store(store),
      Box(store.boxes[n]),
      Cluster(store.clusters[this->Box.cluster]),
      Packet(packet),
      First(first)
  {
  }

  /// Which of the rays the box has a nearer hit for.
  HWY_INLINE CellPacket::Rays Go(CellPacket::Rays rays)
  {
    rays &= this->Enter();
    if (rays == 0)
      return 0;
    this->FindCells();
    const CornerTables tables(this->Cluster);
    Mask walking = MaskOf(rays);
    CellPacket::Rays hits = 0;
    while (true)
    {
      // Every ray on to an active cell, or out of the box.
      this->Look();
      while (true)
      {
        const Mask on = hn::And(walking, this->IsActive());
        walking = hn::AndNot(hn::AndNot(on, this->Last), walking);
        const Mask onwards = hn::AndNot(on, walking);
        if (hn::AllFalse(ints, onwards))
          break;
        this->Advance(onwards);
        this->Look();
      }
      if (hn::AllFalse(ints, walking))
        return hits;
      const Mask found = this->Meet(tables, walking, hits);
      walking = hn::AndNot(hn::Or(found, this->Last), walking);
      if (hn::AllFalse(ints, walking))
        return hits;
      this->Advance(walking);
    }
  }

private:
  /// A point of the rays in coordinates of the cluster, exactly in the plane where an axis is
  /// crossed.
  HWY_INLINE Floats PointAt(int axis, Wide t, Wide way, double begin, double stop) const
  {
    const Wide origin(this->Packet.origin[axis] + this->First),
      direction(this->Packet.direction[axis] + this->First);
    const Wide p = origin + t * direction - Wide(double(this->Base[axis]));
    const Wide face = Select(direction < Wide(0.0), Wide(begin), Wide(stop));
    return hn::Max(Select(way == t, face, p).ToFloats(), hn::Zero(floats));
  }

  /// Where the rays enter and leave the box; those that do, before their nearest hit.
  HWY_INLINE CellPacket::Rays Enter()
  {
    const glm::ivec3 low = this->Box.Low(), high = this->Box.High();
    this->FirstCell = low & 7;
    this->Base = low - this->FirstCell;
    this->LastCell = high - this->Base;
    Wide near[3] = { Wide(0.0), Wide(0.0), Wide(0.0) };
    for (int axis = 0; axis < 3; ++axis)
    {
      const Wide origin(this->Packet.origin[axis] + this->First),
        inverse(this->Packet.inverse[axis] + this->First);
      const Wide u = (Wide(double(low[axis])) - origin) * inverse,
                 v = (Wide(double(high[axis] + 1)) - origin) * inverse;
      near[axis] = Least(u, v);
      this->Far[axis] = Most(u, v);
    }
    this->From = Most(Most(near[0], near[2]), Most(near[1], Wide(0.0)));
    this->Until = Least(
      Least(this->Far[0], this->Far[2]), Least(this->Far[1], Wide(this->Packet.end + this->First)));
    const CellPacket::Rays entered = (this->From <= this->Until).Bits() &
                                     (this->From <= Wide(this->Packet.t + this->First)).Bits();
    if (entered != 0)
      for (int axis = 0; axis < 3; ++axis)
        this->Entry[axis] = this->PointAt(
          axis, this->From, near[axis], this->LastCell[axis] + 1, this->FirstCell[axis]);
    return entered;
  }

  /// The cells that rays begin in, and the ways to the next face of each axis.
  HWY_INLINE void FindCells()
  {
    const Floats zero = hn::Zero(floats);
    this->Place = hn::Zero(ints);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Floats inverse = hn::Load(floats, this->Packet.inverseF[axis] + this->First);
      const Mask forwards = MaskOf(inverse >= zero);
      const Ints first = Splat(this->FirstCell[axis]), last = Splat(this->LastCell[axis]);
      const Ints cell = hn::Max(hn::Min(hn::ConvertTo(ints, this->Entry[axis]), last), first);
      const Ints face = cell + Select(forwards, Splat(1), Splat(0));
      const Floats way = (hn::ConvertTo(floats, face) - this->Entry[axis]) * inverse;
      const Ints next = hn::ConvertTo(ints, hn::Min(hn::Max(way, zero), Splat(cells::LongWay)));
      const Ints limit = Select(forwards, last, first);
      this->Next[axis] = Select(cell == limit, Splat(Never), next);
      this->Step[axis] = Select(forwards, Splat(1 << 3 * axis), Splat(-(1 << 3 * axis)));
      this->Limit[axis] = hn::ShiftLeftSame(limit, 3 * axis);
      this->Place = this->Place + hn::ShiftLeftSame(cell, 3 * axis);
      this->Crossed[axis] = MaskOf(0U);
    }
    this->Ticks = hn::Zero(ints);
    this->End = ((this->Until - this->From) * Wide(cells::TicksPerVoxel)).ToInts();
  }

  /// The next faces on the way.
  HWY_INLINE void Look()
  {
    this->Way = hn::Min(hn::Min(this->Next[0], this->Next[1]), this->Next[2]);
    this->Last = hn::Not(this->Way < this->End);
    for (int axis = 0; axis < 3; ++axis)
      this->Crossing[axis] = this->Next[axis] == this->Way;
  }
  HWY_INLINE void Advance(Mask rays)
  {
    this->Ticks = Select(rays, this->Way, this->Ticks);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Mask crossing = hn::And(rays, this->Crossing[axis]);
      const Ints delta = hn::Load(ints, this->Packet.delta[axis] + this->First);
      this->Crossed[axis] = hn::Or(hn::AndNot(rays, this->Crossed[axis]), crossing);
      this->Place = Select(crossing, this->Place + this->Step[axis], this->Place);
      this->Next[axis] = Select(crossing, this->Next[axis] + delta, this->Next[axis]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const Mask atLimit = hn::And(this->Place, Splat(7 << 3 * axis)) == this->Limit[axis];
      this->Next[axis] = Select(atLimit, Splat(Never), this->Next[axis]);
    }
  }
  HWY_INLINE Mask IsActive() const
  {
    const Words place = hn::BitCast(words, this->Place);
    const Words cells = ByteTable(this->Cluster.active.data()).WordOf(hn::ShiftRight<3>(place));
    const Words bit = hn::Shl(hn::Set(words, 1U), hn::And(place, hn::Set(words, 31U)));
    return hn::RebindMask(ints, hn::TestBit(cells, bit));
  }

  /// The rays on active cells that meet the surface there; nearer hits are kept, and added to hits.
  HWY_INLINE Mask Meet(const CornerTables& tables, Mask rays, CellPacket::Rays& hits)
  {
    const Floats zero = hn::Zero(floats), one = Splat(1.0F);
    const Floats perTick = Splat(static_cast<float>(1.0 / cells::TicksPerVoxel));
    const Floats ticks = hn::ConvertTo(floats, this->Ticks) * perTick,
                 way = hn::ConvertTo(floats, this->Way) * perTick;
    const bool anyLast = !hn::AllFalse(ints, hn::And(rays, this->Last));
    Floats a[3], b[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Floats direction = hn::Load(floats, this->Packet.directionF[axis] + this->First);
      const Mask forwards =
        MaskOf(hn::Load(floats, this->Packet.inverseF[axis] + this->First) >= zero);
      const Floats cell = hn::ConvertTo(floats,
        hn::And(BitCast(ints, hn::Shr(hn::BitCast(words, this->Place), hn::Set(words, 3U * axis))),
          Splat(7)));
      const Floats from = this->Entry[axis] + ticks * direction - cell,
                   to = this->Entry[axis] + way * direction - cell;
      a[axis] = Select(this->Crossed[axis], Select(forwards, zero, one), from);
      b[axis] = Select(this->Crossing[axis], Select(forwards, one, zero), to);
      if (anyLast)
        b[axis] = Select(this->Last,
          this->PointAt(
            axis, this->Until, this->Far[axis], this->FirstCell[axis], this->LastCell[axis] + 1) -
            cell,
          b[axis]);
      a[axis] = hn::Min(hn::Max(a[axis], zero), one);
      b[axis] = hn::Min(hn::Max(b[axis], zero), one);
    }
    const Wide perTickWide(1.0 / cells::TicksPerVoxel);
    const Wide tA = this->From + Wide(this->Ticks) * perTickWide;
    CellPacket::Rays onStart = this->Packet.fromSurface >> this->First;
    if (onStart != 0)
      onStart &= (tA < Wide(cells::OnStart)).Bits();

    Floats corners[8], s = zero;
    Decode<kind>(this->Store, this->Cluster, tables, this->Place, rays, corners);
    const Mask found =
      FirstRoot<kind>(corners, a, b, rays, onStart, this->Packet.startInside >> this->First, s);
    if (hn::AllFalse(ints, found))
      return found;

    const WideMask lastWide = WideMaskOf(BitsOf(this->Last));
    const Wide tB = Select(lastWide, this->Until, this->From + Wide(this->Way) * perTickWide);
    const Wide t = tA + Wide(s) * (tB - tA), best(this->Packet.t + this->First);
    const Ints cluster = Splat(static_cast<std::int32_t>(this->Box.cluster));
    const Mask smaller = hn::Load(ints, this->Packet.cluster + this->First) > cluster;
    const CellPacket::Rays nearer =
      BitsOf(found) & ((t < best).Bits() | ((t == best).Bits() & BitsOf(smaller)));
    const Mask keep = MaskOf(nearer);
    StoreWhere(nearer, t, this->Packet.t + this->First);
    hn::BlendedStore(cluster, keep, ints, this->Packet.cluster + this->First);
    hn::BlendedStore(this->Place, keep, ints, this->Packet.place + this->First);
    const auto keepFloats = hn::RebindMask(floats, keep);
    for (int c = 0; c < 8; ++c)
      hn::BlendedStore(corners[c], keepFloats, floats, this->Packet.corners[c] + this->First);
    for (int axis = 0; axis < 3; ++axis)
      hn::BlendedStore(a[axis] * (one - s) + b[axis] * s, keepFloats, floats,
        this->Packet.local[axis] + this->First);
    hits |= nearer;
    return found;
  }

  static constexpr std::int32_t Never = 0x7FFFFFFF;

  const CellStore& Store;
  const CellBox& Box;
  const CellCluster& Cluster;
  CellPacket& Packet;
  const int First;
  glm::ivec3 Base, FirstCell, LastCell; ///< of the cluster; of the box in it
  Wide From{ 0.0 }, Until{ 0.0 }, Far[3] = { Wide(0.0), Wide(0.0), Wide(0.0) };
  Floats Entry[3];
  Ints Place, Ticks, Way, End, Next[3], Step[3], Limit[3];
  Mask Last, Crossing[3], Crossed[3];
};

template <Kind kind>
CellPacket::Rays WalkPacket(
  const CellStore& store, std::uint32_t n, CellPacket::Rays rays, CellPacket& packet)
{
  CellPacket::Rays hits = 0;
  for (int first = 0; first < CellPacket::Size; first += Lanes)
    if (const CellPacket::Rays some = rays >> first & ((1U << Lanes) - 1U))
      hits |= LaneWalk<kind>(store, n, packet, first).Go(some) << first;
  return hits;
}

CellPacketWalk Choose(CornerType type, CellPrecision precision)
{
  if (precision == CellPrecision::Compact)
    return &WalkPacket<Kind::Compact>;
  return type == CornerType::Int16    ? &WalkPacket<Kind::Int16>
         : type == CornerType::UInt16 ? &WalkPacket<Kind::UInt16>
                                      : &WalkPacket<Kind::Float32>;
}

#else

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

CellPacketWalk Choose(CornerType, CellPrecision)
{
  return &singly::Walk;
}
#endif

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hasp
{

HWY_EXPORT(Choose);

CellPacketWalk ChooseCellPacketWalk(CornerType type, CellPrecision precision)
{
  return HWY_DYNAMIC_DISPATCH(Choose)(type, precision);
}

} // namespace hasp
#endif
