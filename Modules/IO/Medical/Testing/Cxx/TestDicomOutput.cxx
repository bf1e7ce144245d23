#include "Dicom/StoredValues.h"
#include "DicomFixture.h"
#include "vtkHaspDicomOutput.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkDICOMImageReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <dcmtk/dcmdata/dctk.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <set>

namespace
{

using hasp::DicomOutputSettings;
using hasp::GridGeometry;

class DicomOutput : public DicomFixture
{
protected:
  DicomOutput() { std::filesystem::create_directories(this->Folder); }

  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }
  template <typename T>
  hasp::DicomOutput Write(const GridGeometry& g, const std::vector<T>& samples,
    const DicomOutputSettings& settings = {}, const std::string& name = "out") const
  {
    return hasp::WriteDicomSeries(hasp::MakeImage(g, samples), this->Path(name), settings);
  }
  std::size_t Count() const
  {
    return std::distance(
      std::filesystem::directory_iterator(this->Folder), std::filesystem::directory_iterator());
  }
  /// All files of a written folder by name.
  std::map<std::string, std::string> Files(const std::string& name) const
  {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder / name))
      files[entry.path().filename().string()] = ReadBytes(entry.path());
    return files;
  }
};

/// How what was read back differs from what was written, each sample looked up by its place.
struct Change
{
  double shiftMm = 0.0, grey = 0.0;
};

template <typename T>
Change ChangeOf(
  const hasp::LoadedVolume& back, const GridGeometry& g, const std::vector<T>& samples)
{
  Change change;
  const hasp::AnyGridView view = hasp::ViewImage(back.image);
  const GridGeometry& read = hasp::GeometryOf(view);
  EXPECT_EQ(read.Size(), g.Size());
  for (int k = 0; k < read.dims.z; ++k)
    for (int j = 0; j < read.dims.y; ++j)
      for (int i = 0; i < read.dims.x; ++i)
      {
        const glm::dvec3 world = read.IndexToWorld({ i, j, k });
        const glm::ivec3 at(glm::round(g.WorldToIndex(world)));
        change.shiftMm =
          std::max(change.shiftMm, glm::distance(world, g.IndexToWorld(glm::dvec3(at))));
        const bool inside =
          glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, g.dims));
        EXPECT_TRUE(inside);
        if (!inside)
          return change;
        const double value =
          std::visit([&](const auto& samples3) { return double(samples3(i, j, k)); }, view);
        const double truth = samples[(std::size_t(at.z) * g.dims.y + at.y) * g.dims.x + at.x];
        change.grey = std::max(change.grey, std::abs(value - truth));
      }
  return change;
}

DicomOutputSettings CT()
{
  DicomOutputSettings settings;
  settings.modality = "CT";
  settings.hounsfield = true;
  return settings;
}

TEST_F(DicomOutput, LeftStaysLeftWhateverTheAxes)
{
  const GridGeometry oblique = this->Truth();
  const auto samples = Samples(oblique);
  std::vector<glm::dmat3> directions{ glm::dmat3(1), oblique.direction };
  for (int flipped = 0; flipped < 3; ++flipped) // determinant -1
  {
    directions.push_back(glm::dmat3(1));
    directions.back()[flipped] *= -1.0;
    directions.push_back(oblique.direction);
    directions.back()[flipped] *= -1.0;
  }
  directions.push_back({ { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } });  // sagittal
  directions.push_back({ { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } }); // coronal
  directions.push_back({ { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } });  // two axes swapped
  int number = 0;
  for (const glm::dmat3& direction : directions)
  {
    GridGeometry g = oblique;
    g.direction = direction;
    const std::string name = std::to_string(++number);
    this->Write(g, samples, CT(), name);
    const hasp::LoadedVolume back = Read(this->Path(name));
    const Change change = ChangeOf(back, g, samples);
    EXPECT_EQ(change.grey, 0.0) << name;
    EXPECT_LT(change.shiftMm, 1e-6) << name;
    EXPECT_TRUE(back.passport.hounsfield);
    EXPECT_TRUE(back.passport.warnings.empty());
  }
}

/// Another implementation: VTK's own reader. It turns rows and slices about, has no orientation and
/// takes the distance of rows for that of columns.
TEST_F(DicomOutput, VtkReadsTheSameSamples)
{
  const GridGeometry g{ { 9, 7, 5 }, { 1, 2, 3 }, { 0.5, 0.5, 1.25 }, glm::dmat3(1) };
  const auto samples = Samples(g);
  this->Write(g, samples, CT());
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(this->Path("out").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(
    glm::ivec3(image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2]),
    g.dims);
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(image->GetSpacing()[a], g.spacing[a], 1e-6); // it keeps float
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        ASSERT_EQ(image->GetScalarComponentAsDouble(i, g.dims.y - 1 - j, g.dims.z - 1 - k, 0),
          samples[(std::size_t(k) * g.dims.y + j) * g.dims.x + i]);
}

TEST_F(DicomOutput, IntegersOfAllTypesAreExact)
{
  const GridGeometry g{ { 16, 8, 4 }, { 0, 0, 0 }, { 1, 1, 1 }, glm::dmat3(1) };
  const auto expectExact = [&](const auto& samples, const std::string& name)
  {
    const auto written = this->Write(g, samples, {}, name);
    EXPECT_EQ(written.quantisationError, 0.0);
    const auto back = Read(this->Path(name));
    EXPECT_EQ(ChangeOf(back, g, samples).grey, 0.0) << name;
    EXPECT_FALSE(back.passport.hounsfield);
  };
  std::mt19937 random(7);
  std::vector<std::int16_t> shorts(g.Size());
  std::vector<std::uint16_t> words(g.Size());
  std::vector<std::uint8_t> bytes(g.Size());
  std::vector<float> whole(g.Size()), far(g.Size());
  for (std::size_t n = 0; n < g.Size(); ++n)
  {
    shorts[n] = static_cast<std::int16_t>(random());
    words[n] = static_cast<std::uint16_t>(random());
    bytes[n] = static_cast<std::uint8_t>(random());
    whole[n] = static_cast<float>(shorts[n]);
    far[n] = 1e6F + static_cast<float>(words[n]);
  }
  shorts[3] = -32768;
  shorts[4] = 32767;
  words[3] = 65535;
  expectExact(shorts, "int16");
  expectExact(words, "uint16");
  expectExact(bytes, "uint8");
  expectExact(whole, "whole floats");
  expectExact(far, "whole floats far from 0");
}

TEST_F(DicomOutput, FloatsAreRoundedOnlyWhereAllowedAndSayByHowMuch)
{
  const GridGeometry g{ { 16, 8, 4 }, { 0, 0, 0 }, { 1, 1, 1 }, glm::dmat3(1) };
  std::mt19937 random(11);
  std::uniform_real_distribution<float> grey(-0.31F, 1.7F);
  std::vector<float> samples(g.Size());
  std::generate(samples.begin(), samples.end(), [&] { return grey(random); });
  DicomOutputSettings settings;
  settings.modality = "MR";
  EXPECT_THROW(this->Write(g, samples, settings), std::invalid_argument);
  EXPECT_EQ(this->Count(), 0u);
  settings.allowQuantisation = true;
  const auto written = this->Write(g, samples, settings);
  // Half a level, and rounding of float at most 2^-24 of the value.
  const double most = 0.5 * (2.01 / 65535.0) + 2e-7;
  EXPECT_GT(written.quantisationError, 0.0);
  EXPECT_LE(written.quantisationError, most);
  EXPECT_EQ(ChangeOf(Read(this->Path("out")), g, samples).grey, written.quantisationError);
  samples[5] = std::nanf("");
  EXPECT_THROW(this->Write(g, samples, settings, "nan"), std::invalid_argument);
}

TEST_F(DicomOutput, DecimalStringsHaveMostOfSixteenCharacters)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissa(-10.0, 10.0);
  std::uniform_int_distribution<int> exponent(-12, 12);
  for (int n = 0; n < 20000; ++n)
  {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    const std::string text = hasp::DecimalString(value);
    ASSERT_LE(text.size(), 16u);
    // Sign, point and "e-12" leave ten digits at the least.
    ASSERT_NEAR(hasp::FromDecimalString(text), value, 5e-10 * std::abs(value)) << text;
  }
  for (const double value : { 0.0, 1.0, 0.957, -1.0 / 3.0, 1e300, -1e-300, 512.0 })
    EXPECT_NEAR(
      hasp::FromDecimalString(hasp::DecimalString(value)), value, 5e-10 * std::abs(value));
  EXPECT_EQ(hasp::DecimalString(0.957), "0.957");
}

TEST_F(DicomOutput, TheSameVolumeGivesTheSameBytesAndAnotherNone)
{
  const auto samples = Samples(this->Truth());
  this->Write(this->Truth(), samples, CT(), "a");
  this->Write(this->Truth(), samples, CT(), "b");
  EXPECT_EQ(this->Files("a"), this->Files("b"));
  auto changed = samples;
  changed[7] += 1;
  this->Write(this->Truth(), changed, CT(), "c");
  GridGeometry moved = this->Truth();
  moved.origin.x += 1e-6;
  this->Write(moved, samples, CT(), "d");
  const auto uid = [&](const std::string& name)
  {
    DcmFileFormat file;
    file.loadFile(OFFilename(this->Path(name + "/slice-00002.dcm").c_str()));
    OFString series, instance;
    file.getDataset()->findAndGetOFString(DCM_SeriesInstanceUID, series);
    file.getDataset()->findAndGetOFString(DCM_SOPInstanceUID, instance);
    EXPECT_LE(instance.size(), 64u);
    EXPECT_EQ(std::string(series.c_str()).rfind("2.25.", 0), 0u);
    return std::string(series.c_str()) + instance.c_str();
  };
  EXPECT_EQ((std::set<std::string>{ uid("a"), uid("b"), uid("c"), uid("d") }).size(), 3u);
}

/// The page lists what is written; what is written is on the page, and nothing else.
TEST_F(DicomOutput, OnlyTheAttributesOfThePrivacyPageAreWritten)
{
  std::set<std::string> listed, written;
  const std::string page = ReadBytes(HASP_PRIVACY_PAGE);
  const std::regex tag("\\(([0-9a-f]{4},[0-9a-f]{4})\\)");
  for (std::sregex_iterator at(page.begin(), page.end(), tag), end; at != end; ++at)
    listed.insert((*at)[1]);
  for (const std::string modality : { "CT", "MR", "" })
  {
    DicomOutputSettings settings;
    settings.modality = modality;
    settings.knownNotBurnedIn = true;
    settings.slicesMade = 2;
    settings.madeErrorMm = 0.75;
    this->Write(this->Truth(), Samples(this->Truth()), settings, "x" + modality);
    DcmFileFormat file;
    ASSERT_TRUE(
      file.loadFile(OFFilename(this->Path("x" + modality + "/slice-00001.dcm").c_str())).good());
    for (DcmItem* part :
      { static_cast<DcmItem*>(file.getMetaInfo()), static_cast<DcmItem*>(file.getDataset()) })
      for (DcmObject* at = nullptr; (at = part->nextInContainer(at)) != nullptr;)
      {
        char text[16];
        std::snprintf(text, sizeof text, "%04x,%04x", at->getGTag(), at->getETag());
        written.insert(text);
        EXPECT_NE(at->ident(), EVR_SQ);
      }
    OFString derivation;
    file.getDataset()->findAndGetOFString(DCM_DerivationDescription, derivation);
    EXPECT_NE(derivation.find("2 of 8 slices made"), OFString_npos) << derivation;
    EXPECT_NE(derivation.find("0.75 mm"), OFString_npos) << derivation;
  }
  EXPECT_EQ(written, listed);
}

TEST_F(DicomOutput, WhatCannotBeWrittenLeavesNothing)
{
  const auto samples = Samples(this->Truth());
  const auto image = hasp::MakeImage(this->Truth(), samples);
  this->Write(this->Truth(), samples, CT(), "taken");
  EXPECT_THROW(this->Write(this->Truth(), samples, CT(), "taken"), std::runtime_error);
  EXPECT_EQ(this->Files("taken").size(), std::size_t(this->Truth().dims.z));
  EXPECT_THROW(this->Write(this->Truth(), samples, CT(), "none/out"), std::runtime_error);
  EXPECT_THROW(hasp::WriteDicomSeries(image, "/proc/out", CT()), std::runtime_error);
  WriteBytes(this->Folder / "file", "text");
  EXPECT_THROW(this->Write(this->Truth(), samples, CT(), "file"), std::runtime_error);
  EXPECT_EQ(ReadBytes(this->Folder / "file"), "text");
  DicomOutputSettings wrong;
  wrong.hounsfield = true; // of no CT
  EXPECT_THROW(this->Write(this->Truth(), samples, wrong), std::invalid_argument);
  wrong = CT();
  wrong.kVp = std::nan("");
  EXPECT_THROW(this->Write(this->Truth(), samples, wrong), std::invalid_argument);
  GridGeometry flat = this->Truth();
  flat.dims.z = 1;
  EXPECT_THROW(this->Write(flat, Samples(flat), CT()), std::invalid_argument);
  EXPECT_EQ(this->Count(), 2u); // taken, file
}

TEST_F(DicomOutput, CancellingAtAnyStepLeavesNothing)
{
  const auto image = hasp::MakeImage(this->Truth(), Samples(this->Truth()));
  std::filesystem::create_directory(this->Folder / "out"); // an empty folder is taken
  int steps = 0;
  for (int last = 0; last < 1000; ++last)
  {
    steps = 0;
    try
    {
      hasp::WriteDicomSeries(
        image, this->Path("out"), CT(), [&](double) { return steps++ < last; });
      break;
    }
    catch (const hasp::Cancelled&)
    {
      EXPECT_EQ(this->Files("out").size(), 0u);
      EXPECT_EQ(this->Count(), 1u);
    }
  }
  EXPECT_EQ(steps, 2 * this->Truth().dims.z);
  EXPECT_EQ(this->Files("out").size(), std::size_t(this->Truth().dims.z));
}

TEST_F(DicomOutput, TheSignalHandlersBroomTakesFoldersToo)
{
  const auto image = hasp::MakeImage(this->Truth(), Samples(this->Truth()));
  EXPECT_THROW(hasp::WriteDicomSeries(image, this->Path("out"), CT(),
                 [&](double share)
                 {
                   if (share > 0.9)
                   {
                     EXPECT_EQ(this->Count(), 1u);
                     hasp::RemovePendingFiles();
                     EXPECT_EQ(this->Count(), 0u);
                   }
                   return true;
                 }),
    std::exception);
  EXPECT_EQ(this->Count(), 0u);
}

TEST_F(DicomOutput, WhatFailsInspectionIsNotPutInPlace)
{
  WriteBytes(this->Folder / "old.mha", "old");
  const auto write = [](const std::string& name) { WriteBytes(name, "new"); };
  EXPECT_THROW(hasp::WriteInspected(this->Path("old.mha"), write,
                 [](const std::string& pending)
                 {
                   EXPECT_EQ(ReadBytes(pending), "new");
                   EXPECT_TRUE(pending.ends_with(".mha")) << pending;
                   throw std::runtime_error("no");
                 }),
    std::runtime_error);
  EXPECT_EQ(ReadBytes(this->Folder / "old.mha"), "old");
  EXPECT_EQ(this->Count(), 1u);
  hasp::WriteInspected(this->Path("old.mha"), write, [](const std::string&) {});
  EXPECT_EQ(ReadBytes(this->Folder / "old.mha"), "new");
  EXPECT_EQ(this->Count(), 1u);
}

} // namespace
