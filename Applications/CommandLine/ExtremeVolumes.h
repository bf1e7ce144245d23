#pragma once
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

/// A volume that is hard on isosurfaces, and what is known of it beforehand.
struct ExtremeVolume
{
  std::string name;
  vtkSmartPointer<vtkImageData> image;
  double isovalue = 0.0;
  std::size_t activeCells = 0; ///< in closed form, or counted by another rule than extraction's own
  bool denormal = false;       ///< OpenGL may take its samples for 0: nothing may be drawn
  bool holes = false;          ///< has cells without a polynomial
};

std::vector<ExtremeVolume> ExtremeVolumes();

/// A ball of 13 mm in voxels of 0.7 mm, turned: nothing hard about it but what looks at it.
ExtremeVolume OrdinaryBall();

} // namespace hasp
