#pragma once
#include "Dicom/DicomSeries.h"

#include <vector>

/// What must hold of a series before its pixels are worth decoding. Nothing here throws: each adds
/// what it finds to the faults, one fault for all slices with the same thing wrong.
namespace hasp
{

/// Each slice by itself: one monochrome frame of 8 or 16 bits, finite positive spacing, finite
/// position, orthonormal orientation (within 1e-3), finite rescaling with a slope other than 0, and
/// a file that can hold the pixels it declares.
void CheckEach(const std::vector<DicomSlice>& slices, std::vector<ImportFault>& faults);

/// All slices against each other: size, spacing, orientation, frame of reference. Slices without
/// a usable geometry are left out.
void CheckAlike(const std::vector<DicomSlice>& slices, std::vector<ImportFault>& faults);

/// Whether slices can be sorted and measured: each says where it is.
bool HasGeometry(const DicomSlice& slice);

/// Sorts by position along the normal, takes the second and further slices of one place out into
/// stack.doubles, and measures what is left: missing, uneven, tilted. Fills the passport's geometry
/// (its third axis is the cross product of the first two, so it is always right-handed) and counts,
/// and stack.layout. All slices have a geometry and one orientation.
void SortAndMeasure(DicomStack& stack);

} // namespace hasp
