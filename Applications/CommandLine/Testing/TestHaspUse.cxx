#include "HaspProcess.h"

namespace
{

class HaspUse : public HaspTest
{
};

TEST_F(HaspUse, WrongUseIsOne)
{
  ExpectFailure(RunHasp({}), 1, "--help");
  ExpectFailure(RunHasp({ "nonsense" }), 1, "unknown verb; known are info, ");
  ExpectFailure(RunHasp({ "info" }), 1, "IN is required; see hasp info --help");
  ExpectFailure(RunHasp({ "info", "a", "--nonsense" }), 1, "word 3 is no option of info; see");
  ExpectFailure(RunHasp({ "--nonsense" }), 1, "word 1 is no option of hasp; see hasp --help");
  ExpectFailure(RunHasp({ "info", "a", "b" }), 1, "word 3 is one too many: info takes only IN");
  ExpectFailure(RunHasp({ "help", "nonsense" }), 1, "unknown verb; known are ");
}

TEST_F(HaspUse, SlipsOfThePenAreMet)
{
  ExpectFailure(RunHasp({ "rendre", "x" }), 1, "unknown verb; did you mean render?");
  ExpectFailure(RunHasp({ "phant" }), 1, "did you mean phantom?");
  ExpectFailure(RunHasp({ "report", "sterio" }), 1, "unknown report; did you mean stereo?");
  ExpectFailure(RunHasp({ "render", "x", "--iso-value", "3", "--output", "x.png" }), 1,
    "did you mean --isovalue?");
  ExpectFailure(RunHasp({ "info", "x", "--jsno" }), 1, "did you mean --json?");
  ExpectFailure(RunHasp({ "info", "x", "--serie=2" }), 1, "word 3 is no option of info; did you");
}

TEST_F(HaspUse, WordsOfTheCommandLineAreNotEchoed)
{
  const std::string word = "Erika";
  for (const std::vector<std::string>& words :
    std::vector<std::vector<std::string>>{ { word }, { "info", "x", word },
      { "info", "x", "--" + word }, { "info", "x", "--" + word + "=" + word },
      { "info", "x", "-" + word }, { "info", "x", "--series", word }, { "help", word },
      { "info", "x", "--series=" + word }, { "info", "x", "--quiet=" + word }, { "--" + word },
      { "render", "x", "--isovalue", word, "--output", "x.png" }, { "report", word },
      { "render", "x", "--isovalue", "1", "--output", "x.png", "--view", word },
      { "render", "x", "--isovalue", "1", "--output", "x.png", "--zoom", word },
      { "render", "x", "--isovalue", "1", "--output", "x.png", "--resolution", word + ",1" },
      { "render", word + ".mha", "--isovalue", "1", "--output", word + ".png" },
      { "view", word + ".mha", "--surface", word + ".stl", "--output", word + ".png" },
      { "phantom", "--output", word + "/" + word + ".mha" }, { "phantom", "--output", word } })
  {
    const HaspRun run = RunHasp(words);
    EXPECT_NE(run.exitCode, 0);
    EXPECT_EQ((run.err + run.out).find(word), std::string::npos) << run.err;
    EXPECT_TRUE(run.err.starts_with("hasp: ") && run.err.ends_with("\n")) << run.err;
  }
}

TEST_F(HaspUse, WrongValuesAreToldWhatTheOptionTakes)
{
  const auto render = [](const std::string& option, const std::string& value) {
    return RunHasp({ "render", "x", "--isovalue", "1", "--output", "x.png", option, value });
  };
  ExpectFailure(render("--zoom", "0"), 1, "--zoom takes a number in [0.01 - 100]; see hasp render");
  ExpectFailure(render("--view", "inside"), 1, "--view takes one of {");
  ExpectFailure(render("--resolution", "7"), 1, "--resolution takes 2 whole numbers");
  if (HASP_WITH_VIEW)
    ExpectFailure(RunHasp({ "view", "x", "--head", "mouse", "--head-prediction", "33s" }), 1,
      "--head-prediction takes a number");
  ExpectFailure(RunHasp({ "info", "x", "--series", "two" }), 1, "--series takes a whole number;");
}

TEST_F(HaspUse, HelpIsAVerbToo)
{
  EXPECT_EQ(RunHasp({ "help" }).out, RunHasp({ "--help" }).out);
  EXPECT_EQ(RunHasp({ "help", "render" }).out, RunHasp({ "render", "--help" }).out);
}

TEST_F(HaspUse, AValueOutOfRangeIsOne)
{
  const std::string out = this->Path("x.png");
  for (const std::vector<std::string>& bad :
    std::vector<std::vector<std::string>>{ { "--stereo", "quad" }, { "--mapper", "splats" },
      { "--mapper", "VTK" }, { "--resolution", "0,10" }, { "--resolution", "10" },
      { "--color", "2,0,0" }, { "--zoom", "0" }, { "--zoom", "nan" }, { "--ignore-below", "nan" },
      { "--eye-angle", "nan" }, { "--color", "nan,0,0" }, { "--background", "0,nan,0" },
      { "--view", "inside" }, { "--eye-angle", "91" },
      { "--view", "left", "--camera-direction", "1,0,0" } })
  {
    std::vector<std::string> words{ "render", "head.mha", "--isovalue", "1", "--output", out };
    words.insert(words.end(), bad.begin(), bad.end());
    ExpectFailure(RunHasp(words), 1, bad.front());
  }
  EXPECT_TRUE(this->Names().empty());
}

TEST_F(HaspUse, WhatCannotBePrintedIsOne)
{
  const std::string volume = this->Phantom();
  for (const std::vector<std::string>& words :
    std::vector<std::vector<std::string>>{ { "info", volume }, { "info", volume, "--json" },
      { "info", volume, "--explain" }, { "--version" }, { "--help" } })
    ExpectFailure(RunHasp(words, "/dev/full"), 1, "standard output cannot be written to");
}

TEST_F(HaspUse, EveryVerbHelpsWithExamplesAndExitCodes)
{
  const HaspRun top = RunHasp({ "--help" });
  EXPECT_EQ(top.exitCode, 0);
  EXPECT_NE(top.out.find("4 cannot draw"), std::string::npos);
  std::vector<std::string> verbs{ "info", "convert", "render", "phantom", "report" };
  if (HASP_WITH_VIEW)
    verbs.push_back("view");
  for (const std::string& verb : verbs)
  {
    EXPECT_NE(top.out.find("\n  " + verb), std::string::npos) << top.out;
    const HaspRun help = RunHasp({ verb, "--help" });
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.out.find("Example"), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("Exit code"), std::string::npos) << help.out;
    EXPECT_EQ(help.err, "");
  }
}

TEST_F(HaspUse, TheVersionSaysWhatThisIsNot)
{
  const HaspRun run = RunHasp({ "--version" });
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.out.rfind("hasp 0.", 0), 0u) << run.out;
  EXPECT_NE(run.out.find("(commit "), std::string::npos);
  EXPECT_NE(run.out.find("not a medical device"), std::string::npos);
}

} // namespace
