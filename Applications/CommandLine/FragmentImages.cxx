#include "FragmentImages.h"

#include "Planning/DerivedPart.h"
#include "Planning/PlanLists.h"
#include "Report/ScratchFolder.h"
#include "RunFaults.h"
#include "RunLabels.h"
#include "RunParts.h"
#include "Session.h"

#include <set>

namespace hasp
{

RunImages ImagesOfFragments(const PlanDocument& document, const std::string& plan,
  const std::vector<PlanId>& fragments, const std::vector<std::string>& files, Session& session)
{
  const Plan& now = document.history.Current();
  std::vector<PartFile> wanted;
  std::set<PlanId> images;
  for (const PlanId id : fragments)
  {
    wanted.push_back({ .object = id, .made = true });
    for (const PlanId image : ImagesOf(now, id))
      images.insert(image);
  }
  RunImages read = ReadScans(now, images, files, session);
  const ScratchFolder scratch;
  RunFaults faults;
  AddLabelMaps({ document, plan, scratch.Path(), false }, wanted, read, faults, session);
  faults.Refuse(wanted.size(), false);
  return read;
}

} // namespace hasp
