#pragma once
#include <cstdint>
#include <type_traits>

/// What hasp-dicom-decode writes to its standard output (a pipe: it may write no file), in the
/// machine's own byte order: one SliceRecord per file asked for, in that order; in `scan` mode one
/// per frame of files that say of each frame where it lies (enhanced CT and MR), in `decode` mode
/// one per frame asked for, and each good one is followed by pixelBytes of 16-bit stored values.
/// Nothing in it is trusted by the reading side.
///
/// Standard input: entries that are each ended by a NUL: the frame from 0 (scan: not used), a colon
/// and the path. Arguments: scan|decode, memory in bytes
/// that parsing and decoding may take (on top of what the program takes before the first file),
/// processor seconds.
namespace hasp
{

enum class SliceStatus : std::uint32_t
{
  Image = 0,
  NotDicom = 1,    ///< a foreign file
  NoImage = 2,     ///< DICOM without rows and columns
  Damaged = 3,     ///< begins like DICOM, or like an image of it, and cannot be parsed
  CutOff = 4,      ///< fewer pixels than rows x columns (decode)
  Undecodable = 5, ///< no decoder for its compression, or it failed
  Last = Undecodable
};

enum SliceFlags : std::uint32_t
{
  HasSpacing = 1,
  HasPosition = 2,
  HasOrientation = 4,
  HasRescale = 8,
  RescaleIsHU = 16, ///< RescaleType says HU or is absent, as CT leaves it
  Packed = 32,      ///< encapsulated or deflated: the file may be smaller than its pixels
  Monochrome1 = 64,
  Monochrome2 = 128,
  HasInstance = 256,
  SaysBurnedIn = 512,     ///< Burned In Annotation (0028,0301) is YES
  SaysNotBurnedIn = 1024, ///< it is NO; neither flag: the file does not say
  HasGantryTilt = 2048,
  Lossy = 4096, ///< the transfer syntax loses, or Lossy Image Compression (0028,2110) says it did
  HasThickness = 8192,
  HasKVP = 16384,
  HasPadding = 32768,
  Confined = 65536, ///< the decoder runs behind a filter of system calls, not only within limits
  AllFlags = 131071
};

struct SliceRecord
{
  static constexpr std::uint32_t Magic = 0x33445348; // "HSD3"

  std::uint32_t magic;
  std::uint32_t index; ///< of the file in the list, from 0
  std::uint32_t status;
  std::uint32_t flags;
  std::uint32_t frameNumber; ///< of the file, from 0; 0 in files of one
  std::uint32_t moreFrames;  ///< of the same file to come (scan)
  std::uint32_t rows, columns;
  std::uint32_t frames; ///< 1, or as many as the file has without saying where they lie
  std::uint32_t samplesPerPixel;
  std::uint32_t bitsAllocated, bitsStored, highBit, isSigned;
  std::int32_t instance;
  std::int32_t padding;  ///< the stored value of pixels outside the picture (0028,0120)
  double spacing[2];     ///< mm between rows, between columns
  double position[3];    ///< of the first pixel, LPS mm; NaN if it is no number
  double orientation[6]; ///< direction of a row, direction of a column
  double slope, intercept;
  double gantryTilt; ///< degrees, as the file says (0018,1120); the stack itself is measured
  double thickness;  ///< of the slice, mm, as the file says (0018,0050); not the slices' distance
  double kvp;        ///< kV of the tube, as the file says (0018,0060)
  std::uint64_t pixelBytes; ///< that follow
  char modality[24];        ///< NUL-ended texts of DicomTerms.h; empty if the file does not say
  char photometric[24];
  char transferSyntax[72];
  char patientPosition[8];
  char series[72]; ///< UIDs, NUL-ended: to tell series apart, never shown
  char frame[72];  ///< frame of reference
};
static_assert(std::is_trivially_copyable_v<SliceRecord>);
static_assert(sizeof(SliceRecord) == 64 + 16 * 8 + 8 + 2 * 24 + 3 * 72 + 8);

} // namespace hasp
