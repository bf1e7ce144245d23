#include "Verbs.h"

namespace hasp
{

void AddVerbs(CLI::App& app, Session& session)
{
  AddInfoVerb(app, session);
  AddConvertVerb(app, session);
  AddCellsVerb(app, session);
  AddRenderVerb(app, session);
#if HASP_WITH_VIEW
  AddViewVerb(app, session);
  AddCalibrateVerb(app, session);
#endif
#if HASP_WITH_SEGMENTATION
  AddSegmentVerb(app, session);
#endif
  AddCompareVerb(app, session);
#if HASP_WITH_GUIDES
  AddCutVerb(app, session);
  AddGuideVerb(app, session);
  AddCertifyVerb(app, session);
  AddPlateVerb(app, session);
  AddImplantVerb(app, session);
  AddMirrorVerb(app, session);
#endif
#if HASP_WITH_PLANS
  AddPlanVerb(app, session);
#if HASP_WITH_REDUCE_VERB
  AddReduceVerb(app, session);
#endif
  AddRunVerb(app, session);
  AddEvaluateVerb(app, session);
  AddTransplantVerb(app, session);
  AddFractureVerb(app, session);
#endif
  AddDevicesVerb(app, session);
  AddPhantomVerb(app, session);
  AddReportVerb(app, session);
}

} // namespace hasp
