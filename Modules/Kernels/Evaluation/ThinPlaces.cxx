#include "Evaluation/ThinPlaces.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace hasp
{

ThinPlace ThinnestPlace(std::vector<ThinPlace> places, int sides)
{
  constexpr double cellMm = 0.5 * ThinDetailMm;
  const double enough = sides * ThinDetailMm * ThinDetailMm;
  std::stable_sort(places.begin(), places.end(),
    [](const ThinPlace& a, const ThinPlace& b) { return a.mm < b.mm; });
  std::map<std::array<std::int64_t, 3>, double> around; // area within a cube of three cells
  for (const ThinPlace& place : places)
  {
    const glm::dvec3 cell = glm::floor(place.at / cellMm);
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
        {
          double& area = around[{
            std::int64_t(cell.x) + i, std::int64_t(cell.y) + j, std::int64_t(cell.z) + k }];
          area += place.areaMm2;
          if (area >= enough)
            return place;
        }
  }
  return places.empty() ? ThinPlace{} : places.back();
}

} // namespace hasp
