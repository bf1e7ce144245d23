#include "IOFixture.h"
#include "SegmentationText.h"

#include "vtkHaspLabelFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <cstring>
#include <stdexcept>

namespace
{

using Labels = std::vector<std::uint16_t>;

class LabelFile : public IOFixture
{
protected:
  /// 0, 1, 65535 and all between them that a sample's number hits.
  Labels AnyLabels() const
  {
    Labels labels(this->Truth().Size());
    for (std::size_t n = 0; n < labels.size(); ++n)
      labels[n] = static_cast<std::uint16_t>(n % 3 == 0 ? 0 : 65535 - 68 * n);
    labels[1] = 65535;
    return labels;
  }
  std::string Path(const char* name) const { return (this->Folder / name).string(); }

  hasp::LoadedLabels Load(
    const std::string& path, const std::optional<hasp::GridGeometry>& onto = {}) const
  {
    return hasp::LoadLabels(hasp::OpenVolume(path), onto);
  }
  void Refused(const std::string& path, const std::vector<std::string>& says,
    const std::optional<hasp::GridGeometry>& onto = {}) const
  {
    try
    {
      this->Load(path, onto);
      ADD_FAILURE() << "was taken";
    }
    catch (const std::runtime_error& error)
    {
      for (const std::string& piece : says)
        EXPECT_NE(std::string(error.what()).find(piece), std::string::npos) << error.what();
    }
  }
  static Labels SamplesOf(vtkImageData* image)
  {
    EXPECT_EQ(image->GetScalarType(), VTK_UNSIGNED_SHORT);
    const auto* first = static_cast<const std::uint16_t*>(image->GetScalarPointer());
    return { first, first + image->GetNumberOfPoints() };
  }
  /// A file of samples of an NRRD type.
  template <typename T>
  std::string WriteNrrd(const char* type, const std::vector<T>& samples,
    const std::string& more = "", const char* name = "a.nrrd") const
  {
    std::string bytes = SlicersHeader(more);
    bytes.replace(bytes.find("unsigned char"), 13, std::string(type) + "\nendian: little");
    AppendBytes(bytes, samples.data(), samples.size());
    WriteBytes(this->Path(name), bytes);
    return this->Path(name);
  }
};

TEST_F(LabelFile, WhatIsNoLabelMapIsRefused)
{
  std::vector<float> reals(24, 2.0F); // whole, and yet no labels
  this->Refused(this->WriteNrrd("float", reals), { "a.nrrd: ", "floating point", "label map" });
  this->Refused(this->WriteNrrd("double", std::vector<double>(24, 1.0)), { "floating point" });
  std::vector<std::int16_t> signedOnes(24);
  signedOnes[7] = -1;
  this->Refused(this->WriteNrrd("short", signedOnes), { "from -1 to 0", "[0, 65535]" });
  std::vector<std::int32_t> wide(24);
  wide[7] = 65536;
  this->Refused(this->WriteNrrd("int", wide), { "from 0 to 65536" });
  const auto g = this->Truth();
  for (const char* name : { "a.mha", "a.nii", "a.nii.gz", "a.vti" })
  {
    hasp::WriteVolume(hasp::MakeImage(g, std::vector<float>(g.Size(), 3.0F)), this->Path(name));
    this->Refused(this->Path(name), { name, "floating point" });
  }
}

TEST_F(LabelFile, ColoursAreRefused)
{
  std::string nrrd = SlicersHeader("", 3);
  nrrd.replace(nrrd.find("list"), 4, "RGB-color");
  WriteBytes(this->Path("a.nrrd"), nrrd + std::string(72, '\1'));
  this->Refused(this->Path("a.nrrd"), { "colours" });
  WriteBytes(this->Path("a.mha"),
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nElementNumberOfChannels = 3\n"
    "ElementSpacing = 1 1 1\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
    "ElementDataFile = LOCAL\n" +
      std::string(24, '\1'));
  this->Refused(this->Path("a.mha"), { "3 channels" });
}

TEST_F(LabelFile, ARescalingIsRefusedInsteadOfBeingApplied)
{
  const auto g = this->Truth();
  hasp::WriteVolume(hasp::MakeImage(g, this->AnyLabels()), this->Path("a.nii"));
  std::string bytes = ReadBytes(this->Path("a.nii"));
  const float slope = 2.0F;
  std::memcpy(&bytes[112], &slope, 4);
  WriteBytes(this->Path("a.nii"), bytes);
  this->Refused(this->Path("a.nii"), { "rescales its samples" });
}

TEST_F(LabelFile, LabelsPassEachFormatBitByBit)
{
  const auto g = this->Truth();
  const Labels labels = this->AnyLabels();
  const auto image = hasp::MakeImage(g, labels);
  for (const char* name : { "a.nrrd", "a.mha", "a.nii", "a.nii.gz", "a.vti", "a.seg.nrrd" })
    for (const bool compress : { false, true })
    {
      hasp::WriteLabels(image, {}, this->Path(name), { compress });
      const auto read = this->Load(this->Path(name));
      EXPECT_EQ(read.passport.sampleType, "uint16") << name;
      const Labels back = SamplesOf(this->Load(this->Path(name), g).image); // .nii turns axes
      EXPECT_EQ(back, labels) << name;
      EXPECT_EQ(read.table.empty(), std::string(name) != "a.seg.nrrd") << name;
    }
  EXPECT_THROW(hasp::WriteLabels(hasp::MakeImage(g, Samples(g)), {}, this->Path("b.nrrd")),
    std::invalid_argument);
}

TEST_F(LabelFile, NarrowAndWideIntegersBecomeLabels)
{
  std::vector<std::int64_t> wide(24);
  wide[5] = 65535;
  EXPECT_EQ(SamplesOf(this->Load(this->WriteNrrd("int64", wide)).image)[5], 65535);
  std::vector<std::int8_t> narrow(24);
  narrow[5] = 127;
  EXPECT_EQ(SamplesOf(this->Load(this->WriteNrrd("int8", narrow)).image)[5], 127);
  std::vector<std::uint8_t> bytes(24);
  bytes[23] = 255;
  EXPECT_EQ(SamplesOf(this->Load(this->WriteNrrd("uint8", bytes)).image)[23], 255);
}

TEST_F(LabelFile, NamesAndColoursComeBackAndTheUnnamedGetSome)
{
  const auto g = this->Truth();
  std::vector<std::uint8_t> labels(g.Size());
  labels[3] = 7;
  labels[4] = 1;
  labels[5] = 9;
  hasp::LabelTable table;
  for (int n = 0; n < 256; ++n) // each value that a colour's byte can have
    table.push_back({ static_cast<std::uint16_t>(1000 + n), "n", {}, n % 2 == 0 }),
      table.back().colour = { static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(255 - n), 7 };
  const Labels wide(labels.begin(), labels.end());
  table.push_back({ 9, "teeth: \"upper\"\nleft", { 1, 2, 3 }, false });
  hasp::WriteLabels(hasp::MakeImage(g, wide), table, this->Path("a.seg.nrrd"));
  const auto read = this->Load(this->Path("a.seg.nrrd"));
  EXPECT_EQ(read.table, hasp::WithUnnamedLabels(table, { 1, 7 }));
  EXPECT_EQ(SamplesOf(read.image), wide);
  hasp::WriteLabels(hasp::MakeImage(g, labels), {}, this->Path("b.seg.nrrd"));
  EXPECT_EQ(this->Load(this->Path("b.seg.nrrd")).table, hasp::WithUnnamedLabels({}, { 1, 7, 9 }));
}

TEST_F(LabelFile, WhatSlicerCroppedIsPutBackOnTheScan)
{
  // The scan has 2 samples more before and 3 behind the file's along each axis.
  hasp::GridGeometry scan;
  scan.dims = { 9, 8, 7 };
  scan.spacing = { 0.5, 0.75, 2.0 };
  scan.origin = glm::dvec3(-3, 4, 5.5) - 2.0 * scan.spacing;
  std::string samples(24, '\0');
  samples[5] = 1;  // (1, 1, 0)
  samples[23] = 2; // (3, 2, 1)
  WriteBytes(this->Path("a.seg.nrrd"),
    SlicersHeader(SlicersSegment(0, "bone", 1, 0) + SlicersSegment(1, "teeth", 2, 0) +
                  "Segmentation_ReferenceImageExtentOffset:=2 2 2\n") +
      samples);
  const auto read = this->Load(this->Path("a.seg.nrrd"), scan);
  const hasp::GridGeometry g = hasp::ImageGeometry(read.image);
  EXPECT_EQ(g.dims, scan.dims);
  EXPECT_EQ(g.origin, scan.origin);
  Labels truth(scan.Size());
  const hasp::GridView<std::uint16_t> view{ truth.data(), scan };
  view(3, 3, 2) = 1;
  view(5, 4, 3) = 2;
  EXPECT_EQ(SamplesOf(read.image), truth);
  EXPECT_EQ(read.passport.geometry.dims, glm::ivec3(4, 3, 2)) << "the file's own";

  hasp::GridGeometry other = scan;
  other.spacing.x = 0.6;
  this->Refused(this->Path("a.seg.nrrd"), { "a.seg.nrrd: ", "another grid", "spacing" }, other);
  other = scan;
  other.origin.z += 1.0;
  this->Refused(this->Path("a.seg.nrrd"), { "another grid", "1 mm beside" }, other);
  other = scan;
  other.dims = { 5, 5, 5 };
  this->Refused(this->Path("a.seg.nrrd"), { "1 samples with labels lie outside" }, other);
}

TEST_F(LabelFile, FilesOfOldSlicerBecomeOneLabelMapWithATable)
{
  std::string samples(48, '\0');
  samples[0] = samples[3] = 1;
  WriteBytes(this->Path("a.seg.nrrd"),
    SlicersHeader("Segment0_ID:=a\nSegment0_Name:=J\xE4ger\nSegment0_DefaultColor:=0 1 0.5\n"
                  "Segment1_ID:=b\nSegment1_Tags:=TerminologyEntry:x~SCT^1^y~SCT^272673000^Bone|\n",
      2) +
      samples);
  const auto read = this->Load(this->Path("a.seg.nrrd"));
  const hasp::LabelTable table{ { 1, "J\xEF\xBF\xBDger", { 0, 255, 128 }, false },
    { 2, "", { 128, 128, 128 }, true } };
  EXPECT_EQ(read.table, table);
  EXPECT_EQ(SamplesOf(read.image)[0], 1);
  EXPECT_EQ(SamplesOf(read.image)[1], 2);
}

TEST_F(LabelFile, BothGridsAreHeldToTheMemoryLimit)
{
  const auto file = this->WriteNrrd("uint8", std::vector<std::uint8_t>(24));
  hasp::VolumeReadSettings settings;
  settings.memoryLimitBytes = 47; // 24 bytes stored, 48 as labels
  EXPECT_THROW(hasp::LoadLabels(hasp::OpenVolume(file, settings)), std::runtime_error);
  settings.memoryLimitBytes = 48;
  const auto opened = hasp::OpenVolume(file, settings);
  EXPECT_NO_THROW(hasp::LoadLabels(opened));
  hasp::GridGeometry huge = opened.passport.geometry;
  huge.dims = glm::ivec3(100000);
  EXPECT_THROW(hasp::LoadLabels(opened, huge), std::runtime_error);
}

} // namespace
