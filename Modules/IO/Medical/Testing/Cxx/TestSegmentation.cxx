#include "IOFixture.h"
#include "SegmentationText.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <sys/resource.h>

#include <stdexcept>

namespace
{

class Segmentation : public IOFixture
{
protected:
  std::filesystem::path Write(const std::string& bytes) const
  {
    WriteBytes(this->Folder / "a.seg.nrrd", bytes);
    return this->Folder / "a.seg.nrrd";
  }
  static std::vector<std::uint8_t> Labels(vtkImageData* image)
  {
    const auto* first = static_cast<const std::uint8_t*>(image->GetScalarPointer());
    return { first, first + image->GetNumberOfPoints() };
  }
  static std::string Repeat(const std::string& text, int times)
  {
    std::string all;
    while (times-- > 0)
      all += text;
    return all;
  }
};

TEST_F(Segmentation, WhatIsNoSoundSegmentationIsRefused)
{
  const std::string one = SlicersSegment(0, "bone", 1, 0), samples(24, '\1');
  const auto refused = [&](const std::string& bytes, const char* says) {
    this->ExpectRefused(this->Write(bytes), { "a.seg.nrrd: ", says });
  };
  refused(SlicersHeader("") + samples, "no segments");
  refused(SlicersHeader(one + SlicersSegment(1, "skin", 1, 0)) + samples, "one label value");
  refused(SlicersHeader(SlicersSegment(0, "bone", 0, 0)) + samples, "[1, 65535]");
  refused(SlicersHeader(SlicersSegment(0, "bone", 65536, 0)) + samples, "[1, 65535]");
  refused(SlicersHeader(SlicersSegment(0, "bone", 1, 3), 2) + samples + samples, "layer 4 of 2");
  refused(SlicersHeader(one) + samples + "x", "more than the header");
  refused(SlicersHeader(one, 2) + samples, "cut off");
  std::string text = SlicersHeader(one);
  text.replace(text.find("unsigned char"), 13, "float\nendian: little");
  refused(text + Repeat(samples, 4), "labels must be");
  refused(SlicersHeader(one, 2) + std::string(48, '\7'), "label value 7");
  // Two layers that overlap in the one sample of both.
  const std::string two = one + SlicersSegment(1, "skin", 1, 1);
  refused(SlicersHeader(two, 2) + std::string(46, '\0') + "\1\1", "overlap in 1 samples");
  hasp::VolumeReadSettings settings;
  settings.layer = 3;
  this->ExpectRefused(
    this->Write(SlicersHeader(two, 2) + std::string(48, '\0')), { "layer 3" }, settings);
  settings.layer = -1;
  EXPECT_THROW(hasp::OpenVolume("a.seg.nrrd", settings), std::invalid_argument);
  settings.layer = 1;
  hasp::WriteVolume(hasp::MakeImage(this->Truth(), Samples(this->Truth())), this->Folder / "a.mha");
  this->ExpectRefused(this->Folder / "a.mha", { "only a segmentation" }, settings);
}

TEST_F(Segmentation, SlicersLabelMapIsReadWithItsSegments)
{
  std::string samples(24, '\0');
  samples[5] = 7;
  samples[23] = 2;
  const auto volume =
    Read(this->Write(SlicersHeader(SlicersSegment(0, "upper jaw \\n \\\\ \xC3\xA9", 7, 0) +
                                   SlicersSegment(12, "teeth", 2, 0)) +
                     samples));
  EXPECT_EQ(volume.passport.format, "NRRD segmentation");
  EXPECT_EQ(volume.passport.segments, 2);
  EXPECT_EQ(volume.passport.geometry.origin, glm::dvec3(-3, 4, 5.5));
  ASSERT_EQ(volume.segments.size(), 2U);
  EXPECT_EQ(volume.segments[0].labelValue, 7);
  EXPECT_EQ(volume.segments[0].name, "upper jaw \n \\ \xC3\xA9");
  EXPECT_EQ(volume.segments[0].color, (std::array<double, 3>{ 0.25, 0.5, 1.0 }));
  EXPECT_EQ(volume.segments[1].name, "teeth");
  EXPECT_EQ(Labels(volume.image), std::vector<std::uint8_t>(samples.begin(), samples.end()));
  for (const std::string& warning : volume.passport.warnings)
    EXPECT_EQ(warning.find("jaw"), std::string::npos) << "names stay out of the passport";
}

TEST_F(Segmentation, LabelsThatNoSegmentNamesAreCounted)
{
  std::string samples(24, '\0');
  samples[3] = 1;
  samples[5] = samples[9] = 7;
  const auto volume = Read(this->Write(SlicersHeader(SlicersSegment(0, "bone", 1, 0)) + samples));
  EXPECT_EQ(Labels(volume.image), std::vector<std::uint8_t>(samples.begin(), samples.end()));
  ASSERT_EQ(volume.passport.warnings.size(), 1U);
  EXPECT_EQ(volume.passport.warnings[0].find("2 samples hold label values"), 0U);
}

TEST_F(Segmentation, LabelsOfInt16CanBeWrittenAgain)
{
  std::string header = SlicersHeader(SlicersSegment(0, "bone", 300, 0));
  header.replace(header.find("unsigned char"), 13, "short\nendian: big");
  std::string samples(48, '\0');
  samples[10] = 1; // 256 + 44
  samples[11] = 44;
  const auto volume = Read(this->Write(header + samples));
  EXPECT_EQ(volume.passport.sampleType, "uint16");
  EXPECT_EQ(volume.image->GetScalarComponentAsDouble(1, 1, 0, 0), 300.0);
  const auto file = this->Folder / "b.seg.nrrd";
  hasp::WriteSegmentation(volume.image, volume.segments, file);
  EXPECT_EQ(Read(file).image->GetScalarComponentAsDouble(1, 1, 0, 0), 300.0);
  samples[10] = '\x80';
  this->ExpectRefused(this->Write(header + samples), { "label value -32724" });
}

TEST_F(Segmentation, LayersAreMergedWhereNoneOverlapOrChosen)
{
  // Both layers call their segment 1; a third segment is in the second layer.
  const std::string header =
    SlicersHeader(SlicersSegment(0, "bone", 1, 0) + SlicersSegment(1, "skin", 1, 1) +
                    SlicersSegment(2, "air", 3, 1),
      2);
  std::string samples(48, '\0');
  samples[2 * 5] = 1;      // bone, in layer 0
  samples[2 * 6 + 1] = 1;  // skin, in layer 1
  samples[2 * 23 + 1] = 3; // air
  auto volume = Read(this->Write(header + samples));
  std::vector<std::uint8_t> merged(24);
  merged[5] = 1;
  merged[6] = 2;
  merged[23] = 3;
  EXPECT_EQ(Labels(volume.image), merged);
  ASSERT_EQ(volume.segments.size(), 3U);
  EXPECT_EQ(volume.segments[1].labelValue, 2);
  EXPECT_EQ(volume.segments[1].name, "skin");
  EXPECT_EQ(volume.passport.warnings.size(), 1U);

  samples[2 * 5 + 1] = 1; // now bone and skin overlap: each layer alone can be read
  hasp::VolumeReadSettings settings;
  settings.layer = 2;
  volume = Read(this->Write(header + samples), settings);
  std::vector<std::uint8_t> second(24);
  second[5] = second[6] = 1;
  second[23] = 3;
  EXPECT_EQ(Labels(volume.image), second);
  ASSERT_EQ(volume.segments.size(), 2U);
  EXPECT_EQ(volume.segments[1].name, "air");
  EXPECT_EQ(volume.segments[1].labelValue, 3);
}

TEST_F(Segmentation, LargeLabelsOfManyLayersTakeLittleMemory)
{
  constexpr int layers = 2000;
  std::string text;
  for (int n = 0; n < layers; ++n)
    text += SlicersSegment(n, "bone", 65535, n);
  text = SlicersHeader(text, layers);
  text.replace(text.find("unsigned char"), 13, "unsigned short\nendian: little");
  const auto file = this->Write(text + std::string(24 * 2 * layers, '\0'));
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(Read(file).passport.segments, layers);
  getrusage(RUSAGE_SELF, &after);
  // The header is 500 kB; a table of all labels would be 256 KiB for each layer, 500 MiB.
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 100 << 10) << "KiB";
}

TEST_F(Segmentation, MoreSegmentsThanLabelsCannotBeMerged)
{
  std::string text;
  for (int n = 0; n < 65536; ++n)
  {
    const std::string key = "Segment" + std::to_string(n) + "_";
    text += key + "ID:=a\n" + key + "LabelValue:=" + std::to_string(1 + n / 2) + "\n";
    if (n % 2 == 1)
      text += key + "Layer:=1\n";
  }
  text = SlicersHeader(text, 2);
  text.replace(text.find("unsigned char"), 13, "unsigned short\nendian: little");
  this->ExpectRefused(this->Write(text + std::string(96, '\0')), { "65536 segments", "layer" });
}

TEST_F(Segmentation, MergedLayersAreHeldToTheMemoryLimit)
{
  // 256 segments, so that what is merged needs two bytes a sample, not one as the file has.
  std::string text;
  for (int n = 0; n < 256; ++n)
    text += SlicersSegment(n, "bone", 1 + n / 2, n % 2);
  hasp::VolumeReadSettings settings;
  settings.memoryLimitBytes = 24;
  this->ExpectRefused(
    this->Write(SlicersHeader(text, 2) + std::string(48, '\0')), { "memory limit" }, settings);
  settings.memoryLimitBytes = 48;
  EXPECT_EQ(
    Read(this->Write(SlicersHeader(text, 2) + std::string(48, '\0')), settings).passport.sampleType,
    "uint16");
}

TEST_F(Segmentation, FilesOfOldSlicerHaveALayerForEachSegment)
{
  const std::string header =
    SlicersHeader("Segment0_ID:=a\nSegment0_Name:=bone\nSegment1_ID:=b\n", 2);
  std::string samples(48, '\0');
  samples[0] = samples[3] = 1;
  const auto volume = Read(this->Write(header + samples));
  EXPECT_EQ(Labels(volume.image)[0], 1);
  EXPECT_EQ(Labels(volume.image)[1], 2);
  EXPECT_EQ(volume.segments[1].name, "");
}

TEST_F(Segmentation, WhatIsWrittenReadsBack)
{
  const auto g = this->Truth();
  const std::vector<hasp::Segment> segments{ { 3, "mandible \\ left", { 0.9, 0.8, 0.7 } },
    { 1, "z\xC3\xA4hne\nobere", { 0, 0.5, 1 } }, { 200, "none of it", {} } };
  std::vector<std::uint8_t> labels(g.Size());
  labels[g.Size() - 1] = 3;
  labels[13] = labels[27] = 1;
  const auto file = (this->Folder / "b.seg.nrrd").string();
  hasp::WriteSegmentation(hasp::MakeImage(g, labels), segments, file);
  const auto volume = Read(file);
  EXPECT_EQ(Labels(volume.image), labels);
  EXPECT_EQ(volume.passport.geometry.origin, g.origin);
  ASSERT_EQ(volume.segments.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_EQ(volume.segments[n].labelValue, segments[n].labelValue);
    EXPECT_EQ(volume.segments[n].name, segments[n].name);
    EXPECT_EQ(volume.segments[n].color, segments[n].color);
  }
  const std::string bytes = ReadBytes(file);
  for (const char* line :
    { "\nSegment1_Name:=z\xC3\xA4hne\\nobere\n", "\nSegment0_Name:=mandible \\\\ left\n" })
    EXPECT_NE(bytes.find(line), std::string::npos) << line;
}

TEST_F(Segmentation, BadSegmentsAreNotWritten)
{
  const auto g = this->Truth();
  const auto image = hasp::MakeImage(g, std::vector<std::uint8_t>(g.Size(), 1));
  const auto file = (this->Folder / "b.seg.nrrd").string();
  const auto refused = [&](const std::vector<hasp::Segment>& segments)
  {
    EXPECT_THROW(hasp::WriteSegmentation(image, segments, file), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(file));
  };
  refused({});
  refused({ { 0, "a", {} } });
  refused({ { 256, "a", {} } });
  refused({ { 1, "a", {} }, { 1, "b", {} } });
  refused({ { 1, "a", { 0, 0, 1.5 } } });
  refused({ { 1, std::string("a\0b", 3), {} } });
  EXPECT_THROW(hasp::WriteSegmentation(hasp::MakeImage(g, Samples(g)), { { 1, "a", {} } }, file),
    std::invalid_argument);
  EXPECT_THROW(hasp::WriteSegmentation(image, { { 1, "a", {} } }, this->Folder / "b.nrrd"),
    std::runtime_error);
}

} // namespace
