#pragma once
#include <QImage>

#include <chrono>
#include <cstddef>

namespace hasp
{

class FrameView;
class PlannerWindow;

/// What measurements in the window share. Threads: RENDER; all handle the window's events
/// meanwhile.

using Clock = std::chrono::steady_clock;
double MsSince(Clock::time_point start);
/// Since this process was started, whoever started it.
double SinceStartS();

/// Until no job runs and no frame is to come. Throws std::runtime_error after two minutes.
void WaitSettled(PlannerWindow& window);
/// All that has been asked of OpenGL for the view is done.
void FinishDrawing(FrameView& view);
/// Until the next frame is there, drawn to its end, at most 10 s. Throws likewise.
void WaitFrame(FrameView& view);
/// Asks for a frame and waits for it: how long that took.
double DrawnMs(FrameView& view);
/// Handles events for so long.
void Spend(double seconds);

/// Root mean square of the differences of all channels, 0 to 255, at the second one's size.
double RmsBetween(const QImage& picture, const QImage& full);
std::size_t ResidentBytes(); ///< of this process

} // namespace hasp
