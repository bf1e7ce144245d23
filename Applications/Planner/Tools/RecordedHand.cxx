#include "Tools/RecordedHand.h"

#include <stdexcept>
#include <utility>

namespace hasp
{

RecordedHand::RecordedHand(std::shared_ptr<const HapticRecording> recording)
  : Recording(std::move(recording))
{
  if (!this->Recording || this->Recording->records.empty())
    throw std::invalid_argument("the recorded hand: it has no record");
  this->Is.name = "recording";
  this->Is.poseAxes = this->Recording->poseAxes;
  this->Is.forceAxes = this->Recording->forceAxes;
}

DeviceStatus RecordedHand::Read(std::int64_t nowNs, DeviceSample& sample) noexcept
{
  if (!std::exchange(this->Began, true))
    this->BeganNs = nowNs;
  const std::vector<HapticRecord>& records = this->Recording->records;
  const std::int64_t since = NsBetween(this->BeganNs, nowNs);
  while (this->Next + 1 < records.size() &&
         NsBetween(records.front().nowNs, records[this->Next + 1].nowNs) <= since)
    ++this->Next;
  const HapticRecord& now = records[this->Next];
  if (this->Next + 1 == records.size() &&
      since > NsBetween(records.front().nowNs, now.nowNs) + this->Recording->periodNs)
    return DeviceStatus::Ended;
  if (TakesForce(now.status))
  {
    sample = now.sample;
    sample.timeNs = nowNs;
  }
  return now.status;
}

DeviceStatus RecordedHand::Write(const Wrench&) noexcept
{
  return this->Recording->records[this->Next].status;
}

} // namespace hasp
