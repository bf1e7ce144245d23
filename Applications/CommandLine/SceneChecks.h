#pragma once
#include "SceneChoices.h"

namespace hasp
{

/// Holds what was chosen of a scene together, its mapper included. Throws Failure: WrongUse for
/// options that do not go together, with which to leave out.
void RequireFittingOptions(const SceneChoices& choices, const SceneOptions& scene);

/// Where no mapper was chosen and light is asked for that the rays of a cache take no part in,
/// paths or that of several surfaces on each other: active cells.
void ChooseMapperForLight(SceneOptions& scene, bool chosen);

} // namespace hasp
