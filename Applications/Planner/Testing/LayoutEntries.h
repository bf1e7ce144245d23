#pragma once
#include <nlohmann/json.hpp>

#include <array>
#include <string>

/// A layout file's widgets (Window/LayoutWidgets.h), as PlannerProcess reads them.
namespace layout
{

using Json = nlohmann::json;
using Rect = std::array<int, 4>;

inline const Json* Find(const Json& layout, const std::string& name)
{
  if (layout.is_object())
    for (const Json& widget : layout["widgets"])
      if (widget["name"] == name)
        return &widget;
  return nullptr;
}

inline Rect RectOf(const Json& entry, const char* key = "rect")
{
  return entry.at(key).get<Rect>();
}

inline int MiddleX(const Rect& rect)
{
  return rect[0] + rect[2] / 2;
}

inline int MiddleY(const Rect& rect)
{
  return rect[1] + rect[3] / 2;
}

/// Where it takes clicks.
inline Rect HitOf(const Json& widget)
{
  return RectOf(widget, widget.contains("hit") ? "hit" : "rect");
}

} // namespace layout
