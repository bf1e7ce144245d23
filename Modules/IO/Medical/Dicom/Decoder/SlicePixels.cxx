#include "Dicom/Decoder/SlicePixels.h"

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <algorithm>
#include <new>

namespace hasp
{
namespace
{

/// One frame of one sample, whose bits make sense.
bool IsPlain(const SliceRecord& r)
{
  return r.samplesPerPixel == 1 && r.frames == 1 &&
         (r.bitsAllocated == 8 || r.bitsAllocated == 16) && r.bitsStored >= 1 &&
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

SlicePixels Give(SliceStatus status, SliceRecord& record)
{
  record.status = static_cast<std::uint32_t>(status);
  return {};
}

/// Whether it worked. Lack of memory is the limit's fault, not the file's compression.
bool Worked(const OFCondition& done)
{
  if (done == EC_MemoryExhausted)
    throw std::bad_alloc();
  return done.good();
}

} // namespace

SlicePixels DecodePixels(DcmDataset& data, SliceRecord& record)
{
  if (!IsPlain(record) || !Worked(data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr)) ||
      !data.canWriteXfer(EXS_LittleEndianExplicit))
    return Give(SliceStatus::Undecodable, record);
  Uint16 bitsNow = 0; // a decompressor may change what the header said
  data.findAndGetUint16(DCM_BitsAllocated, bitsNow);
  if (bitsNow != record.bitsAllocated)
    return Give(SliceStatus::Undecodable, record);
  const std::size_t count = std::size_t(record.rows) * record.columns;
  SlicePixels pixels;
  unsigned long there = 0;
  Worked(record.bitsAllocated == 16
           ? data.findAndGetUint16Array(DCM_PixelData, pixels.words, &there)
           : data.findAndGetUint8Array(DCM_PixelData, pixels.bytes, &there));
  if (there < count || (!pixels.words && !pixels.bytes))
    return Give(SliceStatus::CutOff, record);
  record.pixelBytes = count * sizeof(std::uint16_t);
  return pixels;
}

SlicePixels DecodeFrame(DcmDataset& data, SliceRecord& record)
{
  DcmElement* element = nullptr;
  Uint32 size = 0, fragment = 0;
  const std::size_t count = std::size_t(record.rows) * record.columns;
  if (!IsPlain(record) || data.findAndGetElement(DCM_PixelData, element).bad() || !element ||
      element->getUncompressedFrameSize(&data, size).bad() ||
      size != count * (record.bitsAllocated / 8))
    return Give(SliceStatus::Undecodable, record);
  SlicePixels pixels;
  pixels.own.resize((size + 1) / 2);
  OFString colour;
  const bool packed = DcmXfer(data.getOriginalXfer()).isEncapsulated();
  if (!Worked(element->getUncompressedFrame(&data, record.frameNumber, fragment, pixels.own.data(),
        static_cast<Uint32>(pixels.own.size() * sizeof(Uint16)), colour)))
    return Give(packed ? SliceStatus::Undecodable : SliceStatus::CutOff, record);
  if (record.bitsAllocated == 16)
    pixels.words = pixels.own.data();
  else
    pixels.bytes = reinterpret_cast<const Uint8*>(pixels.own.data());
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
