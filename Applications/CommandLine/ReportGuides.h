#pragma once
#include "Grid/TriangleMesh.h"

#include <string>

namespace hasp
{

struct GuideSubject;
struct ReportContext;

/// `hasp report guides`: are parts sound whatever is asked for, do they fit, does their certificate
/// find what is wrong, and what does a guide cost, against the same by Booleans of meshes. RENDER
/// thread.
void ReportGuides(ReportContext& context);

/// guides.time, guides.gap.p95 and guides.preview: the demo's guide on the demo's CT, and one on
/// the phantom.
void TryGuideTimes(ReportContext& context);

/// guides.preview: the field of a guide and the active cells that draw it, against its finished
/// mesh, which is welded. `at` goes behind the id: "", which has the bar, or "@phantom".
void TryPreview(ReportContext& context, const GuideSubject& subject, const TriangleMesh& finished,
  const std::string& at);

} // namespace hasp
