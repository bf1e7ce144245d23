// What `hasp report light` says in a build without Embree.
#include "MeasuredRows.h"
#include "ReportLight.h"
#include "ReportRegistry.h"
#include "TransparencyTrial.h"
#include "Windows.h"

namespace hasp
{

void ReportLight(ReportContext& context)
{
  ChooseWindows();
  MeasureTransparency(context);
  for (const char* id :
    { "light.furnace", "light.sphere", "light.reciprocity", "light.energy", "light.sobol.ao",
      "light.sobol.bounce1", "light.sobol.bounce3", "light.hybrid", "light.rays", "light.extreme" })
    context.report.rows.push_back(AbsentRow(id, "closed forms, paths and Embree's triangles",
      "this build has no Embree (HASP_ENABLE_EMBREE), so there is no light but that of lamps"));
}

} // namespace hasp
