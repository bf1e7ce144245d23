#pragma once
#include "Output/ReportPictures.h"

#include <QStringList>

namespace hasp
{

struct Planner;

/// Surfaces of all that a report shows, of the planner's scene where it has them, made now where it
/// has not. `missing`: sentences on what there is none of, and why. Internal to CaseReport. RENDER;
/// a second for each million triangles, and what MakeFragments costs for what is made.
ReportBodies BodiesOf(Planner& planner, QStringList& missing);

} // namespace hasp
