#pragma once
#include "Devices/HapticDevice.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hasp
{

/// One tick, as it went.
struct HapticRecord
{
  std::uint64_t number = 0; ///< of the tick; grows from record to record
  std::int64_t nowNs = 0;   ///< that Read was called with
  DeviceSample sample{};    ///< that it gave
  DeviceStatus status = DeviceStatus::Ok;
  Wrench wrench{};            ///< that Write was called with
  std::uint32_t costNs = 0;   ///< CPU time of the tick
  std::uint32_t contacts = 0; ///< points in contact
};

/// Ticks of one device. Poses may be none and numbers not finite: faults are what one records for.
struct HapticRecording
{
  std::int64_t periodNs = 1'000'000;
  int poseAxes = 6, forceAxes = 6;
  double peakForceN = 3.3, peakTorqueNmm = 0.0;
  /// Of the contact kernels that ran (ContactKernels::name): letters, digits and _; only the first
  /// 8 are kept. Empty: not said.
  std::string kernels{};
  std::vector<HapticRecord> records{};
  std::uint64_t bytesLost = 0; ///< behind the last whole record, where a file was cut off
};

constexpr std::size_t MostHapticRecords = 4'000'000; ///< 66 minutes at 1 kHz; 608 MB
constexpr std::size_t HapticHeaderBytes = 64, HapticRecordBytes = 152;

// The file: a header, then records, all little endian, without gaps. CRC-32 as in PNG.
//
//   header, 64 bytes                         record, 152 bytes
//    0  8 characters "HASPTICK"               0  u64 number
//    8  u32 version, 1                        8  i64 nowNs
//   12  u32 bytes of the header, 64          16  i64 sample's timeNs
//   16  u32 bytes of a record, 152           24  3 f64 position, mm
//   20  u32 poseAxes, 3 or 6                 48  4 f64 orientation, w x y z
//   24  u32 forceAxes, 0, 3 or 6             80  3 f64 force, N
//   28  kernels, characters 1 to 4, or 0    104  3 f64 torque, N mm
//   32  i64 periodNs                        128  u32 buttons, u32 status
//   40  f64 peakForceN                      136  u32 costNs, u32 contacts
//   48  f64 peakTorqueNmm                   144  u32 0
//   56  kernels, 5 to 8, or 0               148  u32 CRC of the 148 bytes before
//   60  u32 CRC of the 60 bytes before
//
// Files of before kernels were said have zeros there, and read as ever.
// A file that was cut off (power, a full disk) is good up to the last record that is whole: what
// follows is counted in bytesLost. Nothing in it says who or what was recorded.

/// Throws std::invalid_argument unless a reader takes such a header: axes, period >= 1 ns, force in
/// [0, 1000] N, torque in [0, 1e6] N mm, the kernels' name. The records are not looked at. Any
/// thread.
void ValidateHapticHeader(const HapticRecording& of);

/// One header or record as bytes, for who writes while it goes on. HAPTIC could; WORKER does.
void PackHapticHeader(const HapticRecording& of, std::span<std::byte, HapticHeaderBytes> bytes);
void PackHapticRecord(const HapticRecord& record, std::span<std::byte, HapticRecordBytes> bytes);

/// Errors are std::runtime_error (file) or std::invalid_argument (content: no such header, another
/// version, a whole record that says what cannot be), with where and why, never the file's name.
/// The size is held against MostHapticRecords before memory is taken. Any thread; O(n).
HapticRecording ParseHapticRecording(std::span<const std::byte> bytes);
HapticRecording ReadHapticRecording(const std::string& file);

} // namespace hasp
