#pragma once
#include "Distance/ImplicitSolid.h"
#include "PlatePath.h"

namespace hasp
{

/// Whether a plate can lie here: under all of its width and its round ends bone must face it within
/// 60 degrees and not be half its width higher or lower than the middle line. Beyond, its faces,
/// which are offsets of bone, would hang over an edge of bone as a fin, or climb a step.
/// Looked at along the path's normals, in columns an eighth of the width apart across and a sixth
/// along; a step between two columns is a slope, too. Throws std::runtime_error, naming the nearest
/// landmark and the place. Some 100 values of `surface` a piece of the path.
void CheckPlateBed(const ImplicitSolid& surface, const PlatePath& path, const PlateRecipe& recipe);

} // namespace hasp
