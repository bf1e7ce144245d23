#pragma once
#include "IsosurfaceView.h"

#include <glm/geometric.hpp>

#include <string>

namespace hasp
{

struct ExtremeVolume;
struct ReportContext;

/// The direction in which extreme volumes are looked at.
inline const glm::dvec3 ObliqueView = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

/// The parts of `hasp report stability` that draw. RENDER thread.

/// A row that passes if the figure is no larger than the limit.
void AddStability(ReportContext& context, const std::string& id, const std::string& testCase,
  double figure, double limit, const std::string& unit);

/// Predicted of clustered cells, traced cells and the ray cache, once it is complete: the surface
/// where a root in long double has it, and nothing else.
void CheckStablePicture(ReportContext& context, const std::string& name, const IsosurfaceView& view,
  const ExtremeVolume& volume);

/// The same from hard places, with an ordinary ball in view.
void CheckStableEyes(ReportContext& context, const ExtremeVolume& ball, int pixels);

} // namespace hasp
