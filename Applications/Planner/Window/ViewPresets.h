#pragma once
class QMenu;

namespace hasp
{

struct Planner;

/// Where to look from, and which grey values the slices show: fixed choices, each with a key.
/// Threads: RENDER.
void AddViewPresets(QMenu& menu, Planner& planner);

} // namespace hasp
