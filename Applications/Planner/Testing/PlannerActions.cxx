// What PlannerProcess does.
#include "LayoutEntries.h"
#include "PlannerProcess.h"

#include <array>
#include <cmath>
#include <cstdio>

using namespace layout;

namespace
{

constexpr int MostTries = 4; // of a path

std::string Decimal(double value)
{
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

} // namespace

void PlannerProcess::Click(const std::string& name, int button)
{
  const Rect rect = HitOf(this->Ready(name));
  this->Act([&] { this->User.Click(MiddleX(rect), MiddleY(rect), button); });
}

int PlannerProcess::ClickToEnd(const std::string& name)
{
  const Rect rect = HitOf(this->Ready(name));
  this->User.Click(MiddleX(rect), MiddleY(rect));
  return this->ExitCode();
}

void PlannerProcess::DoubleClick(const std::string& name)
{
  const Rect rect = RectOf(this->Ready(name));
  this->Act([&] { this->User.DoubleClick(MiddleX(rect), MiddleY(rect)); });
}

void PlannerProcess::ClickId(const std::string& name, long long id, int column, int button)
{
  const Rect rect = RectOf(this->Row(name, [&](const Json& row)
    { return row.value("id", Json()) == id && row.value("column", 0) == column; }));
  this->Act([&] { this->User.Click(MiddleX(rect), MiddleY(rect), button); });
}

void PlannerProcess::ClickRow(const std::string& name, int row, int column)
{
  const Rect rect = RectOf(this->Row(
    name, [&](const Json& of) { return of["row"] == row && of.value("column", 0) == column; }));
  this->Act([&] { this->User.Click(MiddleX(rect), MiddleY(rect)); });
}

void PlannerProcess::ClickAt(const std::string& name, double x, double y, int button)
{
  const Rect rect = RectOf(this->Ready(name));
  this->Act(
    [&]
    {
      this->User.Click(rect[0] + static_cast<int>(std::lround(x * rect[2])),
        rect[1] + static_cast<int>(std::lround(y * rect[3])), button);
    });
}

void PlannerProcess::Drag(
  const std::string& name, double fromX, double fromY, double toX, double toY, int button)
{
  const Rect rect = RectOf(this->Ready(name));
  const auto x = [&](double share) { return rect[0] + static_cast<int>(share * rect[2]); };
  const auto y = [&](double share) { return rect[1] + static_cast<int>(share * rect[3]); };
  this->Act([&] { this->User.Drag(x(fromX), y(fromY), x(toX), y(toY), button); });
}

void PlannerProcess::Wheel(const std::string& name, double x, double y, int steps)
{
  const Rect rect = RectOf(this->Ready(name));
  this->Act(
    [&]
    {
      this->User.Wheel(
        rect[0] + static_cast<int>(x * rect[2]), rect[1] + static_cast<int>(y * rect[3]), steps);
    });
}

void PlannerProcess::Choose(const std::string& combo, int index)
{
  this->Click(combo);
  this->Key("Home");
  for (int n = 0; n < index; ++n)
    this->Key("Down");
  this->Key("Return");
  if (this->Widget(combo).value("index", -1) != index)
    this->Fail(combo + " does not take entry " + std::to_string(index));
}

void PlannerProcess::SetNumber(const std::string& spin, double value)
{
  this->SetText(spin, Decimal(value));
}

void PlannerProcess::SetText(const std::string& line, const std::string& latin1)
{
  this->Click(line);
  this->Key("ctrl+a");
  this->Type(latin1);
  this->Key("Tab");
}

void PlannerProcess::SetChecked(const std::string& name, bool checked)
{
  if (this->Ready(name).value("checked", false) != checked)
    this->Click(name);
}

void PlannerProcess::AnswerFile(const std::string& path)
{
  // Qt selects what the typed text names so far, and may still have a folder on the way there when
  // Return comes: then it goes into that, and empties the line. As a user would: once more.
  const auto isEmptied = [this]
  { return this->Has("fileNameEdit") && this->Widget("fileNameEdit").value("length", 0) == 0; };
  for (int tries = 0; tries == 0 || isEmptied(); ++tries)
  {
    if (tries == MostTries)
      this->Fail("the dialog does not take the path");
    this->Click("fileNameEdit"); // QFileDialog's
    this->Key("ctrl+a");
    this->Type(path);
    this->Key("Return");
  }
}

void PlannerProcess::Menu(const std::vector<std::string>& path)
{
  for (const std::string& name : path)
    this->Click(name);
}

void PlannerProcess::Key(const std::string& keys)
{
  this->Act([&] { this->User.Key(keys); });
}

void PlannerProcess::Type(const std::string& latin1)
{
  this->Act([&] { this->User.Type(latin1); });
}
