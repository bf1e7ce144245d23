#include "Devices/HapticRecorder.h"

#include "Devices/SettingsCheck.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr std::size_t BatchTicks = 256;
constexpr auto relaxed = std::memory_order_relaxed;

std::size_t Checked(std::size_t ringTicks)
{
  CheckRange("haptic recording", "ringTicks", static_cast<double>(ringTicks), 64.0, 1e6);
  return ringTicks;
}

void Grow(std::atomic<std::uint64_t>& count, std::uint64_t by) noexcept
{
  count.store(count.load(relaxed) + by, relaxed); // one thread each
}
} // namespace

HapticRecorder::HapticRecorder(
  const std::string& file, const HapticRecording& of, std::size_t ringTicks)
  : Ring(Checked(ringTicks)),
    Batch(BatchTicks * HapticRecordBytes)
{
  ValidateHapticHeader(of);
  this->Handle = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  std::array<std::byte, HapticHeaderBytes> header{};
  PackHapticHeader(of, header);
  try
  {
    if (this->Handle < 0 || this->WriteAll(header.data(), header.size()) < header.size())
      throw std::runtime_error("haptic recording: the file cannot be written");
    LoopSettings settings{ .periodNs = 20'000'000 };
    settings.scheduling = {
      .fifoPriority = 0, .exactTimer = false, .flushDenormals = false, .lock = MemoryLocking::None
    };
    this->Writer.Start(settings,
      [this](const LoopTick&) noexcept
      {
        this->WriteWhatCame();
        return true;
      });
  }
  catch (...)
  {
    if (this->Handle >= 0)
      close(this->Handle);
    throw;
  }
}

HapticRecorder::~HapticRecorder()
{
  this->Finish();
}

void HapticRecorder::Push(const HapticRecord& record) noexcept
{
  if (!this->Ring.Push(record))
    Grow(this->Full, 1);
}

void HapticRecorder::Finish() noexcept
{
  if (this->Handle < 0)
    return;
  this->Writer.Stop();
  this->WriteWhatCame(); // what came since its last round
  close(this->Handle);
  this->Handle = -1;
}

std::size_t HapticRecorder::WriteAll(const std::byte* bytes, std::size_t count) noexcept
{
  std::size_t done = 0;
  while (done < count)
  {
    const ssize_t more = write(this->Handle, bytes + done, count - done);
    if (more < 0 && errno == EINTR)
      continue;
    if (more <= 0)
      break;
    done += static_cast<std::size_t>(more);
  }
  return done;
}

void HapticRecorder::WriteWhatCame() noexcept
{
  HapticRecord record;
  for (bool more = true; more;)
  {
    std::size_t ticks = 0;
    while (ticks < BatchTicks && (more = this->Ring.Pop(record)))
    {
      if (this->Broken)
        Grow(this->Failed, 1);
      else if (this->Written.load(relaxed) + ticks == MostHapticRecords)
        Grow(this->Late, 1);
      else if (record.number < this->NextNumber)
        Grow(this->Disordered, 1);
      else
      {
        PackHapticRecord(
          record, std::span<std::byte, HapticRecordBytes>(
                    this->Batch.data() + ticks++ * HapticRecordBytes, HapticRecordBytes));
        this->NextNumber = record.number + 1;
      }
    }
    // Half a record may be in the file where it fails: that is what its reader skips.
    const std::size_t whole =
      this->WriteAll(this->Batch.data(), ticks * HapticRecordBytes) / HapticRecordBytes;
    this->Broken = this->Broken || whole < ticks;
    Grow(this->Written, whole);
    Grow(this->Failed, ticks - whole);
  }
}

HapticRecorderCounts HapticRecorder::Counts() const noexcept
{
  return { this->Written.load(relaxed), this->Full.load(relaxed), this->Late.load(relaxed),
    this->Failed.load(relaxed), this->Disordered.load(relaxed) };
}

std::vector<std::string> HapticRecorder::Losses() const
{
  const HapticRecorderCounts counts = this->Counts();
  const struct
  {
    std::uint64_t count;
    const char* what;
  } kinds[] = {
    { counts.full, "ticks that came faster than the disk took them" },
    { counts.late, "ticks after the most that a recording holds" },
    { counts.failed, "ticks that could not be written; is the disk full?" },
    { counts.disordered, "ticks whose numbers had not grown: a loop that starts again counts on" },
  };
  std::vector<std::string> losses;
  for (const auto& [count, what] : kinds)
    if (count > 0)
      losses.push_back("not in the haptic recording: " + std::to_string(count) + " " + what);
  return losses;
}

} // namespace hasp
