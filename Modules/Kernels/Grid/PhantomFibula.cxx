#include "Grid/PhantomAnatomy.h"

#include <array>
#include <utility>

namespace hasp
{

/// Frusta over one triangle, each as wide as the shaft is there, along a bowed axis. The triangle
/// has three different sides: anterior crest, medial and lateral face. The canal is round.
void AddPhantomFibula(const glm::dvec3& center, double cortexMm, PhantomShapes& shapes)
{
  constexpr double Half = 170.0, BowMm = 5.0, Rounding = 3.0;
  constexpr std::array<std::array<double, 2>, 9> Stations{ { { -170.0, 0.95 }, { -150.0, 1.35 },
    { -120.0, 1.05 }, { -60.0, 0.95 }, { 0.0, 0.98 }, { 60.0, 0.94 }, { 120.0, 0.86 },
    { 150.0, 1.15 }, { 170.0, 0.90 } } };
  const std::array<glm::dvec2, 3> triangle{ { { -0.9, -4.9 }, { 4.8, 2.9 }, { -4.2, 3.3 } } };
  const auto section = [&](const std::array<double, 2>& station)
  {
    const double z = station[0], bow = BowMm * (1.0 - (z / Half) * (z / Half));
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& corner : triangle)
      corners.push_back(center + glm::dvec3(station[1] * corner.x, station[1] * corner.y - bow, z));
    return corners;
  };
  std::vector<AnalyticSolid> solids;
  for (std::size_t n = 0; n + 1 < Stations.size(); ++n)
    solids.emplace_back(Frustum(section(Stations[n]), section(Stations[n + 1]), Rounding));
  shapes.parts.emplace_back(PhantomPart::Fibula, AnalyticSolid::Union(solids));
  // The canal follows the triangle's inner circle, cortexMm below the faces, through the shaft.
  constexpr double InnerRadius = 2.63;
  const glm::dvec2 innerCenter(-0.227, 0.486);
  std::vector<AnalyticSolid> canal;
  for (std::size_t n = 1; n + 2 < Stations.size(); ++n)
  {
    const auto ball = [&](const std::array<double, 2>& station)
    {
      const double bow = BowMm * (1.0 - (station[0] / Half) * (station[0] / Half));
      const glm::dvec2 at = station[1] * innerCenter;
      return std::pair(center + glm::dvec3(at.x, at.y - bow, station[0]),
        station[1] * InnerRadius + Rounding - cortexMm);
    };
    const auto [a, radiusA] = ball(Stations[n]);
    const auto [b, radiusB] = ball(Stations[n + 1]);
    if (radiusA > 0.0 && radiusB > 0.0)
      canal.emplace_back(RoundConeShape{ a, b, radiusA, radiusB });
  }
  if (!canal.empty())
    shapes.canal = AnalyticSolid::Union(canal);
  const glm::dvec3 end(0.0, 0.0, Half + Rounding);
  shapes.landmarks.push_back({ "fibula upper end", PhantomPart::Fibula, center + end });
  shapes.landmarks.push_back({ "fibula lower end", PhantomPart::Fibula, center - end });
}

} // namespace hasp
