// What `hasp report cells` says of rays in a build without Embree.
#include "ReportCellsParts.h"

#include "CellRenderers.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

namespace hasp
{
namespace
{

void Absent(ReportContext& context, const CellScene& scene, std::initializer_list<const char*> ids)
{
  for (const char* id : ids)
    context.report.rows.push_back(AbsentRow(id + scene.tag, "Embree's triangles",
      "this build has no Embree (HASP_ENABLE_EMBREE), so no rays are traced against cells either"));
}

} // namespace

void ReportCellRays(ReportContext& context, const CellScene& scene, int)
{
  Absent(context, scene, { "cells.rays", "cells.rays.ao", "cells.rays.memory", "cells.bytes.bvh" });
}

void ReportRandomRays(ReportContext& context, const CellScene& scene, std::int64_t)
{
  Absent(context, scene, { "cells.missed.random" });
}

std::unique_ptr<IsosurfaceMethod> MakeTracerMethod(const IsosurfaceView&)
{
  return nullptr;
}

} // namespace hasp
