#pragma once

namespace hasp
{

struct ReportContext;

/// What `hasp report haptics` measures without a picture. Free of VTK; each puts rows into the
/// report. Times are this thread's CPU time. WORKER.

/// haptics.simd.static.*, haptics.simd.matrix.*: vectors against plain code, pair by pair;
/// haptics.wrench, haptics.wrench.int16: and what both are off by.
void TrySimd(ReportContext& context);

/// haptics.simd.dynamic: a dynamic shell on the move against plain code that draws and evaluates as
/// many points; haptics.dynamic.error: dynamic against static shells of as many points.
void TryDynamicShell(ReportContext& context);

/// haptics.error.levels (curves), haptics.error.falls, haptics.levels: what levels of a shell cost
/// and what they are off by, and how many a budget allows.
void TryLevels(ReportContext& context);

/// haptics.points, haptics.snap.ms, haptics.snap.ripple: whole ticks, with coupling and limits.
void TrySteps(ReportContext& context);

/// haptics.coarse.separated, .touching, ...: with and without the coarse phase.
void TryCoarsePhase(ReportContext& context);

/// haptics.falcon.tick, .delay.in, .delay.out: what a device with a thread of its own costs a tick,
/// and how many ticks later it is heard and felt; on a model of it in this process.
void TryDriver(ReportContext& context);

} // namespace hasp
