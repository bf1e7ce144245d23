#include "IOFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeSlabs.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

namespace
{

class VolumeSlabs : public IOFixture
{
protected:
  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }
  std::size_t FilesThere() const
  {
    return std::distance(std::filesystem::directory_iterator(this->Folder), {});
  }
};

TEST_F(VolumeSlabs, MoreThanTheDiskHoldsIsRefusedBeforeAnythingIsWritten)
{
  const hasp::GridGeometry g{ { 100000, 100000, 100000 }, {}, { 1, 1, 1 } }; // 1.8 million GiB
  for (const char* name : { "a.mha", "a.nrrd", "a.nii" })
    try
    {
      const hasp::VolumeSlabWriter writer(this->Path(name), g, hasp::SampleType::Int16);
      ADD_FAILURE() << name;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find("the disk has"), std::string::npos) << error.what();
    }
  EXPECT_EQ(this->FilesThere(), 0U);
}

TEST_F(VolumeSlabs, BadUseIsRefused)
{
  const auto g = this->Truth();
  const auto make = [&](const char* name, const hasp::GridGeometry& geometry, bool compress)
  { hasp::VolumeSlabWriter(this->Path(name), geometry, hasp::SampleType::Int16, compress); };
  for (const char* name : { "a.vti", "a.seg.nrrd", "a.nhdr", "a.raw", "a", "absent/a.mha" })
    EXPECT_THROW(make(name, g, false), std::runtime_error) << name;
  for (const char* name : { "a.mha", "a.nii" })
    EXPECT_THROW(make(name, g, true), std::runtime_error) << name;
  auto bad = g;
  bad.spacing.y = 0.0;
  EXPECT_THROW(make("a.mha", bad, false), std::invalid_argument);

  hasp::VolumeSlabWriter writer(this->Path("a.mha"), g, hasp::SampleType::Int16);
  EXPECT_THROW(writer.Append(std::vector<std::uint16_t>(120)), std::invalid_argument);
  EXPECT_THROW(writer.Append(std::vector<std::int16_t>(119)), std::invalid_argument);
  EXPECT_THROW(writer.Append(std::vector<std::int16_t>(9 * 120)), std::invalid_argument);
  EXPECT_THROW(writer.Commit(), std::invalid_argument);
  writer.Append(std::vector<std::int16_t>(8 * 120));
  EXPECT_EQ(writer.SlicesLeft(), 0);
  EXPECT_THROW(writer.Append(std::vector<std::int16_t>(120)), std::invalid_argument);
  writer.Commit();
  EXPECT_THROW(writer.Commit(), std::invalid_argument);
  EXPECT_THROW(writer.Append(std::vector<std::int16_t>(0)), std::invalid_argument);
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(VolumeSlabs, SlabsOfAnySizeMakeTheFileThatOnePieceMakes)
{
  const auto g = this->Truth();
  const auto samples = Samples(g);
  for (const char* name : { "a.mha", "a.nrrd", "a.nii", "a.nii.gz" })
  {
    SCOPED_TRACE(name);
    hasp::WriteVolume(hasp::MakeImage(g, samples), this->Path(name));
    const std::string whole = ReadBytes(this->Path(name));
    hasp::VolumeSlabWriter writer(this->Path(name), g, hasp::SampleType::Int16);
    const std::span<const std::int16_t> all(samples);
    writer.Append(all.subspan(0, 120));
    writer.Append(all.subspan(120, 0));
    writer.Append(all.subspan(120, 3 * 120));
    writer.Append(all.subspan(480));
    EXPECT_EQ(ReadBytes(this->Path(name)), whole) << "untouched until Commit";
    std::filesystem::remove(this->Path(name));
    writer.Commit();
    EXPECT_EQ(ReadBytes(this->Path(name)), whole);
    EXPECT_GT(whole.size(), 300U);
  }
}

TEST_F(VolumeSlabs, WithoutCommitThereIsNothing)
{
  const auto g = this->Truth();
  {
    hasp::VolumeSlabWriter writer(this->Path("a.nrrd"), g, hasp::SampleType::Int16, true);
    writer.Append(Samples(g));
  }
  EXPECT_EQ(this->FilesThere(), 0U);
}

} // namespace
