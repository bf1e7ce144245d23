#pragma once
#include <nlohmann/json.hpp>

#include <QStringList>

namespace hasp
{

class PlannerWindow;

/// What LayoutFile says of the program: "busy", "pending", "step", "frames", "plan" (its hash),
/// "message", "modified". No word of the user's.
nlohmann::ordered_json StateOf(const PlannerWindow& window);

/// The user's words in the plan, which no text of that file may hold.
QStringList WordsOf(const PlannerWindow& window);

} // namespace hasp
