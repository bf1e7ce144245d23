#include "Distance/ElementLanes.h"

#include "Distance/OneLane.h"

#include <array>
#include <limits>
#include <utility>

namespace hasp
{

namespace
{
namespace hn = one_lane;

constexpr hn::Tag<float> floats;
constexpr hn::Tag<std::int32_t> ints;
constexpr int Lanes = 1;

using Floats = float;
using Ints = std::int32_t;
using Mask = bool;
using IntMask = bool;

std::uint64_t BitsOf(bool m)
{
  return m ? 1 : 0;
}

#include "Distance/ElementLanes-inl.h"

#include "Distance/ElementFit-inl.h"

#include "Distance/ElementFoot-inl.h"
} // namespace

#if HASP_WITH_HIGHWAY
std::vector<ElementLanes> VectorElementLanes(); // ElementLanesVector.cxx
#endif

std::vector<ElementLanes> AllElementLanes()
{
  std::vector<ElementLanes> all;
#if HASP_WITH_HIGHWAY
  all = VectorElementLanes();
#endif
  all.push_back({ "one number", ScanRow, Gradients, Planes, IsoPlanes, Polish, Refine, ListNear,
    Near, FarRow });
  return all;
}

const ElementLanes& BestElementLanes()
{
  static const ElementLanes best = AllElementLanes().front();
  return best;
}

} // namespace hasp
