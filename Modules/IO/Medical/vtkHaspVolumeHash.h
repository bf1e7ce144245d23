#ifndef vtkHaspVolumeHash_h
#define vtkHaspVolumeHash_h

#include "Grid/GridView.h"          // for AnyGridView
#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <array>  // for places
#include <string> // for hashes

/// Whether two files hold the same volume, whatever their formats. Any thread.
namespace hasp
{

/// SHA-256 as 64 hexadecimal digits of a volume's samples and of their place in the patient; empty
/// in a build without OpenSSL.
///
/// Equal for one volume stored as DICOM, InVesalius, MetaImage, NRRD, NIfTI or VTI: axes are
/// permuted and turned to run to L, P and S, samples count as int16 where all are whole and fit and
/// as float32 otherwise (so 7 as uint8 and 7.0F are one), and the place is what CanonicalPlace
/// makes of it. Different where one sample differs at all, a size, a side (left for right), a
/// spacing by 0.1 %, a direction by 0.12 degrees, or the position by a third of the smallest
/// spacing; below these it may be either.
/// The same for any number of threads. Memory: a slice a thread (32 of a sagittal or coronal
/// stack); cost: on two cores 600 MB/s
/// for int16 in axial order, half of that for sagittal stacks and float32, which is about what
/// reading a raw file takes. Throws Cancelled, and std::invalid_argument for
/// the geometry.
VTKHASPIOMEDICAL_EXPORT std::string VolumeHash(
  const AnyGridView& grid, const ProgressFunction& progress = {});

/// Sizes, spacings, two directions and the centre of a volume whose axes have been put in order,
/// each as a whole number of steps: log spacing in steps of 0.05 %, directions of 1/1024, the
/// centre of a quarter of the smallest spacing.
///
/// Steps cannot be fine and safe at once: a value near the middle between two whole numbers falls
/// on either side after it went through float32, as in NIfTI-1. Of random oblique geometries (0.2
/// to 2 mm, 32 to 512 samples a side, within 300 mm) 20 in 100,000 do, of upright ones at round
/// numbers 12 in 50,000 (TestIOMedical, VolumePlace.*Float32*); with corners in steps of 0.01 mm
/// 462 in 100,000 would.
VTKHASPIOMEDICAL_EXPORT std::array<double, 16> CanonicalPlace(const GridGeometry& geometry);

} // namespace hasp

#endif
