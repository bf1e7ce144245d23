#include "IOFixture.h"
#include "Isosurface/SlabExtraction.h"
#include "Isosurface/Testing/CellFixture.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeSlabReader.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <limits>

namespace
{

using hasp::VolumeSlabReader;

class VolumeSlabReaders : public IOFixture
{
protected:
  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }

  template <typename T>
  std::vector<T> Write(const std::string& name, bool compress = false) const
  {
    auto samples = hasp::testing::Noise<T>(this->Truth());
    hasp::WriteVolume(hasp::MakeImage(this->Truth(), samples), this->Path(name), { compress });
    return samples;
  }

  /// Slabs of several heights hold what the loaded volume holds, at its place.
  template <typename T>
  void ExpectSlabs(const std::string& name, bool streams) const
  {
    SCOPED_TRACE(name);
    const hasp::LoadedVolume whole = Read(this->Path(name));
    const auto truth = std::get<hasp::GridView<const T>>(hasp::ViewImage(whole.image));
    const glm::ivec3 dims = truth.geometry.dims;
    for (const int height : { 1, 2, 5, dims.z })
    {
      VolumeSlabReader reader(this->Path(name), {});
      EXPECT_EQ(reader.Streams(), streams);
      EXPECT_EQ(reader.GetPassport().geometry.dims, dims);
      for (int first = 0; first < dims.z; first += std::max(1, height - 1))
      {
        const int count = std::min(height, dims.z - first);
        const auto slab = std::get<hasp::GridView<const T>>(reader.Read(first, count));
        ASSERT_EQ(slab.geometry.dims, glm::ivec3(dims.x, dims.y, count));
        EXPECT_EQ(slab.geometry.origin, truth.geometry.IndexToWorld({ 0, 0, first }));
        ASSERT_TRUE(std::equal(
          slab.data, slab.data + slab.geometry.Size(), truth.data + truth.Offset(0, 0, first)));
      }
      const std::size_t sliceBytes = sizeof(T) * dims.x * dims.y;
      EXPECT_EQ(reader.BytesHeld(), sliceBytes * (streams ? height : dims.z));
    }
  }
  std::string Refusal(const std::function<void()>& f) const
  {
    try
    {
      f();
    }
    catch (const std::exception& error)
    {
      EXPECT_EQ(std::string(error.what()).find(this->Folder.string()), std::string::npos);
      return error.what();
    }
    return {};
  }
};

TEST_F(VolumeSlabReaders, EveryFormatAndTypeInOneStreamIsReadInSlabs)
{
  for (const char* name : { "a.mha", "a.nrrd", "a.nii", "a.nii.gz" })
  {
    this->Write<std::int16_t>(name);
    this->ExpectSlabs<std::int16_t>(name, true);
    this->Write<std::uint16_t>(name);
    this->ExpectSlabs<std::uint16_t>(name, true);
    this->Write<std::uint8_t>(name);
    this->ExpectSlabs<std::uint8_t>(name, true);
    this->Write<float>(name);
    this->ExpectSlabs<float>(name, true);
  }
  this->Write<std::int16_t>("z.nrrd", true);
  this->ExpectSlabs<std::int16_t>("z.nrrd", true);
}

TEST_F(VolumeSlabReaders, OtherByteOrdersAndFilesBesideAreReadInSlabs)
{
  auto samples = this->Write<std::int16_t>("a.mha");
  for (std::int16_t& sample : samples)
    sample = static_cast<std::int16_t>((sample & 0xFF) << 8 | (sample >> 8 & 0xFF));
  std::string bytes;
  AppendBytes(bytes, samples.data(), samples.size());
  WriteBytes(this->Path("a.raw"), bytes);
  WriteBytes(this->Path("a.mhd"),
    "NDims = 3\nDimSize = 12 10 8\nElementSpacing = 1 1 2\nElementType = MET_SHORT\n"
    "ElementByteOrderMSB = True\nElementDataFile = a.raw\n");
  this->ExpectSlabs<std::int16_t>("a.mhd", true);
}

TEST_F(VolumeSlabReaders, WhatIsNoStreamOfKernelTypesIsLoaded)
{
  this->Write<std::int16_t>("a.vti");
  this->ExpectSlabs<std::int16_t>("a.vti", false);
  const std::vector<double> samples(960, 3.25);
  std::string bytes =
    "NDims = 3\nDimSize = 12 10 8\nElementSpacing = 1 1 2\nElementType = MET_DOUBLE\n"
    "ElementDataFile = LOCAL\n";
  AppendBytes(bytes, samples.data(), samples.size());
  WriteBytes(this->Path("a.mha"), bytes);
  this->ExpectSlabs<float>("a.mha", false);
  hasp::VolumeReadSettings settings;
  settings.memoryLimitBytes = 1000;
  EXPECT_NE(
    this->Refusal([&] { VolumeSlabReader(this->Path("a.mha"), settings); }).find("memory limit"),
    std::string::npos);
  EXPECT_NE(
    this->Refusal([&] { VolumeSlabReader(this->Path("none.mha"), {}); }).find("no such file"),
    std::string::npos);
}

TEST_F(VolumeSlabReaders, OnlyWhatIsInMemoryCountsForTheLimit)
{
  this->Write<std::int16_t>("a.mha");
  hasp::VolumeReadSettings settings;
  settings.memoryLimitBytes = 2 * 12 * 10 * 3; // of 8 slices
  VolumeSlabReader reader(this->Path("a.mha"), settings);
  EXPECT_NO_THROW(reader.Read(0, 3));
  EXPECT_NE(this->Refusal([&] { reader.Read(2, 4); }).find("the limit is 720"), std::string::npos);
}

TEST_F(VolumeSlabReaders, SlicesComeForwardOnly)
{
  for (const char* name : { "a.mha", "a.vti" })
  {
    this->Write<std::int16_t>(name);
    VolumeSlabReader reader(this->Path(name), {});
    EXPECT_THROW(reader.Read(-1, 2), std::invalid_argument);
    EXPECT_THROW(reader.Read(0, 9), std::invalid_argument);
    EXPECT_THROW(reader.Read(7, std::numeric_limits<int>::max()), std::invalid_argument);
    EXPECT_THROW(reader.Read(0, 0), std::invalid_argument);
  }
  VolumeSlabReader reader(this->Path("a.mha"), {});
  EXPECT_THROW(reader.Read(2, 1), std::invalid_argument);
  reader.Read(0, 4);
  reader.Read(3, 2);
  EXPECT_THROW(reader.Read(2, 2), std::invalid_argument);
}

TEST_F(VolumeSlabReaders, AFileThatShrinksMeanwhileIsAnError)
{
  hasp::GridGeometry g = this->Truth();
  g.dims = { 256, 256, 12 }; // more than a stream's buffer holds
  hasp::WriteVolume(hasp::MakeImage(g, hasp::testing::Noise<std::int16_t>(g)), this->Path("a.mha"));
  VolumeSlabReader reader(this->Path("a.mha"), {});
  reader.Read(0, 3);
  std::filesystem::resize_file(this->Path("a.mha"), 256 * 256 * 2 * 4);
  EXPECT_NE(
    this->Refusal([&] { reader.Read(2, 5); }).find("cannot be read to its end"), std::string::npos);
}

TEST_F(VolumeSlabReaders, SamplesThatAreNoNumbersAreRefusedWithTheirPlace)
{
  hasp::ShowFileNames(false);
  auto samples = hasp::testing::Noise<float>(this->Truth());
  samples[(5 * 10 + 4) * 12 + 3] = std::numeric_limits<float>::infinity();
  hasp::WriteVolume(hasp::MakeImage(this->Truth(), samples), this->Path("a.nrrd"));
  VolumeSlabReader reader(this->Path("a.nrrd"), {});
  reader.Read(0, 4);
  EXPECT_NE(this->Refusal([&] { reader.Read(3, 4); })
              .find("the .nrrd file: holds samples that are NaN or infinite, the first at index "
                    "(3, 4, 5)"),
    std::string::npos);
  // The stream has gone on: the same slices would be others.
  EXPECT_NE(this->Refusal([&] { reader.Read(3, 4); }).find("open it again"), std::string::npos);
}

TEST_F(VolumeSlabReaders, FeedTheExtraction)
{
  hasp::GridGeometry g = this->Truth();
  g.dims = { 30, 21, 45 };
  const auto samples = hasp::testing::Noise<std::int16_t>(g);
  for (const char* name : { "a.mha", "a.nrrd", "a.nii.gz", "a.vti" })
  {
    hasp::WriteVolume(hasp::MakeImage(g, samples), this->Path(name));
    const hasp::LoadedVolume whole = Read(this->Path(name));
    VolumeSlabReader reader(this->Path(name), {});
    const hasp::ClusteredCells slabs =
      hasp::ExtractActiveCellsFromSlabs(reader.GetPassport().geometry,
        [&](int first, int count) { return reader.Read(first, count); }, 100.5,
        { hasp::CellPrecision::Exact, 1 << 30, 17 });
    EXPECT_TRUE(
      hasp::testing::SameCells(slabs, hasp::testing::CellsOf(hasp::ViewImage(whole.image), 100.5)))
      << name;
  }
}

} // namespace
