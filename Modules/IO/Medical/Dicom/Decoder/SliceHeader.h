#pragma once
#include "Dicom/DicomWire.h"

class DcmDataset;
class DcmFileFormat;

namespace hasp
{

/// Fills a record from a parsed header. Its status becomes Image, NoImage or Undecodable. Numbers
/// are read as DICOM writes them, whatever the locale.
void DescribeSlice(DcmFileFormat& file, SliceRecord& record);

/// How many frames the file has whose place it tells, by functional groups (PS3.3 C.7.6.16):
/// enhanced CT and MR. 0: it has none, or not of each frame.
std::uint32_t PlacedFrames(DcmDataset& data, const SliceRecord& record);

/// Makes the file's record that of one frame, before PlacedFrames: spacing, position, orientation,
/// thickness and rescaling are the shared ones, and then the frame's own.
void DescribeFrame(DcmDataset& data, std::uint32_t frame, SliceRecord& record);

/// Whether a file that could not be parsed says that it is in a transfer syntax that is not
/// decoded, so that it may be sound; the record then has its name.
bool NamesUndecodable(DcmFileFormat& file, SliceRecord& record);

/// Whether a data set is an image by more than chance: it says what it is (a storage class that
/// exists, or a modality that does) and how large.
bool LooksLikeImage(DcmDataset& data);

} // namespace hasp
