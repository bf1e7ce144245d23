#include "HaspProcess.h"

namespace
{

class HaspUse : public HaspTest
{
};

TEST_F(HaspUse, WrongUseIsOne)
{
  ExpectFailure(RunHasp({}), 1, "--help");
  ExpectFailure(RunHasp({ "nonsense" }), 1, "unknown verb 'nonsense'; known are info, render");
  ExpectFailure(RunHasp({ "info" }), 1, "hasp info --help");
  ExpectFailure(RunHasp({ "info", "a", "--nonsense" }), 1, "--nonsense");
  ExpectFailure(RunHasp({ "--nonsense" }), 1, "hasp --help");
}

TEST_F(HaspUse, AValueOutOfRangeIsOne)
{
  const std::string out = this->Path("x.png");
  for (const std::vector<std::string>& bad :
    std::vector<std::vector<std::string>>{ { "--stereo", "quad" }, { "--mapper", "splats" },
      { "--resolution", "0,10" }, { "--resolution", "10" }, { "--color", "2,0,0" },
      { "--zoom", "0" }, { "--zoom", "nan" }, { "--ignore-below", "nan" }, { "--eye-angle", "nan" },
      { "--color", "nan,0,0" }, { "--background", "0,nan,0" }, { "--view", "inside" },
      { "--eye-angle", "91" }, { "--view", "left", "--camera-direction", "1,0,0" } })
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
  for (const std::string verb : { "info", "render", "phantom", "report" })
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
