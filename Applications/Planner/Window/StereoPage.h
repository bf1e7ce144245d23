#pragma once

class QMenu;

namespace hasp
{

class PlannerWindow;

/// Adds the actions of stereo to the View menu: `3` shows the scene for two eyes in a second
/// window, and puts it away; "Stereo settings" sets it up in millimetres, with the drawn sketch.
/// Threads: RENDER.
void AddStereoActions(QMenu& menu, PlannerWindow& window);

} // namespace hasp
