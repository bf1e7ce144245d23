// hasp-dicom-decode: parses and decodes DICOM files for Hasp in a process of its own, so that a bad
// file can harm nothing. See DicomWire.h for what goes in and out. It limits its own memory and
// time before it opens the first file, and opens no other files than those it is told (and DCMTK's
// dictionary).
#include "Dicom/DicomWire.h"
#include "Sandbox/LimitSelf.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcxfer.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <vector>

namespace
{

using hasp::SliceRecord;
using hasp::SliceStatus;

void CopyText(DcmItem& from, const DcmTagKey& tag, char* into, std::size_t room)
{
  OFString text;
  from.findAndGetOFString(tag, text);
  std::strncpy(into, text.c_str(), room - 1);
}

/// `count` numbers of an attribute. False if it is absent or empty; NaN where one is no number.
bool Numbers(DcmItem& from, const DcmTagKey& tag, double* into, unsigned long count)
{
  OFString any;
  if (from.findAndGetOFString(tag, any).bad() || any.empty())
    return false;
  for (unsigned long n = 0; n < count; ++n)
    if (from.findAndGetFloat64(tag, into[n], n).bad())
      into[n] = std::numeric_limits<double>::quiet_NaN();
  return true;
}

std::uint32_t Unsigned(DcmItem& from, const DcmTagKey& tag, std::uint32_t otherwise)
{
  Uint16 value = 0;
  return from.findAndGetUint16(tag, value).good() ? value : otherwise;
}

bool CanDecode(E_TransferSyntax syntax)
{
  switch (syntax)
  {
    case EXS_RLELossless:
    case EXS_JPEGProcess1:
    case EXS_JPEGProcess2_4:
    case EXS_JPEGProcess14:
    case EXS_JPEGProcess14SV1:
    case EXS_JPEGLSLossless:
    case EXS_JPEGLSLossy:
      return true;
    default:
      return !DcmXfer(syntax).isEncapsulated();
  }
}

void DescribeGeometry(DcmItem& data, SliceRecord& record)
{
  if (Numbers(data, DCM_PixelSpacing, record.spacing, 2))
    record.flags |= hasp::HasSpacing;
  if (Numbers(data, DCM_ImagePositionPatient, record.position, 3))
    record.flags |= hasp::HasPosition;
  if (Numbers(data, DCM_ImageOrientationPatient, record.orientation, 6))
    record.flags |= hasp::HasOrientation;
  if (Numbers(data, DCM_GantryDetectorTilt, &record.gantryTilt, 1))
    record.flags |= hasp::HasGantryTilt;
  record.slope = 1.0;
  const bool slope = Numbers(data, DCM_RescaleSlope, &record.slope, 1);
  const bool intercept = Numbers(data, DCM_RescaleIntercept, &record.intercept, 1);
  if (slope || intercept)
    record.flags |= hasp::HasRescale;
  OFString type;
  data.findAndGetOFString(DCM_RescaleType, type);
  if (type.empty() || type == "HU")
    record.flags |= hasp::RescaleIsHU;
  Sint32 instance = 0;
  if (data.findAndGetSint32(DCM_InstanceNumber, instance).good())
  {
    record.instance = instance;
    record.flags |= hasp::HasInstance;
  }
}

void Describe(DcmDataset& data, SliceRecord& record)
{
  record.rows = Unsigned(data, DCM_Rows, 0);
  record.columns = Unsigned(data, DCM_Columns, 0);
  record.samplesPerPixel = Unsigned(data, DCM_SamplesPerPixel, 1);
  record.bitsAllocated = Unsigned(data, DCM_BitsAllocated, 0);
  record.bitsStored = Unsigned(data, DCM_BitsStored, record.bitsAllocated);
  record.highBit = Unsigned(data, DCM_HighBit, record.bitsStored - 1);
  record.isSigned = Unsigned(data, DCM_PixelRepresentation, 0);
  Sint32 frames = 0; // DCMTK clears it where the attribute is absent
  const bool told = data.findAndGetSint32(DCM_NumberOfFrames, frames).good();
  record.frames = told ? static_cast<std::uint32_t>(frames) : 1;
  OFString photometric;
  data.findAndGetOFString(DCM_PhotometricInterpretation, photometric);
  if (photometric == "MONOCHROME1")
    record.flags |= hasp::Monochrome1;
  if (photometric == "MONOCHROME2")
    record.flags |= hasp::Monochrome2;
  CopyText(data, DCM_PhotometricInterpretation, record.photometric, sizeof(record.photometric));
  OFString burnedIn;
  data.findAndGetOFString(DCM_BurnedInAnnotation, burnedIn);
  if (burnedIn == "YES" || burnedIn == "NO")
    record.flags |= burnedIn == "YES" ? hasp::SaysBurnedIn : hasp::SaysNotBurnedIn;
  DescribeGeometry(data, record);
  CopyText(data, DCM_Modality, record.modality, sizeof(record.modality));
  CopyText(data, DCM_SeriesInstanceUID, record.series, sizeof(record.series));
  CopyText(data, DCM_FrameOfReferenceUID, record.frame, sizeof(record.frame));
  const E_TransferSyntax syntax = data.getOriginalXfer();
  const DcmXfer transfer(syntax);
  if (transfer.isEncapsulated() || syntax == EXS_DeflatedLittleEndianExplicit)
    record.flags |= hasp::Packed;
  std::strncpy(record.transferSyntax, transfer.getXferName(), sizeof(record.transferSyntax) - 1);
  const bool image = record.rows > 0 && record.columns > 0;
  record.status = static_cast<std::uint32_t>(!image              ? SliceStatus::NoImage
                                             : CanDecode(syntax) ? SliceStatus::Image
                                                                 : SliceStatus::Undecodable);
}

bool BeginsLikeDicom(const std::string& path)
{
  char start[132] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(start, sizeof(start));
  return file.gcount() == sizeof(start) && std::memcmp(start + 128, "DICM", 4) == 0;
}

/// Stored values as 16 bits: shifted down to bit 0 and their sign carried up.
template <typename T>
void Unpack(const T* from, const SliceRecord& record, std::vector<std::uint16_t>& into)
{
  const unsigned shift = record.highBit + 1 - record.bitsStored;
  const std::uint32_t mask = (1U << record.bitsStored) - 1U;
  const std::uint32_t sign = record.isSigned ? 1U << (record.bitsStored - 1) : 0U;
  for (std::size_t n = 0; n < into.size(); ++n)
    into[n] = static_cast<std::uint16_t>((((from[n] >> shift) & mask) ^ sign) - sign);
}

/// Sets status, and pixelBytes where there are pixels.
void DecodePixels(DcmDataset& data, SliceRecord& record, std::vector<std::uint16_t>& pixels)
{
  const auto give = [&](SliceStatus status) { record.status = static_cast<std::uint32_t>(status); };
  if (data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad() ||
      !data.canWriteXfer(EXS_LittleEndianExplicit))
    return give(SliceStatus::Undecodable);
  const bool bits = (record.bitsAllocated == 8 || record.bitsAllocated == 16) &&
                    record.bitsStored >= 1 && record.bitsStored <= record.bitsAllocated &&
                    record.highBit + 1 >= record.bitsStored &&
                    record.highBit < record.bitsAllocated;
  if (!bits || record.samplesPerPixel != 1 || record.frames != 1)
    return give(SliceStatus::Undecodable);
  const std::size_t count = std::size_t(record.rows) * record.columns;
  const Uint8* bytes = nullptr;
  const Uint16* words = nullptr;
  unsigned long there = 0;
  if (record.bitsAllocated == 16)
    data.findAndGetUint16Array(DCM_PixelData, words, &there);
  else
    data.findAndGetUint8Array(DCM_PixelData, bytes, &there);
  if (there < count || (!words && !bytes))
    return give(SliceStatus::CutOff);
  pixels.resize(count); // only now: the values are there, so the size is no empty promise
  if (words)
    Unpack(words, record, pixels);
  else
    Unpack(bytes, record, pixels);
  record.pixelBytes = count * sizeof(std::uint16_t);
}

bool Answer(const std::string& path, std::uint32_t index, bool decode)
{
  SliceRecord record{};
  record.magic = SliceRecord::Magic;
  record.index = index;
  std::vector<std::uint16_t> pixels;
  DcmFileFormat file;
  const OFCondition loaded = decode
                               ? file.loadFile(OFFilename(path.c_str()))
                               : file.loadFileUntilTag(OFFilename(path.c_str()), EXS_Unknown,
                                   EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData);
  if (loaded.bad())
    record.status = static_cast<std::uint32_t>(!BeginsLikeDicom(path) ? SliceStatus::NotDicom
                                               : decode               ? SliceStatus::CutOff
                                                                      : SliceStatus::Damaged);
  else
  {
    Describe(*file.getDataset(), record);
    if (decode && record.status == static_cast<std::uint32_t>(SliceStatus::Image))
      DecodePixels(*file.getDataset(), record, pixels);
  }
  return std::fwrite(&record, sizeof(record), 1, stdout) == 1 &&
         std::fwrite(pixels.data(), 1, record.pixelBytes, stdout) == record.pixelBytes &&
         std::fflush(stdout) == 0;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string mode = argc == 4 ? argv[1] : "";
  if (mode != "scan" && mode != "decode")
  {
    std::fputs("usage: hasp-dicom-decode scan|decode MEMORY_BYTES SECONDS < paths, each NUL-ended\n"
               "Hasp starts this program itself to read DICOM files.\n",
      stderr);
    return 2;
  }
  if (!hasp::LimitSelf(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10)))
    return 4;
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  if (!dcmDataDict.isDictionaryLoaded())
    return 5;
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
  try
  {
    std::string path;
    for (std::uint32_t index = 0; std::getline(std::cin, path, '\0'); ++index)
      if (!Answer(path, index, mode == "decode"))
        return 6;
  }
  catch (const std::bad_alloc&)
  {
    return 3;
  }
  return 0;
}
