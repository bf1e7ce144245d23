#ifndef vtkHaspVolumeSlabReader_h
#define vtkHaspVolumeSlabReader_h

#include "Grid/GridView.h"          // for AnyGridView
#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <cstddef> // for sizes
#include <memory>  // for Internals
#include <string>  // for paths

namespace hasp
{

struct Passport;           // of vtkHaspVolumeFile.h
struct VolumeReadSettings; // likewise

/// A volume file read some slices at a time, from the first to the last, for volumes that memory
/// does not hold: the counterpart of VolumeSlabWriter.
///
/// MetaImage, NRRD and NIfTI, raw or compressed, of either byte order, whose samples are int16,
/// uint16, uint8 or float32 without slope and intercept, are read as they come: memory is one slab.
/// Any other volume (DICOM, InVesalius, VTI, segmentations, other samples) is loaded, and Streams
/// says so. Headers are checked as OpenVolume does; samples that are NaN or infinite are refused.
///
/// Reads, and maps nothing: a file that shrinks meanwhile is an error and not a signal
/// (Decisions/0014).
///
/// Threads: one at a time (RENDER or WORKER). Throws as OpenVolume and LoadVolume.
class VTKHASPIOMEDICAL_EXPORT VolumeSlabReader
{
public:
  /// settings  its memory limit holds for what is in memory at once: some slices, or the volume
  explicit VolumeSlabReader(const std::string& path, const VolumeReadSettings& settings,
    const ProgressFunction& progress = {});
  ~VolumeSlabReader();
  VolumeSlabReader(const VolumeSlabReader&) = delete;
  VolumeSlabReader& operator=(const VolumeSlabReader&) = delete;

  /// What the header says; of a loaded volume what its samples say, too.
  const Passport& GetPassport() const;
  /// Whether slices are read when they are asked for. If not, all are in memory.
  bool Streams() const;
  /// Of samples that are held now.
  std::size_t BytesHeld() const;

  /// Slices [first, first + count), good until the next call. `first` is one of the slices of the
  /// call before or the next one. Throws std::invalid_argument if it is not, or where there are no
  /// such slices; std::runtime_error for the file, also ever after it has failed once, and above
  /// the memory limit.
  AnyGridView Read(int first, int count);

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp

#endif
