#pragma once
#include "Planning/Plan.h"
#include "View/SceneActor.h"

namespace hasp
{

/// The plan's colour; translucent and red what is resected, a little blue what is locked.
SceneLook LookOf(const PlanFragment& fragment, bool selected);

} // namespace hasp
