#include "PlannerProcess.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace
{

using Json = nlohmann::json;
using Rect = std::array<int, 4>;

constexpr int MostSteps = 200; // of the wheel, until a widget is seen

const Json* Find(const Json& layout, const std::string& name)
{
  if (layout.is_object())
    for (const Json& widget : layout["widgets"])
      if (widget["name"] == name)
        return &widget;
  return nullptr;
}

Rect RectOf(const Json& entry, const char* key = "rect")
{
  return entry.at(key).get<Rect>();
}

int MiddleX(const Rect& rect)
{
  return rect[0] + rect[2] / 2;
}

int MiddleY(const Rect& rect)
{
  return rect[1] + rect[3] / 2;
}

/// Where it takes clicks.
Rect HitOf(const Json& widget)
{
  return RectOf(widget, widget.contains("hit") ? "hit" : "rect");
}

/// The middle of that can be seen.
bool ShowsMiddle(const Json& widget)
{
  const Rect all = HitOf(widget), shown = RectOf(widget, "shown");
  return MiddleX(all) >= shown[0] && MiddleX(all) < shown[0] + shown[2] &&
         MiddleY(all) >= shown[1] && MiddleY(all) < shown[1] + shown[3];
}

std::string Decimal(double value)
{
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

} // namespace

const Json& PlannerProcess::Layout()
{
  this->ReadLayout();
  return this->Now;
}

bool PlannerProcess::Has(const std::string& name)
{
  this->WaitSettled();
  return Find(this->Now, name) != nullptr;
}

Json PlannerProcess::Widget(const std::string& name)
{
  this->WaitUntil(name + " on the screen", [&](const Json& now) { return Find(now, name); });
  this->WaitSettled();
  const Json* widget = Find(this->Now, name);
  if (!widget)
    this->Fail(name + " has gone again");
  return *widget;
}

Json PlannerProcess::State(const std::string& key)
{
  this->WaitSettled();
  return this->Now["state"].value(key, Json());
}

std::string PlannerProcess::Text(const std::string& name)
{
  return this->Widget(name).value("text", std::string());
}

/// Where it can be clicked on. Scrolls to it, as a user would: by the wheel above what is shown of
/// the place that it is in.
Json PlannerProcess::Ready(const std::string& name)
{
  this->WaitUntil(name + ", enabled",
    [&](const Json& now)
    {
      const Json* widget = Find(now, name);
      return widget && widget->value("enabled", true);
    });
  this->WaitSettled();
  this->ScrollTo(name);
  const Json widget = this->Widget(name);
  if (!widget.value("enabled", true))
    this->Fail(name + " is not enabled any more");
  return widget;
}

void PlannerProcess::ScrollTo(const std::string& name)
{
  Json widget = this->Widget(name);
  for (int step = 0; !ShowsMiddle(widget); ++step)
  {
    if (step > MostSteps || !widget.contains("area"))
      this->Fail(name + " cannot be scrolled to");
    const Rect rect = HitOf(widget), area = RectOf(widget, "area");
    const bool isBelow = MiddleY(rect) >= MiddleY(area);
    // At the margin: no spin box that would take the wheel is there.
    this->Act([&] { this->User.Wheel(area[0] + 2, MiddleY(area), isBelow ? -1 : 1); });
    widget = this->Widget(name);
  }
}

void PlannerProcess::Click(const std::string& name, int button)
{
  const Rect rect = HitOf(this->Ready(name));
  this->Act([&] { this->User.Click(MiddleX(rect), MiddleY(rect), button); });
}

void PlannerProcess::DoubleClick(const std::string& name)
{
  const Rect rect = RectOf(this->Ready(name));
  this->Act([&] { this->User.DoubleClick(MiddleX(rect), MiddleY(rect)); });
}

Json PlannerProcess::Row(const std::string& name, const std::function<bool(const Json&)>& fits)
{
  const Json widget = this->Ready(name);
  for (const Json& row : widget.value("rows", Json::array()))
    if (fits(row))
      return row;
  this->Fail("no such row in " + name);
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
  this->Click("fileNameEdit"); // QFileDialog's
  this->Key("ctrl+a");
  this->Type(path);
  this->Key("Return");
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
