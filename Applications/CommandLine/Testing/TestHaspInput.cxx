#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace
{

using nlohmann::json;

class HaspInput : public HaspTest
{
};

TEST_F(HaspInput, WhatIsMissingIsTwo)
{
  ExpectFailure(RunHasp({ "info", this->Path("no.mha") }), 2, "the .mha file: no such file");
}

TEST_F(HaspInput, AnEmptyFolderIsTwo)
{
  std::filesystem::create_directory(this->folder / "slices");
  ExpectFailure(RunHasp({ "info", this->Path("slices") }), 2, "the folder: it is empty");
  ExpectFailure(RunHasp({ "info", this->Path("slices") + "/" }), 2, "the folder: it is empty");
}

TEST_F(HaspInput, WhatIsNoVolumeIsTwo)
{
  this->WriteText("note.txt", "Dear colleague,\n");
  this->WriteText("note.mha", "Dear colleague,\n");
  this->WriteText("note.vti", "<VTKFile");
  this->WriteText("empty.mha", "");
  std::filesystem::create_directory(this->folder / "slices");
  this->WriteText("slices/note.txt", "Dear colleague,\n");
  for (const std::string name : { "note.txt", "note.mha", "note.vti", "empty.mha", "slices" })
    ExpectFailure(RunHasp({ "info", this->Path(name) }), 2, "hasp: ");
}

TEST_F(HaspInput, ACutFileIsTwo)
{
  const std::string whole = ReadBytes(this->Phantom());
  this->WriteText("cut.mha", whole.substr(0, whole.size() / 2));
  ExpectFailure(RunHasp({ "info", this->Path("cut.mha") }), 2, "the .mha file: ");
}

TEST_F(HaspInput, TheFaultsOfABadVolumeAreData)
{
  this->WriteText("note.mha", "Dear colleague,\n");
  const HaspRun run = RunHasp({ "info", this->Path("note.mha"), "--json" });
  EXPECT_EQ(run.exitCode, 2);
  const json passport = json::parse(run.out).at("passport");
  ASSERT_EQ(passport.at("faults").size(), 1U);
  EXPECT_EQ(passport.at("faults")[0].at("kind"), "damaged");
  EXPECT_EQ(passport.at("faults")[0].at("resamplable"), false);
  EXPECT_TRUE(passport.at("minimum").is_null());
  const std::string sentence = passport.at("faults")[0].at("text");
  EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
  const HaspRun text = RunHasp({ "info", this->Path("note.mha") });
  EXPECT_EQ(text.exitCode, 2);
  EXPECT_NE(text.out.find("fault       " + sentence), std::string::npos) << text.out;
}

TEST_F(HaspInput, ThePassportIsTheVolumes)
{
  const HaspRun run = RunHasp({ "info", this->Phantom(), "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json passport = json::parse(run.out).at("passport");
  EXPECT_EQ(passport.at("spacing_mm"), (json{ 6.0, 6.0, 7.0 }));
  EXPECT_EQ(passport.at("sample_type"), "int16");
  EXPECT_EQ(passport.at("minimum"), -1000.0);
  EXPECT_NEAR(passport.at("maximum").get<double>(), 2800.0, 50.0); // enamel
  const HaspRun text = RunHasp({ "info", this->Path("head.mha"), "--quiet" });
  EXPECT_EQ(text.err, "");
  EXPECT_NE(text.out.find("6 x 6 x 7 mm"), std::string::npos) << text.out;
}

TEST_F(HaspInput, PathsOfTheWorldAreRead)
{
  for (const std::string name : { "übermäßig é.mha", "Череп пациента.mha", "頭 蓋.mha",
         "with  'quotes' & \"more\".mha", "-dash.mha" })
  {
    const HaspRun run = RunHasp({ "info", this->Phantom(name), "--json" });
    EXPECT_EQ(run.exitCode, 0) << name << ": " << run.err;
    EXPECT_EQ((run.err + run.out).find(name), std::string::npos) << run.err;
    const HaspRun named = RunHasp({ "info", this->Path(name), "--json", "--show-names" });
    EXPECT_NE(named.err.find(name), std::string::npos) << named.err;
    EXPECT_EQ(named.err.find(this->folder.string()), std::string::npos) << named.err;
  }
}

TEST_F(HaspInput, ASurfaceHasAPassport)
{
  this->WriteText("Erika.obj", "# SPACE=RAS\nv 0 0 0\nv 10 0 0\nv 0 20 0\nv 0 0 30\n"
                               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const HaspRun run = RunHasp({ "info", this->Path("Erika.obj"), "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ((run.out + run.err).find("Erika"), std::string::npos) << run.out << run.err;
  const json document = json::parse(run.out), passport = document.at("passport");
  EXPECT_EQ(passport.at("format"), "OBJ");
  EXPECT_EQ(passport.at("space"), "RAS");
  EXPECT_EQ(passport.at("triangles"), 4);
  EXPECT_EQ(passport.at("minimum_mm"), (json{ -10.0, -20.0, 0.0 })); // in LPS
  EXPECT_EQ(passport.at("closed"), true);
  EXPECT_EQ(passport.at("outward"), true);
  EXPECT_NEAR(passport.at("volume_mm3").get<double>(), 1000.0, 1e-9);
  EXPECT_EQ(passport.at("warnings"), json::array());
  EXPECT_NE(run.out.find("\"surface\""), std::string::npos); // among the resources
  this->WriteText("open.obj", "v 0 0 0\nv 10 0 0\nv 0 20 0\nf 1 3 2\n");
  const HaspRun text = RunHasp({ "info", this->Path("open.obj"), "--quiet" });
  EXPECT_NE(text.out.find("closed      no, 3 edges at holes"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("warning     the file does not say"), std::string::npos) << text.out;
  ExpectFailure(RunHasp({ "info", this->Path("open.obj"), "--series", "2" }), 1, "--series");
  this->WriteText("cut.obj", "v 0 0 0\nv 10 0 0\nf 1 3 2\n");
  ExpectFailure(
    RunHasp({ "info", this->Path("cut.obj") }), 2, "the .obj file: line 3: a face names");
}

TEST_F(HaspInput, ProgressIsPlainStepsWithoutATerminal)
{
  const HaspRun run = RunHasp({ "info", this->Phantom() });
  EXPECT_EQ(run.err, "hasp: reading the .mha file\n");
}

} // namespace
