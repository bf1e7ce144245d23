#ifndef FragmentImage_h
#define FragmentImage_h

#include "Grid/GridView.h"                 // for AnyGridView
#include "Grid/Progress.h"                 // for ProgressFunction
#include "vtkHaspFiltersFragmentsModule.h" // for export macro

#include <glm/mat3x3.hpp> // for boxes
#include <glm/vec3.hpp>   // likewise

#include <cstdint> // for labels
#include <span>    // for levels
#include <variant> // for samples
#include <vector>  // for samples

/// A fragment alone as a volume of its own: what shows, touches or moves one isosurface takes it as
/// it is. Free of VTK but for the export macro.
namespace hasp
{

/// A box of bone that a saw has turned to dust. World, mm.
struct SawnBox
{
  glm::dvec3 middle{ 0.0 };
  glm::dmat3 axes{ 1.0 }; ///< unit columns; the last one is the normal of both faces
  glm::dvec3 half{ 1.0 }; ///< of the box's sides along these; the last one: of the kerf
};

/// Which label, where its surface is, and by what it was cut.
struct FragmentLevel
{
  std::uint16_t label = 1;
  double isovalue = 226.0; ///< bone is value >= isovalue; in [-1e6, 1e6]
  std::vector<SawnBox> sawn{};
};

/// A part of a scan in which only one label is bone.
struct FragmentImage
{
  GridGeometry geometry; ///< the scan's axes and steps; no samples (dims 0): the label has none
  /// One a sample of the geometry, x fastest. Of a scan of unsigned samples in the next larger
  /// type, so that values below its least can be said.
  std::variant<std::vector<std::int16_t>, std::vector<float>> samples;
};

/// The fragments of a scan, images[n] of levels[n]. Where the label is, samples are the scan's own;
/// elsewhere those at the isovalue or above are mirrored at it, to 2 isovalue - value, or to what
/// the type has nearest to that below the isovalue. So the isosurface is the scan's own to the last
/// bit in cells whose bone is all of the label, and half way to a neighbour of the same grey value;
/// bone without a label is such a neighbour.
///
/// Where bone is missing in a sawn box samples on either side of its face rise and fall with their
/// distance from it, as steeply as the label's grey values are high there, so that the surface is
/// the face: exactly where bone is of one grey value, and else within a part of a voxel. No sample
/// of the label rises. Of bone in such a box that has the label nothing is missing.
///
/// An image reaches two samples beyond its label, or to the scan's end: bone that goes on beyond
/// the scan is open there.
///
/// labels  on the scan's grid; 0 is nothing
/// Throws std::invalid_argument unless the labels are of the scan's grid, for the level of label 0,
/// and for an isovalue out of its range; Cancelled. Any thread; all cores. A pass over the labels,
/// and O(samples of the images).
VTKHASPFILTERSFRAGMENTS_EXPORT std::vector<FragmentImage> FragmentImages(const AnyGridView& grey,
  const GridView<const std::uint16_t>& labels, std::span<const FragmentLevel> levels,
  const ProgressFunction& progress = {});

} // namespace hasp

#endif
