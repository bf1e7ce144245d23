// What a GrabTool gives to its hand: the fragments that are seen, as the plan has them by now.
#include "Tools/GrabTool.h"

#include "Tools/Planner.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspReductionSession.h"

#include "vtkImageData.h"
#include "vtkProp3D.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{
namespace
{
constexpr double MostSamples = 8e6; ///< of the largest fragment's distances: some seconds
}

/// So that the largest fragment's distances have MostSamples at most.
double GrabTool::Spacing() const
{
  double mm = 0.1;
  for (const PlanFragment& fragment : this->Of.plan.Now().fragments)
    if (vtkImageData* image = this->Of.scene.ImageOfFragment(fragment.id))
    {
      const int* dims = image->GetDimensions();
      const double* step = image->GetSpacing();
      const double volume = dims[0] * step[0] * dims[1] * step[1] * dims[2] * step[2];
      mm =
        std::max({ mm, std::min({ step[0], step[1], step[2] }), std::cbrt(volume / MostSamples) });
    }
  return mm;
}

void GrabTool::Follow()
{
  if (!this->Session || this->Hand->GetHeldTool() >= 0)
    return; // when it is let go
  std::map<PlanId, vtkWeakPointer<vtkProp3D>> now;
  for (const PlanFragment& fragment : this->Of.plan.Now().fragments)
    if (vtkProp3D* prop = this->Of.scene.PropOf(fragment.id))
      now[fragment.id] = prop; // the session knows which of them are resected
  for (const auto& [id, prop] : this->Known)
    if (const auto found = now.find(id); found == now.end() || found->second != prop)
      this->Session->RemoveFragment(id);
  this->Hand->SetSpacing(this->Spacing());
  for (const auto& [id, prop] : now)
    if (const auto found = this->Known.find(id);
        found == this->Known.end() || found->second != prop)
      this->Session->AddFragment(id, prop);
  this->Known = std::move(now);
  this->Session->Follow();
  this->Telling.start();
  this->Of.views.Scene().Draw();
}

std::vector<PlanId> GrabTool::Held() const
{
  std::vector<PlanId> held;
  const int tool = this->Session ? this->Hand->GetHeldTool() : -1;
  for (const auto& [id, prop] : this->Known)
    if (tool >= 0 && this->Session->GetTool(id) == tool)
      held.push_back(id);
  return held;
}

} // namespace hasp
