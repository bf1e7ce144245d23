#include "Distance/ElementLanes.h"

// Once an instruction set.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Distance/ElementLanesVector.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "Grid/VectorTargets.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hasp::HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, ElementLanes::Padding> floats;
constexpr hn::RebindToSigned<decltype(floats)> ints;
constexpr int Lanes = static_cast<int>(hn::MaxLanes(floats));

using Floats = hn::Vec<decltype(floats)>;
using Ints = hn::Vec<decltype(ints)>;
using Mask = hn::Mask<decltype(floats)>;
using IntMask = hn::Mask<decltype(ints)>;

HWY_INLINE std::uint64_t BitsOf(Mask m)
{
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(floats, m, bytes);
  return bytes[0] | std::uint64_t(bytes[1]) << 8;
}

#include "Distance/ElementLanes-inl.h"

#include "Distance/ElementFit-inl.h"

#include "Distance/ElementFoot-inl.h"

} // namespace

ElementLanes ElementLanesHere()
{
  return { hwy::TargetName(HWY_TARGET), ScanRow, Gradients, Planes, IsoPlanes, Polish, Refine,
    ListNear, Near, FarRow };
}

} // namespace hasp::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hasp
{

HWY_EXPORT(ElementLanesHere);

std::vector<ElementLanes> VectorElementLanes()
{
  std::vector<ElementLanes> all =
    OfVectorTargets(HWY_DISPATCH_TABLE(ElementLanesHere), HWY_TARGETS);
  std::reverse(all.begin(), all.end());
  return all;
}

} // namespace hasp
#endif
