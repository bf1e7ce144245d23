#include "GuideRecipeFixture.h"

#include <cstring>
#include <filesystem>

namespace
{

using nlohmann::json;

class HaspCertify : public GuideRecipeTest
{
protected:
  void SetUp() override
  {
    this->FinePhantom();
    ASSERT_EQ(this->Guide(Recipe()).exitCode, 0);
  }
  HaspRun Certify(const std::string& part, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> words{ "certify", this->Path(part), "--bone", this->Path("head.mha"),
      "--recipe", this->Path("recipe.json") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  /// A page that needs nothing else and gives nothing away; without its pictures.
  std::string Page(const std::string& name) const
  {
    std::string page = ReadBytes(this->Path(name));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>")) << name;
    EXPECT_TRUE(page.ends_with("</html>\n")) << name;
    EXPECT_NE(page.find("Research use only, not a medical device."), std::string::npos);
    EXPECT_NE(page.find("CGAL (GPL) is "), std::string::npos);
    this->Pictures = 0;
    for (std::size_t at = 0; (at = page.find("base64,", at)) != std::string::npos; ++this->Pictures)
    {
      at += 7;
      EXPECT_EQ(page.compare(at, 8, "iVBORw0K"), 0); // "\x89PNG\r\n"
      page.erase(at, page.find('"', at) - at);
    }
    const std::string folder = this->folder.filename().string();
    for (const std::string& word :
      std::vector<std::string>{ "http", "<script", "rika", ".stl", ".json", folder })
      EXPECT_EQ(page.find(word), std::string::npos) << word;
    return page;
  }
  mutable int Pictures = 0;
  /// The guide's bytes with every coordinate of its corners times a factor.
  void WriteScaled(const std::string& name, float factor) const
  {
    std::string bytes = ReadBytes(this->Path("guide.stl"));
    for (std::size_t triangle = 84; triangle < bytes.size(); triangle += 50)
      for (std::size_t n = 3; n < 12; ++n)
      {
        float value;
        std::memcpy(&value, &bytes[triangle + 4 * n], 4);
        value *= factor;
        std::memcpy(&bytes[triangle + 4 * n], &value, 4);
      }
    this->WriteText(name, bytes);
  }
};

TEST_F(HaspCertify, WhatIsNoPartIsRefused)
{
  ExpectFailure(this->Certify("recipe.json"), 1, "PART must be a surface");
  ExpectFailure(this->Certify("none.stl"), 2, "the .stl file: no such file");
  this->WriteText("cut.stl", ReadBytes(this->Path("guide.stl")).substr(0, 5000));
  ExpectFailure(this->Certify("cut.stl"), 2, "the .stl file");
  this->WriteText("recipe.json", "{");
  ExpectFailure(this->Certify("guide.stl"), 2, "the .json file: recipe: no JSON");
}

TEST_F(HaspCertify, WithoutARecipeNothingIsSaidToHold)
{
  const HaspRun run = RunHasp({ "certify", this->Path("guide.stl"), "--bone",
    this->Path("head.mha"), "--json", "--html", this->Path("a.html") });
  const json certificate = json::parse(run.out).at("certificate");
#if HASP_WITH_CGAL
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_TRUE(certificate.at("passed").is_null());
  EXPECT_EQ(certificate.at("verdict"), "the mesh is sound; not held to a recipe");
  EXPECT_EQ(this->Page("a.html").find("The part holds"), std::string::npos);
#else
  EXPECT_EQ(certificate.at("passed"), false);
#endif
}

TEST_F(HaspCertify, AFileThatSaysItDoesNotHoldNeverDoes)
{
  ASSERT_EQ(this->Guide(Recipe(), { "--check", "--least-share", "1", "--force" }).exitCode, 0);
  const HaspRun run = this->Certify("guide.stl", { "--json" }); // by the usual share
  ExpectFailure(run, 3, "its file says that it DOES NOT HOLD");
  EXPECT_EQ(json::parse(run.out).at("certificate").at("faults").back().at("kind"), "said-red");
  ExpectFailure(RunHasp({ "certify", this->Path("guide.stl"), "--bone", this->Path("head.mha") }),
    3, "its file says that it DOES NOT HOLD");
}

TEST_F(HaspCertify, FaultsAreToldOnceAndWhatCannotBeWrittenFirst)
{
  this->WriteScaled("inch.stl", 1.0F / 25.4F);
  const HaspRun run = this->Certify("inch.stl");
  ExpectFailure(run, 3, "it is in inches, and fits in millimetres");
  EXPECT_EQ(run.out.find("it is in inches"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("verdict             DOES NOT HOLD"), std::string::npos);
  this->WriteScaled("metre.stl", 1.0F / 1000.0F);
  ExpectFailure(this->Certify("metre.stl"), 3, "it is in metres, and fits in millimetres");
  const HaspRun late =
    this->Certify("guide.stl", { "--html", this->Path(std::string(300, 'x') + ".html") });
  ExpectFailure(late, 1, "cannot write the .html file");
  EXPECT_EQ(late.out, "");
}

TEST_F(HaspCertify, APageSaysWhatWasFoundAndHowItWasForced)
{
  json recipe = Recipe();
  recipe["note"] = "Erika's guide";
  std::vector<std::string> words{ "--check", "--least-share", "1", "--html", this->Path("a.html") };
  ASSERT_EQ(this->Guide(recipe, words).exitCode, 3);
  const std::string refused = this->Page("a.html");
  EXPECT_NE(refused.find("<h1 class=\"bad\">The part DOES NOT HOLD</h1>\n<p><b>The guide was not "
                         "kept.</b>"),
    std::string::npos);
  EXPECT_NE(refused.find("<li>only "), std::string::npos); // "... % of the inner wall is within"
  EXPECT_NE(refused.find("<td class=\"bad\">does not hold</td>"), std::string::npos);
  EXPECT_NE(refused.find("<rect "), std::string::npos); // of the histogram
#if HASP_WITH_PICTURES
  EXPECT_EQ(this->Pictures, 4);                            // three sides, and the inner wall
  EXPECT_NE(refused.find("url(#gap)"), std::string::npos); // its scale
#else
  EXPECT_NE(refused.find("There are none: "), std::string::npos);
#endif
  words.push_back("--force");
  ASSERT_EQ(this->Guide(recipe, words).exitCode, 0);
  EXPECT_NE(this->Page("a.html").find("<p><b>It was forced: "), std::string::npos);
  ExpectFailure(this->Guide(recipe, { "--html", this->Path("a.html") }), 1, "--check");
}

TEST_F(HaspCertify, EqualPartsMakeEqualPages)
{
  for (const char* page : { "a.html", "b.html" })
    EXPECT_LE(this->Certify("guide.stl", { "--html", this->Path(page) }).exitCode, 3);
  EXPECT_EQ(ReadBytes(this->Path("a.html")), ReadBytes(this->Path("b.html")));
  const std::string page = this->Page("a.html");
  // Of part and recipe: 64 hexadecimal digits each, where there is OpenSSL.
  const std::size_t part = page.find("<code>"), recipe = page.rfind("<code>");
  if (part != std::string::npos)
  {
    EXPECT_NE(page.substr(part, 70), page.substr(recipe, 70));
    EXPECT_EQ(page.find("</code>", part), part + 70);
  }
#if HASP_WITH_CGAL
  EXPECT_NE(page.find("<h1 class=\"good\">The part holds</h1>"), std::string::npos);
#endif
  ExpectFailure(this->Certify("guide.stl", { "--html", this->Path("a.txt") }), 1, ".html");
}

#if HASP_WITH_CGAL
TEST_F(HaspCertify, AGuideAsItsRecipeHasItHolds)
{
  const HaspRun run = this->Certify("guide.stl", { "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err << run.out;
  const json certificate = json::parse(run.out).at("certificate");
  EXPECT_EQ(certificate.at("format"), "hasp-certificate-1");
  EXPECT_EQ(certificate.at("passed"), true);
  EXPECT_TRUE(certificate.at("faults").empty());
  EXPECT_EQ(certificate.at("mesh").at("self_intersections"), 0);
  EXPECT_NEAR(certificate.at("gap").at("p50_mm").get<double>(), 0.4, 0.05);
  EXPECT_NEAR(certificate.at("shell").at("p50_mm").get<double>(), 3.0, 0.1);
  EXPECT_EQ(certificate.at("insertion").at("blocked"), 0);
  // All that a page with pictures needs: areas of the histogram are those of the inner wall.
  double area = 0.0;
  for (const double mm2 : certificate.at("gap").at("histogram").at("area_mm2"))
    area += mm2;
  EXPECT_NEAR(area, certificate.at("gap").at("inner_wall_mm2").get<double>(), 1e-6);
  EXPECT_NE(this->Certify("guide.stl").out.find("verdict             holds"), std::string::npos);
}
#endif

TEST_F(HaspCertify, APartThatDoesNotHoldIsThreeAndSaysWhy)
{
  this->WriteScaled("inch.stl", 1.0F / 25.4F);
  const HaspRun inch = this->Certify("inch.stl", { "--json" });
  ExpectFailure(inch, 3, "it is in inches, and fits in millimetres");
  EXPECT_EQ(json::parse(inch.out).at("certificate").at("faults").at(0).at("kind"), "units");
  json recipe = Recipe();
  recipe["gapMm"] = 0.9;
  recipe["holes"] = { { { "point", recipe["landmarks"][1] }, { "axis", recipe["withdrawal"] },
    { "diameterMm", 2.0 } } };
  this->WriteText("recipe.json", recipe.dump());
  const HaspRun run = this->Certify("guide.stl");
  ExpectFailure(run, 3, "of the gap of 0.90");
  ExpectFailure(run, 3, "holes[0] is blocked, at (");
  EXPECT_NE(run.out.find("DOES NOT HOLD"), std::string::npos);
}

} // namespace
