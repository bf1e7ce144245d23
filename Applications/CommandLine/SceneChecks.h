#pragma once
#include "SceneChoices.h"

namespace hasp
{

/// Holds what was chosen of a scene together, its mapper included. Throws Failure: WrongUse for
/// options that do not go together, with which to leave out.
void RequireFittingOptions(const SceneChoices& choices, const SceneOptions& scene);

} // namespace hasp
