#include "Haptics/ContactForceLanes.h"

// Once an instruction set. SSSE3 processors without SSE4 are as old as they are few.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Haptics/ContactForceLanes.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "Grid/VectorTargets.h"

#include "Haptics/ContactLaneSums-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{

template <ContactTerms Terms, bool OwnAreas>
struct Kernel
{
  static constexpr bool Gradient = Terms != ContactTerms::Force;
  static constexpr bool Snap = Terms == ContactTerms::Snap;

  const MapView& map;
  const ContactFrame<float>& frame;
  HardeningLaw<float> law;
  float capture, perCapture;

  /// HardeningLaw::At side by side.
  HWY_INLINE void Harden(Floats depth, Floats& pressed, Floats& slope, Floats& squares) const
  {
    const Floats one = Splat(1.0F);
    const Floats until = hn::Max(depth, Splat(-this->law.hard)), beyond = hn::Sub(depth, until);
    const Floats u = hn::Mul(until, Splat(this->law.perHard)), uu = hn::Mul(u, u);
    const Floats more = hn::Mul(Splat(this->law.c), hn::Mul(uu, uu));
    const Floats atUntil = hn::MulAdd(until, more, until);
    slope = hn::MulAdd(Splat(5.0F), more, one);
    pressed = hn::MulAdd(slope, beyond, atUntil);
    squares = hn::MulAdd(hn::Mul(until, until), hn::MulAdd(more, Splat(1.0F / 3.0F), one),
      hn::Mul(beyond, hn::Add(atUntil, pressed)));
  }

  HWY_INLINE void Press(const ContactPoints& points, std::size_t first, const Vectors3& p,
    Floats depth, Mask contact, const Vectors3& gradient, GroupSums& sums) const
  {
    depth = hn::IfThenElseZero(contact, depth);
    sums.contacts += hn::CountTrue(floats, contact);
    sums.deepest = hn::Min(sums.deepest, depth);
    const bool hardens = this->law.c > 0.0F;
    Floats weighted = depth, squares = hn::Mul(depth, depth), weight = Splat(1.0F);
    if (hardens)
      this->Harden(depth, weighted, weight, squares);
    if constexpr (OwnAreas)
    {
      const Floats area = hn::IfThenElseZero(contact, hn::Load(floats, points.areas + first));
      sums.area.sum[0] = hn::Add(sums.area.sum[0], area);
      weighted = hn::Mul(weighted, area);
      squares = hn::Mul(squares, area);
      weight = hn::Mul(weight, area);
    }
    sums.squares.sum[0] = hn::Add(sums.squares.sum[0], squares);
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
      Floats scaled[6] = { g.x, g.y, g.z, t.x, t.y, t.z };
      if (OwnAreas || hardens)
        for (Floats& part : scaled)
          part = hn::Mul(weight, part);
      sums.matrix.Add(j, scaled);
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
    Vectors3 gradient{ zero, zero, zero };
    if constexpr (Snap)
    {
      const Mask near =
        hn::And(inside, hn::And(hn::Gt(depth, zero), hn::Lt(depth, Splat(this->capture))));
      const bool pulls = !hn::AllFalse(floats, near);
      if (touches || pulls)
        gradient = Matrix3{ this->frame.gradientToShell }(mixed.Gradient(cells));
      if (pulls)
        this->Attract(points, first, p, depth, near, gradient, sums);
    }
    if (!touches)
      return;
    if constexpr (Gradient && !Snap)
      gradient = Matrix3{ this->frame.gradientToShell }(mixed.Gradient(cells));
    this->Press(points, first, p, depth, contact, gradient, sums);
  }
};

/// Of runs that are alike in their areas.
template <ContactTerms Terms, bool OwnAreas>
HWY_NOINLINE void Sum(const ContactPoints* run, const ContactPoints* end,
  const ContactFrame<float>& frame, const MapView& map, const ContactSettings& settings,
  float perMm, ShellSums& total) noexcept
{
  const float capture = settings.captureMm * perMm;
  const Kernel<Terms, OwnAreas> kernel{ map, frame, HardeningLaw<float>(settings, perMm), capture,
    1.0F / capture };
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
    sums.AddTo<Terms, OwnAreas>(total);
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
      Sum<Terms, true>(run, end, frame, map, settings, 1.0F / mm, total);
    else
      Sum<Terms, false>(run, end, frame, map, settings, 1.0F / mm, total);
    // Without a gradient the push is along the normal, which is against it.
    total.Scale(one.areas ? 1.0 : one.area, mm, Terms == ContactTerms::Force ? -mm : mm);
    total.AddTo(Terms, frame.shellToMap, settings, sums);
    run = end;
  }
}

ContactKernels ContactForceHere()
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

HWY_EXPORT(ContactForceHere);

std::vector<ContactKernels> LanesContactKernels()
{
  return OfVectorTargets(HWY_DISPATCH_TABLE(ContactForceHere), HWY_TARGETS);
}

} // namespace hasp
#endif
