#ifndef vtkHaspVolumeFile_h
#define vtkHaspVolumeFile_h

#include "Grid/GridGeometry.h"      // for GridGeometry
#include "Grid/Progress.h"          // for ProgressFunction
#include "Grid/ResampleStack.h"     // for ResampleRecord
#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkHaspImportFault.h"     // for ImportFault
#include "vtkSmartPointer.h"        // for return values

#include <array>      // for colours
#include <cstddef>    // for size_t
#include <filesystem> // for paths
#include <functional> // for load
#include <memory>     // for ImportError
#include <optional>   // for what may be unknown
#include <stdexcept>  // for ImportError
#include <string>     // for texts
#include <vector>     // for warnings

class vtkImageData;

/// Volume files without a pipeline: what vtkHaspVolumeReader is a skin of.
/// Any thread; nothing is kept between calls.
namespace hasp
{

/// What is known of a volume. Holds no patient's text, no UID and no path, so it may be shown,
/// logged and sent. Complete when samples are handed on; before any is decoded all but what samples
/// tell: minimum, maximum, levels, hash, and sampleType where they are to be converted ("int16 or
/// float32", "int16, uint16 or float32").
struct Passport
{
  std::string format;             ///< "DICOM", "InVesalius", "MetaImage", "NRRD", "NRRD
                                  ///< segmentation", "NIfTI-1", "NIfTI-2" or "VTI"
  GridGeometry geometry;          ///< patient LPS, mm
  std::string modality;           ///< as the file says, "CT" or "MR"; for what is no known term
                                  ///< "OTHER" in DICOM and empty elsewhere; empty if it does not
                                  ///< say
  bool hounsfield = false;        ///< values are HU by the file's own word, and the samples do
                                  ///< not deny it (CBCT's are not)
  std::optional<double> airLevel; ///< measured where HU are claimed, in the file's values: HU
                                  ///< have air at -1000; none: no plateau of air was found
  std::optional<double> softTissueLevel; ///< likewise; HU have soft tissue at about 40
  std::string sampleType;                ///< "int16", "uint16", "uint8" or "float32"
  double minimum = 0.0;                  ///< smallest sample
  double maximum = 0.0;                  ///< largest sample
  int seriesFound = 1;                   ///< in the folder (DICOM), else 1
  int seriesChosen = 1;                  ///< 1-based, in the order the error text lists them
  int filesSkipped = 0;                  ///< files of the folder that are no DICOM images
  double gapDeviationMm = 0.0;           ///< largest difference of a slice distance from their mean
  std::string compression;               ///< the file's name for it; empty if not compressed
  std::vector<std::string> warnings;     ///< full sentences, for the user
  std::string hash;                      ///< of samples and place, if asked for: see VolumeHash
  int segments = 0;                      ///< named in a segmentation; 0 in any other volume

  // Of DICOM series only. Slices are counted along row x column of their pictures, whatever the
  // files are called; a slice that is missing at either end of the stack cannot be seen.
  std::string photometric;     ///< "MONOCHROME1" (to be shown inverted) or "MONOCHROME2"
  std::string transferSyntax;  ///< the standard's name for how the pixels are packed
  bool lossy = false;          ///< compressed with loss, now or once
  std::string burnedIn;        ///< text burned into the pictures: "yes" or "no"; empty: not said
  std::string patientPosition; ///< "HFS" and so on: how the patient lay; empty: not said
  std::optional<double> thicknessMm;  ///< of a slice, as the file says; not the slices' distance
  std::optional<double> kvp;          ///< of the tube, kV, as the file says
  std::optional<double> paddingValue; ///< of samples outside the picture, in the passport's values
  std::vector<RescaleRun> rescale;    ///< in the stack's order; one if all slices are alike
  double tiltDegrees = 0.0; ///< measured from the positions, in [0, 90); 0 if within the tenth of
                            ///< a pixel that is forgiven
  std::optional<double> tiltTagDegrees; ///< gantry tilt as the file says, its sign is the maker's
  int missingSlices = 0;                ///< between the first and the last one
  int doubledSlices = 0;                ///< beyond the first at their places
  int unevenGaps = 0;                   ///< gaps that are no multiple of the usual one

  std::vector<ImportFault> faults;         ///< why it is refused; empty: it is not
  std::optional<ResampleRecord> resampled; ///< what was done to mend it, and its error in mm;
                                           ///< none: the samples are as the scanner gave them
};

/// A volume was refused. what() says the first fault, how many more there are, and whether
/// resampling would mend them all.
class VTKHASPIOMEDICAL_EXPORT ImportError : public std::runtime_error
{
public:
  /// `known` has at least one fault. The file is named as FileLabel does.
  ImportError(const std::filesystem::path& file, Passport known);
  std::shared_ptr<const Passport> passport; ///< as far as it is known, with all faults
};

/// What one label of a segmentation is. The name is free text of the file, a patient's perhaps: it
/// is for the eyes of who opened the file, not for logs.
struct Segment
{
  int labelValue = 0;                           ///< of its samples, in [1, 65535]
  std::string name;                             ///< UTF-8; bytes that are none are U+FFFD
  std::array<double, 3> color{ 0.5, 0.5, 0.5 }; ///< red, green, blue in [0, 1]
  bool bone = false;                            ///< its tags say so, in SNOMED CT
};

struct VolumeReadSettings
{
  int series = 0;        ///< 1-based; 0 = there must be one only
  bool resample = false; ///< mend tilted, gappy and uneven DICOM stacks and leave copies of slices
                         ///< out (Decisions/0010); sound ones stay byte for byte as they are
  int layer = 0;     ///< of a .seg.nrrd with several label maps, 1-based; 0 = all, which must not
                     ///< overlap and are merged
  bool hash = false; ///< fill the passport's hash; as costly as reading a raw file once more
  std::size_t memoryLimitBytes = std::size_t(4)
                                 << 30; ///< of the samples; checked before any is taken
  /// Most that reading DICOM may take in the child process, on top of its program. It is given less
  /// where less will do: 64 MiB, and to decode four times the largest slice (as declared, or its
  /// file) besides. What needs more is refused, as a file that unpacks to more than it declares.
  std::size_t decoderMemoryBytes = std::size_t(2) << 30;
  /// The child is ended after so long without an answer, in (0, 1e6]; each file is one. A slice
  /// that is to be decoded has a second more for every 8 MiB of its file or (if that is larger, and
  /// up to 64 times the file) of its pixels. Raise it for a slow disk.
  double decoderSilenceSeconds = 2.0;
  double decoderTotalSeconds = 600.0; ///< or after so long in all, in (0, 1e6]
};

struct SampleFile; // internal

/// A file whose header has been read and found good. `load` decodes the samples, and adds to the
/// passport what only they tell.
struct OpenedVolume
{
  std::string file; ///< the path that was opened
  Passport passport;
  std::function<vtkSmartPointer<vtkImageData>(const ProgressFunction&, Passport&)> load;
  std::vector<Segment> segments = {}; ///< of a segmentation
  bool hash = false;                  ///< as the settings ask
  std::size_t memoryLimitBytes = 0;   ///< likewise
  /// Where the samples lie, if it is in one stream, slice after slice: for VolumeSlabReader.
  std::shared_ptr<const SampleFile> samples = {};
};

struct LoadedVolume
{
  Passport passport;
  vtkSmartPointer<vtkImageData>
    image; ///< extent from 0; scalars short, unsigned short, unsigned char or float
  std::vector<Segment> segments = {}; ///< of a segmentation: what its label values are
};

/// Reads and checks the header of a folder of DICOM slices (searched with its subfolders; one slice
/// a file, or enhanced CT and MR whose frames say where they lie), an
/// InVesalius project (.inv3), MetaImage (.mha, .mhd), NRRD (.nrrd, .nhdr), segmentation of 3D
/// Slicer (.seg.nrrd), NIfTI (.nii, .nii.gz) or VTK image (.vti). UTF-8 path.
///
/// DICOM is parsed by a child process (HASP_DICOM_DECODER overrides where it is) that may crash or
/// hang without harm. Refused, by number: several series without a choice; slices that differ in
/// size, orientation or frame of reference; absent or unusable spacing, position, orientation or
/// rescale slope; missing, doubled or uneven slices and a tilted stack, unless they are to be
/// resampled (VolumeReadSettings::resample) and that is within ResampleLimits; colour.
/// Throws std::invalid_argument (settings), std::runtime_error (file: text with its label, what is
/// wrong and what to do; ImportError where faults are known as data), Cancelled.
VTKHASPIOMEDICAL_EXPORT OpenedVolume OpenVolume(const std::string& path,
  const VolumeReadSettings& settings = {}, const ProgressFunction& progress = {});

/// Loads the samples, refuses NaN and infinity with their count and first index, asks them whether
/// they can be HU, and completes the passport. Throws as OpenVolume.
VTKHASPIOMEDICAL_EXPORT LoadedVolume LoadVolume(
  const OpenedVolume& opened, const ProgressFunction& progress = {});

/// The passport of a volume that may be faulty: opens and loads it, and where that is refused gives
/// what is known, with all faults that were found. A fault that hides others (several series, a
/// damaged file of another format) is alone. Throws std::invalid_argument (settings), Cancelled and
/// std::bad_alloc; nothing for the volume's own faults.
VTKHASPIOMEDICAL_EXPORT Passport InspectVolume(const std::string& path,
  const VolumeReadSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
