#pragma once
#include "Devices/HeadPose.h"
#include "StereoWindow.h"

/// A tracker's pose as the eyes of a window. Pure functions; any thread.
namespace hasp
{

StereoHead HeadOf(const HeadPose& pose, double eyeSeparationMm);

/// By what can be seen: more than 0.1 mm or 0.02 degrees.
bool Differ(const HeadPose& a, const HeadPose& b);

/// Can both eyes be drawn?
bool Sees(const StereoHead& head, const StereoWindow& window);

} // namespace hasp
