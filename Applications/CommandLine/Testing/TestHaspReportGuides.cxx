#include "ReportFixture.h"

namespace
{

/// Shares, counts and errors at their bars; of times only that they are there.
TEST_F(HaspReport, RandomPartsAreSoundAndCertificatesFindWhatIsWrong)
{
  const HaspRun run = RunHasp({ "report", "guides", "--quick", "--volume", this->Path("none.inv3"),
    "--json", this->Path("g.json"), "--html", this->Path("g.html") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto report = Json::parse(ReadBytes(this->Path("g.json")));
  const auto value = [&](const std::string& id)
  { return Row(report, "guides." + id).at("value").get<double>(); };
  EXPECT_EQ(value("manifold"), 1.0) << Row(report, "guides.manifold");
  EXPECT_EQ(value("crashes"), 0.0) << Row(report, "guides.crashes");
  EXPECT_EQ(value("fallback"), 0.0) << Row(report, "guides.fallback");
  EXPECT_EQ(value("refused"), 1.0) << Row(report, "guides.manifold");
  EXPECT_LE(value("conservation"), 1e-3);
  EXPECT_EQ(value("plan"), 1.0);
  EXPECT_LE(value("gap.p95@phantom"), 0.1); // mm
  EXPECT_GT(value("time@phantom"), 0.0);
  for (const char* id : { "manifold", "crashes", "fallback", "refused", "planes", "conservation",
         "plan", "gap.p95@phantom", "certificate.found", "certificate.false" })
    EXPECT_EQ(Row(report, std::string("guides.") + id).value("bar_missed", true), false) << id;
  EXPECT_EQ(Row(report, "guides.manifold").at("n"), 32) << "parts, without cuts";
  const auto manifold = Row(report, "guides.manifold").at("data").get<std::string>();
  for (const char* kind : { "16 of kind guide", "8 of kind plate", "8 of kind implant" })
    EXPECT_NE(manifold.find(kind), std::string::npos) << manifold;
  EXPECT_GT(value("preview@phantom"), 0.0);
  EXPECT_LE(Row(report, "guides.preview@phantom").at("error"), 0.1); // mm RMS; voxels of 0.8 mm
  for (const char* id : { "time", "gap.p95", "preview" })
    EXPECT_TRUE(Row(report, std::string("guides.") + id).contains("absent")) << id;
  ASSERT_GE(report.at("unused").size(), 3U);
  for (const auto& resource : report.at("unused"))
    EXPECT_EQ(resource.at("bytes"), 0) << resource;
}

} // namespace
