// hasp-dicom-decode: parses and decodes DICOM files for Hasp in a process of its own, so that a bad
// file can harm nothing. See DicomWire.h for what goes in and out, Confinement.h for what it gives
// up before it opens the first file. It opens no other files than those it is told (and, before
// that, DCMTK's dictionary).
#include "Dicom/Decoder/SliceHeader.h"
#include "Dicom/Decoder/SlicePixels.h"
#include "Sandbox/Confinement.h"

#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
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

bool Write(SliceRecord record, const hasp::SlicePixels& pixels, bool confined)
{
  if (confined)
    record.flags |= hasp::Confined;
  return std::fwrite(&record, sizeof(record), 1, stdout) == 1 &&
         hasp::WritePixels(pixels, record, stdout) && std::fflush(stdout) == 0;
}

/// Answers entry after entry; keeps the latest file open, as its frames are asked for one by one.
class Answerer
{
public:
  Answerer(bool decode, bool confined) : Decode(decode), Confined(confined) {}
  /// False if the answer could not be written.
  bool Answer(const std::string& entry, std::uint32_t index)
  {
    const std::size_t colon = entry.find(':');
    const std::string path = colon == entry.npos ? entry : entry.substr(colon + 1);
    if (!this->File || path != this->Path)
      this->Open(path);
    SliceRecord record = this->Record;
    record.index = index;
    DcmDataset& data = *this->File->getDataset();
    const bool image = record.status == static_cast<std::uint32_t>(SliceStatus::Image);
    if (!this->Decode)
      return image && this->Frames > 0 ? this->AnswerFrames(record) : this->Give(record);
    record.frameNumber = static_cast<std::uint32_t>(std::strtoul(entry.c_str(), nullptr, 10));
    if (image && record.frameNumber >= std::max(1U, this->Frames)) // it had more when scanned
      record.status = static_cast<std::uint32_t>(SliceStatus::CutOff);
    if (record.status != static_cast<std::uint32_t>(SliceStatus::Image))
      return this->Give(record);
    if (this->Frames > 0)
      hasp::DescribeFrame(data, record.frameNumber, record);
    const auto pixels =
      this->Frames > 0 ? hasp::DecodeFrame(data, record) : hasp::DecodePixels(data, record);
    return Write(record, pixels, this->Confined);
  }

private:
  bool Give(const SliceRecord& record) const { return Write(record, {}, this->Confined); }
  bool AnswerFrames(const SliceRecord& whole) const
  {
    for (std::uint32_t frame = 0; frame < this->Frames; ++frame)
    {
      SliceRecord record = whole;
      hasp::DescribeFrame(*this->File->getDataset(), frame, record);
      record.moreFrames = this->Frames - 1 - frame;
      if (!this->Give(record))
        return false;
    }
    return true;
  }
  void Open(const std::string& path)
  {
    this->File = std::make_unique<DcmFileFormat>();
    this->Path = path;
    this->Record = {};
    this->Record.magic = SliceRecord::Magic;
    this->Frames = 0;
    const SliceStatus loaded = Load(*this->File, path, this->Decode);
    this->Record.status = static_cast<std::uint32_t>(loaded);
    if ((loaded == SliceStatus::Damaged || loaded == SliceStatus::CutOff) &&
        hasp::NamesUndecodable(*this->File, this->Record))
      this->Record.status = static_cast<std::uint32_t>(SliceStatus::Undecodable);
    if (loaded != SliceStatus::Image)
      return;
    hasp::DescribeSlice(*this->File, this->Record);
    this->Frames = hasp::PlacedFrames(*this->File->getDataset(), this->Record);
  }

  const bool Decode, Confined;
  std::string Path;
  std::unique_ptr<DcmFileFormat> File;
  SliceRecord Record{};     ///< of the file as a whole
  std::uint32_t Frames = 0; ///< whose place it tells
};

} // namespace

int main(int argc, char** argv)
{
  const std::string mode = argc == 4 ? argv[1] : "";
  if (mode != "scan" && mode != "decode")
  {
    std::fputs(
      "usage: hasp-dicom-decode scan|decode MEMORY_BYTES SECONDS < FRAME:PATH, each NUL-ended\n"
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
    Answerer answerer(mode == "decode", confinement == hasp::Confinement::Filtered);
    std::string entry;
    for (std::uint32_t index = 0; std::getline(std::cin, entry, '\0'); ++index)
      if (!answerer.Answer(entry, index))
        return 6;
  }
  catch (const std::bad_alloc&)
  {
    return 3;
  }
  return 0;
}
