#pragma once

namespace hasp
{

class PlannerWindow;

/// All keys and what the mouse does, in a window that need not be closed to go on working. Keys of
/// menus are read from the menus, so that none is told wrong. Threads: RENDER.
void ShowKeysPage(PlannerWindow& window);

/// What this is, which version, and what it is not for.
void ShowAboutPage(PlannerWindow& window);

} // namespace hasp
