#include "DicomFixture.h"
#include "vtkHaspVolumeReader.h"
#include "vtkHaspVolumeView.h"

#include "Grid/Phantom.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

class ResampledSeries : public DicomFixture
{
protected:
  static hasp::VolumeReadSettings Resampling()
  {
    hasp::VolumeReadSettings settings;
    settings.resample = true;
    return settings;
  }
  static void Place(DcmDataset& slice, const glm::dvec3& p)
  {
    slice.putAndInsertString(DCM_ImagePositionPatient,
      (std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z)).c_str());
  }
};

TEST_F(ResampledSeries, SoundSeriesStaysByteForByte)
{
  const auto folder = this->Faulty({});
  const auto plain = Read(folder), asked = Read(folder, Resampling());
  EXPECT_FALSE(asked.passport.resampled);
  EXPECT_TRUE(asked.passport.warnings.empty());
  const auto *a = static_cast<const std::int16_t*>(plain.image->GetScalarPointer()),
             *b = static_cast<const std::int16_t*>(asked.image->GetScalarPointer());
  EXPECT_TRUE(std::equal(a, a + this->Truth().Size(), b));
  const auto g = hasp::ImageGeometry(plain.image), h = hasp::ImageGeometry(asked.image);
  EXPECT_EQ(g.dims, h.dims);
  EXPECT_EQ(g.origin, h.origin);
  EXPECT_EQ(g.spacing, h.spacing);
  EXPECT_EQ(g.direction, h.direction);
}

TEST_F(ResampledSeries, MissingSliceIsMadeAndTheOthersAreExact)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 4));
  const auto volume = Read(folder, Resampling());
  const auto g = this->Truth();
  ASSERT_EQ(hasp::ImageGeometry(volume.image).dims, g.dims);
  EXPECT_EQ(volume.passport.sampleType, "int16");
  // The fixture counts its samples up, so the mean of slices 3 and 5 is what slice 4 was.
  ExpectSame(volume, g, Samples(g));
  ASSERT_TRUE(volume.passport.resampled);
  EXPECT_TRUE(volume.passport.faults.empty());
  EXPECT_EQ(volume.passport.missingSlices, 1);
  EXPECT_EQ(volume.passport.resampled->slicesMade, 1);
  EXPECT_NEAR(volume.passport.resampled->farthestMm, 1.25, 1e-6);
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_NE(volume.passport.warnings[0].find("1 of 8 slices were made"), std::string::npos)
    << volume.passport.warnings[0];
}

TEST_F(ResampledSeries, CopiesAreLeftOutOnlyIfTheyAreTheSame)
{
  const auto folder = this->Faulty({});
  std::filesystem::copy_file(this->FileOf(folder, 2), folder / "copy.dcm");
  std::filesystem::copy_file(this->FileOf(folder, 7), folder / "another.dcm");
  const auto volume = Read(folder, Resampling());
  ExpectSame(volume, this->Truth(), Samples(this->Truth()));
  EXPECT_EQ(volume.passport.doubledSlices, 2);
  EXPECT_EQ(volume.passport.resampled->slicesMade, 0);
  EXPECT_TRUE(volume.passport.resampled->errorKnown);
  EXPECT_EQ(volume.passport.resampled->error95, 0.0);
  DcmFileFormat other;
  ASSERT_TRUE(other.loadFile(OFFilename((folder / "copy.dcm").c_str())).good());
  const Uint16* pixels = nullptr;
  ASSERT_TRUE(other.getDataset()->findAndGetUint16Array(DCM_PixelData, pixels).good());
  std::vector<Uint16> changed(pixels, pixels + 120);
  changed[77] ^= 1; // one bit of one pixel is another picture
  other.getDataset()->putAndInsertUint16Array(DCM_PixelData, changed.data(), 120);
  ASSERT_TRUE(
    other.saveFile(OFFilename((folder / "copy.dcm").c_str()), EXS_LittleEndianExplicit).good());
  this->ExpectRefused(folder, { "different pictures", "copy.dcm" }, Resampling());
  const auto passport = hasp::InspectVolume(folder.string(), Resampling());
  ASSERT_EQ(passport.faults.size(), 1U);
  EXPECT_EQ(passport.faults[0].kind, hasp::FaultKind::DoubledSlices);
  EXPECT_FALSE(passport.faults[0].resamplable);
}

TEST_F(ResampledSeries, RescaledToFractionsStaysFloat)
{
  const auto folder =
    this->Faulty([](int, DcmDataset& s) { s.putAndInsertString(DCM_RescaleSlope, "0.5"); });
  std::filesystem::remove(this->FileOf(folder, 4));
  const auto volume = Read(folder, Resampling());
  EXPECT_EQ(volume.passport.sampleType, "float32");
  const auto g = this->Truth();
  const auto samples = Samples(g);
  for (int k = 0; k < 8; ++k)
    for (int i = 0; i < 12; ++i)
      ASSERT_EQ(volume.image->GetScalarComponentAsDouble(i, 3, k, 0),
        0.5 * (samples[std::size_t(k) * 120 + 36 + i] + 1024) - 1024.0);
}

TEST_F(ResampledSeries, MemoryForBothVolumesIsCheckedFirst)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 4));
  auto settings = Resampling();
  settings.memoryLimitBytes = 12 * 10 * (7 + 8) * 2 - 1;
  this->ExpectRefused(folder, { "memory limit" }, settings);
  settings.memoryLimitBytes += 1;
  Read(folder, settings);
}

TEST_F(ResampledSeries, FaultsThatAreNotMendedStayRefused)
{
  const auto folder = this->Faulty(
    [](int k, DcmDataset& s)
    {
      if (k == 1)
        s.putAndInsertString(DCM_FrameOfReferenceUID, "1.2.3");
    });
  std::filesystem::remove(this->FileOf(folder, 4));
  this->ExpectRefused(folder, { "frame of reference" }, Resampling());
}

/// The head's phantom as slices whose pictures are taken where a tilted gantry takes them: the bone
/// is where it is, in any grid.
TEST_F(ResampledSeries, BoneOfATiltedGappySagittalSeriesIsWhereItIs)
{
  hasp::PhantomSettings settings;
  settings.edgeMm = 2.0;
  const auto bone = hasp::PhantomBone(settings);
  for (const double degrees : { 8.0, -20.0 })
  {
    hasp::GridGeometry g; // rows to posterior, columns to the feet: normal to the right
    g.dims = { 64, 72, 26 };
    g.spacing = { 1.25, 1.25, 2.0 };
    g.direction = glm::dmat3(0, 1, 0, 0, 0, -1, -1, 0, 0);
    g.origin = glm::dvec3(-20, -100, 60);
    const glm::dvec3 lean = std::tan(glm::radians(degrees)) * g.direction[1];
    const auto placeOf = [&](int k) {
      return g.IndexToWorld({ 0, 0, k }) + lean * (k * g.spacing.z);
    };
    std::vector<std::int16_t> samples;
    for (int k = 0; k < g.dims.z; ++k)
    {
      auto slice = g;
      slice.dims.z = 1;
      slice.origin = placeOf(k);
      const auto part = hasp::SamplePhantom(slice, settings);
      samples.insert(samples.end(), part.begin(), part.end());
    }
    const auto folder = this->Folder / "tilted";
    std::filesystem::remove_all(folder);
    this->WriteSeries(folder, g, samples, [&](int k, DcmDataset& s) { Place(s, placeOf(k)); });
    std::filesystem::remove(this->FileOf(folder, 12));
    const auto volume = Read(folder, Resampling());
    const auto& record = *volume.passport.resampled;
    EXPECT_NEAR(record.tiltDegrees, std::abs(degrees), 1e-3);
    EXPECT_EQ(record.slicesMade, 1);
    EXPECT_EQ(volume.passport.minimum, -1000); // the outside is air, and nothing is below
    EXPECT_TRUE(volume.passport.hounsfield);
    const auto h = hasp::ImageGeometry(volume.image);
    EXPECT_EQ(h.dims.z, 26);
    EXPECT_NEAR(glm::determinant(h.direction), 1.0, 1e-9);
    // Each sample against the phantom sampled at its own place; where the scan never was is air.
    const auto truth = hasp::SamplePhantom(h, settings);
    std::size_t compared = 0, off = 0;
    double most = 0.0;
    const auto* is = static_cast<const std::int16_t*>(volume.image->GetScalarPointer());
    for (int k = 0; k < h.dims.z; ++k)
      for (int j = 0; j < h.dims.y; ++j)
        for (int i = 0; i < h.dims.x; ++i)
        {
          const std::size_t n = (std::size_t(k) * h.dims.y + j) * h.dims.x + i;
          const glm::dvec3 from = h.IndexToWorld({ i, j, k }) - placeOf(k);
          const double row = glm::dot(from, g.direction[1]) / g.spacing.y;
          if (row < 0.0 || row > g.dims.y - 1)
          {
            ASSERT_EQ(is[n], -1000);
            continue;
          }
          ++compared;
          // Half of the step to bone is 480 HU over 2 mm: 300 HU are 1.25 mm of the surface.
          if (const double d = std::abs(is[n] - truth[n]); d > 300.0 && k != 12)
            ++off;
          else if (k != 12)
            most = std::max(most, d);
        }
    EXPECT_GT(compared, 100000U);
    EXPECT_LT(double(off), 1e-4 * double(compared)) << most;
    // The skull's side is nearly parallel to the slices, so the bridge of 4 mm costs much: all of
    // itself where the surface is not found between its ends, and never more. The tilt adds
    // t (1 - t) <= 1/4 of what a sample is off the mean of its neighbours, over their gradient: of
    // an edge, where the sample lies between its neighbours, a quarter of a pixel at most. How near
    // the record is to the truth: TestResampleStack.
    EXPECT_TRUE(record.errorKnown);
    EXPECT_GT(record.error95, 0.0);
    EXPECT_LE(record.error95, 4.0 + 0.25 * 1.25);
  }
}

TEST_F(ResampledSeries, ReversedFilesGiveTheSameVolume)
{
  const auto g = this->Truth();
  const auto place = [&](int k) { return g.IndexToWorld({ 0, 0.4 * k, k }); };
  const auto forward = this->Folder / "forward", back = this->Folder / "back";
  auto samples = Samples(g);
  this->WriteSeries(forward, g, samples, [&](int k, DcmDataset& s) { Place(s, place(k)); });
  std::vector<std::int16_t> reversed;
  for (int k = 7; k >= 0; --k)
    reversed.insert(reversed.end(), samples.begin() + k * 120, samples.begin() + (k + 1) * 120);
  this->WriteSeries(back, g, reversed, [&](int k, DcmDataset& s) { Place(s, place(7 - k)); });
  const auto a = Read(forward, Resampling()), b = Read(back, Resampling());
  const auto ga = hasp::ImageGeometry(a.image);
  ASSERT_EQ(ga.dims, hasp::ImageGeometry(b.image).dims);
  EXPECT_LT(glm::distance(ga.origin, hasp::ImageGeometry(b.image).origin), 1e-9);
  const auto* pa = static_cast<const std::int16_t*>(a.image->GetScalarPointer());
  EXPECT_TRUE(
    std::equal(pa, pa + ga.Size(), static_cast<const std::int16_t*>(b.image->GetScalarPointer())));
}

TEST_F(ResampledSeries, ReaderResamplesWhenAsked)
{
  const auto folder = this->Faulty({});
  std::filesystem::remove(this->FileOf(folder, 4));
  vtkNew<vtkHaspVolumeReader> reader;
  EXPECT_FALSE(reader->GetResample());
  reader->SetFileName(folder.c_str());
  reader->ResampleOn();
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0U);
  ASSERT_TRUE(reader->GetPassport().resampled);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 8);
}

// ---- HU or not, as data of a whole series ----

TEST_F(ResampledSeries, SamplesDenyHounsfieldThatHeadersClaim)
{
  hasp::PhantomSettings settings;
  auto g = hasp::PhantomGrid({ 6, 6, 8 }, settings);
  const auto samples = hasp::SamplePhantom(g, settings);
  this->WriteSeries(this->Folder / "ct", g, samples);
  const auto ct = Read(this->Folder / "ct");
  EXPECT_TRUE(ct.passport.hounsfield);
  ASSERT_TRUE(ct.passport.airLevel);
  EXPECT_NEAR(*ct.passport.airLevel, -1000.0, 10.0);
  // As a cone beam scanner writes it: CT, rescaled, "HU"; air elsewhere.
  this->WriteSeries(this->Folder / "cbct", g, samples,
    [](int, DcmDataset& s) { s.putAndInsertString(DCM_RescaleSlope, "0.6"); });
  const auto cbct = Read(this->Folder / "cbct");
  EXPECT_FALSE(cbct.passport.hounsfield);
  ASSERT_EQ(cbct.passport.warnings.size(), 1U);
  EXPECT_NE(cbct.passport.warnings[0].find("not at 40"), std::string::npos)
    << cbct.passport.warnings[0];
  // MR never claims it.
  this->WriteSeries(this->Folder / "mr", g, samples,
    [](int, DcmDataset& s) { s.putAndInsertString(DCM_Modality, "MR"); });
  const auto mr = Read(this->Folder / "mr");
  EXPECT_FALSE(mr.passport.hounsfield);
  EXPECT_FALSE(mr.passport.airLevel);
  EXPECT_TRUE(mr.passport.warnings.empty());
}

} // namespace
