#pragma once

class QMenu;

namespace hasp
{

struct Planner;

/// Adds "3D view" to the View menu: how the scan is shown there besides its bone (translucent skin,
/// where it begins, the brightest values). All are off at first, and stay as they are when another
/// plan comes. Threads: RENDER.
void AddSceneLooks(QMenu& menu, Planner& planner);

} // namespace hasp
