#include "PlannerDesk.h"

#include <array>
#include <fstream>
#include <stdexcept>
#include <thread>

// The driver of windows, on a program of a few widgets: LayoutSubject.
namespace
{

using Json = nlohmann::json;
using LayoutFile = PlannerDesk;
namespace fs = std::filesystem;

TEST_F(LayoutFile, WhatDoesNotComeFailsWithWhatIsOnTheScreen)
{
  const auto subject = this->Open();
  subject->patienceS = 0.2;
  try
  {
    subject->Click("no.such.widget");
    FAIL() << "it clicked on nothing";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("no.such.widget"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("\"add\""), std::string::npos) << "not its layout";
  }
}

TEST_F(LayoutFile, WhatIsNotEnabledIsNotClickedOn)
{
  const auto subject = this->Open();
  subject->patienceS = 0.2;
  EXPECT_THROW(subject->Click("off"), std::runtime_error);
}

TEST_F(LayoutFile, AnEndedProgramIsNotWaitedFor)
{
  const auto subject = this->Open();
  subject->Kill9();
  EXPECT_EQ(subject->ExitCode(), 128 + SIGKILL);
  EXPECT_THROW(subject->Click("add"), std::runtime_error);
}

TEST_F(LayoutFile, AFileThatCannotBeWrittenIsSaid)
{
  fs::create_directories(this->folder / "home/layout.json.part"); // where it would be written
  try
  {
    PlannerProcess({ this->Screen.Display(), this->folder / "home", {}, 1.0 });
    FAIL() << "a folder is no file";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("cannot be written"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find(Canary), std::string::npos);
  }
}

TEST_F(LayoutFile, EachClickCountsOnce)
{
  const auto subject = this->Open();
  for (int n = 1; n <= 3; ++n)
  {
    subject->Click("add");
    EXPECT_EQ(subject->Text("count"), std::to_string(n));
  }
  EXPECT_EQ(subject->Effort().clicks, 3u);
  EXPECT_EQ(subject->Effort().keys, 0u);
}

TEST_F(LayoutFile, EachEventIsCountedOnce)
{
  const auto subject = this->Open();
  const auto grows = [&](const std::function<void()>& act)
  {
    const int before = subject->State("events");
    act();
    return subject->State("events").get<int>() - before;
  };
  EXPECT_EQ(grows([&] { subject->Click("add"); }), 2); // down and up
  EXPECT_EQ(grows([&] { subject->Wheel("area", 0.5, 0.5, -3); }), 3);
  EXPECT_EQ(grows([&] { subject->Drag("area", 0.2, 0.2, 0.4, 0.4); }), 2);
  EXPECT_EQ(grows([&] { subject->Key("ctrl+m"); }), 2); // a shortcut, which comes as no key
  EXPECT_EQ(grows([&] { subject->Type("nnnn"); }), 4);  // in one millisecond: as if it repeated
}

TEST_F(LayoutFile, KeysGoToTheWindowOnTop)
{
  const auto subject = this->Open();
  subject->Key("ctrl+m");
  EXPECT_EQ(subject->Text("count"), "1") << "the window had no keyboard before the first click";
  subject->Click("ask");
  subject->Key("Escape");
  subject->Key("ctrl+m");
  EXPECT_EQ(subject->Text("count"), "2") << "the window did not get the keyboard back";
  subject->Key("alt+a");
  EXPECT_EQ(subject->Text("count"), "3");
  EXPECT_EQ(subject->Effort().keys, 4u);
}

TEST_F(LayoutFile, AClickWaitsForTheJobThatItBegins)
{
  const auto subject = this->Open();
  subject->Click("slow");
  EXPECT_EQ(subject->Text("count"), "100");
  const UserEffort effort = subject->Effort();
  EXPECT_GE(effort.ofThemBusyS, 0.5); // the job takes 1 s; files come 50 ms apart
  EXPECT_GE(effort.machineWaitS, effort.ofThemBusyS);
}

TEST_F(LayoutFile, DialogsAreNamedAndAnswered)
{
  const auto subject = this->Open();
  EXPECT_TRUE(subject->Layout()["modal"].is_null());
  subject->Click("ask");
  EXPECT_EQ(subject->Layout()["modal"]["name"], "sure");
  EXPECT_EQ(subject->Text("sure.text"), "Add a thousand?");
  subject->Click("sure.cancel");
  EXPECT_EQ(subject->Text("count"), "0");
  subject->Click("ask");
  subject->Click("sure.yes");
  EXPECT_EQ(subject->Text("count"), "1000");
  EXPECT_TRUE(subject->Layout()["modal"].is_null());
}

TEST_F(LayoutFile, EachKindOfWidgetTakesWhatItIsGiven)
{
  const auto subject = this->Open();
  subject->SetNumber("number", -12.5);
  EXPECT_EQ(subject->Widget("number")["value"], -12.5);
  EXPECT_EQ(subject->Text("number"), "-12.50 mm");
  subject->Choose("combo", 2);
  EXPECT_EQ(subject->Widget("combo")["index"], 2);
  subject->SetText("line", "A b+c/9");
  EXPECT_EQ(subject->Widget("line")["length"], 7);
  EXPECT_FALSE(subject->Widget("line").contains("text"));
  subject->SetChecked("check", true);
  EXPECT_EQ(subject->Widget("check")["checked"], true);
  subject->SetChecked("check", true);
  EXPECT_EQ(subject->Widget("check")["checked"], true);
  subject->SetChecked("group", false);
  EXPECT_EQ(subject->Widget("group")["checked"], false);
  subject->ClickRow("tabs", 1);
  EXPECT_TRUE(subject->Has("second"));
  EXPECT_FALSE(subject->Has("first"));
  subject->Menu({ "menu.count", "count.once" });
  EXPECT_EQ(subject->Text("count"), "1");
}

TEST_F(LayoutFile, FilesAreAnsweredAndNoPathIsShown)
{
  const auto subject = this->Open();
  std::ofstream(this->folder / "a_file-1.txt") << "text";
  subject->Click("open");
  EXPECT_EQ(subject->Layout()["modal"]["class"], "QFileDialog");
  EXPECT_EQ(subject->Layout().dump().find(Canary), std::string::npos);
  subject->AnswerFile((this->folder / "a_file-1.txt").string());
  EXPECT_EQ(subject->Text("file"), "a_file-1.txt");
}

TEST_F(LayoutFile, RowsAreFoundByTheirIds)
{
  const auto subject = this->Open();
  subject->ClickId("list", 12);
  const Json rows = subject->Widget("list")["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["selected"], false);
  EXPECT_EQ(rows[1]["selected"], true);
  EXPECT_THROW(subject->ClickId("list", 13), std::runtime_error);
}

TEST_F(LayoutFile, WhatIsBelowIsScrolledTo)
{
  const auto subject = this->Open();
  EXPECT_EQ(subject->Widget("below")["shown"][3], 0);
  subject->Click("below");
  EXPECT_EQ(subject->Text("count"), "10");
}

TEST_F(LayoutFile, WordsOfTheUserAreLeftOut)
{
  const auto subject = this->Open();
  EXPECT_FALSE(subject->Widget("secret").contains("text"));
  EXPECT_EQ(subject->Layout().dump().find("herd"), std::string::npos);
}

TEST_F(LayoutFile, AnIdleProgramWritesNothing)
{
  const auto subject = this->Open();
  subject->Click("line"); // where a cursor blinks: events, and nothing new
  const auto written = fs::last_write_time(this->folder / "home/layout.json");
  std::this_thread::sleep_for(std::chrono::milliseconds(1200)); // it blinks each 500 ms
  EXPECT_EQ(fs::last_write_time(this->folder / "home/layout.json"), written);
}

TEST_F(LayoutFile, GoesWithItsProgram)
{
  const auto subject = this->Open();
  subject->CloseWindow();
  EXPECT_EQ(subject->ExitCode(), 0);
  EXPECT_EQ(subject->Output(), "");
  EXPECT_FALSE(fs::exists(this->folder / "home/layout.json"));
}

TEST_F(LayoutFile, TheLastClickEndsItsProgram)
{
  EXPECT_EQ(this->Open()->ClickToEnd("quit"), 0);
}

TEST_F(LayoutFile, APictureShowsTheWindow)
{
  const auto subject = this->Open();
  const fs::path png = this->folder / "screen.png";
  subject->SavePicture(png);
  const QImage picture(QString::fromStdString(png.string()));
  ASSERT_EQ(picture.size(), QSize(1280, 800));
  const auto rect = subject->Widget("add")["rect"].get<std::array<int, 4>>();
  bool someInk = false; // letters on a button
  for (int x = rect[0]; x < rect[0] + rect[2]; ++x)
    someInk = someInk || qGray(picture.pixel(x, rect[1] + rect[3] / 2)) < 100;
  EXPECT_TRUE(someInk);
}

} // namespace
