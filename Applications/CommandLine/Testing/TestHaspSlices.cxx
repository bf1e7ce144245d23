#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace
{

using nlohmann::json;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

/// Folders of DICOM slices with faults, as their users meet them. Sound ones are 3.5 mm apart.
class HaspSlices : public HaspTest
{
protected:
  HaspSlices()
  {
    const std::string head = this->Path("head.mha");
    EXPECT_EQ(
      RunHasp({ "phantom", "--output", head, "--spacing", "6,6,3.5", "--quiet" }).exitCode, 0);
    EXPECT_EQ(RunHasp({ "convert", head, this->Path("slices"), "--hounsfield" }).exitCode, 0);
  }
  fs::path Slice(int number) const
  {
    char name[24];
    std::snprintf(name, sizeof name, "slice-%05d.dcm", number);
    return this->folder / "slices" / name;
  }
  /// Moves a slice, in mm: its Image Position (0020,0032) is written anew.
  void Move(int number, double y, double z) const
  {
    std::string bytes = ReadBytes(this->Slice(number).string());
    const auto at = bytes.find(std::string("\x20\x00\x32\x00"
                                           "DS",
      6));
    ASSERT_NE(at, bytes.npos);
    const auto size = static_cast<unsigned char>(bytes[at + 6]); // less than 256: three numbers
    double p[3];
    ASSERT_EQ(std::sscanf(bytes.substr(at + 8, size).c_str(), "%lf\\%lf\\%lf", p, p + 1, p + 2), 3);
    char text[64];
    std::snprintf(text, sizeof text, "%.6g\\%.6g\\%.6g", p[0], p[1] + y, p[2] + z);
    std::string value = text;
    value.resize((value.size() + 1) / 2 * 2, ' ');
    bytes.replace(at + 8, size, value);
    bytes[at + 6] = static_cast<char>(value.size());
    std::ofstream(this->Slice(number), std::ios::binary) << bytes;
  }
  void MoveAll(double y) const
  {
    for (int n = 1; fs::exists(this->Slice(n)); ++n)
      this->Move(n, y * (n - 1), 0.0);
  }
  HaspRun Info(const Words& more = {}) const
  {
    Words words{ "info", this->Path("slices") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  /// Text and JSON say the same faults, and both end with 2.
  void ExpectFaults(const Words& kinds, const std::string& sentence) const
  {
    const HaspRun text = this->Info();
    ExpectFailure(text, 2, "hasp: the folder: ");
    EXPECT_NE(text.out.find(sentence), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find("values "), std::string::npos) << text.out; // of what is not read
    const HaspRun document = this->Info({ "--json" });
    EXPECT_EQ(document.exitCode, 2) << document.err;
    const json passport = json::parse(document.out).at("passport");
    Words found;
    for (const json& fault : passport.at("faults"))
      found.push_back(fault.at("kind"));
    EXPECT_EQ(found, kinds) << document.out;
    EXPECT_EQ(passport.at("minimum"), nullptr);
    EXPECT_EQ(passport.at("resampled"), nullptr);
  }
  json Resampled() const
  {
    const HaspRun run = this->Info({ "--resample", "--json" });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    const json passport = json::parse(run.out).at("passport");
    EXPECT_EQ(passport.at("faults"), json::array());
    EXPECT_EQ(passport.at("hounsfield"), true);
    return passport.at("resampled");
  }
};

TEST_F(HaspSlices, MissingOnesAreTwoAndResampledNought)
{
  fs::remove(this->Slice(20));
  fs::remove(this->Slice(31));
  this->ExpectFaults({ "missing_slices" }, "fault       2 slices are missing");
  const json faults = json::parse(this->Info({ "--json" }).out).at("passport").at("faults");
  EXPECT_EQ(faults.at(0).at("slices"), (json{ 20, 31 }));
  EXPECT_EQ(faults.at(0).at("files"), (json{ 19, 20, 29, 30 })); // as they are counted now
  EXPECT_EQ(faults.at(0).at("mm"), 7.0);
  EXPECT_EQ(faults.at(0).at("resamplable"), true);
  const json resampled = this->Resampled();
  EXPECT_EQ(resampled.at("slices_made"), 2);
  EXPECT_GT(resampled.at("error_p95_mm"), 0.0);
  EXPECT_LE(resampled.at("error_p95_mm"), 7.0); // the whole gap
  const HaspRun text = this->Info({ "--resample" });
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_NE(text.out.find("resampled   2 slices made"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("of surfaces by resampling"), std::string::npos) << text.out;
}

TEST_F(HaspSlices, DoubledOnesAreLeftOutIfTheyAreTheSame)
{
  fs::copy_file(this->Slice(9), this->folder / "slices" / "copy.dcm");
  this->ExpectFaults({ "doubled_slices" }, "--resample mends it if the pictures are the same.");
  EXPECT_EQ(this->Resampled().at("slices_made"), 0);
  std::string bytes = ReadBytes(this->Slice(9).string());
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  std::ofstream(this->folder / "slices" / "copy.dcm", std::ios::binary) << bytes;
  ExpectFailure(this->Info({ "--resample" }), 2, "different pictures");
}

TEST_F(HaspSlices, UnevenTiltedAndSeveralAtOnce)
{
  this->Move(12, 0.0, 1.2);
  this->ExpectFaults({ "uneven_spacing" }, "fault       the slices are uneven: 4.7 mm");
  EXPECT_EQ(this->Resampled().at("slices_made"), 1);
  this->Move(12, 0.0, -1.2);
  this->MoveAll(0.5);
  this->ExpectFaults({ "gantry_tilt" }, "fault       the stack is tilted");
  EXPECT_NEAR(this->Resampled().at("tilt_degrees").get<double>(), 8.13, 0.01); // atan(0.5 / 3.5)
  fs::remove(this->Slice(20));
  this->ExpectFaults({ "missing_slices", "gantry_tilt" }, "fault       1 slice is missing");
  const json resampled = this->Resampled();
  EXPECT_EQ(resampled.at("slices_made"), 1);
  EXPECT_NEAR(resampled.at("tilt_degrees").get<double>(), 8.13, 0.01);
}

TEST_F(HaspSlices, ConvertRefusesThemOrWritesThemMended)
{
  fs::remove(this->Slice(20));
  const Words convert{ "convert", this->Path("slices"), this->Path("back.mha") };
  ExpectFailure(RunHasp(convert), 2, "It can be read resampled (--resample");
  EXPECT_FALSE(fs::exists(this->Path("back.mha")));
  Words asked = convert;
  asked.push_back("--resample");
  const HaspRun run = RunHasp(asked);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.err.find("warning: Resampled: 1 of "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(" mm (95 %), measured on the series itself."), std::string::npos);
  const auto passport = [&](const char* name) {
    return json::parse(RunHasp({ "info", this->Path(name), "--json" }).out).at("passport");
  };
  const json back = passport("back.mha"), head = passport("head.mha");
  EXPECT_EQ(back.at("dims"), head.at("dims"));
  EXPECT_EQ(back.at("origin_mm"), head.at("origin_mm"));
  EXPECT_EQ(back.at("spacing_mm"), head.at("spacing_mm"));
  EXPECT_EQ(back.at("faults"), json::array());
}

TEST_F(HaspSlices, NamesThatCommandTheTerminalAreNotSaidAsTheyAre)
{
  const fs::path odd = this->folder / "slices" / "\x1b[31ma\n\xff\xc2\x9b.dcm";
  fs::copy_file(this->Slice(9), odd);
  for (const Words& words : { Words{}, { "--show-names" }, { "--show-names", "--json" } })
  {
    const HaspRun run = this->Info(words);
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ((run.out + run.err).find('\x1b'), std::string::npos) << run.err;
    EXPECT_EQ((run.out + run.err).find("\\u001b"), std::string::npos) << run.out;
    EXPECT_EQ((run.out + run.err).find("\xc2\x9b"), std::string::npos) << run.err;
    const bool named = run.err.find("?[31ma???.dcm") != std::string::npos;
    EXPECT_EQ(named, !words.empty()) << run.err;
  }
}

} // namespace
