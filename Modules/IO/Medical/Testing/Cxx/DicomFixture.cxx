#include "DicomFixture.h"

#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcrlerp.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <dcmtk/oflog/oflog.h>

#include <cstdio>

namespace
{

std::string Decimals(std::initializer_list<double> numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    char one[32];
    std::snprintf(one, sizeof(one), "%.12g", number); // 16 characters at most for sizes met here
    if (!text.empty())
      text += '\\';
    text += one;
  }
  return text;
}

void Compress(DcmDataset& slice, E_TransferSyntax syntax)
{
  if (slice.canWriteXfer(syntax))
    return; // the edit has compressed it
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  DcmRLEEncoderRegistration::registerCodecs();
  DJEncoderRegistration::registerCodecs();
  DJLSEncoderRegistration::registerCodecs();
  ASSERT_TRUE(slice.chooseRepresentation(syntax, nullptr).good()) << DcmXfer(syntax).getXferName();
  ASSERT_TRUE(slice.canWriteXfer(syntax));
}

void Describe(DcmDataset& d, const hasp::GridGeometry& g, int k)
{
  const glm::dvec3 p = g.IndexToWorld({ 0, 0, k }), x = g.direction[0], y = g.direction[1];
  d.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
  d.putAndInsertString(DCM_SOPInstanceUID, ("1.2.826.0.1.99." + std::to_string(k + 1)).c_str());
  d.putAndInsertString(DCM_SeriesInstanceUID, "1.2.826.0.1.98");
  d.putAndInsertString(DCM_FrameOfReferenceUID, "1.2.826.0.1.97");
  d.putAndInsertString(DCM_PatientName, "Canary^Patient");
  d.putAndInsertString(DCM_Modality, "CT");
  d.putAndInsertString(DCM_InstanceNumber, std::to_string(k + 1).c_str());
  d.putAndInsertString(DCM_PixelSpacing, Decimals({ g.spacing.y, g.spacing.x }).c_str());
  d.putAndInsertString(DCM_ImagePositionPatient, Decimals({ p.x, p.y, p.z }).c_str());
  d.putAndInsertString(
    DCM_ImageOrientationPatient, Decimals({ x.x, x.y, x.z, y.x, y.y, y.z }).c_str());
  d.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
  d.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  d.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(g.dims.y));
  d.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(g.dims.x));
  d.putAndInsertUint16(DCM_BitsAllocated, 16);
  d.putAndInsertUint16(DCM_BitsStored, 12);
  d.putAndInsertUint16(DCM_HighBit, 11);
  d.putAndInsertUint16(DCM_PixelRepresentation, 0);
  d.putAndInsertString(DCM_RescaleSlope, "1");
  d.putAndInsertString(DCM_RescaleIntercept, "-1024");
  d.putAndInsertString(DCM_RescaleType, "HU");
}

} // namespace

std::filesystem::path DicomFixture::FileOf(const std::filesystem::path& folder, int k) const
{
  return folder / ("IM" + std::to_string((k * 5 + 3) % 97) + ".dcm");
}

void DicomFixture::WriteSeries(const std::filesystem::path& folder,
  const hasp::GridGeometry& geometry, const std::vector<std::int16_t>& samples, const Edit& edit,
  E_TransferSyntax syntax) const
{
  std::filesystem::create_directories(folder);
  const std::size_t inSlice = std::size_t(geometry.dims.x) * geometry.dims.y;
  for (int k = 0; k < geometry.dims.z; ++k)
  {
    DcmFileFormat file;
    DcmDataset& slice = *file.getDataset();
    Describe(slice, geometry, k);
    std::vector<Uint16> pixels(inSlice);
    for (std::size_t n = 0; n < inSlice; ++n)
    {
      const int stored = samples[k * inSlice + n] + 1024;
      ASSERT_TRUE(stored >= 0 && stored < 4096);
      pixels[n] = static_cast<Uint16>(stored);
    }
    slice.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
    if (edit)
      edit(k, slice);
    if (syntax != EXS_LittleEndianExplicit)
      Compress(slice, syntax);
    ASSERT_TRUE(file.saveFile(OFFilename(this->FileOf(folder, k).c_str()), syntax).good());
  }
}

std::filesystem::path DicomFixture::Faulty(const Edit& edit) const
{
  const auto folder = this->Folder / "series";
  this->WriteSeries(folder, this->Truth(), Samples(this->Truth()), edit);
  return folder;
}
