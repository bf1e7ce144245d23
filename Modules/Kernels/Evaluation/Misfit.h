#pragma once
#include "Evaluation/FitCertificate.h"

#include <optional>

namespace hasp
{

/// Would a part that does not fit do so in other units, mirrored, or in another patient space? The
/// first that holds of: inches, centimetres, metres (and millimetres read as those), RAS, and
/// mirror images along each axis about 0, the part's box and the volume's.
///
/// Some 1,000 places of the changed mesh are asked, so that one in metres, whose triangles are too
/// low to be measured, is told, too. Fits: gap, slots and holes hold, as CertifyFit judges them.
/// Without claims of any of them: nothing. Throws what MeasureGuideGap does. Any thread.
std::optional<FitFault> ExplainMisfit(
  const TriangleMesh& mesh, const AnyGridView& bone, const PartClaims& claims, double volumeMm3);

} // namespace hasp
