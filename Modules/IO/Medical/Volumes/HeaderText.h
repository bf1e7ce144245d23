#pragma once
#include "Grid/GridGeometry.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What headers written as text have in common.
namespace hasp
{

/// Without blanks and line ends around it.
std::string Trimmed(std::string_view text);

std::string LowerCase(std::string_view text);

/// Numbers set apart by blanks; nothing unless there are `count` of them, all finite, and nothing
/// else.
std::optional<std::vector<double>> FiniteNumbers(std::string_view text, std::size_t count);

/// The modality if it is one of the few that passports name ("CT", "MR", ...), else empty: other
/// text of a file goes nowhere.
std::string KnownModality(std::string_view text);

/// Sets spacing and direction from the world vectors of an index step along each axis, mm. Throws
/// ThrowFileError with the angle if they are not at right angles, and whatever
/// GridGeometry::Validate finds. dims and origin are to be set before.
void SetIndexSteps(
  const std::filesystem::path& file, const glm::dmat3& steps, GridGeometry& geometry);

/// Largest difference of an angle between two steps from 90 degrees; NaN if one is zero or not
/// finite.
double SkewDegrees(const glm::dmat3& steps);

/// Below it directions count as at right angles: what GridGeometry::Validate lets pass.
constexpr double SkewLimitDegrees = 0.0057;

} // namespace hasp
