#include "Haptics/ContactForceLanes.h"

// Once an instruction set. SSSE3 processors without SSE4 are as old as they are few.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Haptics/ContactForceLanes.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "Haptics/ContactLanes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

/// Vectors that are summed a lane, in float, before their sums are added in double.
constexpr std::uint32_t GroupSize = 64;

template <int Count>
struct LaneSums
{
  Floats sum[Count];

  HWY_INLINE LaneSums()
  {
    for (Floats& s : this->sum)
      s = hn::Zero(floats);
  }
  HWY_INLINE void AddTo(double* total) const
  {
    for (int n = 0; n < Count; ++n)
      total[n] += static_cast<double>(hn::GetLane(hn::SumOfLanes(floats, this->sum[n])));
  }
};

/// sum += a j, j = [g; lever]
HWY_INLINE void AddLever(Floats a, const Vectors3& g, const Vectors3& lever, LaneSums<6>& to)
{
  const Floats j[6] = { g.x, g.y, g.z, lever.x, lever.y, lever.z };
  for (int n = 0; n < 6; ++n)
    to.sum[n] = hn::MulAdd(a, j[n], to.sum[n]);
}

/// sum += [f; p x f]
HWY_INLINE void AddForce(const Vectors3& f, const Vectors3& p, LaneSums<6>& to)
{
  to.sum[0] = hn::Add(to.sum[0], f.x);
  to.sum[1] = hn::Add(to.sum[1], f.y);
  to.sum[2] = hn::Add(to.sum[2], f.z);
  to.sum[3] = hn::MulAdd(p.y, f.z, hn::NegMulAdd(p.z, f.y, to.sum[3]));
  to.sum[4] = hn::MulAdd(p.z, f.x, hn::NegMulAdd(p.x, f.z, to.sum[4]));
  to.sum[5] = hn::MulAdd(p.x, f.y, hn::NegMulAdd(p.y, f.x, to.sum[5]));
}

/// One group's sums, depths in the lanes' units. What the terms do not need is never touched, so it
/// takes no register.
struct GroupSums
{
  LaneSums<6> push, pull;
  LaneSums<6> row0;
  LaneSums<5> row1;
  LaneSums<4> row2;
  LaneSums<3> row3;
  LaneSums<2> row4;
  LaneSums<1> row5;
  LaneSums<1> squares, area, attractedArea;
  Floats deepest;
  std::size_t contacts = 0, attracted = 0;

  HWY_INLINE GroupSums() : deepest(hn::Zero(floats)) {}
};

/// The rest of a row of sum A j j^T, from the diagonal on.
template <int Count>
HWY_INLINE void AddRow(Floats scaled, const Floats (&j)[6], LaneSums<Count>& to)
{
  for (int n = 0; n < Count; ++n)
    to.sum[n] = hn::MulAdd(scaled, j[6 - Count + n], to.sum[n]);
}

template <ContactTerms Terms, bool OwnAreas>
struct Kernel
{
  static constexpr bool Gradient = Terms != ContactTerms::Force;
  static constexpr bool Snap = Terms == ContactTerms::Snap;

  const MapView& map;
  const ContactFrame<float>& frame;
  float capture, perCapture;

  HWY_INLINE void Press(const ContactPoints& points, std::size_t first, const Vectors3& p,
    Floats depth, Mask contact, const Vectors3& gradient, GroupSums& sums) const
  {
    depth = hn::IfThenElseZero(contact, depth);
    sums.contacts += hn::CountTrue(floats, contact);
    sums.deepest = hn::Min(sums.deepest, depth);
    Floats weighted = depth;
    if constexpr (OwnAreas)
    {
      const Floats area = hn::IfThenElseZero(contact, hn::Load(floats, points.areas + first));
      sums.area.sum[0] = hn::Add(sums.area.sum[0], area);
      weighted = hn::Mul(depth, area);
    }
    sums.squares.sum[0] = hn::MulAdd(weighted, depth, sums.squares.sum[0]);
    if constexpr (!Gradient)
    {
      const Vectors3 n = Load3(points.nx, points.ny, points.nz, first);
      AddForce(
        { hn::Mul(weighted, n.x), hn::Mul(weighted, n.y), hn::Mul(weighted, n.z) }, p, sums.push);
    }
    else
    {
      const Vectors3 g = Where(contact, gradient);
      const Vectors3 t = Cross(p, g);
      AddLever(weighted, g, t, sums.push);
      const Floats j[6] = { g.x, g.y, g.z, t.x, t.y, t.z };
      const auto scaled = [&](int row) HWY_ATTR
      {
        if constexpr (OwnAreas)
          return hn::Mul(hn::Load(floats, points.areas + first), j[row]);
        else
          return j[row];
      };
      AddRow(scaled(0), j, sums.row0);
      AddRow(scaled(1), j, sums.row1);
      AddRow(scaled(2), j, sums.row2);
      AddRow(scaled(3), j, sums.row3);
      AddRow(scaled(4), j, sums.row4);
      AddRow(scaled(5), j, sums.row5);
    }
  }

  HWY_INLINE void Attract(const ContactPoints& points, std::size_t first, const Vectors3& p,
    Floats depth, Mask near, const Vectors3& gradient, GroupSums& sums) const
  {
    const Vectors3 n = Load3(points.nx, points.ny, points.nz, first);
    const Floats facing = hn::Neg(Dot(n, gradient));
    const Mask pulled = hn::And(near, hn::Gt(facing, hn::Zero(floats)));
    const Floats share = hn::Mul(depth, Splat(this->perCapture));
    const Floats rim = hn::NegMulAdd(share, share, Splat(1.0F));
    const Floats bend = hn::Mul(rim, facing);
    Floats pull = hn::IfThenElseZero(pulled, hn::Mul(share, hn::Mul(bend, bend)));
    if constexpr (OwnAreas)
    {
      const Floats area = hn::IfThenElseZero(pulled, hn::Load(floats, points.areas + first));
      sums.attractedArea.sum[0] = hn::Add(sums.attractedArea.sum[0], area);
      pull = hn::Mul(pull, area);
    }
    sums.attracted += hn::CountTrue(floats, pulled);
    const Vectors3 g = Where(pulled, gradient);
    AddForce({ hn::Mul(pull, g.x), hn::Mul(pull, g.y), hn::Mul(pull, g.z) }, p, sums.pull);
  }

  /// Lanes points, from the first on.
  HWY_INLINE void Feel(const ContactPoints& points, std::size_t first, GroupSums& sums) const
  {
    const Vectors3 p = Load3(points.x, points.y, points.z, first);
    const Vectors3 index = Matrix3{ this->frame.shellToIndex }(p, this->frame.indexOfShell);
    const Mask inside = Inside(index, this->map.last);
    if (hn::AllFalse(floats, inside))
      return;
    const Cells cells = FindCells(this->map, index, inside);
    const Mixed mixed(cells);
    const Floats depth = mixed.Value(cells); // in the lanes' units
    const Floats zero = hn::Zero(floats);
    const Mask contact = hn::And(inside, hn::Lt(depth, zero));
    const bool touches = !hn::AllFalse(floats, contact);
    if constexpr (!Snap)
    {
      if (!touches)
        return;
    }
    Vectors3 gradient{ zero, zero, zero };
    if constexpr (Snap)
    {
      const Mask near =
        hn::And(inside, hn::And(hn::Gt(depth, zero), hn::Lt(depth, Splat(this->capture))));
      const bool pulls = !hn::AllFalse(floats, near);
      if (!touches && !pulls)
        return;
      gradient = Matrix3{ this->frame.gradientToShell }(mixed.Gradient(cells));
      if (pulls)
        this->Attract(points, first, p, depth, near, gradient, sums);
      if (!touches)
        return;
    }
    else if constexpr (Gradient)
      gradient = Matrix3{ this->frame.gradientToShell }(mixed.Gradient(cells));
    this->Press(points, first, p, depth, contact, gradient, sums);
  }

  static HWY_INLINE void Flush(const GroupSums& sums, ShellSums& total)
  {
    if (sums.contacts > 0)
    {
      sums.push.AddTo(total.push.data());
      sums.squares.AddTo(&total.squares);
      if constexpr (OwnAreas)
        sums.area.AddTo(&total.area);
      else
        total.area += static_cast<double>(sums.contacts);
      if constexpr (Gradient)
      {
        sums.row0.AddTo(total.matrix.data());
        sums.row1.AddTo(total.matrix.data() + 6);
        sums.row2.AddTo(total.matrix.data() + 11);
        sums.row3.AddTo(total.matrix.data() + 15);
        sums.row4.AddTo(total.matrix.data() + 18);
        sums.row5.AddTo(total.matrix.data() + 20);
      }
      const float deepest = hn::GetLane(hn::MinOfLanes(floats, sums.deepest));
      total.deepestMm = std::min(total.deepestMm, static_cast<double>(deepest));
      total.contacts += static_cast<std::uint32_t>(sums.contacts);
    }
    if constexpr (Snap)
      if (sums.attracted > 0)
      {
        sums.pull.AddTo(total.pull.data());
        if constexpr (OwnAreas)
          sums.attractedArea.AddTo(&total.attractedArea);
        else
          total.attractedArea += static_cast<double>(sums.attracted);
      }
  }
};

/// Of runs that are alike in their areas.
template <ContactTerms Terms, bool OwnAreas>
HWY_NOINLINE void Sum(const ContactPoints* run, const ContactPoints* end,
  const ContactFrame<float>& frame, const MapView& map, float capture, ShellSums& total) noexcept
{
  const Kernel<Terms, OwnAreas> kernel{ map, frame, capture, 1.0F / capture };
  constexpr std::uint32_t most = GroupSize * Lanes;
  std::uint32_t first = 0;
  while (run != end)
  {
    GroupSums sums;
    for (std::uint32_t room = most; room > 0 && run != end;)
    {
      const std::uint32_t last = first + std::min(room, run->count - first);
      room -= last - first;
      for (; first < last; first += Lanes)
        kernel.Feel(*run, first, sums);
      if (first == run->count)
      {
        ++run;
        first = 0;
      }
    }
    kernel.Flush(sums, total);
  }
}

template <ContactTerms Terms>
void SideBySide(ContactRuns runs, const ContactPlacement& placement, const MapView& map,
  const ContactSettings& settings, ContactSums& sums) noexcept
{
  if (runs.begin() == runs.end())
    return;
  ContactFrame<float> frame(placement, map);
  if (!frame.finite)
    return;
  frame.gradientToShell *= 1.0F / PerSample;
  const float mm = map.mmPerStep / PerSample; // a lane's unit of depth
  for (const ContactPoints* run = runs.begin(); run != runs.end();)
  {
    const ContactPoints& one = *run;
    const ContactPoints* end = std::find_if(run, runs.end(),
      [&](const ContactPoints& other) {
        return one.areas ? other.areas == nullptr
                         : other.areas != nullptr || other.area != one.area;
      });
    ShellSums total;
    if (one.areas)
      Sum<Terms, true>(run, end, frame, map, settings.captureMm / mm, total);
    else
      Sum<Terms, false>(run, end, frame, map, settings.captureMm / mm, total);
    // Without a gradient the push is along the normal, which is against it.
    total.Scale(one.areas ? 1.0 : one.area, mm, Terms == ContactTerms::Force ? -mm : mm);
    total.AddTo(Terms, frame.shellToMap, settings, sums);
    run = end;
  }
}

ContactKernels Here()
{
  return { hwy::TargetName(HWY_TARGET),
    { SideBySide<ContactTerms::Force>, SideBySide<ContactTerms::Matrix>,
      SideBySide<ContactTerms::Snap> } };
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hasp
{

HWY_EXPORT(Here);

std::vector<ContactKernels> LanesContactKernels()
{
  std::vector<ContactKernels> kernels;
  const auto& table = HWY_DISPATCH_TABLE(Here);
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
  {
    const std::int64_t target = left & -left;
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    if (target == HWY_SCALAR || target == HWY_EMU128)
      continue; // ours is better than a vector of one lane, or a vector that is played
    const std::size_t at = std::size(table) == 1 ? 0 : chosen.GetIndex(); // 1: compiled for one
    kernels.insert(kernels.begin(), table[at]());
  }
  return kernels;
}

} // namespace hasp
#endif
