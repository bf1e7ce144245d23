#include "RunFixture.h"

#include <cmath>

namespace
{

TEST_F(HaspRunTest, AnyNumberOfThreadsAndASecondRunWriteTheSameBytes)
{
  std::vector<std::string> words = this->Scan();
  words.insert(words.end(), { "--json", "--explain", "--threads", "1" });
  EXPECT_EQ(Made(this->Make("one", words)), (std::vector<int>{ 4, 5, 8, 6, 9, 7 }));
  const auto one = this->Files("one");
  std::vector<std::string> names;
  for (const auto& [name, bytes] : one)
    names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{ "fragment-4.stl", "fragment-5-planned.stl",
                     "fragment-5.stl", "group-8.stl", "guide-6.json", "guide-6.stl", "guide-9.json",
                     "guide-9.stl", "plate-7.stl", "run.json" }));
  const json run = json::parse(one.at("run.json"));
  EXPECT_EQ(run.at("parts").size(), 6U);
  EXPECT_EQ(run.at("parts")[0].at("cuts")[0].at("parted"), true);
  EXPECT_EQ(run.at("parts")[3].at("verdict"), "green");
  EXPECT_EQ(run.at("parts")[3].at("certificate").at("slots").size(), 1U); // of the cut
  EXPECT_EQ(run.at("parts")[4].at("certificate").at("slots").size(), 0U);
  EXPECT_EQ(run.at("parts")[5].at("verdict"), "green"); // on fragments: its screw's bore is held
  EXPECT_EQ(run.at("parts")[5].at("certificate").at("holes")[0].at("name"), "screws[0]");
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});

  const HaspRun second = this->Make("second", { "--json" }); // needs no scan
  EXPECT_EQ(Made(second), std::vector<int>{});
  EXPECT_EQ(this->Files("second"), one);
  for (const char* threads : { "2", "4" })
  {
    std::vector<std::string> again = this->Scan();
    again.insert(again.end(), { "--json", "--rebuild", "--threads", threads });
    EXPECT_EQ(Made(this->Make(threads, again)).size(), 6U);
    EXPECT_EQ(this->Files(threads), one) << threads;
  }
}

TEST_F(HaspRunTest, OnlyWhatHangsOnAChangeIsMadeAnew)
{
  std::vector<std::string> words = this->Scan();
  words.push_back("--json");
  ASSERT_EQ(Made(this->Make("first", words)).size(), 6U);
  this->Apply(json::array({ { { "change", "cut" }, { "object", Cut(18) } } }));
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 4, 5, 8, 6, 7 })); // and not guide 9
  const std::string part = this->Path("part.stl");
  ExpectFailure(this->Plan({ "--export", "6", "--output", part }), 2,
    "guide 6 is out of date: cut 3 has changed");
  EXPECT_FALSE(fs::exists(part));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0);
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});
  ASSERT_EQ(this->Plan({ "--export", "6", "--output", part }).exitCode, 0);
  EXPECT_EQ(ReadBytes(part), ReadBytes(this->Path("first/guide-6.stl")));
  ASSERT_EQ(this->Plan({ "--redo" }).exitCode, 0);
  EXPECT_EQ(Made(this->Make("moved", words)), (std::vector<int>{ 4, 5, 8, 6, 7 }));
  EXPECT_NE(this->Files("moved").at("fragment-4.stl"), this->Files("first").at("fragment-4.stl"));
  EXPECT_EQ(this->Files("moved").at("guide-9.stl"), this->Files("first").at("guide-9.stl"));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0); // what was made before is still there
  EXPECT_EQ(Made(this->Make("undone", { "--json" })), std::vector<int>{});
  EXPECT_EQ(this->Files("undone"), this->Files("first"));
  this->Apply(json::array({ Move(-3) })); // guides and pieces lie in the scan
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 8, 7 }));
}

TEST_F(HaspRunTest, ScansThatAreMissingOrOthersAreRefused)
{
  this->Phantom("other.mha");
  ExpectFailure(this->Make("out", {}), 2, "volume 1: not among the files given");
  const HaspRun other = this->Make("out", { "--volume", this->Path("other.mha") });
  ExpectFailure(other, 2, "volume 1: not among the files given");
  EXPECT_NE(other.err.find("--volume number 1 is none that the plan"), std::string::npos);
  ExpectFailure(this->Make("out", { "--volume", this->Path("no.mha") }), 2, "no such file");
  EXPECT_EQ(
    this->Names(), (std::vector<std::string>{ "case.hasp", "edits.json", "leg.mha", "other.mha" }));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0);
  ExpectFailure(this->Make("out", {}), 2, "nothing is made of it");
}

TEST_F(HaspRunTest, WhatCannotBeMadeIsNamedByIds)
{
  this->Apply(json::array({ { { "change", "cut" }, { "object", Cut(700) } } }));
  ExpectFailure(this->Make("out", this->Scan()), 2, "fragment 4: cut 3 does not meet bone");
  this->Apply(
    json::array({ { { "change", "cut" }, { "object", Cut(60) } } })); // above the seed of 4
  const HaspRun one = this->Make("out", this->Scan());
  ExpectFailure(one, 2, "fragment 5: it is one piece with fragment 4");
  // Its fault, too, where it is a part of others; and they are no reason not to make the rest.
  for (const char* other : { "group 8: fragment 5: it is one", "plate 7: fragment 5: it is one" })
    EXPECT_NE(one.err.find(other), std::string::npos) << one.err;
  EXPECT_FALSE(fs::exists(this->Path("out")));
  EXPECT_NE(one.err.find("guide 6: "), std::string::npos) << one.err; // the cut is beside it
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 5, 8, 6, 7 }));
}

TEST_F(HaspRunTest, RedPartsAreRefusedOrSaySo)
{
  json thin = Guide(9, -60, json::array()).at("object");
  thin["recipe"]["holes"] = { { { "point", Front(-60) }, { "axis", { 0, -1, 0 } },
    { "diameterMm", 11.2 }, { "depthMm", 20 }, { "sleeveHeightMm", 0 } } };
  this->Apply(json::array({ { { "change", "guide" }, { "object", thin } } }));
  const HaspRun red = this->Make("out", this->Scan());
  ExpectFailure(red, 3, "guide 9: ");
  EXPECT_FALSE(fs::exists(this->Path("out")));
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{ 9 }); // the others are kept
  std::vector<std::string> words = this->Scan();
  words.push_back("--force");
  const HaspRun forced = this->Make("out", words);
  ASSERT_EQ(forced.exitCode, 0) << forced.err;
  EXPECT_NE(forced.err.find("guide 9: "), std::string::npos);
  EXPECT_NE(ReadBytes(this->Path("out/guide-9.stl")).substr(0, 80).find("DOES NOT HOLD"),
    std::string::npos);
  EXPECT_EQ(ReadBytes(this->Path("out/guide-6.stl")).substr(0, 80).find("DOES NOT HOLD"),
    std::string::npos);
  ExpectFailure(this->Make("again", {}), 3, "guide 9: "); // kept, and red it stays
  const std::string shown = this->Plan({ "--show" }).out;
  EXPECT_NE(shown.find("guide 9 is in date and DOES NOT HOLD:\n  "), std::string::npos) << shown;
  EXPECT_NE(shown.find("guide 6 is in date and holds\n"), std::string::npos) << shown;
  const std::string part = this->Path("part.stl");
  ExpectFailure(this->Plan({ "--export", "9", "--output", part }), 3, "guide 9 does not hold");
  EXPECT_EQ(this->Plan({ "--export", "9", "--output", part, "--force" }).exitCode, 0);
}

TEST_F(HaspRunTest, DamageIsMendedAndAPlanAloneIsOnlyRead)
{
  ASSERT_EQ(this->Make("first", this->Scan()).exitCode, 0);
  const std::string before = ReadBytes(this->Path("case.hasp/plan.json"));
  const json run = json::parse(ReadBytes(this->Path("first/run.json")));
  const std::string blob = run.at("parts")[0].at("sha256");
  this->WriteText("case.hasp/blobs/" + blob, "damaged");
  ExpectFailure(this->Plan({ "--export", "4", "--output", this->Path("part.stl") }), 2,
    "blobs/" + blob.substr(0, 12) + " is damaged");
  std::vector<std::string> words = this->Scan();
  words.push_back("--json");
  const HaspRun mended = this->Make("mended", words);
  EXPECT_EQ(Made(mended), std::vector<int>{ 4 });
  EXPECT_NE(mended.err.find("fragment 4 is made anew: blobs/"), std::string::npos) << mended.err;
  EXPECT_EQ(this->Files("mended"), this->Files("first"));
  EXPECT_EQ(this->Plan({ "--check" }).exitCode, 0);

  fs::copy_file(this->Path("case.hasp/plan.json"), this->Path("plan.json"));
  const auto files = fs::file_size(this->Path("plan.json"));
  std::vector<std::string> alone{ "run", this->Path("plan.json"), "--volume", this->Path("leg.mha"),
    "--output", this->Path("alone"), "--json" };
  EXPECT_EQ(Made(RunHasp(alone)).size(), 6U); // its blobs are elsewhere
  EXPECT_EQ(this->Files("alone"), this->Files("first"));
  EXPECT_EQ(fs::file_size(this->Path("plan.json")), files);
  EXPECT_FALSE(fs::exists(this->Path("blobs")));
}

TEST_F(HaspRunTest, ATransplantsSegmentsLieInTheDefectAndOnTheDonor)
{
  this->Apply(json::array({ Transplant(1.5) }));
  std::vector<std::string> words = this->Scan();
  words.push_back("--json");
  ASSERT_EQ(Made(this->Make("first", words)).size(), 7U);
  auto files = this->Files("first");
  const auto corners = CornersOf(files.at("transplant-10.stl"));
  auto both = CornersOf(files.at("transplant-10-segment-1.stl"));
  for (const auto& corner : both)
    ASSERT_TRUE(corner[0] > 59.9F && corner[0] < 90.1F) << corner[0];
  const auto second = CornersOf(files.at("transplant-10-segment-2.stl"));
  both.insert(both.end(), second.begin(), second.end());
  EXPECT_EQ(both, corners);
  const json part = json::parse(files.at("run.json")).at("parts")[6];
  for (std::size_t n = 0; n < 2; ++n)
  {
    const json& segment = part.at("segments")[n];
    EXPECT_NEAR(segment.at("length_mm"), 30.0, 1e-9);
    const std::string name = segment.at("on_donor").at("file");
    EXPECT_EQ(name, "transplant-10-donor-segment-" + std::to_string(n + 1) + ".stl");
    for (const auto& corner : CornersOf(files.at(name)))
    {
      const double along = corner[2] + 170.0; // the axis leans by 5 mm in 170
      ASSERT_TRUE(along > double(segment.at("donor_from_mm")) - 1.0 &&
                  along < double(segment.at("donor_to_mm")) + 1.0 && std::abs(corner[0]) < 20.0);
    }
  }
  const json& joints = part.at("joints");
  EXPECT_TRUE(joints[0].at("gap_mm").is_null() && joints[2].at("overlap_mm").is_null());
  EXPECT_LT(joints[1].at("gap_mm").get<double>(), 0.1);
  EXPECT_LT(joints[1].at("overlap_mm").get<double>(), 0.1);
  EXPECT_GT(joints[1].at("contact_mm2").get<double>(), 50.0);
  EXPECT_EQ(Made(this->Make("second", { "--json" })), std::vector<int>{}); // of what was kept
  EXPECT_EQ(this->Files("second"), files);
}

} // namespace
