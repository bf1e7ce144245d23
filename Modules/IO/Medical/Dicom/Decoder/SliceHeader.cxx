#include "Dicom/Decoder/SliceHeader.h"
#include "Dicom/DicomTerms.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <cstring>
#include <limits>

namespace hasp
{
namespace
{

OFString TextOf(DcmItem& from, const DcmTagKey& tag)
{
  OFString text;
  from.findAndGetOFString(tag, text);
  return text;
}

template <std::size_t Room>
void Copy(const char* text, char (&into)[Room])
{
  std::strncpy(into, text, Room - 1);
}

/// `count` numbers of an attribute. False if it is absent or empty; NaN where one is no number.
bool Numbers(DcmItem& from, const DcmTagKey& tag, double* into, unsigned long count)
{
  if (TextOf(from, tag).empty())
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

void DescribeGeometry(DcmItem& data, SliceRecord& record)
{
  const auto numbers = [&](const DcmTagKey& tag, double* into, unsigned long count, SliceFlags flag)
  {
    if (Numbers(data, tag, into, count))
      record.flags |= flag;
  };
  numbers(DCM_PixelSpacing, record.spacing, 2, HasSpacing);
  numbers(DCM_ImagePositionPatient, record.position, 3, HasPosition);
  numbers(DCM_ImageOrientationPatient, record.orientation, 6, HasOrientation);
  numbers(DCM_GantryDetectorTilt, &record.gantryTilt, 1, HasGantryTilt);
  numbers(DCM_SliceThickness, &record.thickness, 1, HasThickness);
}

void DescribeRescale(DcmItem& data, SliceRecord& record)
{
  const bool slope = Numbers(data, DCM_RescaleSlope, &record.slope, 1);
  const bool intercept = Numbers(data, DCM_RescaleIntercept, &record.intercept, 1);
  if (slope || intercept)
    record.flags |= HasRescale;
  const OFString type = TextOf(data, DCM_RescaleType);
  if (type.empty() || type == "HU")
    record.flags |= RescaleIsHU;
  else
    record.flags &= ~std::uint32_t(RescaleIsHU);
}

void DescribeValues(DcmItem& data, SliceRecord& record)
{
  record.slope = 1.0;
  DescribeRescale(data, record);
  Sint32 instance = 0;
  if (data.findAndGetSint32(DCM_InstanceNumber, instance).good())
  {
    record.instance = instance;
    record.flags |= HasInstance;
  }
  if (Numbers(data, DCM_KVP, &record.kvp, 1))
    record.flags |= HasKVP;
  // Its type follows the pixels', by what wrote the file and not always by what they say.
  Uint16 plain = 0;
  Sint16 withSign = 0;
  if (data.findAndGetUint16(DCM_PixelPaddingValue, plain).good())
    record.padding = record.isSigned ? static_cast<Sint16>(plain) : plain;
  else if (data.findAndGetSint16(DCM_PixelPaddingValue, withSign).good())
    record.padding = record.isSigned ? withSign : static_cast<Uint16>(withSign);
  else
    return;
  record.flags |= HasPadding;
}

void DescribePicture(DcmItem& data, SliceRecord& record)
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
  Copy(
    TermOf(Photometrics, TextOf(data, DCM_PhotometricInterpretation).c_str()), record.photometric);
  if (std::strcmp(record.photometric, "MONOCHROME1") == 0)
    record.flags |= Monochrome1;
  if (std::strcmp(record.photometric, "MONOCHROME2") == 0)
    record.flags |= Monochrome2;
  const OFString burnedIn = TextOf(data, DCM_BurnedInAnnotation);
  if (burnedIn == "YES" || burnedIn == "NO")
    record.flags |= burnedIn == "YES" ? SaysBurnedIn : SaysNotBurnedIn;
}

/// What the file's own header names, if it names what DCMTK does not know; else what DCMTK found.
const TransferSyntax& FindSyntax(DcmFileFormat& file)
{
  const OFString named =
    file.getMetaInfo() ? TextOf(*file.getMetaInfo(), DCM_TransferSyntaxUID) : OFString();
  const TransferSyntax& said = SyntaxOf(named.c_str());
  const TransferSyntax& found = SyntaxOf(DcmXfer(file.getDataset()->getOriginalXfer()).getXferID());
  return named.empty() || (said.decoded && found.decoded) ? found : said;
}

} // namespace

bool NamesUndecodable(DcmFileFormat& file, SliceRecord& record)
{
  const TransferSyntax& syntax = FindSyntax(file);
  Copy(syntax.name, record.transferSyntax);
  return !syntax.decoded && !TextOf(*file.getMetaInfo(), DCM_TransferSyntaxUID).empty();
}

void DescribeSlice(DcmFileFormat& file, SliceRecord& record)
{
  DcmDataset& data = *file.getDataset();
  DescribePicture(data, record);
  DescribeGeometry(data, record);
  DescribeValues(data, record);
  Copy(TermOf(Modalities, TextOf(data, DCM_Modality).c_str()), record.modality);
  Copy(TermOf(PatientPositions, TextOf(data, DCM_PatientPosition).c_str()), record.patientPosition);
  Copy(TextOf(data, DCM_SeriesInstanceUID).c_str(), record.series);
  Copy(TextOf(data, DCM_FrameOfReferenceUID).c_str(), record.frame);
  const TransferSyntax& syntax = FindSyntax(file);
  Copy(syntax.name, record.transferSyntax);
  const DcmXfer transfer(data.getOriginalXfer());
  if (transfer.isEncapsulated() || transfer.getXfer() == EXS_DeflatedLittleEndianExplicit)
    record.flags |= Packed;
  if (syntax.lossy || TextOf(data, DCM_LossyImageCompression) == "01")
    record.flags |= Lossy;
  const bool image = record.rows > 0 && record.columns > 0;
  record.status = static_cast<std::uint32_t>(!image           ? SliceStatus::NoImage
                                             : syntax.decoded ? SliceStatus::Image
                                                              : SliceStatus::Undecodable);
}

std::uint32_t PlacedFrames(DcmDataset& data, const SliceRecord& record)
{
  DcmSequenceOfItems* groups = nullptr;
  if (data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups).bad() || !groups)
    return 0;
  return groups->card() == record.frames ? record.frames : 0;
}

void DescribeFrame(DcmDataset& data, std::uint32_t frame, SliceRecord& record)
{
  record.frames = 1;
  record.frameNumber = frame;
  const auto describe = [&](const DcmTagKey& groups, long at)
  {
    DcmItem *group = nullptr, *macro = nullptr;
    if (data.findAndGetSequenceItem(groups, group, at).bad() || !group)
      return;
    for (const DcmTagKey& tag :
      { DCM_PixelMeasuresSequence, DCM_PlanePositionSequence, DCM_PlaneOrientationSequence })
      if (group->findAndGetSequenceItem(tag, macro).good() && macro)
        DescribeGeometry(*macro, record);
    if (group->findAndGetSequenceItem(DCM_PixelValueTransformationSequence, macro).good() && macro)
      DescribeRescale(*macro, record);
  };
  describe(DCM_SharedFunctionalGroupsSequence, 0);
  describe(DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(frame));
}

bool LooksLikeImage(DcmDataset& data)
{
  const OFString modality = TextOf(data, DCM_Modality);
  const bool named = (!modality.empty() && TermOf(Modalities, modality.c_str()) != OtherTerm) ||
                     dcmIsaStorageSOPClassUID(TextOf(data, DCM_SOPClassUID).c_str());
  return named && Unsigned(data, DCM_Rows, 0) > 0 && Unsigned(data, DCM_Columns, 0) > 0;
}

} // namespace hasp
