#include "IOFixture.h"
#include "SegmentationText.h"

#include "vtkHaspLabelFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <random>
#include <stdexcept>

// Small files, damaged in each way there is. An exception is an answer; anything else ends the
// program.
namespace
{

class SegmentationHostile : public IOFixture
{
protected:
  std::string Sound(const std::string& ending, bool compress) const
  {
    hasp::GridGeometry g = this->Truth();
    g.dims = { 5, 4, 3 };
    std::vector<std::uint16_t> labels(g.Size(), 2);
    labels[7] = 65535;
    const auto file = (this->Folder / ("a" + ending)).string();
    hasp::WriteLabels(hasp::MakeImage(g, labels), { { 2, "jaw" } }, file, { compress });
    return ReadBytes(file);
  }
  bool Reads(const std::string& bytes, const std::string& ending) const
  {
    const auto file = (this->Folder / ("b" + ending)).string();
    WriteBytes(file, bytes);
    hasp::VolumeReadSettings settings;
    settings.memoryLimitBytes = 1 << 16; // a damaged size may be large
    try
    {
      const auto labels = hasp::LoadLabels(hasp::OpenVolume(file, settings));
      EXPECT_EQ(labels.image->GetScalarType(), VTK_UNSIGNED_SHORT);
      return true;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find("b" + ending + ": "), std::string::npos)
        << error.what();
      return false;
    }
  }
};

TEST_F(SegmentationHostile, AFileThatIsCutOffAnywhereIsRefused)
{
  for (const std::string ending : { ".seg.nrrd", ".nrrd", ".mha" })
    for (const bool compress : { false, true })
    {
      if (compress && ending == ".mha")
        continue; // raw in either case
      const std::string bytes = this->Sound(ending, compress);
      ASSERT_TRUE(this->Reads(bytes, ending));
      const std::size_t first = compress ? bytes.find("\n\n") : 0; // else cut as the raw one
      for (std::size_t size = first; size < bytes.size(); ++size)
        EXPECT_FALSE(this->Reads(bytes.substr(0, size), ending)) << ending << " of " << size;
      EXPECT_FALSE(this->Reads(bytes + "x", ending)) << ending;
    }
}

TEST_F(SegmentationHostile, AnyByteMayBeWrong)
{
  std::mt19937 random(5);
  int refused = 0, all = 0;
  for (const bool compress : { false, true })
  {
    const std::string bytes = this->Sound(".seg.nrrd", compress);
    for (std::size_t at = compress; at < bytes.size();
         at += 2) // odd ones of the one, even of the other
    {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 + random() % 255));
      refused += !this->Reads(damaged, ".seg.nrrd");
      ++all;
    }
  }
  EXPECT_GT(refused, all / 10);
}

TEST_F(SegmentationHostile, SizesThatNoFileHoldsTakeNoMemory)
{
  const std::string sound = this->Sound(".seg.nrrd", false);
  for (const char* sizes : { "99999 99999 99999", "2147483647 2147483647 2147483647", "0 4 3",
         "-5 4 3", "5 4 1e15", "5 4", "5 4 3 2", "1000000000000000 1 1", "nan 4 3", "6 4 3" })
  {
    std::string bytes = sound;
    bytes.replace(bytes.find("5 4 3\n"), 5, sizes);
    EXPECT_FALSE(this->Reads(bytes, ".seg.nrrd")) << sizes;
  }
  for (const char* layers : { "0", "65537", "-1", "9223372036854775807", "100000000000000" })
  {
    std::string bytes = SlicersHeader(SlicersSegment(0, "bone", 1, 0), 2) + std::string(48, '\1');
    bytes.replace(bytes.find("sizes: 2 "), 9, "sizes: " + std::string(layers) + " ");
    EXPECT_FALSE(this->Reads(bytes, ".seg.nrrd")) << layers;
  }
}

TEST_F(SegmentationHostile, TextsOfTheFileStayOutOfErrors)
{
  const std::string canary = "Zaphod";
  const auto says = [&](const std::string& bytes) -> std::string
  {
    const auto file = (this->Folder / "b.seg.nrrd").string();
    WriteBytes(file, bytes);
    try
    {
      hasp::LoadLabels(hasp::OpenVolume(file));
    }
    catch (const std::exception& error)
    {
      return error.what();
    }
    return canary + ", for it was read";
  };
  const std::string sound = SlicersSegment(0, canary, 1, 0), samples(24, '\1');
  for (const std::string& bytes :
    { SlicersHeader(sound + SlicersSegment(1, canary, 1, 0)) + samples,
      SlicersHeader(sound + SlicersSegment(1, canary, 2, 7)) + samples,
      SlicersHeader(sound + "Segment1_ID:=" + canary + "\nSegment1_LabelValue:=" + canary + "\n") +
        samples,
      SlicersHeader(canary + "\n" + sound) + samples, SlicersHeader(sound, 2) + samples,
      SlicersHeader(sound + "Segment0_Name:=" + canary + "\n") + samples })
    EXPECT_EQ(says(bytes).find(canary), std::string::npos) << says(bytes);
}

} // namespace
