#include "Haptics/BlockLanes.h"

// Once an instruction set, as the contact kernels.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Haptics/BlockLanes.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "Grid/VectorTargets.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, BlockPlaces::Count> floats;
constexpr hn::RebindToSigned<decltype(floats)> ints;
constexpr hn::Rebind<std::uint16_t, decltype(floats)> shorts;
constexpr int Lanes = static_cast<int>(hn::MaxLanes(floats));

using Floats = hn::Vec<decltype(floats)>;
using Ints = hn::Vec<decltype(ints)>;
using Mask = hn::Mask<decltype(floats)>;

HWY_INLINE Floats Splat(float v)
{
  return hn::Set(floats, v);
}
HWY_INLINE Ints Splat(std::int32_t v)
{
  return hn::Set(ints, v);
}
HWY_INLINE Floats Mix(Floats a, Floats b, Floats t)
{
  return hn::MulAdd(t, hn::Sub(b, a), a);
}
HWY_INLINE Floats Square(Floats a)
{
  return hn::Mul(a, a);
}
HWY_INLINE Ints Nine(Ints v)
{
  return hn::Add(hn::ShiftLeft<3>(v), v);
}

/// Signed samples at the corners of cells, one a lane.
struct Corners
{
  Floats at[8];

  HWY_INLINE Corners(const BlockSamples& block, Ints first)
  {
    static_assert(BlockSamples::Row == 9);
    const Floats isovalue = Splat(block.isovalue), outward = Splat(block.outward);
    for (int n = 0; n < 8; ++n)
    {
      const float* from = &block.values[BlockSamples::IndexOf(n & 1, n >> 1 & 1, n >> 2)];
      this->at[n] = hn::Mul(outward, hn::Sub(hn::GatherIndex(floats, from, first), isovalue));
    }
  }
};

HWY_INLINE Corners CornersOf(const BlockSamples& block, const std::uint16_t* cells)
{
  static_assert(BlockSamples::Side == 8);
  const Ints number = hn::PromoteTo(ints, hn::LoadU(shorts, cells)), seven = Splat(7);
  const Ints j = hn::And(hn::ShiftRight<3>(number), seven), k = hn::ShiftRight<6>(number);
  return { block, hn::Add(Nine(hn::Add(Nine(k), j)), hn::And(number, seven)) };
}

/// Areas of the surface in the six tetrahedra of cells, one cell a lane, in CellTetrahedra's order.
///
/// The area of a level of a linear function is its gradient times the derivative of the volume
/// within: 3 V |g| N / D, D the product of |v_i| + |v_o| over corners i inside and o outside,
/// N v^2 of the corner that is alone, or for two by two the product of those inside times the sum
/// of those outside, and the other way round. Nothing cancels out. The gradient is a difference
/// along each axis, for a tetrahedron's corners lie one step after the other from 0 to 7.
class Tetrahedra
{
public:
  HWY_INLINE Tetrahedra(const BlockSamples& block, const Corners& corners)
    : Half(0.5F * block.spacing.x * block.spacing.y * block.spacing.z)
  {
    Floats most = hn::Abs(corners.at[0]);
    for (int n = 1; n < 8; ++n)
      most = hn::Max(most, hn::Abs(corners.at[n]));
    const Floats scale =
      hn::Div(Splat(1.0F), most); // areas do not depend on it; floats' range does
    for (int n = 0; n < 8; ++n)
    {
      this->Value[n] = hn::Mul(scale, corners.at[n]);
      this->Size[n] = hn::Abs(this->Value[n]);
    }
    for (int axis = 0; axis < 3; ++axis)
      this->PerSpacing[axis] = Splat(1.0F / block.spacing[axis]);
  }

  /// From corner 0 along `first` to a, along `second` to b, to 7.
  template <int A, int B, int First, int Second>
  HWY_INLINE Floats Area() const
  {
    constexpr int third = 3 - First - Second;
    const Floats slope = hn::Sqrt(hn::Add(this->Slope<0, A, First>(),
      hn::Add(this->Slope<A, B, Second>(), this->Slope<B, 7, third>())));
    const int corner[4] = { 0, A, B, 7 };
    const Floats one = Splat(1.0F), zero = hn::Zero(floats);
    Floats productIn = one, productOut = one, sumIn = zero, sumOut = zero, count = zero;
    for (const int c : corner)
    {
      const Mask in = this->Inside(c);
      const Floats size = this->Size[c];
      productIn = hn::Mul(productIn, hn::IfThenElse(in, size, one));
      productOut = hn::Mul(productOut, hn::IfThenElse(in, one, size));
      sumIn = hn::Add(sumIn, hn::IfThenElseZero(in, size));
      sumOut = hn::Add(sumOut, hn::IfThenZeroElse(in, size));
      count = hn::Add(count, hn::IfThenElseZero(in, one));
    }
    Floats below = one;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        below =
          hn::Mul(below, hn::IfThenElse(hn::Xor(this->Inside(corner[i]), this->Inside(corner[j])),
                           hn::Add(this->Size[corner[i]], this->Size[corner[j]]), one));
    const Floats two = hn::MulAdd(productIn, sumOut, hn::Mul(productOut, sumIn));
    const Floats above = hn::IfThenElse(hn::Eq(count, one), Square(productIn),
      hn::IfThenElse(hn::Eq(count, Splat(3.0F)), Square(productOut), two));
    const Mask crossed =
      hn::And(hn::And(hn::Gt(count, zero), hn::Lt(count, Splat(4.0F))), hn::Gt(below, zero));
    return hn::IfThenElseZero(
      crossed, hn::Div(hn::Mul(hn::Mul(Splat(this->Half), slope), above), below));
  }
  /// Calls visit(number, areas) for each.
  template <typename Visit>
  HWY_INLINE void ForEach(const Visit& visit) const
  {
    visit(0, this->Area<1, 3, 0, 1>());
    visit(1, this->Area<2, 3, 1, 0>());
    visit(2, this->Area<2, 6, 1, 2>());
    visit(3, this->Area<4, 6, 2, 1>());
    visit(4, this->Area<4, 5, 2, 0>());
    visit(5, this->Area<1, 5, 0, 2>());
  }

private:
  template <int From, int To, int Axis>
  HWY_INLINE Floats Slope() const
  {
    return Square(hn::Mul(hn::Sub(this->Value[To], this->Value[From]), this->PerSpacing[Axis]));
  }
  HWY_INLINE Mask Inside(int corner) const { return hn::Le(this->Value[corner], hn::Zero(floats)); }

  float Half;
  Floats Value[8], Size[8], PerSpacing[3];
};

void Areas(const BlockSamples& block, const std::uint16_t* cells, int count, float* areas) noexcept
{
  for (int n = 0; n < count; n += Lanes)
  {
    Floats sum = hn::Zero(floats);
    Tetrahedra(block, CornersOf(block, cells + n))
      .ForEach([&](int, Floats area) HWY_ATTR { sum = hn::Add(sum, area); });
    hn::StoreU(sum, floats, areas + n);
  }
}

void Pick(const BlockSamples& block, const std::uint16_t* cells, float* left,
  std::uint8_t* tetrahedra) noexcept
{
  for (int n = 0; n < BlockPlaces::Count; n += Lanes)
  {
    const Floats zero = hn::Zero(floats);
    Floats rest = hn::LoadU(floats, left + n), start = rest, picked = zero;
    Tetrahedra(block, CornersOf(block, cells + n))
      .ForEach(
        [&](int number, Floats area) HWY_ATTR
        {
          const Mask open = hn::And(hn::Ge(rest, zero), hn::Gt(area, zero));
          start = hn::IfThenElse(open, rest, start);
          picked = hn::IfThenElse(open, Splat(static_cast<float>(number)), picked);
          rest = hn::Sub(rest, hn::IfThenElseZero(open, area));
        });
    hn::StoreU(start, floats, left + n);
    alignas(64) float numbers[Lanes];
    hn::Store(picked, floats, numbers);
    std::copy_n(numbers, Lanes, tetrahedra + n);
  }
}

/// Lanes places, from the first on.
HWY_INLINE std::uint32_t ProjectSome(const BlockSamples& block, BlockPlaces& places, int first)
{
  const Floats zero = hn::Zero(floats);
  const float voxel = std::min({ block.spacing.x, block.spacing.y, block.spacing.z });
  Floats index[3], normal[3] = { zero, zero, zero };
  for (int axis = 0; axis < 3; ++axis)
    index[axis] = hn::Load(floats, places.index[axis] + first);
  Mask active = hn::FirstN(floats, Lanes), found = hn::FirstN(floats, 0);
  for (int step = 0; step < 5 && !hn::AllFalse(floats, active); ++step)
  {
    Ints cell[3];
    Floats t[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = hn::Min(
        hn::Max(hn::ConvertTo(ints, index[axis]), Splat(0)), Splat(block.samples[axis] - 2));
      t[axis] = hn::Sub(index[axis], hn::ConvertTo(floats, cell[axis]));
    }
    const Corners corners(block, hn::Add(Nine(hn::Add(Nine(cell[2]), cell[1])), cell[0]));
    const auto& c = corners.at;
    Floats row[4], along[4];
    for (int n = 0; n < 4; ++n)
    {
      along[n] = hn::Sub(c[2 * n + 1], c[2 * n]);
      row[n] = hn::MulAdd(t[0], along[n], c[2 * n]);
    }
    const Floats low = Mix(row[0], row[1], t[1]), high = Mix(row[2], row[3], t[1]);
    const Floats perIndex[3] = { Mix(Mix(along[0], along[1], t[1]), Mix(along[2], along[3], t[1]),
                                   t[2]),
      Mix(hn::Sub(row[1], row[0]), hn::Sub(row[3], row[2]), t[2]), hn::Sub(high, low) };
    Floats slope[3], squared = zero;
    for (int axis = 0; axis < 3; ++axis)
    {
      slope[axis] = hn::Mul(perIndex[axis], Splat(1.0F / block.spacing[axis]));
      squared = hn::MulAdd(slope[axis], slope[axis], squared);
    }
    active = hn::And(active, hn::And(hn::Gt(squared, zero),
                               hn::Lt(squared, Splat(std::numeric_limits<float>::infinity()))));
    const Floats perLength = hn::Div(Splat(1.0F), hn::Sqrt(squared));
    const Floats off = hn::Mul(Mix(low, high, t[2]), perLength);
    const Floats move = hn::Min(hn::Max(off, Splat(-0.5F * voxel)), Splat(0.5F * voxel));
    for (int axis = 0; axis < 3; ++axis)
    {
      normal[axis] = hn::IfThenElse(active, hn::Mul(slope[axis], perLength), normal[axis]);
      const Floats moved =
        hn::NegMulAdd(hn::Mul(move, normal[axis]), Splat(1.0F / block.spacing[axis]), index[axis]);
      const Floats last = Splat(static_cast<float>(block.samples[axis] - 1));
      index[axis] = hn::IfThenElse(active, hn::Min(hn::Max(moved, zero), last), index[axis]);
    }
    const Mask there = hn::And(active, hn::Lt(hn::Abs(off), Splat(0.02F * voxel)));
    found = hn::Or(found, there);
    active = hn::AndNot(there, active);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    hn::Store(index[axis], floats, places.index[axis] + first);
    hn::Store(normal[axis], floats, places.normal[axis] + first);
  }
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(floats, found, bits);
  return bits[0] | static_cast<std::uint32_t>(bits[1]) << 8U;
}

std::uint32_t Project(const BlockSamples& block, BlockPlaces& places) noexcept
{
  std::uint32_t found = 0;
  for (int n = 0; n < BlockPlaces::Count; n += Lanes)
    found |= ProjectSome(block, places, n) << n;
  return found;
}

} // namespace

BlockKernels BlocksHere()
{
  return { hwy::TargetName(HWY_TARGET), Areas, Pick, Project };
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hasp
{

HWY_EXPORT(BlocksHere);

std::vector<BlockKernels> LanesBlockKernels()
{
  return OfVectorTargets(HWY_DISPATCH_TABLE(BlocksHere), HWY_TARGETS);
}

} // namespace hasp
#endif
