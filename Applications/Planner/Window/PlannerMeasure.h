#pragma once
#include <nlohmann/json_fwd.hpp>

#include <functional>

namespace hasp
{

class PlannerWindow;

/// What `hasp-planner --measure FILE` measures on this display, in this window: raw figures, which
/// `hasp report planner` makes rows of. It works in the window as a user's events would: a press of
/// the mouse on a fragment, moves, a release; the isovalue as the slider sets it.
///
///   first      {ms, sample}: from the program's start to the sample's first complete picture
///   idle       {seconds, frames}: of all views
///   reopened   {times, bytes: [..]}: resident memory, as a small plan is opened again and again
///   isovalue   [{size, ours_ms: [..], rival_ms: [..], rms_255, rival_rms_255, changed_255}] of
///              256^3, 512^3: from a new isovalue to the picture; rival: vtkFlyingEdges3D and its
///              mesh in the same view; rms_255: how far that picture is from the one at rest;
///              changed_255: how far pictures at rest are from one isovalue to the next
///   drag       {frames, seconds, share, touching, rms_255, ticks, skipped, tick_us, tick_us_p99;
///              full: the same of all pixels}; touching: share of looks that found it in contact
///
/// quick: 256^3 alone, 100 times. Threads: RENDER; takes minutes. Throws std::runtime_error if the
/// window does not come to rest, or does not show what is measured.
nlohmann::ordered_json MeasurePlanner(PlannerWindow& window, bool quick);

} // namespace hasp
