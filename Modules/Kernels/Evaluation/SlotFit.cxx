#include "Evaluation/SlotFit.h"

#include "Evaluation/LeastSquares.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace hasp
{

namespace
{
constexpr double StepMm = 0.25;
constexpr double OtherMm = 1.0;

/// A wall's places: u along, v across, d from the middle plane.
struct Wall
{
  std::vector<glm::dvec3> places;
  std::array<double, 3> plane{}; ///< d = plane[0] + plane[1] u + plane[2] v

  /// What lies more than OtherMm behind the plane, at first behind the middle one of all places, is
  /// the wall of something else, such as a sleeve beside the slot. `out`: the sign of d that is
  /// behind.
  void Fit(double out)
  {
    std::vector<double> d;
    for (const glm::dvec3& p : this->places)
      d.push_back(p.z);
    std::nth_element(d.begin(), d.begin() + std::ptrdiff_t(d.size() / 2), d.end());
    this->plane = { d[d.size() / 2], 0.0, 0.0 };
    for (std::size_t before = 0; before != this->places.size();)
    {
      before = this->places.size();
      std::erase_if(
        this->places, [&](const glm::dvec3& p) { return out * (p.z - this->At(p)) > OtherMm; });
      this->FitTo(this->places);
    }
    this->FitMost();
  }
  /// The plane that guides a blade is that of most of the wall: a side of the part that it runs
  /// into does not turn it. Flatness tells of both.
  void FitMost()
  {
    constexpr int Rounds = 10;
    std::vector<glm::dvec3> near = this->places;
    const auto most = near.begin() + std::ptrdiff_t(near.size() - near.size() / 4);
    for (int round = 0; round < Rounds; ++round)
    {
      std::nth_element(near.begin(), most - 1, near.end(),
        [&](const glm::dvec3& a, const glm::dvec3& b) { return this->Off(a) < this->Off(b); });
      this->FitTo({ near.begin(), most });
    }
  }
  void FitTo(std::span<const glm::dvec3> some)
  {
    NormalEquations<3> equations;
    for (const glm::dvec3& p : some)
      equations.Add({ 1.0, p.x, p.y }, p.z);
    if (const auto solved = equations.Solve())
      this->plane = *solved;
    else // places in one line: no tilt can be told
      this->plane = { equations.MeanValue(), 0.0, 0.0 };
  }
  double At(const glm::dvec2& uv) const
  {
    return this->plane[0] + this->plane[1] * uv.x + this->plane[2] * uv.y;
  }
  double Off(const glm::dvec3& p) const { return std::abs(p.z - this->At(p)); }
  double Flatness() const
  {
    std::vector<double> off;
    for (const glm::dvec3& p : this->places)
      off.push_back(this->Off(p));
    const auto nth = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 95 / 100);
    std::nth_element(off.begin(), nth, off.end());
    return *nth;
  }
  double TiltDegrees() const
  {
    return glm::degrees(std::atan(std::hypot(this->plane[1], this->plane[2])));
  }
};

/// What the rays of a slot find, in its own axes.
class Probe
{
public:
  Probe(const TriangleTree& tree, const ClaimedSlot& slot)
    : Tree(tree),
      Slot(slot),
      Normal(glm::normalize(slot.normal)),
      Along(glm::normalize(slot.along - glm::dot(slot.along, Normal) * Normal)),
      Across(glm::cross(Normal, Along)),
      Reach(2.0 * slot.widthMm + 1.0)
  {
  }

  SlotFit Measure()
  {
    const double half = 0.5 * this->Slot.lengthMm - StepMm;
    const double middle = glm::dot(this->Tree.Middle() - this->Slot.point, this->Across);
    const double reach = this->Tree.Reach(this->Across);
    const int columns = std::max(0, static_cast<int>(half / StepMm));
    const int rows = static_cast<int>(std::ceil(reach / StepMm));
    for (int row = -rows; row <= rows; ++row)
      for (int column = -columns; column <= columns; ++column)
        this->At({ column * StepMm, middle + row * StepMm });
    if (this->Fit.places > 0)
      this->FitPlanes();
    return this->Fit;
  }

private:
  void At(const glm::dvec2& uv)
  {
    const glm::dvec3 place = this->Slot.point + uv.x * this->Along + uv.y * this->Across;
    const auto up = this->Tree.First(place, this->Normal, 0.0);
    if (!up)
      return;
    if (glm::dot(up->normal, this->Normal) > 0.0)
    {
      if (!this->Fit.blockedAt)
        this->Fit.blockedAt = place;
      return;
    }
    const auto down = this->Tree.First(place, -this->Normal, 0.0, this->Reach);
    const double facing = std::cos(glm::radians(20.0));
    if (!down || up->t > this->Reach || glm::dot(up->normal, this->Normal) > -facing ||
        glm::dot(down->normal, this->Normal) < facing)
      return;
    this->Upper.places.emplace_back(uv, up->t);
    this->Lower.places.emplace_back(uv, -down->t);
    if (this->Fit.places++ == 0 || up->t + down->t < this->Fit.leastWidthMm)
    {
      this->Fit.leastWidthMm = up->t + down->t;
      this->Fit.leastAt = place;
    }
  }

  void FitPlanes()
  {
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& p : this->Upper.places)
    {
      low = glm::min(low, glm::dvec2(p));
      high = glm::max(high, glm::dvec2(p));
    }
    this->Upper.Fit(1.0);
    this->Lower.Fit(-1.0);
    const glm::dvec2 middle = 0.5 * (low + high);
    const double up = this->Upper.At(middle), down = this->Lower.At(middle);
    this->Fit.tiltDegrees = std::max(this->Upper.TiltDegrees(), this->Lower.TiltDegrees());
    this->Fit.widthMm = (up - down) * std::cos(glm::radians(this->Fit.tiltDegrees));
    this->Fit.flatnessMm = std::max(this->Upper.Flatness(), this->Lower.Flatness());
    this->Fit.offsetMm = 0.5 * std::abs(up + down);
    this->Fit.lengthMm = high.x - low.x;
    this->Fit.guideMm = high.y - low.y;
  }

  const TriangleTree& Tree;
  const ClaimedSlot& Slot;
  glm::dvec3 Normal, Along, Across;
  double Reach;
  Wall Upper, Lower;
  SlotFit Fit;
};
} // namespace

SlotFit FitSlot(const TriangleTree& tree, const ClaimedSlot& slot)
{
  return Probe(tree, slot).Measure();
}

} // namespace hasp
