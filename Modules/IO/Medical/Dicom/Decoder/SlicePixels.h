#pragma once
#include "Dicom/DicomWire.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctypes.h>

#include <cstdio>
#include <vector>

class DcmDataset;

namespace hasp
{

/// A slice's pixels as the data set holds them once decompressed, valid as long as it lives; or a
/// frame's own. Both pointers are empty where there are none.
struct SlicePixels
{
  std::vector<Uint16> own;
  const Uint8* bytes = nullptr;
  const Uint16* words = nullptr;
};

/// Decompresses the only frame. Sets the record's status to Undecodable or CutOff, or its
/// pixelBytes.
SlicePixels DecodePixels(DcmDataset& data, SliceRecord& record);

/// The same for one frame of several, and only that is decompressed.
SlicePixels DecodeFrame(DcmDataset& data, SliceRecord& record);

/// Writes record.pixelBytes of stored values, 16 bits each: shifted down to bit 0 and their sign
/// carried up. False if that failed. Needs no memory that grows with the slice.
bool WritePixels(const SlicePixels& pixels, const SliceRecord& record, std::FILE* out);

} // namespace hasp
