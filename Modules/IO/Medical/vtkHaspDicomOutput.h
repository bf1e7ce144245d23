#ifndef vtkHaspDicomOutput_h
#define vtkHaspDicomOutput_h

#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <cstddef> // for size_t
#include <string>  // for texts

class vtkImageData;

namespace hasp
{

/// What a series says beside its samples and geometry. Nothing of it is taken from a file but what
/// a Passport holds.
struct DicomOutputSettings
{
  std::string modality;           ///< "CT" or "MR"; any other becomes a Secondary Capture, "OT"
  bool hounsfield = false;        ///< the values are HU: for "CT" only
  bool knownNotBurnedIn = false;  ///< nobody's name is in the pixels: Burned In Annotation NO
  double sliceThicknessMm = 0.0;  ///< of the scan; 0: not known, the distance of slices is written
  double kVp = 0.0;               ///< 0: not known
  int slicesMade = 0;             ///< by resampling; > 0: Derivation Description says so
  double madeErrorMm = 0.0;       ///< and that 95 % of surfaces are off by no more; 0: not known
  bool allowQuantisation = false; ///< float samples may be rounded to 65536 levels
};

struct DicomOutput
{
  int slices = 0;
  std::size_t bytes = 0;
  double slope = 1.0, intercept = 0.0; ///< grey value = slope * stored value + intercept
  double quantisationError = 0.0;      ///< largest, in grey values; 0: every sample is exact
};

/// Writes a volume as a folder of DICOM slices, explicit little endian, one 16-bit file a slice:
/// slice-00001.dcm and so on in the direction row x column. Integer samples are exact; float ones
/// are if they are whole numbers, else they are rounded, which has to be allowed. A volume of
/// either handedness keeps each sample's place in the patient, within 1e-6 mm.
///
/// Only the attributes of Utilities/Docs/Privacy.md are written: no patient, no date, no machine.
/// UIDs and the pseudonymous Patient ID come from samples, geometry and settings alone, so the same
/// volume gives the same bytes.
///
/// The folder appears whole or not at all, and is refused if it is there and not empty. UTF-8 path.
/// Throws std::invalid_argument (image, settings), std::runtime_error (folder, or a build without
/// HASP_ENABLE_VTKDICOM), Cancelled. Any thread. Two passes over the samples.
VTKHASPIOMEDICAL_EXPORT DicomOutput WriteDicomSeries(vtkImageData* image, const std::string& folder,
  const DicomOutputSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
