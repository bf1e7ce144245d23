#include "Dicom/ContentUid.h"

#include "vtksys/MD5.h"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <new>

namespace hasp
{
namespace
{

/// The 128 bits as a decimal number, most significant byte first.
std::string Decimal(std::array<unsigned char, 16> number)
{
  std::string digits;
  while (std::any_of(number.begin(), number.end(), [](unsigned char b) { return b != 0; }))
  {
    unsigned rest = 0;
    for (unsigned char& byte : number)
    {
      const unsigned value = rest * 256 + byte;
      byte = static_cast<unsigned char>(value / 10);
      rest = value % 10;
    }
    digits.push_back(static_cast<char>('0' + rest));
  }
  return { digits.rbegin(), digits.rend() };
}

} // namespace

ContentUid::ContentUid() : State(vtksysMD5_New())
{
  if (!this->State)
    throw std::bad_alloc();
  vtksysMD5_Initialize(this->State);
}

ContentUid::~ContentUid()
{
  vtksysMD5_Delete(this->State);
}

void ContentUid::Add(const void* bytes, std::size_t size)
{
  const auto* at = static_cast<const unsigned char*>(bytes);
  while (size > 0)
  {
    const std::size_t part = std::min<std::size_t>(size, INT_MAX);
    vtksysMD5_Append(this->State, at, static_cast<int>(part));
    at += part;
    size -= part;
  }
}

void ContentUid::Add(std::string_view text)
{
  const std::uint64_t size = text.size();
  this->Add(&size, sizeof size);
  this->Add(text.data(), text.size());
}

void ContentUid::Finish()
{
  vtksysMD5_Finalize(this->State, this->Digest.data());
}

std::string ContentUid::Uid(std::string_view thing) const
{
  ContentUid named;
  named.Add(this->Digest.data(), this->Digest.size());
  named.Add(thing);
  named.Finish();
  Bytes uuid = named.Digest;
  uuid[6] = static_cast<unsigned char>((uuid[6] & 0x0f) | 0x30); // RFC 4122: version 3, by name
  uuid[8] = static_cast<unsigned char>((uuid[8] & 0x3f) | 0x80);
  return "2.25." + Decimal(uuid);
}

std::string ContentUid::Short() const
{
  std::string text;
  for (std::size_t n = 0; n < 16; ++n)
    text.push_back("0123456789ABCDEF"[this->Digest[n / 2] >> (n % 2 == 0 ? 4 : 0) & 15]);
  return text;
}

} // namespace hasp
