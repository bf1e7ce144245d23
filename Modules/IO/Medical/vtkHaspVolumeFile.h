#ifndef vtkHaspVolumeFile_h
#define vtkHaspVolumeFile_h

#include "Grid/GridGeometry.h"      // for GridGeometry
#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkSmartPointer.h"        // for return values

#include <array>      // for colours
#include <cstddef>    // for size_t
#include <functional> // for load
#include <string>     // for texts
#include <vector>     // for warnings

class vtkImageData;

/// Volume files without a pipeline: what vtkHaspVolumeReader is a skin of.
/// Any thread; nothing is kept between calls.
namespace hasp
{

/// What is known of a volume. Holds no patient's text, no UID and no path, so it may be shown,
/// logged and sent. Complete when samples are handed on; everything but minimum and maximum before
/// any sample is decoded (sampleType may then still be "int16 or float32": see below).
struct Passport
{
  std::string format;                ///< "DICOM", "InVesalius", "MetaImage", "NRRD", "NRRD
                                     ///< segmentation", "NIfTI-1", "NIfTI-2" or "VTI"
  GridGeometry geometry;             ///< patient LPS, mm
  std::string modality;              ///< as the file says, "CT" or "MR"; empty if it does not
  bool hounsfield = false;           ///< values are HU by the file's own word (CBCT's are not)
  std::string sampleType;            ///< "int16", "uint16", "uint8" or "float32"
  double minimum = 0.0;              ///< smallest sample
  double maximum = 0.0;              ///< largest sample
  int seriesFound = 1;               ///< in the folder (DICOM), else 1
  int seriesChosen = 1;              ///< 1-based, in the order the error text lists them
  int filesSkipped = 0;              ///< files of the folder that are no DICOM images
  double gapDeviationMm = 0.0;       ///< largest difference of a slice distance from spacing.z
  std::string compression;           ///< the file's name for it; empty if not compressed
  std::vector<std::string> warnings; ///< full sentences, for the user
  std::string hash;                  ///< of samples and place, if asked for: see VolumeHash
  int segments = 0;                  ///< named in a segmentation; 0 in any other volume
};

/// What one label of a segmentation is. The name is free text of the file, a patient's perhaps: it
/// is for the eyes of who opened the file, not for logs.
struct Segment
{
  int labelValue = 0;                           ///< of its samples, in [1, 65535]
  std::string name;                             ///< UTF-8
  std::array<double, 3> color{ 0.5, 0.5, 0.5 }; ///< red, green, blue in [0, 1]
};

struct VolumeReadSettings
{
  int series = 0;    ///< 1-based; 0 = there must be one only
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

/// A file whose header has been read and found good. `load` decodes the samples.
struct OpenedVolume
{
  std::string file; ///< the path that was opened
  Passport passport;
  std::function<vtkSmartPointer<vtkImageData>(const ProgressFunction&)> load;
  std::vector<Segment> segments = {}; ///< of a segmentation
  bool hash = false;                  ///< as the settings ask
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
/// hang without harm. Refused, by name and number: several series without a choice; slices that
/// differ in size, orientation or frame of reference; absent or unusable spacing, position,
/// orientation or rescale slope; missing, doubled or uneven slices; a tilted stack; colour.
/// Throws std::invalid_argument (settings), std::runtime_error (file: text with its base name,
/// what is wrong and what to do), Cancelled.
VTKHASPIOMEDICAL_EXPORT OpenedVolume OpenVolume(const std::string& path,
  const VolumeReadSettings& settings = {}, const ProgressFunction& progress = {});

/// Loads the samples, refuses NaN and infinity with their count and first index, and completes the
/// passport. Throws std::runtime_error, Cancelled.
VTKHASPIOMEDICAL_EXPORT LoadedVolume LoadVolume(
  const OpenedVolume& opened, const ProgressFunction& progress = {});

} // namespace hasp

#endif
