#include "Isosurface/CellPacket.h"

// Compiled as CellPacketWalk.cxx is.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Isosurface/CellPacketRays.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET & (HWY_AVX2 | HWY_AVX3)
#include "Isosurface/CellLanes-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

/// PictureRays::Of for Lanes pixels of a packet, from the first on.
HWY_INLINE CellPacket::Rays PixelLanes(
  const PictureRays& picture, const glm::ivec2& from, int first, PacketRays& rays)
{
  static_assert(CellPacket::Side == 4);
  const Ints n = hn::Iota(ints, first);
  const Wide half(0.5), one(1.0), zero(0.0), infinity(std::numeric_limits<double>::infinity());
  const glm::dvec2 size = picture.GetPixelSize();
  const Wide x = (Wide(hn::And(n, Splat(3)) + Splat(from.x)) + half) * Wide(size.x) - one,
             y = (Wide(hn::ShiftRight<2>(n) + Splat(from.y)) + half) * Wide(size.y) - one;
  const glm::dmat4& m = picture.GetToIndex();
  const auto a = [&](int row) HWY_ATTR
  { return Wide(m[0][row]) * x + Wide(m[1][row]) * y + Wide(m[3][row]); };
  const Wide aw = a(3), bw(m[2][3]);
  const Wide origin[3] = { a(0) / aw, a(1) / aw, a(2) / aw };
  const Wide direction[3] = { Wide(m[2][0]) * aw - a(0) * bw, Wide(m[2][1]) * aw - a(1) * bw,
    Wide(m[2][2]) * aw - a(2) * bw };
  Wide tMin = Negative(infinity), tMax = infinity;
  CellPacket::Rays outside = 0;
  for (const glm::dvec4& plane : picture.GetPlanes())
  {
    const Wide px(plane.x), py(plane.y), pz(plane.z);
    const Wide at = px * origin[0] + py * origin[1] + pz * origin[2] + Wide(plane.w);
    const Wide slope = px * direction[0] + py * direction[1] + pz * direction[2];
    const WideMask towards = zero < slope, away = slope < zero;
    const Wide t = Negative(at) / slope;
    tMin = Select(towards, Select(tMin < t, t, tMin), tMin);
    tMax = Select(away, Select(t < tMax, t, tMax), tMax);
    outside |= ~towards.Bits() & ~away.Bits() & (at < zero).Bits();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Store(origin[axis], rays.origin[axis] + first);
    Store(direction[axis], rays.direction[axis] + first);
  }
  Store(tMin, rays.tMin + first);
  Store(tMax, rays.tMax + first);
  return (tMin <= tMax).Bits() & ~outside;
}

CellPacket::Rays Pixels(const PictureRays& picture, const glm::ivec2& from, PacketRays& rays)
{
  CellPacket::Rays some = 0;
  for (int first = 0; first < CellPacket::Size; first += Lanes)
    some |= PixelLanes(picture, from, first, rays) << first;
  return some;
}

/// BeginWalk for Lanes rays of a packet, from the first on; those that meet the volume. odd: rays
/// that need its care for lengths; not begun here.
HWY_INLINE CellPacket::Rays BeginLanes(const PacketRays& rays, const glm::ivec3& volume, int first,
  CellPacket& packet, CellPacket::Rays& odd)
{
  const Wide zero(0.0), one(1.0), huge(1e300), slack(cells::Slack);
  const Wide given[3] = { Wide(rays.direction[0] + first), Wide(rays.direction[1] + first),
    Wide(rays.direction[2] + first) };
  const Wide origin[3] = { Wide(rays.origin[0] + first), Wide(rays.origin[1] + first),
    Wide(rays.origin[2] + first) };
  const Wide length = Root(given[0] * given[0] + given[1] * given[1] + given[2] * given[2]);
  const Wide tMin(rays.tMin + first), tMax(rays.tMax + first);
  const Wide sum = origin[0] + origin[1] + origin[2], most(std::numeric_limits<double>::max());
  const CellPacket::Rays good =
    (tMin <= tMax).Bits() & (sum <= most).Bits() & (Negative(most) <= sum).Bits();
  const CellPacket::Rays usual = (Wide(1e-100) < length).Bits() & (length < Wide(1e100)).Bits();
  odd = good & ~usual;

  const Wide perLength = one / length;
  Wide near[3] = { zero, zero, zero }, far[3] = { zero, zero, zero };
  WideMask still[3];
  CellPacket::Rays beside = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Wide size(static_cast<double>(volume[axis])), o = origin[axis];
    const WideMask stays = still[axis] = given[axis] == zero;
    const Wide plain = one / Select(stays, zero, given[axis]) * length;
    const Wide inverse = Least(Most(plain, Negative(huge)), huge);
    const Wide u = Negative(o) * inverse, v = (size - o) * inverse;
    near[axis] = Select(stays, Negative(huge), Least(u, v));
    far[axis] = Select(stays, huge, Most(u, v));
    beside |= stays.Bits() & ~((Negative(slack) <= o).Bits() & (o <= size + slack).Bits());
    Store(given[axis] * perLength, packet.direction[axis] + first);
    Store(inverse, packet.inverse[axis] + first);
  }
  const Wide t0 = Most(Most(near[0], near[1]), Most(near[2], tMin * length));
  const Wide t1 = Least(Least(far[0], far[1]), Least(far[2], tMax * length));
  const Wide span = t1 - t0;
  const CellPacket::Rays meet =
    good & usual & ~beside & (zero <= span).Bits() & (span <= Wide(1e100)).Bits();
  Store(span, packet.end + first);
  Store(Wide(std::numeric_limits<double>::infinity()), packet.t + first);
  hn::Store(hn::Zero(ints), ints, packet.cluster + first);

  for (int axis = 0; axis < 3; ++axis)
  {
    const Wide direction(packet.direction[axis] + first), inverse(packet.inverse[axis] + first);
    const Wide end = Wide(double(volume[axis])) - Select(still[axis], slack, zero);
    const Wide moved = origin[axis] + t0 * direction;
    Store(Least(Most(moved, zero), end), packet.origin[axis] + first);
    const Floats ticks =
      (Least(Most(inverse, Wide(-1e20)), Wide(1e20)) * Wide(cells::TicksPerVoxel)).ToFloats();
    hn::Store(direction.ToFloats(), floats, packet.directionF[axis] + first);
    hn::Store(ticks, floats, packet.inverseF[axis] + first);
    hn::Store(hn::ConvertTo(ints, hn::Min(hn::Abs(ticks), Splat(cells::LongWay))), ints,
      packet.delta[axis] + first);
  }
  return meet;
}

CellPacket::Rays Begin(const PacketRays& rays, const glm::ivec3& volume, CellPacket& packet)
{
  packet.fromSurface = packet.startInside = 0;
  CellPacket::Rays meet = 0, odd = 0;
  for (int first = 0; first < CellPacket::Size; first += Lanes)
  {
    CellPacket::Rays some = 0;
    meet |= BeginLanes(rays, volume, first, packet, some) << first;
    odd |= some << first;
  }
  return meet | singly::Begin(rays, odd, volume, packet);
}

/// Hits' depth in a window. Their clusters' origins are read from the clusters' last words.
HWY_INLINE Floats DepthOf(const CellStore& store, const CellPacket& packet, Mask hits, int first,
  const glm::dmat4& indexToClip, const Floats (&local)[3])
{
  constexpr std::int32_t step = sizeof(CellCluster) / sizeof(std::uint32_t);
  const auto* origins = reinterpret_cast<const std::uint32_t*>(store.clusters) + step - 2;
  const Ints at = hn::IfThenElseZero(hits, hn::Load(ints, packet.cluster + first) * Splat(step));
  const Words xy = hn::GatherIndex(words, origins, at), z = hn::GatherIndex(words, origins + 1, at);
  const Words origin[3] = { xy, hn::ShiftRight<13>(xy), z }, thirteen = hn::Set(words, 0x1FFFU);
  const Ints place = hn::Load(ints, packet.place + first);
  Wide index[3] = { Wide(0.0), Wide(0.0), Wide(0.0) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const Ints inCluster = hn::And(hn::ShiftRightSame(place, 3 * axis), Splat(7));
    const Ints corner = hn::BitCast(ints, hn::ShiftLeft<3>(hn::And(origin[axis], thirteen)));
    index[axis] = Wide(corner + inCluster) + Wide(local[axis]);
  }
  const auto clip = [&](int row) HWY_ATTR
  {
    const auto& m = indexToClip;
    return Wide(m[0][row]) * index[0] + Wide(m[1][row]) * index[1] +
           (Wide(m[2][row]) * index[2] + Wide(m[3][row]));
  };
  const Wide half(0.5), depth = half * clip(2) / clip(3) + half;
  return Least(Most(depth, Wide(0.0)), Wide(1.0)).ToFloats();
}

void EndLanes(const CellStore& store, const CellPacket& packet, Mask hits, int first,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  const Floats zero = hn::Zero(floats), one = Splat(1.0F);
  Floats local[3], low[4], high[4], c[4], d[4];
  for (int axis = 0; axis < 3; ++axis)
    local[axis] = Select(hits, hn::Load(floats, packet.local[axis] + first), zero);
  const Floats x = local[0], y = local[1], z = local[2];
  for (int n = 0; n < 4; ++n)
  {
    low[n] = hn::Load(floats, packet.corners[n] + first);
    high[n] = hn::Load(floats, packet.corners[n + 4] + first);
    c[n] = low[n] * (one - z) + high[n] * z;
    d[n] = high[n] - low[n];
  }
  // HaspTrilinearGradient
  const Floats gx = (one - y) * (c[1] - c[0]) + y * (c[3] - c[2]),
               gy = (one - x) * (c[2] - c[0]) + x * (c[3] - c[1]),
               gz = ((one - x) * d[0] + x * d[1]) * (one - y) + ((one - x) * d[2] + x * d[3]) * y;
  const Floats depth = DepthOf(store, packet, hits, first, indexToClip, local);
  hn::StoreInterleaved4(Select(hits, gx, zero), Select(hits, gy, zero), Select(hits, gz, zero),
    Select(hits, depth, Splat(TracedPicture::NoDepth)), floats, &pixels.gradients[first].x);
  hn::StoreInterleaved3(x, y, z, floats, &pixels.places[first].x);
}

void End(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  for (int first = 0; first < CellPacket::Size; first += Lanes)
    EndLanes(store, packet, MaskOf(hits >> first), first, indexToClip, pixels);
  NameCells(store, packet, hits, pixels);
}

#else

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

CellPacket::Rays Pixels(const PictureRays& picture, const glm::ivec2& from, PacketRays& rays)
{
  return singly::Pixels(picture, from, rays);
}

CellPacket::Rays Begin(const PacketRays& rays, const glm::ivec3& volume, CellPacket& packet)
{
  packet.fromSurface = packet.startInside = 0;
  return singly::Begin(rays, CellPacket::All, volume, packet);
}

void End(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  singly::End(store, packet, hits, indexToClip, pixels);
}
#endif

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hasp
{

HWY_EXPORT(Pixels);
HWY_EXPORT(Begin);
HWY_EXPORT(End);

CellPacket::Rays PixelsOfPacket(
  const PictureRays& picture, const glm::ivec2& from, PacketRays& rays)
{
  return HWY_DYNAMIC_DISPATCH(Pixels)(picture, from, rays);
}

CellPacket::Rays BeginCellPacket(
  const PacketRays& rays, const glm::ivec3& volume, CellPacket& packet)
{
  return HWY_DYNAMIC_DISPATCH(Begin)(rays, volume, packet);
}

void EndCellPacket(const CellStore& store, const CellPacket& packet, CellPacket::Rays hits,
  const glm::dmat4& indexToClip, CellPixels& pixels)
{
  HWY_DYNAMIC_DISPATCH(End)(store, packet, hits, indexToClip, pixels);
}

} // namespace hasp
#endif
