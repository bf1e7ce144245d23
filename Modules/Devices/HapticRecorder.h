#pragma once
#include "Devices/HapticRecording.h"
#include "Realtime/LoopThread.h"
#include "Realtime/SpscRing.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

struct HapticRecorderCounts
{
  std::uint64_t written = 0;    ///< ticks that are in the file
  std::uint64_t full = 0;       ///< ticks lost because the writer could not keep up
  std::uint64_t late = 0;       ///< … that came after the most a file holds
  std::uint64_t failed = 0;     ///< … that the disk did not take
  std::uint64_t disordered = 0; ///< … whose number had not grown: no reader would take the file
};

/// Writes ticks to a file while they happen: HapticRecording's format.
///
/// The tick pushes a record into a ring and goes on; a thread of this writes what came, every 20
/// ms. If the program ends in the middle, the file holds all but the last 20 ms. What finds the
/// ring full is lost and counted, and the numbers of the records show where. Threads: Push on
/// HAPTIC; all else on RENDER, Finish after the last Push. A thread (WORKER) of its own from
/// construction to Finish. Cost: 20 ns a Push; the ring, 160 bytes a tick.
class HapticRecorder
{
public:
  /// Makes the file, or empties it. `of`: all but the records. ringTicks: in [64, 1,000,000].
  /// Throws std::runtime_error if the file cannot be written, std::invalid_argument if ringTicks
  /// is out of its range, or as ValidateHapticHeader: then no file is touched.
  HapticRecorder(const std::string& file, const HapticRecording& of, std::size_t ringTicks = 4096);
  ~HapticRecorder();
  HapticRecorder(const HapticRecorder&) = delete;
  HapticRecorder& operator=(const HapticRecorder&) = delete;

  void Push(const HapticRecord& record) noexcept;

  /// Writes what is left and closes the file. What is pushed from then on is lost.
  void Finish() noexcept;

  HapticRecorderCounts Counts() const noexcept;
  /// What is not in the file, in sentences.
  std::vector<std::string> Losses() const;

private:
  void WriteWhatCame() noexcept;
  /// How many of them the disk took.
  std::size_t WriteAll(const std::byte* bytes, std::size_t count) noexcept;

  SpscRing<HapticRecord> Ring;
  std::vector<std::byte> Batch; ///< the writer's
  int Handle = -1;
  bool Broken = false;          ///< the writer's: the disk has refused once
  std::uint64_t NextNumber = 0; ///< the writer's: the least that a record may have
  std::atomic<std::uint64_t> Written{ 0 }, Full{ 0 }, Late{ 0 }, Failed{ 0 }, Disordered{ 0 };
  LoopThread Writer;
};

} // namespace hasp
