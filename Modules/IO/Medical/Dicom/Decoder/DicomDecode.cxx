// hasp-dicom-decode: parses and decodes DICOM files for Hasp in a process of its own, so that a bad
// file can harm nothing. See DicomWire.h for what goes in and out, Confinement.h for what it gives up
// before it opens the first file. It opens no other files than those it is told (and, before that,
// DCMTK's dictionary).
#include "Sandbox/Confinement.h"
#include "Dicom/Decoder/SliceHeader.h"
#include "Dicom/Decoder/SlicePixels.h"

#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <new>
#include <string>

namespace
{

using hasp::SliceRecord;
using hasp::SliceStatus;

bool HasPreamble(const std::string& path)
{
  char start[132] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(start, sizeof(start));
  return file.gcount() == sizeof(start) && std::memcmp(start + 128, "DICM", 4) == 0;
}

/// Parses the file, values of more than 4 KiB only when they are asked for. Gives its status where
/// there is nothing to describe, Image where there is.
SliceStatus Load(DcmFileFormat& file, const std::string& path, bool decode)
{
  const bool preamble = HasPreamble(path);
  const OFFilename name(path.c_str());
  // Without a preamble the pixels' presence is a part of the proof, so nothing is left out.
  const OFCondition loaded = decode || !preamble
                               ? file.loadFile(name)
                               : file.loadFileUntilTag(name, EXS_Unknown, EGL_noChange,
                                   DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData);
  if (loaded == EC_MemoryExhausted && preamble) // of a foreign file it means nothing
    throw std::bad_alloc();
  if (preamble)
    return loaded.good() ? SliceStatus::Image : decode ? SliceStatus::CutOff : SliceStatus::Damaged;
  DcmDataset& data = *file.getDataset();
  if (!hasp::LooksLikeImage(data))
    return SliceStatus::NotDicom;
  if (loaded.bad())
    return decode ? SliceStatus::CutOff : SliceStatus::Damaged;
  return data.tagExists(DCM_PixelData) ? SliceStatus::Image : SliceStatus::NotDicom;
}

bool Answer(const std::string& path, std::uint32_t index, bool decode, bool confined)
{
  SliceRecord record{};
  record.magic = SliceRecord::Magic;
  record.index = index;
  hasp::SlicePixels pixels;
  DcmFileFormat file;
  const SliceStatus loaded = Load(file, path, decode);
  record.status = static_cast<std::uint32_t>(loaded);
  if ((loaded == SliceStatus::Damaged || loaded == SliceStatus::CutOff) &&
      hasp::NamesUndecodable(file, record))
    record.status = static_cast<std::uint32_t>(SliceStatus::Undecodable);
  if (loaded == SliceStatus::Image)
  {
    hasp::DescribeSlice(file, record);
    if (decode && record.status == static_cast<std::uint32_t>(SliceStatus::Image))
      pixels = hasp::DecodePixels(*file.getDataset(), record);
  }
  if (confined)
    record.flags |= hasp::Confined;
  return std::fwrite(&record, sizeof(record), 1, stdout) == 1 &&
         hasp::WritePixels(pixels, record, stdout) && std::fflush(stdout) == 0;
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
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  if (!dcmDataDict.isDictionaryLoaded())
    return 5;
  dcmEnableUnknownVRConversion.set(OFTrue); // UN, as of converters that knew less, is read as meant
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
  const hasp::Confinement confinement =
    hasp::EnterSandbox(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  if (confinement == hasp::Confinement::None)
    return 4;
  try
  {
    std::string path;
    for (std::uint32_t index = 0; std::getline(std::cin, path, '\0'); ++index)
      if (!Answer(path, index, mode == "decode", confinement == hasp::Confinement::Filtered))
        return 6;
  }
  catch (const std::bad_alloc&)
  {
    return 3;
  }
  return 0;
}
