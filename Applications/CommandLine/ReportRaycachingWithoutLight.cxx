// What `hasp report raycaching` says of light in a build without Embree.
#include "RaycachingScene.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

namespace hasp
{

void ReportRaycachingStillLight(ReportContext&, const RaycachingScene&) {}

void ReportRaycachingLight(ReportContext& context, const RaycachingScene& scene)
{
  for (const char* id : { "raycaching.cost.lit@auto", "raycaching.cost.lit@cache",
         "raycaching.ao.slope", "raycaching.ao.slope.casts", "raycaching.ao.floor" })
    context.report.rows.push_back(AbsentRow(id + scene.cells.tag, "16 rays for each pixel",
      "this build has no Embree (HASP_ENABLE_EMBREE), so nothing casts rays for light"));
}

} // namespace hasp
