// A patient's name in all that is fed to the program, and where it goes: nowhere.
#include "../../CommandLine/Testing/CanaryFiles.h"
#include "../../CommandLine/Testing/HaspProcess.h"
#include "LeakSearch.h"
#include "WholeWay.h"

#include <QByteArray>

namespace
{
namespace fs = std::filesystem;

/// From the front, in the large view: the phantom's forehead.
constexpr std::array<std::array<double, 2>, 4> Forehead{ { { 0.56, 0.40 }, { 0.57, 0.37 },
  { 0.58, 0.34 }, { 0.59, 0.31 } } };

class PlannerCanary : public WholeWay
{
protected:
  fs::path Names() const { return this->folder / canary::Name(); }

  /// A head whose header, name and folder name a patient.
  std::string Head() const
  {
    const std::string plain = this->Path("plain.mha"),
                      named = this->Names() / (canary::Name() + "-head.mha");
    const HaspRun run = RunHasp({ "phantom", "--spacing", "2,2,2", "--quiet", "--output", plain });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::string bytes = ReadBytes(plain);
    bytes.insert(bytes.find("ElementDataFile"), "Comment = " + canary::Name() + "\nPatientName = " +
                                                  canary::Family + "^" + canary::Given + "\n");
    canary::WriteTo(named, bytes);
    return named;
  }
  void Note(PlannerProcess& planner, const std::string& when)
  {
    this->Seen["layout " + when] = planner.Layout().dump();
    this->Seen["title " + when] = TitlesOn(this->Screen.Display());
  }
  /// One more object than before, or why not.
  static void ExpectTaken(PlannerProcess& planner, const std::function<void()>& import)
  {
    const Json before = planner.State("plan");
    import();
    EXPECT_NE(planner.State("plan"), before) << planner.State("message");
  }
  void ImportAll(PlannerProcess& planner)
  {
    const std::string head = this->Head();
    const std::string triangle = canary::MakeSurfaces(this->Names()).front().path;
    ExpectTaken(planner, [&] { Import(planner, triangle); });
    planner.Key("ctrl+z"); // it is open, and no part is made of it
    const auto slices = canary::MakeDicomFolders(this->Names()).front();
    ASSERT_TRUE(slices.opens);
    ExpectTaken(planner, [&] { ImportFolder(planner, slices.path); });
    const fs::path broken = this->Names() / (canary::Name() + "-broken.mha");
    canary::WriteTo(broken, "ObjectType = Image\nName = " + canary::Name() + "\n");
    Import(planner, broken);
    EXPECT_NE(planner.State("message"), "") << "it was taken";
    this->Note(planner, "with a fault");
    ExpectTaken(planner, [&] { Import(planner, head); });
  }
  void PlanGuide(PlannerProcess& planner)
  {
    planner.Key("alt+1");
    planner.Key("ctrl+m");
    planner.Click("step.guide");
    planner.Click("guide.new");
    for (const auto& [x, y] : Forehead)
      planner.ClickAt("view.scene", x, y);
    planner.Key("Escape");
    Picture(planner, "PlannerCanaryGuide");
  }
  /// A case, all of its files, and a program that is killed with something not saved.
  void Plan(const std::string& caseLabel)
  {
    const auto planner =
      this->Begin({ "--study", this->Path("study"), "--operator", "A", "--trial", "1" });
    this->ImportAll(*planner);
    planner->SetText("import.case", caseLabel);
    this->PlanGuide(*planner);
    const std::string said = MakeAll(*planner);
    EXPECT_NE(said.find("is made: green."), std::string::npos) << said;
    ExportAll(*planner, this->Path("parts"));
    planner->Choose("export.format", 1);
    ExportAll(*planner, this->Path("others"));
    planner->SetChecked("export.report.names", true);
    WriteReport(*planner, this->Path("report.html"));
    this->Note(*planner, "at the end");
    SaveAs(*planner, (this->folder / "home/Hasp/case.hasp").string());
    planner->Click("step.import");
    planner->SetNumber("import.thickness", 3);
    planner->SetText("import.case", caseLabel + "-2");
    this->Seen["output"] = planner->Output();
    planner->Kill9();
  }
  /// The window as a picture, as --screenshot has it, and its list of recent plans.
  void LookAgain()
  {
    const std::string picture = this->Path("window.png");
    const auto planner = this->Begin({ "--screenshot", picture });
    planner->WaitUntil("the picture", [&](const Json&) { return fs::exists(picture); });
    planner->Menu({ "menu.file", "menu.recent" });
    this->Note(*planner, "with recent plans");
    planner->Key("Escape");
    planner->Key("Escape");
    planner->CloseWindow();
    EXPECT_EQ(planner->ExitCode(), 0);
    this->Seen["output again"] = planner->Output();
  }
  /// Where a token is, by the file's name or what was seen; with what was found.
  std::map<std::string, std::string> Leaks() const
  {
    std::map<std::string, std::string> all = this->Seen, found;
    for (const char* part : { "home", "parts", "others", "study" })
      for (auto& [name, bytes] : FilesBelow(this->folder / part))
        all[std::string(part) + "/" + name] = std::move(bytes);
    for (const char* file : { "report.html", "report.pdf", "window.png" })
      all[file] = ReadBytes(this->Path(file));
    for (const auto& [name, bytes] : all)
      if (const std::string leaks = LeaksIn(name) + LeaksIn(bytes); !leaks.empty())
        found[name] = leaks;
    for (const char* written : { "study/A-1.jsonl", "parts/guide-5.stl", "others/guide-5.3mf",
           "home/state/hasp-planner/recent.json", "window.png" })
      EXPECT_TRUE(all.contains(written)) << written;
    const Json plan = Json::parse(all.at("home/Hasp/case.hasp/plan.json")).at("plan");
    EXPECT_EQ(plan.at("volumes").size(), 2U) << "not all was imported";
    return found;
  }

  std::map<std::string, std::string> Seen;
};

TEST_F(PlannerCanary, NoNameOfAPatientIsInWhatThePlannerWritesShowsOrKeeps)
{
  this->Plan("K-17");
  this->LookAgain();
  EXPECT_EQ(this->Leaks(), (std::map<std::string, std::string>()));
}

/// The same with a name where the user's own words go: if it is not found there, nothing above is.
TEST_F(PlannerCanary, ANameThatAUserTypesIsFoundWhereTheUsersWordsGo)
{
  this->Plan(canary::Family);
  this->LookAgain();
  std::string where;
  for (const auto& [name, leaks] : this->Leaks())
    where += name + "\n";
  for (const char* place : { "home/Hasp/case.hasp/plan.json", "home/state/hasp-planner/work/",
         "home/state/hasp-planner/recent.json", "report.html", "title at the end" })
    EXPECT_NE(where.find(place), std::string::npos) << place << " is not among\n" << where;
}

TEST(LeakSearch, FindsANameHoweverItIsPacked)
{
  const std::string name = "of " + canary::Name(), plain = "nothing of the kind";
  const auto wide = [](const std::string& text)
  {
    std::string all;
    for (const char letter : text)
      all += std::string(1, '\0') + letter;
    return all;
  };
  const auto packed = [](const std::string& text)
  { return qCompress(QByteArray::fromStdString(text)).mid(4).toStdString(); };
  const auto zip = [&](const std::string& text)
  { return std::string("PK\3\4", 4) + std::string(26, '\0') + packed(text).substr(2); };
  const auto page = [&](const std::string& text)
  {
    return "<img src=\"data:image/png;base64," +
           QByteArray::fromStdString(packed(text)).toBase64().toStdString() + "\">";
  };
  for (const auto& pack :
    { std::function<std::string(const std::string&)>(wide), { packed }, { zip }, { page } })
  {
    EXPECT_NE(LeaksIn(pack(name)), "");
    EXPECT_EQ(LeaksIn(pack(plain)), "");
  }
}

} // namespace
