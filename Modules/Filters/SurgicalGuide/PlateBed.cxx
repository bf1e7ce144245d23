#include "PlateBed.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double MostSlopeDeg = 60.0;
constexpr int ColumnsAside = 4; // from the middle line to the edge
constexpr double LeastStepPerWidth = 1e-3;

struct Bed
{
  const ImplicitSolid& surface;
  const PlateRecipe& recipe;

  [[noreturn]] void Refuse(const glm::dvec3& at, const std::string& how) const
  {
    const auto& marks = this->recipe.landmarks;
    const auto nearest = std::min_element(marks.begin(), marks.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::distance(a, at) < glm::distance(b, at); });
    std::ostringstream text;
    text.precision(3);
    text
      << "plate: near landmarks[" << nearest - marks.begin() << "], at (" << at.x << ", " << at.y
      << ", " << at.z << "), bone " << how
      << ": lay it along flatter bone, make it narrower, or bridge a line of fracture (bridgeMm)";
    throw std::runtime_error(text.str());
  }

  /// The plate's inner face in the column over and under a foot, from above; none if it is not
  /// within half the width.
  std::optional<glm::dvec3> Face(const glm::dvec3& foot, const glm::dvec3& normal) const
  {
    const double reach = 0.5 * this->recipe.widthMm;
    double height = reach + this->recipe.gapMm;
    if (this->surface.At(foot + height * normal) <= this->recipe.gapMm)
      return {};
    while (height > -reach)
    {
      const glm::dvec3 at = foot + height * normal;
      const double off = this->surface.At(at) - this->recipe.gapMm;
      if (off <= 0.0)
        return at;
      height -= std::max(off / this->surface.Steepness(), LeastStepPerWidth * this->recipe.widthMm);
    }
    return {};
  }

  void CheckSlope(const glm::dvec3& at, double degrees) const
  {
    if (degrees <= MostSlopeDeg)
      return;
    std::ostringstream how;
    how.precision(3);
    how << "slopes by " << degrees << " degrees under the plate, at most " << MostSlopeDeg;
    this->Refuse(at, how.str());
  }

  glm::dvec3 CheckColumn(const glm::dvec3& foot, const glm::dvec3& normal) const
  {
    const auto face = this->Face(foot, normal);
    if (!face)
    {
      std::ostringstream how;
      how << "is over half the plate's width, " << 0.5 * this->recipe.widthMm
          << " mm, higher or lower than the middle line";
      this->Refuse(foot, how.str());
    }
    const glm::dvec3 out = glm::normalize(this->surface.SampleAt(*face).gradient);
    this->CheckSlope(*face, glm::degrees(std::acos(glm::clamp(glm::dot(out, normal), -1.0, 1.0))));
    return *face;
  }

  /// From the middle line to the edge; steps between columns are slopes, too.
  void CheckLine(
    const glm::dvec3& middle, const glm::dvec3& direction, const glm::dvec3& normal) const
  {
    const double step = 0.5 * this->recipe.widthMm / ColumnsAside;
    glm::dvec3 before = this->CheckColumn(middle, normal);
    for (int n = 1; n <= ColumnsAside; ++n)
    {
      const glm::dvec3 face = this->CheckColumn(middle + double(n) * step * direction, normal);
      const double rise = std::abs(glm::dot(face - before, normal));
      this->CheckSlope(0.5 * (face + before), glm::degrees(std::atan2(rise, step)));
      before = face;
    }
  }
};
} // namespace

void CheckPlateBed(const ImplicitSolid& surface, const PlatePath& path, const PlateRecipe& recipe)
{
  const Bed bed{ surface, recipe };
  const std::size_t pieces = path.normals.size();
  for (std::size_t n = 0; n < pieces; ++n)
  {
    const glm::dvec3 a = path.places[n], b = path.places[n + 1], up = path.normals[n];
    const glm::dvec3 along = glm::normalize(b - a), side = glm::cross(up, along);
    const glm::dvec3 middle = 0.5 * (a + b);
    for (const glm::dvec3& aside : { side, -side })
      bed.CheckLine(middle, aside, up);
    for (const double turn : { -0.5, 0.0, 0.5 }) // the ends are round
    {
      const glm::dvec3 forth =
        std::cos(turn * glm::radians(90.0)) * along + std::sin(turn * glm::radians(90.0)) * side;
      if (n == 0)
        bed.CheckLine(a, -forth, up);
      if (n + 1 == pieces)
        bed.CheckLine(b, forth, up);
    }
  }
}

} // namespace hasp
