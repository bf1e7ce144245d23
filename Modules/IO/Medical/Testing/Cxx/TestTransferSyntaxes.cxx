#include "Dicom/DicomTerms.h"
#include "DicomFixture.h"

#include "vtkImageData.h"

#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>

#include <cmath>

namespace
{

/// Stored values of one slice for each of several pixel formats, encoded by DCMTK as it reads them.
class TransferSyntaxes : public DicomFixture
{
protected:
  struct Format
  {
    int bits;
    bool isSigned;
  };
  static constexpr int n = 32;
  static constexpr double Intercept = -1024.0;

  static hasp::GridGeometry Grid()
  {
    hasp::GridGeometry g;
    g.dims = { n, n, 2 };
    return g;
  }
  /// Smooth, with an edge, over the format's whole range; each slice its own.
  static int Stored(const Format& format, int i, int j, int k)
  {
    const double low = format.isSigned ? -std::ldexp(1.0, format.bits - 1) : 0.0;
    const double span = std::ldexp(1.0, format.bits) - 1.0;
    const double wave = 0.25 * (2.0 + std::sin(0.2 * i + k) + std::cos(0.15 * j));
    return int(std::lround(low + span * (i == 0 && j < 2 ? double(j) : i > j ? 1.0 - wave : wave)));
  }
  /// Both slices written so. `encode` compresses, where the syntax alone does not say how.
  std::filesystem::path Write(const Format& format, E_TransferSyntax syntax,
    const std::function<void(DcmDataset&)>& encode = {}) const
  {
    const auto folder = this->Folder / "syntax";
    std::filesystem::remove_all(folder);
    const auto g = Grid();
    this->WriteSeries(
      folder, g, std::vector<std::int16_t>(g.Size()),
      [&](int k, DcmDataset& slice)
      {
        slice.putAndInsertUint16(DCM_BitsAllocated, format.bits > 8 ? 16 : 8);
        slice.putAndInsertUint16(DCM_BitsStored, static_cast<Uint16>(format.bits));
        slice.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(format.bits - 1));
        slice.putAndInsertUint16(DCM_PixelRepresentation, format.isSigned);
        std::vector<Uint16> words;
        std::vector<Uint8> bytes;
        for (int at = 0; at < n * n; ++at)
        {
          const int value = Stored(format, at % n, at / n, k) & ((1 << format.bits) - 1);
          words.push_back(static_cast<Uint16>(value));
          bytes.push_back(static_cast<Uint8>(value));
        }
        if (format.bits > 8)
          slice.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size());
        else
          slice.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
        if (encode)
          encode(slice);
      },
      syntax);
    return folder;
  }
  /// The largest difference of what is read from what was stored.
  static double LargestError(const hasp::LoadedVolume& volume, const Format& format)
  {
    double largest = 0.0;
    for (int k = 0; k < 2; ++k)
      for (int at = 0; at < n * n; ++at)
        largest = std::max(
          largest, std::abs(volume.image->GetScalarComponentAsDouble(at % n, at / n, k, 0) -
                            Intercept - Stored(format, at % n, at / n, k)));
    return largest;
  }
  static bool WarnsOfLoss(const hasp::LoadedVolume& volume)
  {
    for (const std::string& warning : volume.passport.warnings)
      if (warning.find("with loss") != warning.npos)
        return true;
    return false;
  }
};

TEST_F(TransferSyntaxes, LosslessOnesAreExactForEachPixelFormat)
{
  for (const Format& format : { Format{ 8, false }, Format{ 10, false }, Format{ 12, false },
         Format{ 16, false }, Format{ 12, true }, Format{ 16, true } })
    for (const E_TransferSyntax syntax : { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit,
           EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit, EXS_RLELossless,
           EXS_JPEGProcess14, EXS_JPEGProcess14SV1, EXS_JPEGLSLossless })
    {
      SCOPED_TRACE(std::to_string(format.bits) + (format.isSigned ? " signed " : " ") +
                   DcmXfer(syntax).getXferName());
      // DCMTK's JPEG-LS encoder asserts on fewer than 16 bits with a sign; its stream knows no
      // sign.
      const auto encode = [](DcmDataset& slice)
      {
        Uint16 isSigned = 0;
        slice.findAndGetUint16(DCM_PixelRepresentation, isSigned);
        slice.putAndInsertUint16(DCM_PixelRepresentation, 0);
        DJLSEncoderRegistration::registerCodecs();
        ASSERT_TRUE(slice.chooseRepresentation(EXS_JPEGLSLossless, nullptr).good());
        slice.putAndInsertUint16(DCM_PixelRepresentation, isSigned);
      };
      const auto volume = Read(syntax == EXS_JPEGLSLossless ? this->Write(format, syntax, encode)
                                                            : this->Write(format, syntax));
      EXPECT_EQ(LargestError(volume, format), 0.0);
      EXPECT_FALSE(WarnsOfLoss(volume));
    }
}

TEST_F(TransferSyntaxes, EachPredictorOfJpegLosslessIsExact)
{
  for (int predictor = 1; predictor <= 7; ++predictor)
  {
    SCOPED_TRACE(predictor);
    const Format format{ 12, false };
    const auto folder = this->Write(format, EXS_JPEGProcess14,
      [&](DcmDataset& slice)
      {
        DJEncoderRegistration::registerCodecs();
        const DJ_RPLossless how(predictor, 0);
        ASSERT_TRUE(slice.chooseRepresentation(EXS_JPEGProcess14, &how).good());
      });
    EXPECT_EQ(LargestError(Read(folder), format), 0.0);
  }
}

TEST_F(TransferSyntaxes, NearLosslessJpegLsStaysWithinItsBoundAndWarns)
{
  for (const int bound : { 1, 3 })
    for (const Format& format : { Format{ 8, false }, Format{ 12, false } })
    {
      SCOPED_TRACE(std::to_string(format.bits) + " bits, " + std::to_string(bound));
      const auto volume = Read(this->Write(format, EXS_JPEGLSLossy,
        [&](DcmDataset& slice)
        {
          DJLSEncoderRegistration::registerCodecs();
          const DJLSRepresentationParameter how(static_cast<Uint16>(bound), OFFalse);
          ASSERT_TRUE(slice.chooseRepresentation(EXS_JPEGLSLossy, &how).good());
        }));
      EXPECT_LE(LargestError(volume, format), bound);
      EXPECT_GT(LargestError(volume, format), 0.0); // else nothing was lost, and nothing tested
      EXPECT_TRUE(WarnsOfLoss(volume));
    }
}

TEST_F(TransferSyntaxes, LossyJpegIsReadAndWarns)
{
  for (const E_TransferSyntax syntax :
    { EXS_JPEGProcess1, EXS_JPEGProcess2_4, EXS_JPEGProcess6_8, EXS_JPEGProcess10_12 })
    for (const int bits : { 8, 12 })
    {
      if (syntax == EXS_JPEGProcess1 && bits == 12)
        continue; // baseline has 8 bits
      SCOPED_TRACE(std::to_string(bits) + " bits, " + DcmXfer(syntax).getXferName());
      const Format format{ bits, false };
      const auto volume = Read(this->Write(format, syntax,
        [&](DcmDataset& slice)
        {
          DJEncoderRegistration::registerCodecs();
          const DJ_RPLossy how(100);
          ASSERT_TRUE(slice.chooseRepresentation(syntax, &how).good());
        }));
      // At quality 100 each of 64 coefficients is off by 0.5 at most and weighs up to 1/4 in a
      // pixel: 8, and 1 for rounding.
      EXPECT_LE(LargestError(volume, format), 9.0);
      EXPECT_TRUE(WarnsOfLoss(volume));
    }
}

TEST_F(TransferSyntaxes, JpegThatHoldsTheParserForeverIsEnded)
{
  // DCMTK 3.6.7 looks for the bit depth from marker to marker and never gets past a TEM (FF 01).
  const auto folder = this->Write({ 8, false }, EXS_JPEGProcess1);
  std::string bytes = ReadBytes(this->FileOf(folder, 1));
  const std::size_t tables = bytes.find("\xFF\xDB");
  ASSERT_NE(tables, bytes.npos);
  bytes[tables + 1] = '\x01';
  WriteBytes(this->FileOf(folder, 1), bytes);
  hasp::VolumeReadSettings settings;
  settings.decoderSilenceSeconds = 0.3;
  this->ExpectRefused(folder, { "hangs at", this->FileOf(folder, 1).filename() }, settings);
}

TEST_F(TransferSyntaxes, EarlierLossIsWarnedOf)
{
  const auto with = [&](const char* text)
  {
    return WarnsOfLoss(Read(this->Faulty(
      [&](int, DcmDataset& slice) { slice.putAndInsertString(DCM_LossyImageCompression, text); })));
  };
  EXPECT_TRUE(with("01"));
  EXPECT_FALSE(with("00"));
}

/// The file with another transfer syntax in its header, whatever its pixels are.
std::string Relabelled(const std::string& file, std::string uid)
{
  if (uid.size() % 2 != 0)
    uid.push_back('\0');
  const std::size_t at = file.find(std::string("\x02\x00\x10\x00UI", 6));
  const std::size_t old = static_cast<unsigned char>(file[at + 6]);
  std::string changed = file;
  changed.replace(at + 8, old, uid);
  changed[at + 6] = static_cast<char>(uid.size());
  changed[140] = static_cast<char>(changed[140] + int(uid.size()) - int(old)); // group length
  return changed;
}

TEST_F(TransferSyntaxes, WhatIsNotDecodedIsNamedWithARemedy)
{
  const auto folder = this->Faulty({});
  const std::string sound = ReadBytes(this->FileOf(folder, 1));
  int tried = 0;
  for (const hasp::TransferSyntax& syntax : hasp::TransferSyntaxes)
  {
    if (syntax.decoded)
      continue;
    SCOPED_TRACE(syntax.name);
    WriteBytes(this->FileOf(folder, 1), Relabelled(sound, syntax.uid));
    const bool jpeg2000 = std::string(syntax.name).starts_with("JPEG 2000");
    this->ExpectRefused(folder,
      { this->FileOf(folder, 1).filename(), "compressed as \"" + std::string(syntax.name) + "\"",
        jpeg2000 ? "gdcmconv" : "uncompressed" });
    ++tried;
  }
  EXPECT_GT(tried, 30);
  WriteBytes(this->FileOf(folder, 1), Relabelled(sound, "1.2.826.0.1.3680043.77"));
  this->ExpectRefused(folder, { "compressed as \"unknown\"" });
}

} // namespace
