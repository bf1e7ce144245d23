#ifndef vtkHaspVolumeSlabs_h
#define vtkHaspVolumeSlabs_h

#include "Grid/GridGeometry.h"      // for GridGeometry
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <cstdint> // for samples
#include <memory>  // for Internals
#include <span>    // for samples
#include <string>  // for paths

namespace hasp
{

/// What kernels read, in the order of AnyGridView.
enum class SampleType
{
  Int16,
  UInt16,
  UInt8,
  Float32
};

/// A volume file written some slices at a time, for volumes that memory does not hold.
///
/// By the path's ending (UTF-8): .mha, .nrrd and .nii raw; .nrrd with `compress` and .nii.gz with
/// gzip (level 1). The file appears whole with Commit or not at all; without it the earlier file is
/// as it was. Slices come in the order of the geometry, x fastest. NIfTI files hold x or y
/// reversed where that keeps the quaternion of their qform exact; each sample stays at its place in
/// the world. They are NIfTI-1 with float32 positions unless that would move a corner by more than
/// 1e-4 mm or a side is above 32767 samples: then NIfTI-2.
///
/// Memory: one slice for NIfTI, nothing for the others. Cost: the disk's; gzip about 45 MB/s.
/// Threads: one at a time (RENDER or WORKER). Throws std::invalid_argument for geometry and
/// samples, std::runtime_error for the file, with its label: unknown ending, or too little room on
/// the disk (checked before the first byte; what gzip leaves is not known before, so there the
/// write itself fails).
class VTKHASPIOMEDICAL_EXPORT VolumeSlabWriter
{
public:
  VolumeSlabWriter(
    const std::string& path, const GridGeometry& geometry, SampleType type, bool compress = false);
  ~VolumeSlabWriter();
  VolumeSlabWriter(const VolumeSlabWriter&) = delete;
  VolumeSlabWriter& operator=(const VolumeSlabWriter&) = delete;

  /// The next slices: dims.x * dims.y * n samples, n >= 0 and at most SlicesLeft(), of the type
  /// promised. After a failed write no more can be appended.
  void Append(std::span<const std::int16_t> samples);
  void Append(std::span<const std::uint16_t> samples);
  void Append(std::span<const std::uint8_t> samples);
  void Append(std::span<const float> samples);

  int SlicesLeft() const;

  /// Puts the file in place. Throws std::invalid_argument while slices are missing.
  void Commit();

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp

#endif
