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
///   first_ms          from the program's start to the sample's first complete picture
///   isovalue          [{size, ours_ms: [..], rival_ms: [..], rms_255, psnr_db}] of 256^3, 512^3:
///                     from a new isovalue to the picture; rival: vtkFlyingEdges3D and its mesh in
///                     the same view; rms_255: how far that picture is from the settled one
///   drag              {frames, seconds, share, ticks, tick_us, rms_255; full: the same of all
///   pixels} idle              {seconds, frames} reopened          {times, bytes_before,
///   bytes_after}
///
/// quick: fewer pairs, 256^3 alone, 100 times. Threads: RENDER; takes minutes. Throws
/// std::runtime_error if the window does not come to rest.
nlohmann::ordered_json MeasurePlanner(PlannerWindow& window, bool quick, double startedS);

} // namespace hasp
