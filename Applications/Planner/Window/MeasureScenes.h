#pragma once

namespace hasp
{

class PlannerWindow;

/// Plans to measure in the window. Each is shown, from the front, and at rest when these return.
/// Threads: RENDER. Throw std::runtime_error if the window does not come to rest.

/// A phantom of so many samples a side, and nothing else.
void ShowPhantom(PlannerWindow& window, int size);
/// A small phantom with a fragment, a cut through it, and a surface: its scan and its surface are
/// kept, so that the plan shows all of it again when it is opened.
void ShowSmallCase(PlannerWindow& window);
/// A broken mandible with its true labels as fragments, the first locked.
void ShowBrokenJaw(PlannerWindow& window);

} // namespace hasp
