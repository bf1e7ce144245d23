// What PlannerProcess sees on the screen.
#include "LayoutEntries.h"
#include "PlannerProcess.h"

using namespace layout;

namespace
{

constexpr int MostSteps = 200; // of the wheel, until a widget is seen

/// The middle of that can be seen.
bool ShowsMiddle(const Json& widget)
{
  const Rect all = HitOf(widget), shown = RectOf(widget, "shown");
  return MiddleX(all) >= shown[0] && MiddleX(all) < shown[0] + shown[2] &&
         MiddleY(all) >= shown[1] && MiddleY(all) < shown[1] + shown[3];
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

Json PlannerProcess::Row(const std::string& name, const std::function<bool(const Json&)>& fits)
{
  const Json widget = this->Ready(name);
  for (const Json& row : widget.value("rows", Json::array()))
    if (fits(row))
      return row;
  this->Fail("no such row in " + name);
}
