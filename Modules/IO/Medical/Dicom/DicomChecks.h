#pragma once
#include "Dicom/DicomSeries.h"

#include <filesystem>
#include <vector>

/// What must hold of a series before its pixels are worth decoding. All throw std::runtime_error
/// that names the folder, the slices, the numbers and the remedy.
namespace hasp
{

/// One slice by itself: one monochrome frame of 8 or 16 bits, finite positive spacing, finite
/// position, orthonormal orientation (within 1e-3), finite rescaling with a slope other than 0, and
/// a file that can hold the pixels it declares.
void CheckSlice(const std::filesystem::path& folder, const DicomSlice& slice);

/// All slices against the first: size, spacing, orientation, frame of reference.
void CheckAlike(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices);

/// Sorts by position along the normal and measures the stack: at least two slices, none doubled,
/// none missing, even gaps (within 1 % or 0.02 mm: positions are written with few decimals), no
/// tilt (no slice off the stack's axis by more than a tenth of a pixel). Gives the volume's
/// geometry; its third axis is the cross product of the first two, so it is always right-handed.
GridGeometry SortAndMeasure(
  const std::filesystem::path& folder, std::vector<DicomSlice>& slices, double& gapDeviationMm);

} // namespace hasp
