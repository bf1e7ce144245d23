#pragma once
#include "Haptics/DistanceMap.h"
#include "Testing/SampledDistance.h"

namespace hasp
{

/// A body's distance map, baked with its reference. Its axes are the grid's world.
class ContactMap
{
public:
  ContactMap(const GridGeometry& grid, double rangeMm, const testing::DistanceFunction& distance)
    : Sampled(distance, grid),
      Map(this->Sampled.View(), { .rangeMm = rangeMm, .reference = true })
  {
  }
  DistanceMapView<std::int16_t> Shorts() const { return this->Map.View(); }
  DistanceMapView<float> Floats() const { return this->Map.Reference(); }
  const std::vector<float>& Samples() const { return this->Sampled.samples; }

private:
  testing::SampledDistance Sampled;
  DistanceMap Map;
};

} // namespace hasp
