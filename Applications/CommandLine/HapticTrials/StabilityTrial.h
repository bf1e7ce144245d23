#pragma once

namespace hasp
{

struct ReportContext;

/// The haptic cases of `hasp report stability`: each of Studies' rows is tried, and passes if what
/// comes is what was predicted, stable or not; quick: one of each family and prediction. Then ten
/// minutes of ticks in which all goes wrong, of the coupling and of the whole step; a minute in
/// quick, a day in a soak. WORKER.
void TryStability(ReportContext& context);

} // namespace hasp
