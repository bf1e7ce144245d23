#include "DecoderRun.h"
#include "Dicom/DicomTerms.h"
#include "DicomFixture.h"

#include <cstring>
#include <random>

namespace
{

/// What is an image, what is other DICOM, what is foreign; and what of it leaves the decoder.
class DicomRecognition : public DicomFixture
{
protected:
  /// The sound series, as data sets alone: no preamble, no meta header.
  std::filesystem::path Bare(E_TransferSyntax syntax, const Edit& edit = {}) const
  {
    const auto folder = this->Faulty(edit);
    for (int k = 0; k < this->Truth().dims.z; ++k)
    {
      const OFFilename name(this->FileOf(folder, k).c_str());
      DcmFileFormat file;
      EXPECT_TRUE(file.loadFile(name).good());
      file.loadAllDataIntoMemory();
      EXPECT_TRUE(file.getDataset()->saveFile(name, syntax).good());
    }
    return folder;
  }
  hasp::SliceRecord Scan(const std::filesystem::path& file, const std::string& locale = "C") const
  {
    return RunDecoder("scan", file, this->Folder, locale).record;
  }
  hasp::SliceRecord ScanWith(const std::function<void(DcmDataset&)>& edit) const
  {
    return this->Scan(this->FileOf(this->Faulty([&](int, DcmDataset& slice) { edit(slice); }), 0));
  }
};

// ---- what must not be taken for an image ----

TEST_F(DicomRecognition, ForeignFilesAreNoDicom)
{
  const auto folder = this->Folder / "foreign";
  std::filesystem::create_directories(folder);
  std::mt19937 random(20260101);
  std::string noise(4096, '\0');
  for (int n = 0; n < 40; ++n)
  {
    for (char& byte : noise)
      byte = static_cast<char>(random());
    WriteBytes(folder / ("noise" + std::to_string(n)), noise);
  }
  WriteBytes(folder / "empty", "");
  WriteBytes(folder / "byte", "\x08");
  WriteBytes(folder / "zeros", std::string(5000, '\0'));
  WriteBytes(folder / "text.txt", std::string(3000, 'a') + "CT MR Rows Columns\n");
  WriteBytes(folder / "picture.jpg", std::string("\xFF\xD8\xFF\xE0\0\x10JFIF\0", 11) + noise);
  WriteBytes(folder / "archive.zip", "PK\x03\x04" + noise);
  WriteBytes(folder / "late.dcm", std::string(129, '\0') + "DICM" + noise); // one byte off
  this->ExpectRefused(folder, { "none of its 47 files is a DICOM image" });
}

TEST_F(DicomRecognition, BareDataThatSaysTooLittleIsForeign)
{
  const auto without = [&](const std::vector<DcmTagKey>& tags)
  {
    return this->Bare(EXS_LittleEndianImplicit,
      [&](int, DcmDataset& slice)
      {
        for (const DcmTagKey& tag : tags)
          slice.findAndDeleteElement(tag);
      });
  };
  for (const auto& tags : std::vector<std::vector<DcmTagKey>>{
         { DCM_SOPClassUID, DCM_Modality }, { DCM_Rows }, { DCM_Columns }, { DCM_PixelData } })
    this->ExpectRefused(without(tags), { "none of its 8 files is a DICOM image" });
}

TEST_F(DicomRecognition, BareDataCutOffIsNotSkipped)
{
  const auto folder = this->Bare(EXS_LittleEndianImplicit);
  std::filesystem::resize_file(this->FileOf(folder, 7), 800); // the last slice: no gap would show
  this->ExpectRefused(folder, { this->FileOf(folder, 7).filename(), "cut off" });
}

TEST_F(DicomRecognition, OtherDicomIsSkipped)
{
  const auto folder = this->Faulty({});
  DcmFileFormat directory, report;
  directory.getDataset()->putAndInsertString(DCM_SOPClassUID, UID_MediaStorageDirectoryStorage);
  directory.getDataset()->putAndInsertString(DCM_SOPInstanceUID, "1.2.826.0.1.5");
  DcmItem* item = nullptr;
  ASSERT_TRUE(
    directory.getDataset()->findOrCreateSequenceItem(DCM_DirectoryRecordSequence, item).good());
  item->putAndInsertUint16(DCM_Rows, 16); // an icon's, not the file's
  item->putAndInsertUint16(DCM_Columns, 16);
  ASSERT_TRUE(directory.saveFile((folder / "DICOMDIR").c_str(), EXS_LittleEndianExplicit).good());
  report.getDataset()->putAndInsertString(DCM_SOPClassUID, UID_BasicTextSRStorage);
  report.getDataset()->putAndInsertString(DCM_SOPInstanceUID, "1.2.826.0.1.6");
  report.getDataset()->putAndInsertString(DCM_Modality, "SR");
  ASSERT_TRUE(report.saveFile((folder / "report.dcm").c_str(), EXS_LittleEndianExplicit).good());
  EXPECT_EQ(this->Scan(folder / "DICOMDIR").status, unsigned(hasp::SliceStatus::NoImage));
  EXPECT_EQ(this->Scan(folder / "report.dcm").status, unsigned(hasp::SliceStatus::NoImage));
  EXPECT_EQ(Read(folder).passport.filesSkipped, 2);
}

// ---- what must be taken for one ----

TEST_F(DicomRecognition, BareDataIsReadExactly)
{
  const auto g = this->Truth();
  for (const E_TransferSyntax syntax :
    { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit, EXS_BigEndianExplicit })
  {
    SCOPED_TRACE(DcmXfer(syntax).getXferName());
    ExpectSame(Read(this->Bare(syntax)), g, Samples(g));
  }
  // As ACR-NEMA wrote it: no SOP class, but a modality.
  ExpectSame(Read(this->Bare(EXS_LittleEndianImplicit,
               [](int, DcmDataset& slice)
               {
                 slice.findAndDeleteElement(DCM_SOPClassUID);
                 slice.putAndInsertString(DcmTag(0x0008, 0x0010, EVR_SH), "ACR-NEMA 2.0");
               })),
    g, Samples(g));
}

// ---- what leaves the decoder ----

TEST_F(DicomRecognition, NumbersOfTheScanReachThePassport)
{
  const auto passport = Read(
    this->Faulty(
      [](int, DcmDataset& slice)
      {
        slice.putAndInsertString(DCM_SliceThickness, "1.375");
        slice.putAndInsertString(DCM_KVP, "120");
        slice.putAndInsertString(DCM_PatientPosition, "FFDR");
        slice.putAndInsertUint16(DCM_PixelPaddingValue, 24);
      })).passport;
  EXPECT_EQ(passport.thicknessMm, 1.375);
  EXPECT_EQ(passport.kvp, 120.0);
  EXPECT_EQ(passport.patientPosition, "FFDR");
  EXPECT_EQ(passport.paddingValue, -1000.0); // the fixture's intercept is -1024
}

TEST_F(DicomRecognition, NumbersForTheImporterArrive)
{
  const auto r = this->ScanWith(
    [](DcmDataset& slice)
    {
      slice.putAndInsertString(DCM_SliceThickness, "1.375");
      slice.putAndInsertString(DCM_KVP, "120");
      slice.putAndInsertString(DCM_PatientPosition, "FFDR");
      slice.putAndInsertUint16(DCM_PixelPaddingValue, 4000);
      slice.putAndInsertString(DCM_LossyImageCompression, "01");
    });
  EXPECT_EQ(r.flags & (hasp::HasThickness | hasp::HasKVP | hasp::HasPadding | hasp::Lossy),
    hasp::HasThickness | hasp::HasKVP | hasp::HasPadding | hasp::Lossy);
  EXPECT_EQ(r.thickness, 1.375);
  EXPECT_EQ(r.kvp, 120.0);
  EXPECT_EQ(r.padding, 4000);
  EXPECT_STREQ(r.patientPosition, "FFDR");
  const auto none = this->ScanWith([](DcmDataset&) {});
  EXPECT_EQ(none.flags & (hasp::HasThickness | hasp::HasKVP | hasp::HasPadding | hasp::Lossy), 0U);
  EXPECT_STREQ(none.patientPosition, "");
}

TEST_F(DicomRecognition, PaddingHasTheSignOfThePixels)
{
  const auto padding = [&](Uint16 isSigned, E_TransferSyntax syntax)
  {
    const auto folder = this->Bare(syntax,
      [&](int, DcmDataset& slice)
      {
        slice.putAndInsertUint16(DCM_PixelRepresentation, isSigned);
        if (isSigned)
          slice.putAndInsertSint16(DcmTag(DCM_PixelPaddingValue, EVR_SS), -2000);
        else
          slice.putAndInsertUint16(DcmTag(DCM_PixelPaddingValue, EVR_US), 63536);
      });
    return this->Scan(this->FileOf(folder, 0)).padding;
  };
  for (const E_TransferSyntax syntax : { EXS_LittleEndianExplicit, EXS_LittleEndianImplicit })
  {
    EXPECT_EQ(padding(1, syntax), -2000);
    EXPECT_EQ(padding(0, syntax), 63536); // the same bits
  }
}

TEST_F(DicomRecognition, TextsThatAreNotListedDoNotLeaveTheDecoder)
{
  const auto r = this->ScanWith(
    [](DcmDataset& slice)
    {
      slice.putAndInsertString(DCM_Modality, "CANARY");
      slice.putAndInsertString(DCM_PhotometricInterpretation, "CANARY");
      slice.putAndInsertString(DCM_PatientPosition, "CANARY");
      slice.putAndInsertString(DCM_BurnedInAnnotation, "CANARY");
      slice.putAndInsertString(DCM_RescaleType, "CANARY");
      slice.putAndInsertString(DCM_LossyImageCompression, "CANARY");
    });
  EXPECT_STREQ(r.modality, hasp::OtherTerm);
  EXPECT_STREQ(r.photometric, hasp::OtherTerm);
  EXPECT_STREQ(r.patientPosition, hasp::OtherTerm);
  EXPECT_EQ(r.flags & (hasp::SaysBurnedIn | hasp::SaysNotBurnedIn | hasp::RescaleIsHU), 0U);
  EXPECT_EQ(ReadBytes(this->Folder / "answer").find("ANARY"), std::string::npos);
}

TEST_F(DicomRecognition, EachListedTermArrivesAsItIs)
{
  for (const char* term : { "CT", "MR", "PT", "OT", "RTDOSE" })
    EXPECT_STREQ(
      this->ScanWith([&](DcmDataset& slice) { slice.putAndInsertString(DCM_Modality, term); })
        .modality,
      term);
  for (const char* term : hasp::PatientPositions)
    EXPECT_STREQ(
      this->ScanWith(
            [&](DcmDataset& slice) { slice.putAndInsertString(DCM_PatientPosition, term); })
        .patientPosition,
      term);
}

TEST_F(DicomRecognition, NumbersAreReadAlikeInEveryLocale)
{
  const auto file = this->FileOf(this->Faulty({}), 3);
  const auto plain = this->Scan(file);
  // Where that locale is not installed it is the same run twice; where it is, decimals are commas.
  const auto german = this->Scan(file, "de_DE.UTF-8");
  EXPECT_EQ(plain.spacing[0], 0.75);
  EXPECT_EQ(std::memcmp(&plain, &german, sizeof(plain)), 0);
}

} // namespace
