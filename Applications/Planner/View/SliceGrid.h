#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

class vtkImageData;

namespace hasp
{

/// What slices ask of an image, however it lies in the world. World places in mm. Any thread, as
/// long as no other one changes the image meanwhile.

struct WorldBox
{
  glm::dvec3 low, high;
};
/// Of its voxels: half a voxel beyond its samples.
WorldBox BoxOf(vtkImageData* image);

/// The nearest place within the image's samples.
glm::dvec3 ClampInto(vtkImageData* image, const glm::dvec3& place);

/// A step to the next slice along an axis of the world (0 x, 1 y, 2 z): the spacing of the image's
/// axis that runs along it most, mm.
double StepAlong(vtkImageData* image, int worldAxis);

/// The grey value there, as slices show it; nothing outside the samples, and where these are of a
/// type that no volume has.
std::optional<double> GreyAt(vtkImageData* image, const glm::dvec3& place);

/// Two grey values with such shares of the samples below them, [0, 1]; of all samples where there
/// are a million at most, of every nth otherwise.
glm::dvec2 GreyQuantiles(vtkImageData* image, double lowShare, double highShare);

} // namespace hasp
