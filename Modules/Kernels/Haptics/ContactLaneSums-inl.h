// Private to ContactForceLanes.cxx, and compiled once an instruction set: sums over points, one a
// lane.
#if defined(HASP_CONTACT_LANE_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HASP_CONTACT_LANE_SUMS_INL
#undef HASP_CONTACT_LANE_SUMS_INL
#else
#define HASP_CONTACT_LANE_SUMS_INL
#endif

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

/// Upper triangle of sum A j j^T, a row each: small enough to stay in registers.
struct MatrixSums
{
  LaneSums<6> row0;
  LaneSums<5> row1;
  LaneSums<4> row2;
  LaneSums<3> row3;
  LaneSums<2> row4;
  LaneSums<1> row5;

  HWY_INLINE MatrixSums() {} // one that is not written is not compiled for the instruction set
  /// scaled: A j
  HWY_INLINE void Add(const Floats (&j)[6], const Floats (&scaled)[6])
  {
    AddRow(scaled[0], j, this->row0);
    AddRow(scaled[1], j, this->row1);
    AddRow(scaled[2], j, this->row2);
    AddRow(scaled[3], j, this->row3);
    AddRow(scaled[4], j, this->row4);
    AddRow(scaled[5], j, this->row5);
  }
  HWY_INLINE void AddTo(double* total) const
  {
    this->row0.AddTo(total);
    this->row1.AddTo(total + 6);
    this->row2.AddTo(total + 11);
    this->row3.AddTo(total + 15);
    this->row4.AddTo(total + 18);
    this->row5.AddTo(total + 20);
  }

private:
  /// From the diagonal on.
  template <int Count>
  static HWY_INLINE void AddRow(Floats scaled, const Floats (&j)[6], LaneSums<Count>& to)
  {
    for (int n = 0; n < Count; ++n)
      to.sum[n] = hn::MulAdd(scaled, j[6 - Count + n], to.sum[n]);
  }
};

/// One group's sums, depths in the lanes' units. What the terms do not need is never touched, so it
/// takes no register. Areas are summed where points have their own; else contacts are counted.
struct GroupSums
{
  LaneSums<6> push, pull;
  MatrixSums matrix;
  LaneSums<1> squares, area, attractedArea;
  Floats deepest;
  std::size_t contacts = 0, attracted = 0;

  HWY_INLINE GroupSums() : deepest(hn::Zero(floats)) {}

  template <ContactTerms Terms, bool OwnAreas>
  HWY_INLINE void AddTo(ShellSums& total) const
  {
    if (this->contacts > 0)
    {
      this->push.AddTo(total.push.data());
      this->squares.AddTo(&total.squares);
      if constexpr (OwnAreas)
        this->area.AddTo(&total.area);
      else
        total.area += static_cast<double>(this->contacts);
      if constexpr (Terms != ContactTerms::Force)
        this->matrix.AddTo(total.matrix.data());
      const float most = hn::GetLane(hn::MinOfLanes(floats, this->deepest));
      total.deepestMm = std::min(total.deepestMm, static_cast<double>(most));
      total.contacts += static_cast<std::uint32_t>(this->contacts);
    }
    if constexpr (Terms == ContactTerms::Snap)
      if (this->attracted > 0)
      {
        this->pull.AddTo(total.pull.data());
        if constexpr (OwnAreas)
          this->attractedArea.AddTo(&total.attractedArea);
        else
          total.attractedArea += static_cast<double>(this->attracted);
      }
  }
};

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
