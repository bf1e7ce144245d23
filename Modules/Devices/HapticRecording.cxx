#include "Devices/HapticRecording.h"

#include "Devices/SettingsCheck.h"
#include "Devices/TextFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* What = "haptic recording";
constexpr std::array<char, 8> Magic = { 'H', 'A', 'S', 'P', 'T', 'I', 'C', 'K' };
constexpr std::uint32_t Version = 1, KnownStatus = 31;
constexpr std::size_t CrcBytes = 4;

[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument(std::string(What) + ": " + why);
}

constexpr std::array<std::uint32_t, 256> CrcTable = []
{
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n)
  {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit)
      c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}();

std::uint32_t Crc32(std::span<const std::byte> bytes)
{
  std::uint32_t crc = ~0u;
  for (const std::byte b : bytes)
    crc = CrcTable[(crc ^ std::to_integer<std::uint32_t>(b)) & 255] ^ (crc >> 8);
  return ~crc;
}

/// Numbers one after the other, little endian whatever the machine is.
class Packer
{
public:
  explicit Packer(std::span<std::byte> bytes) : Bytes(bytes) {}
  template <class Number>
  void Put(Number number)
  {
    using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
    const auto bits = std::bit_cast<Bits>(number);
    for (std::size_t b = 0; b < sizeof bits; ++b)
      this->Bytes[this->At++] = static_cast<std::byte>(bits >> (8 * b) & 255);
  }
  void Put(const glm::dvec3& v)
  {
    for (int axis = 0; axis < 3; ++axis)
      this->Put(v[axis]);
  }
  void PutCrc() { this->Put(Crc32(this->Bytes.first(this->At))); }

private:
  std::span<std::byte> Bytes;
  std::size_t At = 0;
};

class Unpacker
{
public:
  explicit Unpacker(std::span<const std::byte> bytes) : Bytes(bytes) {}
  template <class Number>
  Number Take()
  {
    using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
    Bits bits = 0;
    for (std::size_t b = 0; b < sizeof bits; ++b)
      bits |= static_cast<Bits>(this->Bytes[this->At++]) << (8 * b);
    return std::bit_cast<Number>(bits);
  }
  glm::dvec3 TakeVector()
  {
    const auto x = this->Take<double>(), y = this->Take<double>(), z = this->Take<double>();
    return { x, y, z };
  }

private:
  std::span<const std::byte> Bytes;
  std::size_t At = 0;
};

/// Whether the last four bytes are the CRC of those before.
bool IsWhole(std::span<const std::byte> bytes)
{
  const std::size_t body = bytes.size() - CrcBytes;
  return Unpacker(bytes.last(CrcBytes)).Take<std::uint32_t>() == Crc32(bytes.first(body));
}

/// Four characters from `at` on as one number, zeros where there are none; and back.
std::uint32_t Letters(const std::string& name, std::size_t at)
{
  std::uint32_t bits = 0;
  for (std::size_t n = 0; n < 4 && at + n < name.size(); ++n)
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(name[at + n])) << 8 * n;
  return bits;
}

std::string LettersOf(std::uint32_t bits)
{
  std::string name;
  for (; bits != 0; bits >>= 8)
    name += static_cast<char>(bits & 255);
  return name;
}

HapticRecording ParseHeader(std::span<const std::byte> bytes)
{
  if (bytes.size() < HapticHeaderBytes)
    Refuse("there are " + std::to_string(bytes.size()) + " bytes, a header has " +
           std::to_string(HapticHeaderBytes));
  const auto header = bytes.first(HapticHeaderBytes);
  if (std::memcmp(header.data(), Magic.data(), Magic.size()) != 0)
    Refuse("it does not begin as one");
  Unpacker in(header.subspan(Magic.size()));
  if (const auto version = in.Take<std::uint32_t>(); version != Version)
    Refuse("it is of version " + std::to_string(version) + ", and this program reads " +
           std::to_string(Version));
  if (!IsWhole(header))
    Refuse("the header is damaged");
  const auto headerBytes = in.Take<std::uint32_t>(), recordBytes = in.Take<std::uint32_t>();
  if (headerBytes != HapticHeaderBytes || recordBytes != HapticRecordBytes)
    Refuse("header and records have " + std::to_string(headerBytes) + " and " +
           std::to_string(recordBytes) + " bytes, must be " + std::to_string(HapticHeaderBytes) +
           " and " + std::to_string(HapticRecordBytes));
  HapticRecording recording;
  recording.poseAxes = static_cast<int>(in.Take<std::uint32_t>());
  recording.forceAxes = static_cast<int>(in.Take<std::uint32_t>());
  const auto firstLetters = in.Take<std::uint32_t>();
  recording.periodNs = in.Take<std::int64_t>();
  recording.peakForceN = in.Take<double>();
  recording.peakTorqueNmm = in.Take<double>();
  recording.kernels = LettersOf(firstLetters) + LettersOf(in.Take<std::uint32_t>());
  ValidateHapticHeader(recording);
  return recording;
}

HapticRecord ParseRecord(std::span<const std::byte> bytes)
{
  Unpacker in(bytes);
  HapticRecord r;
  r.number = in.Take<std::uint64_t>();
  r.nowNs = in.Take<std::int64_t>();
  r.sample.timeNs = in.Take<std::int64_t>();
  r.sample.pose.position = in.TakeVector();
  r.sample.pose.orientation.w = in.Take<double>();
  r.sample.pose.orientation.x = in.Take<double>();
  r.sample.pose.orientation.y = in.Take<double>();
  r.sample.pose.orientation.z = in.Take<double>();
  r.wrench.force = in.TakeVector();
  r.wrench.torque = in.TakeVector();
  r.sample.buttons = in.Take<std::uint32_t>();
  r.status = static_cast<DeviceStatus>(in.Take<std::uint32_t>());
  r.costNs = in.Take<std::uint32_t>();
  r.contacts = in.Take<std::uint32_t>();
  return r;
}
} // namespace

void ValidateHapticHeader(const HapticRecording& of)
{
  const int poses = of.poseAxes, forces = of.forceAxes;
  if ((poses != 3 && poses != 6) || (forces != 0 && forces != 3 && forces != 6))
    Refuse("axes of pose and force are " + std::to_string(poses) + " and " +
           std::to_string(forces) + ", must be 3 or 6, and 0, 3 or 6");
  if (of.periodNs < 1)
    Refuse("the period is " + std::to_string(of.periodNs) + " ns, must be 1 or more");
  const bool named = std::all_of(of.kernels.begin(), of.kernels.end(),
    [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
    });
  if (!named)
    Refuse("the kernels' name is none: it must be letters, digits and _");
  CheckRange(What, "the largest force in N", of.peakForceN, 0.0, 1000.0);
  CheckRange(What, "the largest torque in N mm", of.peakTorqueNmm, 0.0, 1e6);
}

void PackHapticHeader(const HapticRecording& of, std::span<std::byte, HapticHeaderBytes> bytes)
{
  std::memcpy(bytes.data(), Magic.data(), Magic.size());
  Packer out(bytes.subspan(Magic.size(), HapticHeaderBytes - Magic.size() - CrcBytes));
  out.Put(Version);
  out.Put(static_cast<std::uint32_t>(HapticHeaderBytes));
  out.Put(static_cast<std::uint32_t>(HapticRecordBytes));
  out.Put(static_cast<std::uint32_t>(of.poseAxes));
  out.Put(static_cast<std::uint32_t>(of.forceAxes));
  out.Put(Letters(of.kernels, 0));
  out.Put(of.periodNs);
  out.Put(of.peakForceN);
  out.Put(of.peakTorqueNmm);
  out.Put(Letters(of.kernels, 4));
  Packer(bytes.last(CrcBytes)).Put(Crc32(bytes.first(HapticHeaderBytes - CrcBytes)));
}

void PackHapticRecord(const HapticRecord& r, std::span<std::byte, HapticRecordBytes> bytes)
{
  Packer out(bytes);
  out.Put(r.number);
  out.Put(r.nowNs);
  out.Put(r.sample.timeNs);
  out.Put(r.sample.pose.position);
  const glm::dquat& q = r.sample.pose.orientation;
  for (const double number : { q.w, q.x, q.y, q.z })
    out.Put(number);
  out.Put(r.wrench.force);
  out.Put(r.wrench.torque);
  for (const std::uint32_t number : { r.sample.buttons, static_cast<std::uint32_t>(r.status),
         r.costNs, r.contacts, std::uint32_t(0) })
    out.Put(number);
  out.PutCrc();
}

HapticRecording ParseHapticRecording(std::span<const std::byte> bytes)
{
  HapticRecording recording = ParseHeader(bytes);
  auto left = bytes.subspan(HapticHeaderBytes);
  if (left.size() / HapticRecordBytes > MostHapticRecords)
    Refuse("there are " + std::to_string(left.size() / HapticRecordBytes) + " ticks, at most " +
           std::to_string(MostHapticRecords));
  recording.records.reserve(left.size() / HapticRecordBytes);
  for (; left.size() >= HapticRecordBytes; left = left.subspan(HapticRecordBytes))
  {
    const auto one = left.first(HapticRecordBytes);
    if (!IsWhole(one))
      break;
    const HapticRecord record = ParseRecord(one);
    const std::string which =
      "tick " + std::to_string(recording.records.size() + 1) + " of the file ";
    if (!recording.records.empty() && record.number <= recording.records.back().number)
      Refuse(which + "is not younger than the one before");
    if ((static_cast<std::uint32_t>(record.status) & ~KnownStatus) != 0)
      Refuse(which + "has a status that is none");
    recording.records.push_back(record);
  }
  recording.bytesLost = left.size();
  return recording;
}

HapticRecording ReadHapticRecording(const std::string& file)
{
  const std::string text =
    ReadTextFile(file, HapticHeaderBytes + (MostHapticRecords + 1) * HapticRecordBytes, What);
  return ParseHapticRecording(std::as_bytes(std::span(text)));
}

} // namespace hasp
