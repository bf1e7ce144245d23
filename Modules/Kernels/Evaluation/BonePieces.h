#pragma once
#include "Grid/GridView.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <unordered_map>

namespace hasp
{

/// Is bone at a place part of a piece large enough to count? Floods from there, and no farther than
/// the answer needs. Pieces are joined by samples that touch, corners included, as in the guides'
/// own rule; what is asked of them is found anew here.
/// One thread: answers are kept.
class BonePieces
{
public:
  /// `ignoreBelowMm3`: pieces below that do not count; 0: all do. The volume outlives this.
  BonePieces(const AnyGridView& volume, double isovalue, double ignoreBelowMm3);

  /// `world` is in bone: of the samples around it the greatest is asked. Beyond the volume, and
  /// where all of them are below the isovalue: false.
  bool Counts(const glm::dvec3& world);

private:
  bool Flood(std::size_t start);
  double ValueAt(std::size_t sample) const;

  const AnyGridView& Volume;
  double Isovalue;
  std::size_t LeastSamples;
  std::unordered_map<std::size_t, bool> Known;
};

} // namespace hasp
