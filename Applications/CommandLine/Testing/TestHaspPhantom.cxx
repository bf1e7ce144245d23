#include "HaspProcess.h"

#include "Grid/Phantom.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>

namespace
{

using nlohmann::json;
using Samples = std::vector<std::int16_t>;
using Words = std::vector<std::string>;

class HaspPhantom : public HaspTest
{
protected:
  HaspRun Make(const Words& more, const std::string& name = "p.mha") const
  {
    Words words{ "phantom", "--quiet", "--output", this->Path(name) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  /// What follows the header of a MetaImage.
  Samples ReadSamples(const std::string& name) const
  {
    const std::string bytes = ReadBytes(this->Path(name)), last = "ElementDataFile = LOCAL\n";
    const std::size_t at = bytes.find(last) + last.size();
    Samples samples((bytes.size() - at) / sizeof(std::int16_t));
    std::memcpy(samples.data(), bytes.data() + at, samples.size() * sizeof(std::int16_t));
    return samples;
  }
};

TEST_F(HaspPhantom, WrongOptionsAreOneAndLeaveNothing)
{
  const std::vector<Words> wrong{ { "--anatomy", "skull" }, { "--size", "1,20,20" },
    { "--size", "20,20,4096" }, { "--size", "20,20,20", "--spacing", "5,5,5" }, { "--flip", "x" },
    { "--noise", "nan" }, { "--blur", "0.5,-1,0.5" }, { "--slice-thickness", "-1" },
    { "--field-radius", "inf" }, { "--spacing", "0,1,1" } };
  for (const Words& words : wrong)
    EXPECT_EQ(this->Make(words).exitCode, 1) << words[0] << " " << words[1];
  EXPECT_EQ(this->Make({}, "p.png").exitCode, 1);
  EXPECT_TRUE(this->Names().empty());
}

TEST_F(HaspPhantom, TheFileHoldsTheKernelsSamples)
{
  ASSERT_EQ(this
              ->Make({ "--anatomy", "both", "--spacing", "5,6,7", "--noise", "12", "--seed", "7",
                "--blur", "0.5,0.5,0.7", "--slice-thickness", "2", "--metal", "--intact",
                "--field-radius", "150", "--grain" })
              .exitCode,
    0);
  hasp::PhantomSettings s;
  s.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
  s.noiseHU = 12.0;
  s.seed = 7;
  s.blurMm = { 0.5, 0.5, 0.7 };
  s.sliceMm = 2.0;
  s.metal.on = true;
  s.defect = false;
  s.fieldRadiusMm = 150.0;
  s.grain = true;
  EXPECT_EQ(this->ReadSamples("p.mha"), hasp::SamplePhantom(hasp::PhantomGrid({ 5, 6, 7 }, s), s));
}

TEST_F(HaspPhantom, FlippedAxesStoreTheSamePlacesTheOtherWayRound)
{
  ASSERT_EQ(this->Make({ "--size", "30,31,32" }, "a.mha").exitCode, 0);
  ASSERT_EQ(this->Make({ "--size", "30,31,32", "--flip", "ijk" }, "b.mha").exitCode, 0);
  ASSERT_EQ(this->Make({ "--size", "30,31,32", "--flip", "i" }, "c.mha").exitCode, 0);
  const Samples a = this->ReadSamples("a.mha");
  Samples b = this->ReadSamples("b.mha"), c = this->ReadSamples("c.mha");
  ASSERT_EQ(a.size(), 30u * 31u * 32u);
  EXPECT_NE(a, b);
  std::reverse(b.begin(), b.end());
  EXPECT_EQ(a, b);
  EXPECT_NE(a, c) << "left and right differ";
  for (auto row = c.begin(); row != c.end(); row += 30)
    std::reverse(row, row + 30);
  EXPECT_EQ(a, c);
}

TEST_F(HaspPhantom, JsonTellsTheTruth)
{
  const HaspRun run = this->Make({ "--anatomy", "fibula", "--spacing", "4,4,8", "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document.at("hounsfield"), true);
  ASSERT_EQ(document.at("parts").size(), 1u);
  EXPECT_EQ(document.at("parts").at(0).at("name"), "fibula");
  // About a cylinder of 13 mm and 346 mm.
  EXPECT_NEAR(document.at("parts").at(0).at("volume_mm3").get<double>(), 42000.0, 10000.0);
  std::set<std::string> names;
  for (const json& mark : document.at("landmarks"))
    names.insert(mark.at("name").get<std::string>());
  EXPECT_EQ(names, (std::set<std::string>{ "fibula lower end", "fibula upper end" }));
  EXPECT_FALSE(document.contains("defect"));
}

TEST_F(HaspPhantom, NobodyCallsConeBeamValuesHounsfield)
{
  const HaspRun made =
    this->Make({ "--cbct", "--spacing", "8,8,8", "--field-radius", "80", "--json" });
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(json::parse(made.out).at("hounsfield"), false);
  const HaspRun info = RunHasp({ "info", this->Path("p.mha"), "--json" });
  ASSERT_EQ(info.exitCode, 0) << info.err;
  EXPECT_EQ(json::parse(info.out).at("passport").at("hounsfield"), false);
}

TEST_F(HaspPhantom, EveryFormatIsReadBackAsMade)
{
  for (const std::string name : { "p.mha", "p.nrrd", "p.nii", "p.nii.gz", "p.vti" })
  {
    ASSERT_EQ(this->Make({ "--size", "24,26,28" }, name).exitCode, 0) << name;
    const HaspRun info = RunHasp({ "info", this->Path(name), "--json" });
    ASSERT_EQ(info.exitCode, 0) << name << info.err;
    EXPECT_EQ(json::parse(info.out).at("passport").at("dims"), (json{ 24, 26, 28 })) << name;
  }
}

} // namespace
