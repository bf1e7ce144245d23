#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"
#include "Planning/GuideRecipe.h"

namespace hasp
{

/// The guide of vtkHaspGuideFilter, free of VTK: see there for what is made.
/// Throws std::invalid_argument (recipe, volume) and std::runtime_error (no such guide can be
/// made), naming the landmark, slot or hole; Cancelled. Any thread; all cores.
TriangleMesh BuildGuide(
  const AnyGridView& ct, const GuideRecipe& recipe, const ProgressFunction& progress = {});

} // namespace hasp
