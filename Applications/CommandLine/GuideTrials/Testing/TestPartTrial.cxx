// What `hasp report guides` makes of what random parts say, without making any.
#include "GuideTrials.h"
#include "PartLine.h"
#include "ReportRegistry.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

namespace
{

using hasp::PartOutcome;

/// Says Sound of every seed, but of the first of a kind what is given for it; the second of one
/// kind ends its process.
hasp::Report Tried(const std::map<std::string, PartOutcome>& first, const std::string& crash = "")
{
  hasp::PartRunner runner;
  runner.kinds = { { "guide", 2 }, { "plate", 1 }, { "implant", 1 }, { "cut", 0 } };
  runner.run = [&](const std::string& kind, std::uint32_t seed, std::size_t count)
  {
    hasp::PartRun run;
    for (const std::uint32_t end = seed + std::uint32_t(count); seed < end; ++seed)
    {
      if (kind == crash && seed == 100'001)
        return hasp::PartRun{ run.output, "exit code 139" };
      hasp::PartLine line;
      line.seed = seed;
      line.outcome =
        seed % 100'000 == 0 && first.contains(kind) ? first.at(kind) : PartOutcome::Sound;
      line.text = "fake";
      run.output += hasp::FormatPartLine(line);
    }
    return run;
  };
  hasp::Report report;
  hasp::ReportContext context{ report, {}, [](double, const std::string&) {} };
  hasp::TryParts(context, runner, 100, 5);
  return report;
}

const hasp::ReportRow& Row(const hasp::Report& report, const std::string& id)
{
  for (const hasp::ReportRow& row : report.rows)
    if (row.id == id)
      return row;
  throw std::runtime_error("no row " + id);
}

TEST(PartTrial, CountsPartsByTheirSharesAndNoCuts)
{
  const hasp::Report report = Tried({});
  const hasp::ReportRow& manifold = Row(report, "guides.manifold");
  EXPECT_EQ(manifold.n, 100);
  EXPECT_EQ(*manifold.value, 1.0);
  EXPECT_EQ(manifold.data.find("cut"), std::string::npos);
  for (const char* kind : { "50 of kind guide", "25 of kind plate", "25 of kind implant" })
    EXPECT_NE(manifold.data.find(kind), std::string::npos) << manifold.data;
  const hasp::ReportRow& conserved = Row(report, "guides.conservation");
  EXPECT_EQ(conserved.n, 5);
  EXPECT_EQ(conserved.bars.at(1).figure, 0.0);
}

TEST(PartTrial, EveryKindOfPartCounts)
{
  for (const char* kind : { "guide", "plate", "implant" })
  {
    const hasp::Report open = Tried({ { kind, PartOutcome::Open } });
    EXPECT_EQ(*Row(open, "guides.manifold").value, 0.99) << kind;
    EXPECT_NE(Row(open, "guides.manifold").data.find(kind + std::string(" 100000, not one closed")),
      std::string::npos);
    EXPECT_EQ(Row(open, "guides.conservation").bars.at(1).figure, 0.0);
    const hasp::Report wrong = Tried({ { kind, PartOutcome::Wrong } });
    EXPECT_EQ(*Row(wrong, "guides.refused").value, 0.0) << kind;
    const hasp::Report fell = Tried({ { kind, PartOutcome::FellBack } });
    EXPECT_EQ(*Row(fell, "guides.fallback").value, 1.0) << kind;
  }
}

TEST(PartTrial, ACrashCostsOnePart)
{
  const hasp::Report report = Tried({}, "implant");
  const hasp::ReportRow& crashes = Row(report, "guides.crashes");
  EXPECT_EQ(*crashes.value, 1.0);
  EXPECT_EQ(crashes.n, 100);
  EXPECT_EQ(*Row(report, "guides.manifold").value, 1.0);
  EXPECT_NE(crashes.data.find("implant 100001: exit code 139"), std::string::npos) << crashes.data;
}

TEST(PartTrial, ACutThatIsNotSoundMissesItsOwnBarAlone)
{
  const hasp::Report open = Tried({ { "cut", PartOutcome::Open } });
  EXPECT_EQ(Row(open, "guides.conservation").bars.at(1).figure, 1.0);
  EXPECT_EQ(*Row(open, "guides.manifold").value, 1.0);
  const hasp::Report crashed = Tried({}, "cut");
  EXPECT_EQ(Row(crashed, "guides.conservation").bars.at(1).figure, 1.0);
  EXPECT_EQ(*Row(crashed, "guides.crashes").value, 0.0);
}

} // namespace
