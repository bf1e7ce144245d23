#pragma once

namespace hasp
{

class PlannerWindow;

/// Asks, for each work folder that a crash left with something that was not saved, whether it shall
/// be brought back; it is gone afterwards, unless it stays to be asked for again. Threads: RENDER.
void OfferRecovery(PlannerWindow& window);

} // namespace hasp
