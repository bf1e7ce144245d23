#pragma once
#include "Haptics/ContactPoints.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace hasp
{

/// Points as the kernels read them, aligned and padded.
class ShellOfPoints
{
public:
  void Add(const glm::dvec3& position, const glm::dvec3& normal)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Columns[axis].push_back(static_cast<float>(position[axis]));
      this->Columns[3 + axis].push_back(static_cast<float>(normal[axis]));
    }
  }
  std::size_t Count() const { return this->Columns[0].size(); }

  /// Valid until points are added. areas: of each, or one for all.
  ContactPoints Get(float area, const std::vector<float>& areas = {})
  {
    const std::size_t padded =
      (this->Count() + ContactPoints::Lanes - 1) / ContactPoints::Lanes * ContactPoints::Lanes;
    this->Storage.assign(7 * padded + 16, 0.0F);
    void* start = this->Storage.data();
    std::size_t space = this->Storage.size() * sizeof(float);
    float* at = static_cast<float*>(std::align(64, 7 * padded * sizeof(float), start, space));
    for (std::size_t column = 0; column < 7; ++column)
      for (std::size_t n = 0; n < padded; ++n)
        at[column * padded + n] = column < 6         ? n < this->Count() ? this->Columns[column][n]
                                                       : column < 3      ? ContactPoints::FarAway
                                                                         : 0.0F
                                  : n < areas.size() ? areas[n]
                                                     : 0.0F;
    return { at, at + padded, at + 2 * padded, at + 3 * padded, at + 4 * padded, at + 5 * padded,
      areas.empty() ? nullptr : at + 6 * padded, area, static_cast<std::uint32_t>(padded) };
  }

private:
  std::vector<float> Columns[6];
  std::vector<float> Storage;
};

} // namespace hasp
