#ifndef ImageSteps_h
#define ImageSteps_h

#include "Grid/Progress.h"                    // for ProgressFunction
#include "Planning/SegmentationRecipe.h"      // for the steps
#include "vtkHaspFiltersSegmentationModule.h" // for export macro
#include "vtkSmartPointer.h"                  // for return values

class vtkImageData;

/// The steps of a recipe that make an image of an image. The input stays as it is, to the last bit:
/// whoever keeps it has taken the step back. The output has the input's extent, origin, spacing and
/// direction, and float scalars under the name of the input's: float holds all values of the types
/// that are read, and what lies between them.
///
/// All: input as hasp::ViewImage reads it (short, unsigned short, unsigned char, float; one
/// component). Lengths are mm along each axis of the grid, whatever its spacing and direction.
/// Throw std::invalid_argument if the input or a number is not in order (names the value and the
/// legal range), std::runtime_error if VTK's filter fails, Cancelled if progress says so, and
/// whatever progress throws. Nothing is printed. Any thread as long as no other changes the input;
/// all cores, the same bytes with any number of threads. Progress is told from the calling thread
/// and grows.
namespace hasp
{

/// vtkImageGaussianSmooth, cut off at four standard deviations; at the grid's border over what is
/// there, so that a constant stays. Along an axis of which four standard deviations are less than a
/// voxel nothing changes. Limit: below half a voxel a sampled Gaussian is narrower than it says.
/// O(voxels * sigma in voxels).
VTKHASPFILTERSSEGMENTATION_EXPORT vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const GaussianStep& step, const ProgressFunction& progress = {});

/// vtkImageMedian3D of a box of 2 r + 1 voxels along each axis, r = radiusMm / spacing rounded, at
/// least 1 (0 along an axis of one voxel). At the border the box is cut off. Refuses a box of more
/// than 4,096 voxels, which would take hours, and says the largest radius that will do.
/// O(voxels * box).
VTKHASPFILTERSSEGMENTATION_EXPORT vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const MedianStep& step, const ProgressFunction& progress = {});

/// vtkImageAnisotropicDiffusion3D with all 26 neighbours, each by its distance in mm: in each
/// iteration a voxel becomes a mean of itself and those that differ by less than `edge`.
/// O(voxels * iterations).
VTKHASPFILTERSSEGMENTATION_EXPORT vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const EdgePreservingStep& step, const ProgressFunction& progress = {});

/// CorrectConeBeam (Segmentation/ConeBeam.h).
VTKHASPFILTERSSEGMENTATION_EXPORT vtkSmartPointer<vtkImageData> ApplyStep(
  vtkImageData* image, const ConeBeamStep& step, const ProgressFunction& progress = {});

} // namespace hasp

#endif
