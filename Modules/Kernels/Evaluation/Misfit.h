#pragma once
#include "Evaluation/FitCertificate.h"
#include "Evaluation/MeshSamples.h"

#include <optional>
#include <span>

namespace hasp
{

/// Would a part that does not fit do so in other units, mirrored, or in another patient space? The
/// first that holds of: inches, centimetres, metres (and millimetres read as those), RAS, and
/// mirror images along each axis about 0, the part's box and the volume's.
///
/// samples   of the mesh; about 1,000 of them are asked
/// Fits: gap, slots and holes hold, as CertifyFit judges them. Without claims of any of them:
/// nothing. Throws what MeasureGuideGap does. Any thread.
std::optional<FitFault> ExplainMisfit(const TriangleMesh& mesh, std::span<const MeshSample> samples,
  const AnyGridView& bone, const PartClaims& claims, double volumeMm3);

} // namespace hasp
