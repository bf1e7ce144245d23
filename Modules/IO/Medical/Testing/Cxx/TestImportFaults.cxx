#include "DicomFixture.h"
#include "vtkHaspFileNames.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using hasp::FaultKind;
using hasp::ImportFault;
using hasp::Passport;

class ImportFaults : public DicomFixture
{
protected:
  static Passport Inspect(
    const std::filesystem::path& path, const hasp::VolumeReadSettings& settings = {})
  {
    return hasp::InspectVolume(path.string(), settings);
  }
  static std::vector<FaultKind> Kinds(const Passport& passport)
  {
    std::vector<FaultKind> kinds;
    for (const ImportFault& fault : passport.faults)
      kinds.push_back(fault.kind);
    return kinds;
  }
  /// The fault of the series with this edit; there must be one, and opening must say its sentence.
  ImportFault Only(const Edit& edit, FaultKind kind) const
  {
    const auto folder = this->Faulty(edit);
    const Passport passport = Inspect(folder);
    EXPECT_EQ(Kinds(passport), std::vector<FaultKind>{ kind });
    if (passport.faults.empty())
      return {};
    this->ExpectRefused(folder, { passport.faults.front().text });
    std::filesystem::remove_all(folder);
    return passport.faults.front();
  }
  /// Puts slice k at this place on the index axes of the truth.
  static void Place(DcmDataset& slice, const hasp::GridGeometry& g, const glm::dvec3& index)
  {
    const glm::dvec3 p = g.IndexToWorld(index);
    slice.putAndInsertString(DCM_ImagePositionPatient,
      (std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z)).c_str());
  }
};

template <typename Change>
auto At(int k, Change change)
{
  return [=](int at, DcmDataset& slice)
  {
    if (at == k)
      change(slice);
  };
}

auto Put(const DcmTagKey& tag, const char* text)
{
  return [=](DcmDataset& slice) { slice.putAndInsertString(tag, text); };
}

auto Drop(const DcmTagKey& tag)
{
  return [=](DcmDataset& slice) { slice.findAndDeleteElement(tag); };
}

// ---- one fault at a time: kind, numbers, millimetres ----

TEST_F(ImportFaults, SoundSeriesHasNone)
{
  const Passport p = Inspect(this->Faulty({}));
  EXPECT_TRUE(p.faults.empty());
  EXPECT_EQ(p.maximum, 559);
  EXPECT_FALSE(p.resampled);
  EXPECT_EQ(p.missingSlices + p.doubledSlices + p.unevenGaps, 0);
  EXPECT_EQ(p.tiltDegrees, 0.0);
}

TEST_F(ImportFaults, MissingSlicesHaveTheirNumbers)
{
  auto g = this->Truth();
  g.dims.z = 16;
  g.dims.x = 6;
  g.dims.y = 5;
  const auto folder = this->Folder / "series";
  this->WriteSeries(folder, g, Samples(g));
  for (const int k : { 3, 4, 9 })
    std::filesystem::remove(this->FileOf(folder, k));
  const Passport p = Inspect(folder);
  ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::MissingSlices });
  const ImportFault& fault = p.faults.front();
  EXPECT_EQ(fault.slices, (std::vector<int>{ 4, 5, 10 })); // from 1
  EXPECT_EQ(fault.files.size(), 4U);
  EXPECT_NEAR(fault.millimetres, 3.75, 1e-6);
  EXPECT_TRUE(fault.resamplable);
  EXPECT_NE(fault.text.find("3 slices are missing, the most between"), std::string::npos)
    << fault.text;
  EXPECT_EQ(p.missingSlices, 3);
  // As far as it is known:
  EXPECT_EQ(p.format, "DICOM");
  EXPECT_EQ(p.geometry.dims, glm::ivec3(6, 5, 13));
  EXPECT_NEAR(p.geometry.spacing.z, 1.25, 1e-6);
}

TEST_F(ImportFaults, MissingAtTheEndsCannotBeSeen)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 0));
  std::filesystem::remove(this->FileOf(folder, 7));
  const Passport p = Inspect(folder);
  EXPECT_TRUE(p.faults.empty());
  EXPECT_EQ(p.geometry.dims.z, 6);
}

TEST_F(ImportFaults, GapsTooWideAreNotResampled)
{
  auto g = this->Truth();
  g.dims = { 4, 4, 50 };
  const auto folder = this->Folder / "series";
  this->WriteSeries(folder, g, Samples(g));
  for (int k = 20; k < 26; ++k)
    std::filesystem::remove(this->FileOf(folder, k));
  hasp::VolumeReadSettings settings;
  settings.resample = true;
  for (const bool resample : { false, true })
  {
    settings.resample = resample;
    const Passport p = Inspect(folder, settings);
    ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::MissingSlices });
    EXPECT_FALSE(p.faults[0].resamplable);
    EXPECT_NE(p.faults[0].text.find("at most 5 are made in one gap"), std::string::npos);
    EXPECT_FALSE(p.resampled);
  }
}

TEST_F(ImportFaults, DoubledSlices)
{
  const auto folder = this->Faulty({});
  std::filesystem::copy_file(this->FileOf(folder, 2), folder / "copy.dcm");
  const Passport p = Inspect(folder);
  ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::DoubledSlices });
  EXPECT_EQ(p.faults[0].slices, std::vector<int>{ 3 });
  EXPECT_EQ(p.faults[0].files.size(), 1U);
  EXPECT_TRUE(p.faults[0].resamplable);
  EXPECT_EQ(p.doubledSlices, 1);
}

TEST_F(ImportFaults, UnevenSlices)
{
  const auto g = this->Truth();
  const ImportFault fault = this->Only(At(4,
                                         [&](DcmDataset& s) {
                                           Place(s, g, { 0, 0, 4.3 });
                                         }),
    FaultKind::UnevenSpacing);
  EXPECT_EQ(fault.slices, (std::vector<int>{ 5, 6 })); // before each of them the gap is uneven
  EXPECT_NEAR(fault.millimetres, 1.625, 1e-4);         // written with six decimals
  EXPECT_TRUE(fault.resamplable);
}

TEST_F(ImportFaults, TiltAndShift)
{
  const auto g = this->Truth();
  const ImportFault tilt = this->Only(
    [&](int k, DcmDataset& s) {
      Place(s, g, { 0, 0.4 * k, k });
    },
    FaultKind::GantryTilt);
  EXPECT_NEAR(tilt.degrees, 13.4957, 1e-3); // atan(0.4 * 0.75 / 1.25)
  EXPECT_NEAR(tilt.millimetres, 0.3 * 7, 1e-4);
  EXPECT_EQ(tilt.slices, std::vector<int>{ 8 });
  EXPECT_TRUE(tilt.resamplable);
  const ImportFault shift = this->Only(At(3,
                                         [&](DcmDataset& s) {
                                           Place(s, g, { 2, 0, 3 });
                                         }),
    FaultKind::ShiftedSlices);
  EXPECT_EQ(shift.slices, std::vector<int>{ 4 });
  EXPECT_NEAR(shift.millimetres, 2 * 0.5, 1e-4);
  EXPECT_FALSE(shift.resamplable);
}

TEST_F(ImportFaults, TheShiftedSliceIsNamedWhereverItIs)
{
  const auto g = this->Truth();
  for (const bool tilted : { false, true })
    for (const int odd : { 0, 4, 7 })
    {
      SCOPED_TRACE(std::to_string(odd) + (tilted ? " tilted" : ""));
      std::filesystem::remove_all(this->Folder / "series");
      const Passport p = Inspect(this->Faulty(
        [&](int k, DcmDataset& s) {
          Place(s, g, { k == odd ? 2 : 0, tilted ? 0.4 * k : 0.0, k });
        }));
      using enum FaultKind;
      const auto expected = tilted ? std::vector<FaultKind>{ ShiftedSlices, GantryTilt }
                                   : std::vector<FaultKind>{ ShiftedSlices };
      ASSERT_EQ(Kinds(p), expected);
      EXPECT_EQ(p.faults[0].slices, std::vector<int>{ odd + 1 });
      EXPECT_NEAR(p.faults[0].millimetres, 2 * 0.5, 1e-4);
    }
}

TEST_F(ImportFaults, UnevenSliceOfATiltedTableIsUnevenAndTilted)
{
  const auto g = this->Truth();
  const Passport p = Inspect(this->Faulty(
    [&](int k, DcmDataset& s)
    {
      const double along = k == 4 ? 4.3 : k;
      Place(s, g, { 0, 0.4 * along, along });
    }));
  using enum FaultKind;
  EXPECT_EQ(Kinds(p), (std::vector<FaultKind>{ UnevenSpacing, GantryTilt }));
  EXPECT_TRUE(p.faults[0].resamplable && p.faults[1].resamplable);
}

TEST_F(ImportFaults, WhatNoResamplingMends)
{
  using enum FaultKind;
  const auto one = [&](const Edit& edit, FaultKind kind)
  {
    SCOPED_TRACE(hasp::FaultName(kind));
    const ImportFault fault = this->Only(edit, kind);
    EXPECT_FALSE(fault.resamplable);
    EXPECT_EQ(fault.files.size(), 1U);
  };
  one(At(2, Drop(DCM_PixelSpacing)), NoGeometry);
  one(At(2, Put(DCM_PixelSpacing, "0\\1")), NoGeometry);
  one(At(2, Drop(DCM_ImagePositionPatient)), NoGeometry);
  one(At(2, Put(DCM_ImagePositionPatient, "nan\\0\\0")), NoGeometry);
  one(At(2, Drop(DCM_ImageOrientationPatient)), NoGeometry);
  one(At(2, Put(DCM_PixelSpacing, "0.75\\0.6")), MixedSizes);
  one(At(2, Put(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0")), MixedOrientations);
  one(At(2, Put(DCM_FrameOfReferenceUID, "1.2.3")), MixedFrames);
  one(At(2, Put(DCM_RescaleSlope, "0")), BadRescale);
  one(At(2, Put(DCM_PhotometricInterpretation, "PALETTE COLOR")), Unsupported);
  one(At(2, Put(DCM_NumberOfFrames, "7")), Unsupported);
  one(At(0,
        [](DcmDataset& slice)
        {
          slice.putAndInsertUint16(DCM_Rows, 12);
          slice.putAndInsertUint16(DCM_Columns, 10);
        }),
    MixedSizes);
}

TEST_F(ImportFaults, OneFaultForAllSlicesWithTheSameWrong)
{
  const auto folder = this->Faulty([](int, DcmDataset& s) { Drop(DCM_PixelSpacing)(s); });
  const Passport p = Inspect(folder);
  ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::NoGeometry });
  EXPECT_EQ(p.faults[0].files.size(), 8U);
  EXPECT_NE(p.faults[0].text.find("and so 7 more"), std::string::npos) << p.faults[0].text;
}

TEST_F(ImportFaults, SeveralSeriesSingleSliceAndNothing)
{
  const auto folder = this->Folder / "two";
  const auto g = this->Truth();
  this->WriteSeries(folder / "a", g, Samples(g));
  this->WriteSeries(folder / "b", g, Samples(g),
    [](int, DcmDataset& s) { Put(DCM_SeriesInstanceUID, "1.2.826.0.1.99")(s); });
  Passport p = Inspect(folder);
  EXPECT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::MixedSeries });
  EXPECT_EQ(p.seriesFound, 2);
  auto single = g;
  single.dims.z = 1;
  this->WriteSeries(this->Folder / "one", single, Samples(single));
  EXPECT_EQ(Kinds(Inspect(this->Folder / "one")), std::vector<FaultKind>{ FaultKind::SingleSlice });
  std::filesystem::create_directories(this->Folder / "empty");
  p = Inspect(this->Folder / "empty");
  EXPECT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::Damaged });
  EXPECT_EQ(p.faults[0].text, "it is empty; give the folder that holds the slices");
  this->ExpectRefused(this->Folder / "empty", { "empty: it is empty; give" }); // once
}

TEST_F(ImportFaults, TooLargeAndCutOff)
{
  hasp::VolumeReadSettings settings;
  settings.memoryLimitBytes = 100;
  EXPECT_EQ(
    Kinds(Inspect(this->Faulty({}), settings)), std::vector<FaultKind>{ FaultKind::TooLarge });
  const auto folder = this->Faulty({});
  std::filesystem::resize_file(this->FileOf(folder, 6), 300);
  const Passport p = Inspect(folder);
  ASSERT_FALSE(p.faults.empty());
  EXPECT_EQ(p.faults[0].kind, FaultKind::Damaged);
  EXPECT_FALSE(p.faults[0].resamplable);
}

// ---- together ----

TEST_F(ImportFaults, AllFaultsAreFoundAndTheErrorCountsThem)
{
  const auto g = this->Truth();
  const auto folder = this->Faulty(
    [&](int k, DcmDataset& s)
    {
      Place(s, g, { 0, 0.4 * k, k == 6 ? 6.3 : k });
      if (k == 1)
        Put(DCM_RescaleSlope, "0")(s);
    });
  std::filesystem::remove(this->FileOf(folder, 3));
  std::filesystem::copy_file(this->FileOf(folder, 2), folder / "copy.dcm");
  const Passport p = Inspect(folder);
  using enum FaultKind;
  EXPECT_EQ(Kinds(p), (std::vector<FaultKind>{ BadRescale, DoubledSlices, MissingSlices,
                        UnevenSpacing, ShiftedSlices, GantryTilt }));
  this->ExpectRefused(
    folder, { p.faults[0].text, "5 more faults",
              "(doubled_slices, missing_slices, uneven_spacing, shifted_slices, gantry_tilt)" });
  // It was moved along the normal; a table moves along the tilted line, and is only uneven then.
  EXPECT_EQ(p.faults[4].slices, std::vector<int>{ 7 });
  EXPECT_NEAR(p.faults[4].millimetres, 0.4 * 0.75 * 0.3, 1e-4);
  EXPECT_NEAR(p.faults[5].degrees, 13.4957, 1e-2);
  // One that cannot be mended hides nothing of the others' being mendable.
  EXPECT_TRUE(p.faults[1].resamplable);
  EXPECT_FALSE(p.faults[0].resamplable);
}

TEST_F(ImportFaults, ErrorNamesTheRemedyIfItMendsAll)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 3));
  this->ExpectRefused(folder, { "--resample" });
  try
  {
    hasp::OpenVolume(folder.string());
    ADD_FAILURE() << "was opened";
  }
  catch (const hasp::ImportError& error)
  {
    EXPECT_EQ(error.passport->faults.front().kind, FaultKind::MissingSlices);
  }
}

TEST_F(ImportFaults, OtherFormatsHaveTheirSentence)
{
  WriteBytes(this->Folder / "bad.mha", "no image");
  const Passport p = Inspect(this->Folder / "bad.mha");
  ASSERT_EQ(Kinds(p), std::vector<FaultKind>{ FaultKind::Damaged });
  EXPECT_FALSE(p.faults[0].text.empty());
  EXPECT_EQ(p.faults[0].text.find("bad.mha"), std::string::npos);
  EXPECT_EQ(
    Kinds(Inspect(this->Folder / "absent.vti")), std::vector<FaultKind>{ FaultKind::Damaged });
  hasp::VolumeReadSettings settings;
  settings.series = -1;
  EXPECT_THROW(Inspect(this->Folder / "bad.mha", settings), std::invalid_argument);
}

TEST_F(ImportFaults, NoFaultSaysANameOrAPatientsText)
{
  hasp::ShowFileNames(false);
  const auto g = this->Truth();
  const auto folder = this->Faulty([&](int k, DcmDataset& s) { Place(s, g, { 0, 0.4 * k, k }); });
  std::filesystem::remove(this->FileOf(folder, 3));
  std::filesystem::copy_file(this->FileOf(folder, 2), folder / "copy.dcm");
  const Passport p = Inspect(folder);
  EXPECT_EQ(p.faults.size(), 3U);
  std::string all;
  for (const ImportFault& fault : p.faults)
    all += fault.text;
  for (const char* canary : { "Canary", "1.2.826", "hasp-io", "IM", "copy", ".dcm" })
    EXPECT_EQ(all.find(canary), all.npos) << all;
}

// ---- what else the passport says ----

TEST_F(ImportFaults, RescaleRunsFollowTheStack)
{
  const Passport p = Inspect(this->Faulty(
    [](int k, DcmDataset& s)
    {
      if (k >= 5)
        Put(DCM_RescaleSlope, "2")(s);
    }));
  ASSERT_EQ(p.rescale.size(), 2U);
  EXPECT_EQ(p.rescale[0].firstSlice, 1);
  EXPECT_EQ(p.rescale[0].lastSlice, 5);
  EXPECT_EQ(p.rescale[1].firstSlice, 6);
  EXPECT_EQ(p.rescale[1].lastSlice, 8);
  EXPECT_EQ(p.rescale[1].slope, 2.0);
  EXPECT_EQ(p.rescale[1].intercept, -1024.0);
}

TEST_F(ImportFaults, PicturesAreDescribed)
{
  Passport p = Inspect(this->Faulty({}));
  EXPECT_EQ(p.photometric, "MONOCHROME2");
  EXPECT_EQ(p.transferSyntax, "Explicit VR Little Endian");
  EXPECT_EQ(p.burnedIn, "");
  EXPECT_TRUE(p.warnings.empty()); // a CT that does not say is no news
  p = Inspect(this->Faulty(At(3, Put(DCM_BurnedInAnnotation, "YES"))));
  EXPECT_EQ(p.burnedIn, "yes");
  ASSERT_EQ(p.warnings.size(), 1U);
  EXPECT_NE(p.warnings[0].find("burned into"), std::string::npos);
  p = Inspect(this->Faulty([](int, DcmDataset& s) { Put(DCM_BurnedInAnnotation, "NO")(s); }));
  EXPECT_EQ(p.burnedIn, "no");
  EXPECT_TRUE(p.warnings.empty());
  p = Inspect(this->Faulty([](int, DcmDataset& s) { Put(DCM_Modality, "OT")(s); }));
  ASSERT_EQ(p.warnings.size(), 1U);
  EXPECT_NE(p.warnings[0].find("does not say"), std::string::npos);
}

TEST_F(ImportFaults, TiltThatOnlyTheTagKnowsIsAWarning)
{
  const Passport p =
    Inspect(this->Faulty([](int, DcmDataset& s) { Put(DCM_GantryDetectorTilt, "-12")(s); }));
  EXPECT_TRUE(p.faults.empty());
  ASSERT_TRUE(p.tiltTagDegrees);
  EXPECT_EQ(*p.tiltTagDegrees, -12.0);
  ASSERT_EQ(p.warnings.size(), 1U);
  EXPECT_NE(p.warnings[0].find("12 degrees"), std::string::npos);
}

} // namespace
