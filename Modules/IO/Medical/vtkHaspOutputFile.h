#ifndef vtkHaspOutputFile_h
#define vtkHaspOutputFile_h

#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkHaspPartLabel.h"       // for what files say of a part

#include <functional>  // for inspection
#include <string>      // for paths
#include <string_view> // for bytes
#include <vector>      // for segments

class vtkImageData;
class vtkPolyData;

/// Writing without a pipeline: what vtkHaspVolumeWriter and vtkHaspSurfaceWriter are skins of.
/// Files appear whole or not at all: temporary file in the same folder, fsync, rename. On any
/// failure the earlier file is as it was. UTF-8 paths. Any thread, one per file.
/// All throw std::runtime_error with the file's label, or std::invalid_argument for the data.
namespace hasp
{

struct Segment; // of vtkHaspVolumeFile.h

struct VolumeWriteSettings
{
  bool compress = false; ///< .nrrd with gzip; .nii.gz and .vti always are compressed, others never
};

/// .vti (LZ4), .mha, .nrrd (raw, or gzip), .nii (raw) or .nii.gz, by the ending. What ViewImage
/// takes is written, with its direction; none but .vti has an extent: there, sample (0,0,0) is the
/// first of the image's extent. What VolumeSlabWriter says of its files is true of these.
VTKHASPIOMEDICAL_EXPORT void WriteVolume(
  vtkImageData* image, const std::string& path, const VolumeWriteSettings& settings = {});

struct SegmentationWriteSettings
{
  bool compress = true; ///< gzip; off: raw
};

/// .seg.nrrd as 3D Slicer reads it: one layer, with each segment's label value, name, colour and
/// tags, and the grid as its reference geometry. Labels are unsigned char or unsigned short; label
/// values are distinct and at least 1. Names are written as they are, for they are what the user
/// called the segments: UTF-8 without control characters other than line feeds; a segment without a
/// name is named by its ID. Labels that are no segment's are written, but Slicer shows none of
/// them. Refused besides: a single sample, which Slicer takes as an empty segmentation, and a
/// header above the 4 MiB that are read back (some 9,000 segments). progress may cancel: Cancelled.
VTKHASPIOMEDICAL_EXPORT void WriteSegmentation(vtkImageData* labels,
  const std::vector<Segment>& segments, const std::string& path,
  const SegmentationWriteSettings& settings = {}, const ProgressFunction& progress = {});

/// What an inspection of a part's file found. A part that does not hold is written once more, the
/// same but for its label, which says so: throw to have no file at all.
enum class PartVerdict
{
  Holds,
  DoesNotHold
};
/// Is given the name of the whole file, with the ending it will have, before it is put in place. If
/// it throws, the file is gone and the earlier one as it was.
using InspectPart = std::function<PartVerdict(const std::string& pendingFile)>;

/// By the extension; world millimetres in LPS, which the header or a comment says ("Hasp <version>
/// SPACE=LPS; UNIT=mm"), and after it the label. The same bytes every time. LoadSurface reads each
/// back bit by bit, .stl rounded to float32, .3mf within 2e-7 of a coordinate and 1e-6 mm besides.
///   .stl  binary, float32, normals from the triangles' corners
///   .ply  binary little-endian, float or double as the points are
///   .obj  text, each coordinate as the shortest decimal that reads back the same; one object
///   .3mf  zip, by lib3mf (HASP_ENABLE_LIB3MF), which cuts float32 off after six decimals
/// Refused: no triangles, polygons or strips (run vtkTriangleFilter), points that are not finite
/// (.stl, .3mf: in float32), more than 2^32 - 1 triangles, a label that is none
/// (ValidatePartLabel); as .3mf what lib3mf finds not closed, not 2-manifold or not wound one way,
/// and more than 2^31 - 1 points or triangles.
/// Limit: lib3mf sets the program's locale to "C".
VTKHASPIOMEDICAL_EXPORT void WriteSurface(vtkPolyData* surface, const std::string& path,
  const PartLabel& label = {}, const InspectPart& inspect = {});

/// An object of a file of several.
struct NamedSurface
{
  std::string name; ///< one that IsPartName takes; may be empty
  vtkPolyData* surface = nullptr;
};

/// .3mf: one object each, in this order, under their names; else as WriteSurface. The label's name
/// is that of the whole.
VTKHASPIOMEDICAL_EXPORT void WriteSurfaces(const std::vector<NamedSurface>& surfaces,
  const std::string& path, const PartLabel& label = {}, const InspectPart& inspect = {});

/// These bytes, whatever the file's ending.
VTKHASPIOMEDICAL_EXPORT void WriteBytes(std::string_view bytes, const std::string& path);

/// Has `write` make a file, or a folder, under a temporary name with the same ending beside `path`,
/// shows it to `inspect`, and puts it in place unless that throws: then nothing is left of it.
/// What stood there is replaced if it is a file or an empty folder.
VTKHASPIOMEDICAL_EXPORT void WriteInspected(const std::string& path,
  const std::function<void(const std::string& pendingName)>& write,
  const std::function<void(const std::string& pendingName)>& inspect);

/// Removes the temporary files and folders of all writes under way (of sixteen at most): for the
/// handler of a signal that ends the program. Those writes can then no longer succeed. Safe in a
/// signal handler, any thread.
VTKHASPIOMEDICAL_EXPORT void RemovePendingFiles() noexcept;

} // namespace hasp

#endif
