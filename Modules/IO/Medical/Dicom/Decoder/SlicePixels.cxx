#include "Dicom/Decoder/SlicePixels.h"

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <new>

namespace hasp
{
namespace
{

bool BitsMakeSense(const SliceRecord& r)
{
  return (r.bitsAllocated == 8 || r.bitsAllocated == 16) && r.bitsStored >= 1 &&
         r.bitsStored <= r.bitsAllocated && r.highBit + 1 >= r.bitsStored &&
         r.highBit < r.bitsAllocated;
}

template <typename T>
bool Write(const T* from, const SliceRecord& r, std::FILE* out)
{
  const unsigned shift = r.highBit + 1 - r.bitsStored;
  const std::uint32_t mask = (1U << r.bitsStored) - 1U;
  const std::uint32_t sign = r.isSigned ? 1U << (r.bitsStored - 1) : 0U;
  std::uint16_t block[16384];
  for (std::size_t left = r.pixelBytes / sizeof(std::uint16_t); left > 0;)
  {
    const std::size_t now = std::min(left, std::size(block));
    for (std::size_t n = 0; n < now; ++n)
      block[n] = static_cast<std::uint16_t>((((from[n] >> shift) & mask) ^ sign) - sign);
    if (std::fwrite(block, sizeof(std::uint16_t), now, out) != now)
      return false;
    from += now;
    left -= now;
  }
  return true;
}

} // namespace

SlicePixels DecodePixels(DcmDataset& data, SliceRecord& record)
{
  const auto give = [&](SliceStatus status)
  {
    record.status = static_cast<std::uint32_t>(status);
    return SlicePixels{};
  };
  const auto fits = [](const OFCondition& done)
  {
    if (done == EC_MemoryExhausted)
      throw std::bad_alloc(); // it is the limit that failed, not the file's compression
    return done.good();
  };
  if (!BitsMakeSense(record) || record.samplesPerPixel != 1 || record.frames != 1)
    return give(SliceStatus::Undecodable);
  if (!fits(data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr)) ||
      !data.canWriteXfer(EXS_LittleEndianExplicit))
    return give(SliceStatus::Undecodable);
  Uint16 bitsNow = 0; // a decompressor may change what the header said
  data.findAndGetUint16(DCM_BitsAllocated, bitsNow);
  if (bitsNow != record.bitsAllocated)
    return give(SliceStatus::Undecodable);
  const std::size_t count = std::size_t(record.rows) * record.columns;
  SlicePixels pixels;
  unsigned long there = 0;
  fits(record.bitsAllocated == 16 ? data.findAndGetUint16Array(DCM_PixelData, pixels.words, &there)
                                  : data.findAndGetUint8Array(DCM_PixelData, pixels.bytes, &there));
  if (there < count || (!pixels.words && !pixels.bytes))
    return give(SliceStatus::CutOff);
  record.pixelBytes = count * sizeof(std::uint16_t);
  return pixels;
}

bool WritePixels(const SlicePixels& pixels, const SliceRecord& record, std::FILE* out)
{
  if (record.pixelBytes == 0)
    return true;
  return pixels.words ? Write(pixels.words, record, out) : Write(pixels.bytes, record, out);
}

} // namespace hasp
