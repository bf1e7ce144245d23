#pragma once
#include "Dicom/DicomWire.h"

class DcmDataset;
class DcmFileFormat;

namespace hasp
{

/// Fills a record from a parsed header. Its status becomes Image, NoImage or Undecodable. Numbers
/// are read as DICOM writes them, whatever the locale.
void DescribeSlice(DcmFileFormat& file, SliceRecord& record);

/// Whether a file that could not be parsed says that it is in a transfer syntax that is not decoded,
/// so that it may be sound; the record then has its name.
bool NamesUndecodable(DcmFileFormat& file, SliceRecord& record);

/// Whether a data set is an image by more than chance: it says what it is (a storage class that
/// exists, or a modality that does) and how large.
bool LooksLikeImage(DcmDataset& data);

} // namespace hasp
