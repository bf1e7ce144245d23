#pragma once
#include "Grid/Phantom.h"

#include <optional>
#include <utility>
#include <vector>

namespace hasp
{

/// Which shapes the phantom is made of, in the world. Built in microseconds from checked settings.
struct PhantomShapes
{
  std::vector<std::pair<PhantomPart, AnalyticSolid>> parts;
  std::optional<AnalyticSolid> skin;   ///< soft tissue besides the scalpMm around each bone
  std::optional<AnalyticSolid> airway; ///< air within the soft tissue
  std::optional<AnalyticSolid> canal;  ///< of the fibula
  std::optional<AnalyticSolid> enamel; ///< crowns of all teeth
  std::vector<RoundConeShape> metal;   ///< the metal crowns, if any
  std::vector<PhantomLandmark> landmarks;
};
PhantomShapes MakePhantomShapes(const PhantomSettings& settings);

/// The fibula around a centre, upright, its canal cortexMm below its faces.
void AddPhantomFibula(const glm::dvec3& center, double cortexMm, PhantomShapes& shapes);

/// Throws std::invalid_argument with the field, its value and the legal range.
void CheckPhantom(const PhantomSettings& settings);

} // namespace hasp
