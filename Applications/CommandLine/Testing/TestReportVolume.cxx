// How reports name the volume that they are given.
#include "Failure.h"
#include "Grid/Phantom.h"
#include "ReportVolume.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeSlabs.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace
{

namespace fs = std::filesystem;

class ReportVolumes : public testing::Test
{
protected:
  ReportVolumes() : Folder(fs::temp_directory_path() / ("hasp-report-" + std::to_string(getpid())))
  {
    fs::create_directories(this->Folder);
  }
  ~ReportVolumes() override { fs::remove_all(this->Folder); }

  /// A ramp from 0 to `most`, under a name that no report may say.
  std::string Write(std::int16_t most) const
  {
    const hasp::GridGeometry grid{ { 5, 6, 7 }, {}, glm::dvec3(1.0), glm::dmat3(1) };
    std::vector<std::int16_t> samples(grid.Size());
    for (std::size_t n = 0; n < samples.size(); ++n)
      samples[n] = static_cast<std::int16_t>(most * n / (samples.size() - 1));
    const std::string path = (this->Folder / "Cranium.mha").string();
    hasp::VolumeSlabWriter writer(path, grid, hasp::SampleType::Int16);
    writer.Append(std::span<const std::int16_t>(samples));
    writer.Commit();
    return path;
  }
  static std::string Refusal(const std::string& path)
  {
    try
    {
      hasp::ReadReportVolume(path);
    }
    catch (const hasp::Failure& failure)
    {
      EXPECT_EQ(failure.code, hasp::ExitCode::BadInput);
      return failure.what();
    }
    return "accepted";
  }

  const fs::path Folder;
};

TEST_F(ReportVolumes, WhatCannotBeMeasuredIsRefusedAtOnce)
{
  EXPECT_EQ(Refusal(this->Write(225)).rfind("the .mha file: has no surface at 226", 0), 0U);
  const std::string text = (this->Folder / "note.mha").string();
  std::ofstream(text) << "Dear colleague";
  EXPECT_THROW(hasp::RequireReportVolume(text), hasp::Failure);
  EXPECT_NO_THROW(hasp::RequireReportVolume((this->Folder / "none.mha").string()));
}

TEST_F(ReportVolumes, AreNamedByWhatTheyAreNotByTheirFile)
{
  const hasp::ReportVolume volume = hasp::ReadReportVolume(this->Write(226));
  EXPECT_EQ(volume.name, "volume");
  EXPECT_EQ(volume.data, "given volume, 5x6x7, 226");
#ifdef HASP_CRANIUM
  const fs::path renamed = this->Folder / "x.inv3";
  fs::create_symlink(HASP_CRANIUM, renamed);
  const hasp::ReportVolume cranium = hasp::ReadReportVolume(renamed.string());
  EXPECT_EQ(cranium.name, "cranium");
  EXPECT_EQ(cranium.data.rfind("real CT, ", 0), 0U) << cranium.data;
#endif
}

} // namespace
