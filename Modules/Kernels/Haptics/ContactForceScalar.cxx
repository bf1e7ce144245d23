#include "Haptics/ContactFrame.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// The eight samples around a place, and where it is between them, in [0, 1].
template <typename Real>
struct Cell
{
  std::array<Real, 8> corner; ///< x fastest
  glm::vec<3, Real> at;

  Real Value() const noexcept
  {
    const Real x = this->at.x, y = this->at.y, z = this->at.z;
    std::array<Real, 4> row;
    for (int n = 0; n < 4; ++n)
      row[n] = this->corner[2 * n] + x * (this->corner[2 * n + 1] - this->corner[2 * n]);
    const Real low = row[0] + y * (row[1] - row[0]), high = row[2] + y * (row[3] - row[2]);
    return low + z * (high - low);
  }

  /// Of Value, per step of the index: its exact derivative, so that forces have a potential.
  glm::vec<3, Real> Gradient() const noexcept
  {
    const auto& c = this->corner;
    const Real x = this->at.x, y = this->at.y, z = this->at.z;
    const auto mix = [](Real a, Real b, Real t) { return a + t * (b - a); };
    return {
      mix(mix(c[1] - c[0], c[3] - c[2], y), mix(c[5] - c[4], c[7] - c[6], y), z),
      mix(mix(c[2] - c[0], c[3] - c[1], x), mix(c[6] - c[4], c[7] - c[5], x), z),
      mix(mix(c[4] - c[0], c[5] - c[1], x), mix(c[6] - c[2], c[7] - c[3], x), y),
    };
  }
};

/// False outside of the grid, where nothing is felt.
template <typename T, typename Real>
bool FindCell(
  const DistanceMapView<T>& map, const glm::vec<3, Real>& index, Cell<Real>& cell) noexcept
{
  using View = DistanceMapView<T>;
  glm::ivec3 block, local;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(index[axis] > Real(0) && index[axis] < static_cast<Real>(map.last[axis])))
      return false;
    const int whole = static_cast<int>(index[axis]);
    cell.at[axis] = index[axis] - static_cast<Real>(whole);
    block[axis] = whole / View::Side;
    local[axis] = whole % View::Side;
  }
  const std::int32_t brick =
    map.firstSample[(block.z * map.blocks.y + block.y) * map.blocks.x + block.x];
  const T* sample = map.samples + brick + local.x + View::Row * local.y + View::Slice * local.z;
  for (int n = 0; n < 8; ++n)
    cell.corner[n] =
      static_cast<Real>(sample[(n & 1) + View::Row * (n >> 1 & 1) + View::Slice * (n >> 2)]);
  return true;
}

/// j = [g; p x g]
template <typename Real>
std::array<double, 6> Lever(const glm::vec<3, Real>& g, const glm::vec<3, Real>& p) noexcept
{
  return { g.x, g.y, g.z, p.y * g.z - p.z * g.y, p.z * g.x - p.x * g.z, p.x * g.y - p.y * g.x };
}

void Add(const std::array<double, 6>& lever, double factor, std::array<double, 6>& sum) noexcept
{
  for (int n = 0; n < 6; ++n)
    sum[n] += factor * lever[n];
}

template <typename Real>
struct Point
{
  glm::vec<3, Real> position, normal; ///< the shell's axes
  Real area;
};

template <ContactTerms Terms, typename Real>
void Press(const Point<Real>& point, const Cell<Real>& cell, const ContactFrame<Real>& frame,
  const HardeningLaw<Real>& law, Real mm, ShellSums& sums) noexcept
{
  const double area = point.area;
  const typename HardeningLaw<Real>::Pressure pressure = law.At(mm);
  if constexpr (Terms == ContactTerms::Force)
    Add(Lever(-point.normal, point.position), area * pressure.depth, sums.push);
  else
  {
    const auto lever = Lever(frame.gradientToShell * cell.Gradient(), point.position);
    Add(lever, area * pressure.depth, sums.push);
    for (int r = 0, n = 0; r < 6; ++r)
      for (int c = r; c < 6; ++c, ++n)
        sums.matrix[n] += area * pressure.slope * lever[r] * lever[c];
  }
  sums.squares += area * pressure.squares;
  sums.area += area;
  sums.deepestMm = std::min<double>(sums.deepestMm, mm);
  ++sums.contacts;
}

template <typename Real>
void Attract(const Point<Real>& point, const Cell<Real>& cell, const ContactFrame<Real>& frame,
  Real share, ShellSums& sums) noexcept
{
  const auto gradient = frame.gradientToShell * cell.Gradient();
  const Real facing =
    -(point.normal.x * gradient.x + point.normal.y * gradient.y + point.normal.z * gradient.z);
  if (!(facing > Real(0)))
    return;
  const Real rim = Real(1) - share * share;
  Add(Lever(gradient, point.position), point.area * share * rim * rim * facing * facing, sums.pull);
  sums.attractedArea += point.area;
}

template <ContactTerms Terms, typename T, typename Real>
void Feel(const ContactPoints& points, const ContactFrame<Real>& frame,
  const DistanceMapView<T>& map, const ContactSettings& settings, ShellSums& sums) noexcept
{
  const HardeningLaw<Real> law(settings, Real(1));
  const Real capture = settings.captureMm;
  for (std::uint32_t n = 0; n < points.count; ++n)
  {
    const Point<Real> point{ { points.x[n], points.y[n], points.z[n] },
      { points.nx[n], points.ny[n], points.nz[n] }, points.areas ? points.areas[n] : points.area };
    Cell<Real> cell;
    if (!FindCell(map, frame.shellToIndex * point.position + frame.indexOfShell, cell))
      continue;
    const Real mm = cell.Value() * static_cast<Real>(map.mmPerStep);
    if (mm < Real(0))
      Press<Terms>(point, cell, frame, law, mm, sums);
    else if (Terms == ContactTerms::Snap && mm > Real(0) && mm < capture)
      Attract(point, cell, frame, mm / capture, sums);
  }
}

template <ContactTerms Terms, typename T, typename Real>
void OneByOne(ContactRuns runs, const ContactPlacement& placement, const DistanceMapView<T>& map,
  const ContactSettings& settings, ContactSums& sums) noexcept
{
  const ContactFrame<Real> frame(placement, map);
  if (!frame.finite)
    return;
  ShellSums shell;
  for (const ContactPoints& points : runs)
    Feel<Terms>(points, frame, map, settings, shell);
  shell.AddTo(Terms, frame.shellToMap, settings, sums);
}

} // namespace

ContactKernels ScalarContactKernels() noexcept
{
  using T = std::int16_t;
  return { "scalar",
    { OneByOne<ContactTerms::Force, T, float>, OneByOne<ContactTerms::Matrix, T, float>,
      OneByOne<ContactTerms::Snap, T, float> } };
}

void ContactForceReference(ContactTerms terms, ContactRuns points,
  const ContactPlacement& placement, const DistanceMapView<float>& map,
  const ContactSettings& settings, ContactSums& sums) noexcept
{
  switch (terms)
  {
    case ContactTerms::Force:
      return OneByOne<ContactTerms::Force, float, double>(points, placement, map, settings, sums);
    case ContactTerms::Matrix:
      return OneByOne<ContactTerms::Matrix, float, double>(points, placement, map, settings, sums);
    case ContactTerms::Snap:
      return OneByOne<ContactTerms::Snap, float, double>(points, placement, map, settings, sums);
  }
}

} // namespace hasp
