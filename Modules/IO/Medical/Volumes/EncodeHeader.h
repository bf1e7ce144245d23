#pragma once
#include "Grid/GridGeometry.h"
#include "vtkHaspVolumeSlabs.h"

#include <cstddef>
#include <string>

/// What stands in a volume file before its samples (little-endian, x fastest).
namespace hasp
{

struct VolumeHeader
{
  std::string bytes;
  bool flipX = false; ///< rows are to be written from their end
  bool flipY = false; ///< and slices from their last row
};

VolumeHeader EncodeMetaImage(const GridGeometry& geometry, SampleType type);
/// `more` are lines for the end of the header, each with its "\n".
VolumeHeader EncodeNrrd(
  const GridGeometry& geometry, SampleType type, bool compressed, const std::string& more = {});
/// NIfTI-1, or NIfTI-2 where float32 does not hold the positions or int16 the sizes.
VolumeHeader EncodeNifti(const GridGeometry& geometry, SampleType type);

std::size_t BytesOf(SampleType type);

} // namespace hasp
