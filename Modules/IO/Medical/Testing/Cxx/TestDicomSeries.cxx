#include "DicomFixture.h"

#include "vtkImageData.h"

#include <cmath>

namespace
{

using DicomSeries = DicomFixture;

/// Only for slice k.
template <typename Change>
auto At(int k, Change change)
{
  return [=](int at, DcmDataset& slice)
  {
    if (at == k)
      change(slice);
  };
}

// ---- what must be refused, and in which words ----

TEST_F(DicomSeries, EmptyAndForeignFoldersAreRefused)
{
  std::filesystem::create_directories(this->Folder / "empty");
  this->ExpectRefused(this->Folder / "empty", { "empty" });
  WriteBytes(this->Folder / "empty" / "notes.txt", "nothing of interest");
  this->ExpectRefused(this->Folder / "empty", { "none of its 1 files" });
  this->ExpectRefused(this->Folder / "absent", { "absent", "no such file" });
}

TEST_F(DicomSeries, MissingSliceIsNamedWithItsGap)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 3));
  this->ExpectRefused(
    folder, { "1 slice is missing", "instance 3", "instance 5", "2.5 mm", "1.25 mm" });
}

TEST_F(DicomSeries, DoubledSliceIsNamed)
{
  const auto folder = this->Faulty({});
  std::filesystem::copy_file(this->FileOf(folder, 2), folder / "copy.dcm");
  this->ExpectRefused(folder, { "same place", "copy.dcm", this->FileOf(folder, 2).filename() });
}

TEST_F(DicomSeries, UnevenSliceIsNamed)
{
  const auto g = this->Truth();
  const auto folder = this->Faulty(At(4,
    [&](DcmDataset& slice)
    {
      const glm::dvec3 p = g.IndexToWorld({ 0, 0, 4.3 });
      for (int a = 0; a < 3; ++a)
        slice.putAndInsertString(DCM_ImagePositionPatient,
          (std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z)).c_str());
    }));
  this->ExpectRefused(folder, { "uneven", "1.625 mm", "instance 4", "instance 5" });
}

TEST_F(DicomSeries, TiltIsRefusedWithItsAngle)
{
  const auto g = this->Truth();
  const auto folder = this->Faulty(
    [&](int k, DcmDataset& slice)
    {
      const double shear = 0.2 / g.spacing.x * k; // 0.2 mm a slice of 1.25 mm: 9.1 degrees
      const glm::dvec3 p = g.IndexToWorld({ shear, 0, k });
      slice.putAndInsertString(DCM_ImagePositionPatient,
        (std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z)).c_str());
    });
  this->ExpectRefused(folder, { "tilted", "9.1 degrees" });
}

TEST_F(DicomSeries, UnusableGeometryIsNeverGuessed)
{
  const auto refused = [&](const Edit& edit, const std::vector<std::string>& says)
  {
    SCOPED_TRACE(says.front());
    this->ExpectRefused(this->Faulty(edit), says);
  };
  const auto put = [](const DcmTagKey& tag, const char* text)
  { return [=](DcmDataset& slice) { slice.putAndInsertString(tag, text); }; };
  const auto drop = [](const DcmTagKey& tag)
  { return [=](DcmDataset& slice) { slice.findAndDeleteElement(tag); }; };
  refused(At(2, drop(DCM_PixelSpacing)), { "no pixel spacing", "instance 3" });
  refused(At(2, put(DCM_PixelSpacing, "0\\1")), { "spacing of 0 x 1" });
  refused(At(2, put(DCM_PixelSpacing, "0.75\\0.6")), { "pixel spacing of 0.6 mm, not 0.5 mm" });
  refused(At(2, drop(DCM_ImagePositionPatient)), { "no position", "instance 3" });
  refused(At(2, put(DCM_ImagePositionPatient, "nan\\0\\0")), { "no finite number" });
  refused(At(2, put(DCM_ImagePositionPatient, "1\\2")), { "no finite number" });
  refused(At(2, drop(DCM_ImageOrientationPatient)), { "no usable orientation" });
  refused(At(2, put(DCM_ImageOrientationPatient, "1\\0\\0\\0.1\\1\\0")), { "right angles" });
  refused(At(2, put(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0")), { "turned against" });
  refused(At(2, put(DCM_FrameOfReferenceUID, "1.2.3")), { "frame of reference" });
  refused(At(2, put(DCM_RescaleSlope, "0")), { "slope must not be 0" });
  refused(At(2, put(DCM_RescaleIntercept, "inf")), { "finite" });
  refused(At(2, put(DCM_PhotometricInterpretation, "PALETTE COLOR")), { "colour" });
  refused(At(2, put(DCM_NumberOfFrames, "7")), { "7 frames" });
}

TEST_F(DicomSeries, OtherSizeIsNamed)
{
  const auto folder = this->Faulty(At(2,
    [](DcmDataset& slice)
    {
      slice.putAndInsertUint16(DCM_Rows, 12);
      slice.putAndInsertUint16(DCM_Columns, 10);
    }));
  this->ExpectRefused(folder, { "instance 3", "10 x 12 pixels, not 12 x 10" });
}

TEST_F(DicomSeries, HugeHeaderTakesNoMemory)
{
  const auto folder = this->Faulty(
    [](int, DcmDataset& slice)
    {
      slice.putAndInsertUint16(DCM_Rows, 65535);
      slice.putAndInsertUint16(DCM_Columns, 65535);
    });
  this->ExpectRefused(folder, { "declares 65535 x 65535", "cut off" });
}

TEST_F(DicomSeries, CutOffFileIsNamed)
{
  for (const double share : { 0.95, 0.3 })
  {
    const auto folder = this->Faulty({});
    const auto file = this->FileOf(folder, 6);
    std::filesystem::resize_file(
      file, static_cast<std::uintmax_t>(share * double(std::filesystem::file_size(file))));
    this->ExpectRefused(folder, { file.filename(), "cut off" });
  }
}

TEST_F(DicomSeries, SeveralSeriesAskForAChoiceAndEachCanBeChosen)
{
  const auto folder = this->Folder / "series";
  const auto a = this->Truth();
  auto b = a;
  b.dims = { 6, 5, 4 };
  this->WriteSeries(folder / "a", a, Samples(a));
  this->WriteSeries(folder / "b", b, Samples(b),
    [](int, DcmDataset& slice)
    {
      slice.putAndInsertString(DCM_SeriesInstanceUID, "1.2.826.0.1.99");
      slice.putAndInsertString(DCM_Modality, "MR");
    });
  this->ExpectRefused(
    folder, { "2 series", "1: CT, 8 images of 12 x 10", "2: MR, 4 images of 6 x 5", "SetSeries" });
  hasp::VolumeReadSettings settings;
  settings.series = 2;
  const auto volume = Read(folder, settings);
  ExpectSame(volume, b, Samples(b));
  EXPECT_FALSE(volume.passport.hounsfield);
  EXPECT_EQ(volume.passport.seriesFound, 2);
  settings.series = 1;
  ExpectSame(Read(folder, settings), a, Samples(a));
  settings.series = 3;
  this->ExpectRefused(folder, { "series 3", "holds 2" }, settings);
}

// ---- what must be read, and exactly ----

TEST_F(DicomSeries, ObliqueSeriesWithShuffledNamesIsExact)
{
  const auto g = this->Truth();
  const auto folder = this->Faulty({});
  WriteBytes(folder / "LIESMICH.txt", "a foreign file");
  const auto volume = Read(folder);
  ExpectSame(volume, g, Samples(g));
  EXPECT_EQ(volume.passport.format, "DICOM");
  EXPECT_EQ(volume.passport.modality, "CT");
  EXPECT_TRUE(volume.passport.hounsfield);
  EXPECT_EQ(volume.passport.sampleType, "int16");
  EXPECT_EQ(volume.passport.filesSkipped, 1);
  EXPECT_EQ(volume.passport.minimum, -400);
  EXPECT_EQ(volume.passport.maximum, 559);
  EXPECT_LT(volume.passport.gapDeviationMm, 1e-6);
}

TEST_F(DicomSeries, SagittalAndLeftHandedStacksKeepTheirChirality)
{
  auto sagittal = this->Truth();
  sagittal.direction = glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0);
  auto fromAbove = this->Truth(); // slices written from head to feet
  fromAbove.direction = glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1);
  for (const auto& g : { sagittal, fromAbove })
  {
    const auto folder = this->Folder / "series";
    this->WriteSeries(folder, g, Samples(g));
    const auto volume = Read(folder);
    ExpectSame(volume, g, Samples(g));
    EXPECT_NEAR(glm::determinant(volume.passport.geometry.direction), 1.0, 1e-9);
  }
}

TEST_F(DicomSeries, Monochrome1KeepsItsValuesAndWarns)
{
  const auto g = this->Truth();
  const auto volume = Read(this->Faulty([](int, DcmDataset& slice)
    { slice.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME1"); }));
  ExpectSame(volume, g, Samples(g));
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_NE(volume.passport.warnings[0].find("MONOCHROME1"), std::string::npos);
}

TEST_F(DicomSeries, RescalingIsPerSliceAndFloatWhereInt16WouldLose)
{
  // Slice 5 is stored with another slope: half steps that no integer holds.
  const auto volume =
    Read(this->Faulty(At(5, [](DcmDataset& s) { s.putAndInsertString(DCM_RescaleSlope, "0.5"); })));
  EXPECT_EQ(volume.passport.sampleType, "float32");
  const auto g = this->Truth();
  const auto samples = Samples(g);
  for (const int k : { 4, 5 })
    for (int i = 0; i < g.dims.x; ++i)
    {
      const double stored = samples[std::size_t(k) * 120 + i] + 1024;
      EXPECT_EQ(volume.image->GetScalarComponentAsDouble(i, 0, k, 0),
        (k == 5 ? 0.5 : 1.0) * stored - 1024.0);
    }
}

TEST_F(DicomSeries, SignedAndShiftedBitsAreUnpacked)
{
  // Signed 12 bits in bits 4 to 15, low bits set to noise that must not show.
  const auto g = this->Truth();
  const auto samples = Samples(g);
  const auto folder = this->Faulty(
    [&](int k, DcmDataset& slice)
    {
      std::vector<Uint16> pixels(120);
      for (int n = 0; n < 120; ++n)
        pixels[n] = static_cast<Uint16>((samples[k * 120 + n] * 16) | (n & 15));
      slice.putAndInsertUint16(DCM_HighBit, 15);
      slice.putAndInsertUint16(DCM_PixelRepresentation, 1);
      slice.putAndInsertString(DCM_RescaleIntercept, "0");
      slice.putAndInsertUint16Array(DCM_PixelData, pixels.data(), 120);
    });
  ExpectSame(Read(folder), g, samples);
}

TEST_F(DicomSeries, CTWithoutRescalingIsNotCalledHU)
{
  const auto volume = Read(this->Faulty(
    [](int, DcmDataset& slice)
    {
      slice.findAndDeleteElement(DCM_RescaleSlope);
      slice.findAndDeleteElement(DCM_RescaleIntercept);
    }));
  EXPECT_FALSE(volume.passport.hounsfield);
  EXPECT_EQ(volume.passport.minimum, -400 + 1024);
  EXPECT_EQ(volume.passport.warnings.size(), 1U);
}

TEST_F(DicomSeries, FoldersMayBeNamedInAnyLanguage)
{
  const auto g = this->Truth();
  for (const char* name :
    { "K\xC3\xA4se e\xCC\x81t\xC3\xA9", "\xD0\xA7\xD0\xB5\xD1\x80\xD0\xB5\xD0\xBF",
      "\xE9\xA0\xAD\xE8\x93\x8B 3", " two  spaces ", "a'b\"c;$(d)" })
  {
    SCOPED_TRACE(name);
    const auto folder = this->Folder / name / "s";
    this->WriteSeries(folder, g, Samples(g));
    ExpectSame(Read(this->Folder / name), g, Samples(g));
  }
}

TEST_F(DicomSeries, SampleTypeIsKnownBeforePixelsWhereHeadersDecideIt)
{
  // 12 bits less 1024 always fit 16 signed bits; 16 unsigned bits may not, though these do.
  EXPECT_EQ(hasp::OpenVolume(this->Faulty({}).string()).passport.sampleType, "int16");
  const auto folder = this->Faulty(
    [](int, DcmDataset& slice)
    {
      slice.putAndInsertUint16(DCM_BitsStored, 16);
      slice.putAndInsertUint16(DCM_HighBit, 15);
    });
  const auto opened = hasp::OpenVolume(folder.string());
  EXPECT_EQ(opened.passport.sampleType, "int16 or float32");
  EXPECT_EQ(hasp::LoadVolume(opened).passport.sampleType, "int16");
}

TEST_F(DicomSeries, FilesThatChangeBetweenHeadersAndPixelsAreNamed)
{
  const auto folder = this->Faulty({});
  const auto file = this->FileOf(folder, 5);
  const auto refused = [&](const std::string& says, const std::function<void()>& change)
  {
    this->Faulty({});
    const auto opened = hasp::OpenVolume(folder.string());
    change();
    try
    {
      hasp::LoadVolume(opened);
      ADD_FAILURE() << "was loaded: " << says;
    }
    catch (const std::runtime_error& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find(says), text.npos) << text;
      EXPECT_NE(text.find(file.filename().string()), text.npos) << text;
      EXPECT_EQ(text.find(this->Folder.string()), text.npos) << text;
    }
  };
  const auto put = [&](const DcmTagKey& tag, const char* value)
  {
    DcmFileFormat changed;
    ASSERT_TRUE(changed.loadFile(OFFilename(file.c_str())).good());
    changed.getDataset()->loadAllDataIntoMemory();
    changed.getDataset()->putAndInsertString(tag, value);
    ASSERT_TRUE(changed.saveFile(OFFilename(file.c_str()), EXS_LittleEndianExplicit).good());
  };
  refused("damaged or cut off", [&] { std::filesystem::remove(file); });
  refused("damaged or cut off", [&] { WriteBytes(file, "no image any more"); });
  refused("changed while it was read", [&] { put(DCM_RescaleSlope, "2"); });
  refused("changed while it was read", [&] { put(DCM_RescaleIntercept, "7"); });
  refused("changed while it was read", [&] { put(DCM_ImagePositionPatient, "1\\2\\3"); });
  refused("changed while it was read",
    [&]
    {
      std::filesystem::copy_file(this->FileOf(folder, 4), file, // another slice took its name
        std::filesystem::copy_options::overwrite_existing);
    });
}

TEST_F(DicomSeries, PassportHoldsNoPatientTextAndNoUID)
{
  const auto p = hasp::OpenVolume(this->Faulty({}).string()).passport;
  std::string all = p.format + p.modality + p.sampleType + p.compression;
  for (const auto& warning : p.warnings)
    all += warning;
  for (const char* canary : { "Canary", "1.2.826", "hasp-io" })
    EXPECT_EQ(all.find(canary), all.npos);
}

} // namespace
