#include "PictureFiles.h"

#include "HaspRenderTest.h"
#include "SoftwareScene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace
{
namespace fs = std::filesystem;

/// A folder of its own for each case, gone afterwards.
class PictureFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::temp_directory_path() / (std::string("hasp-pictures-") + test->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
    this->Baseline = this->Folder / "baseline" / "TestX.png";
    this->Output = this->Folder / "out";
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  int Check(const hasp::RGBPicture& picture, bool record = false)
  {
    std::string words[] = { "TestX", "--baseline", this->Baseline.string(), "--output",
      this->Output.string(), "--record" };
    char* argv[] = { words[0].data(), words[1].data(), words[2].data(), words[3].data(),
      words[4].data(), words[5].data() };
    testing::internal::CaptureStdout();
    const int result = hasp::CheckPicture(picture, record ? 6 : 5, argv);
    this->Said = testing::internal::GetCapturedStdout();
    return result;
  }

  fs::path Folder{}, Baseline{}, Output{};
  std::string Said{};
};

TEST_F(PictureFiles, RefusesWhatIsMissingOrNoPNG)
{
  EXPECT_THROW(hasp::ReadPNG(this->Folder / "none.png"), std::runtime_error);
  EXPECT_THROW(hasp::ReadPNG(this->Folder), std::runtime_error);
  std::ofstream(this->Folder / "text.png") << "this is no picture";
  EXPECT_THROW(hasp::ReadPNG(this->Folder / "text.png"), std::runtime_error);
  std::ofstream(this->Folder / "empty.png").flush();
  EXPECT_THROW(hasp::ReadPNG(this->Folder / "empty.png"), std::runtime_error);
  EXPECT_THROW(hasp::WritePNG(SoftwareScene().Draw(), "/proc/nowhere/x.png"), std::runtime_error);
}

TEST_F(PictureFiles, SurviveTheRoundTrip)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  hasp::WritePNG(scene, this->Folder / "new" / "scene.png");
  const hasp::RGBPicture back = hasp::ReadPNG(this->Folder / "new" / "scene.png");
  EXPECT_EQ(back.width, scene.width);
  EXPECT_EQ(back.height, scene.height);
  EXPECT_EQ(back.pixels, scene.pixels);
}

TEST_F(PictureFiles, AMissingBaselineFailsAndKeepsWhatWasDrawn)
{
  EXPECT_EQ(this->Check(SoftwareScene().Draw()), EXIT_FAILURE);
  EXPECT_NE(this->Said.find("no such picture"), std::string::npos) << this->Said;
  EXPECT_TRUE(fs::exists(this->Output / "TestX.png"));
}

TEST_F(PictureFiles, ABaselineOfAnotherSizeFails)
{
  hasp::WritePNG(hasp::RGBPicture(20, 10), this->Baseline);
  EXPECT_EQ(this->Check(SoftwareScene().Draw()), EXIT_FAILURE);
  EXPECT_NE(this->Said.find("differ in size"), std::string::npos) << this->Said;
}

TEST_F(PictureFiles, AWrongPictureFailsWithPicturesAndTheCommand)
{
  hasp::WritePNG(SoftwareScene().Draw(), this->Baseline);
  SoftwareScene wrong;
  wrong.wrongDepth = true;
  EXPECT_EQ(this->Check(wrong.Draw()), EXIT_FAILURE);
  EXPECT_NE(this->Said.find("update-baseline TestX"), std::string::npos) << this->Said;
  EXPECT_EQ(hasp::ReadPNG(this->Output / "TestX.png").pixels, wrong.Draw().pixels);
  EXPECT_TRUE(fs::exists(this->Output / "TestX.difference.png"));

  EXPECT_EQ(this->Check(SoftwareScene().Draw()), EXIT_SUCCESS) << this->Said;
  EXPECT_FALSE(fs::exists(this->Output / "TestX.png")) << "the failure's pictures are gone";
}

TEST_F(PictureFiles, AnAlternateMayMatchInstead)
{
  SoftwareScene other;
  other.shade = 0.9;
  hasp::WritePNG(other.Draw(), this->Baseline);
  EXPECT_EQ(this->Check(SoftwareScene().Draw()), EXIT_FAILURE);
  hasp::WritePNG(SoftwareScene().Draw(), this->Baseline.parent_path() / "TestX_1.png");
  EXPECT_EQ(this->Check(SoftwareScene().Draw()), EXIT_SUCCESS) << this->Said;
}

TEST_F(PictureFiles, RecordingRefusesAnEmptyPicture)
{
  EXPECT_EQ(this->Check(hasp::RGBPicture(20, 10), true), EXIT_FAILURE);
  EXPECT_FALSE(fs::exists(this->Output / "TestX.png"));
  EXPECT_EQ(this->Check(SoftwareScene().Draw(), true), EXIT_SUCCESS) << this->Said;
  EXPECT_TRUE(fs::exists(this->Output / "TestX.png"));
  EXPECT_FALSE(fs::exists(this->Baseline)) << "recording never writes beside the baseline";
}

TEST_F(PictureFiles, VTKsComparisonIsBlindToShadeAndSeesPlace)
{
  const hasp::RGBPicture scene = SoftwareScene().Draw();
  SoftwareScene dark, moved;
  dark.shade = 0.8;
  moved.shiftX = 20;
  EXPECT_LT(hasp::MeasureAsVTKDoes(dark.Draw(), scene), 0.15);
  EXPECT_GT(hasp::MeasureAsVTKDoes(moved.Draw(), scene), 0.15);
}

} // namespace
