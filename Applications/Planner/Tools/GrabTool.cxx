#include "Tools/GrabTool.h"

#include "HapticExchange.h"
#include "Tools/DevicePointer.h"
#include "Tools/Planner.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspReductionSession.h"

#include "QVTKInteractor.h"
#include "vtkCommand.h"
#include "vtkProp3D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{
constexpr int TellMs = 100;
}

GrabTool::GrabTool(Planner& planner, QObject* parent)
  : Tool(parent),
    Of(planner),
    Faults([&planner](const QString& text) { planner.SayFault(text); })
{
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject* object, unsigned long event, void* self, void*)
    { static_cast<GrabTool*>(self)->Heard(object, event); });
  // A press may come with another number of pixels: the pointer has not moved by the difference.
  this->BeforePress->SetCallback([](vtkObject* interactor, unsigned long, void*, void*)
    { interactor->InvokeEvent(vtkCommand::MouseMoveEvent); });
  this->Untaken->SetClientData(this);
  this->Untaken->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<GrabTool*>(self)->SayWhyNot(); });
  this->Soon.setSingleShot(true);
  this->Soon.setInterval(0);
  this->Telling.setInterval(TellMs);
  connect(&planner, &Planner::DeviceChanged, this, &GrabTool::TakeDevice);
  connect(&this->Soon, &QTimer::timeout, this, &GrabTool::Follow);
  connect(&this->Telling, &QTimer::timeout, this,
    [this]
    {
      const GrabState now = this->State();
      if (!now.held.empty())
        this->Of.views.Scene().Moving();
      const bool isBaking = this->Hand && this->Hand->GetState() == vtkHaspHapticInteractor::Baking;
      if (!isBaking && now.held.empty())
        this->Telling.stop();
      Q_EMIT this->StateChanged();
    });
}

GrabTool::~GrabTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void GrabTool::Begin()
{
  this->Hand = vtkSmartPointer<vtkHaspHapticInteractor>::New();
  this->Faults.Follow(this->Hand);
  this->Faults.Follow(this->Hand->GetLoop());
  this->Hand->SetRenderer(this->Of.views.Scene().Renderer());
  this->TakeDevice();
  this->Hand->SetSnapToFit(this->Snap);
  this->Hand->SetShowForces(this->Forces);
  for (const unsigned long event :
    { vtkHaspHapticInteractor::GrabEvent, vtkHaspHapticInteractor::ReleaseEvent,
      vtkHaspHapticInteractor::ContactEvent, vtkHaspHapticInteractor::FreeEvent })
    this->Hand->AddObserver(event, this->Command);
  this->Session = vtkSmartPointer<vtkHaspReductionSession>::New();
  this->Faults.Follow(this->Session);
  this->Session->SetHistory(this->Of.plan.History());
  this->Session->SetInteractor(this->Hand);
  this->Session->AddObserver(vtkHaspReductionSession::PlanChangedEvent, this->Command);
  this->Of.views.Scene().interactor()->AddObserver(
    vtkCommand::LeftButtonPressEvent, this->BeforePress, 2.0F); // before the hand
  this->Of.views.Scene().interactor()->AddObserver(
    vtkCommand::LeftButtonPressEvent, this->Untaken, 0.5F); // not where the hand takes it
  // Right before a frame: its pose is the newest. And before DistanceColours asks for it.
  this->FrameTag =
    this->Of.views.Scene().renderWindow()->AddObserver(vtkCommand::StartEvent, this->Command, 1.0F);
  connect(&this->Of.plan, &PlanSession::Changed, this, &GrabTool::FollowSoon);
  connect(&this->Of.scene, &PlanScene::PropsChanged, this, &GrabTool::FollowSoon);
  this->Follow();
  this->Hand->Start();
}

/// The planner's, or else the mouse; what is in hand is let go.
void GrabTool::TakeDevice()
{
  if (this->Hand && !GiveDevice(*this->Hand, this->Of))
    this->Hand->UseMouse();
}

void GrabTool::End()
{
  this->Hand->Release(); // a step of the plan
  disconnect(&this->Of.plan, &PlanSession::Changed, this, &GrabTool::FollowSoon);
  disconnect(&this->Of.scene, &PlanScene::PropsChanged, this, &GrabTool::FollowSoon);
  this->Of.views.Scene().interactor()->RemoveObserver(this->BeforePress);
  this->Of.views.Scene().interactor()->RemoveObserver(this->Untaken);
  this->Of.views.Scene().renderWindow()->RemoveObserver(this->FrameTag);
  this->Soon.stop();
  this->Telling.stop();
  this->Hand->Stop();
  this->Hand->RemoveObserver(this->Command);
  this->Session->RemoveObserver(this->Command);
  this->Session->SetInteractor(nullptr); // takes back what was given to it
  this->Session = nullptr;
  this->Known.clear();
  this->Hand = nullptr;
  this->Of.views.Scene().Draw();
  Q_EMIT this->HeldChanged();
  Q_EMIT this->StateChanged();
}

QString GrabTool::Hint() const
{
  return tr("Drag a fragment to move it; the wheel moves it in depth, the middle button turns it, "
            "Shift holds it. Beside fragments the view turns. Esc: back");
}

void GrabTool::SetSnap(bool on)
{
  this->Snap = on;
  if (this->Hand)
    this->Hand->SetSnapToFit(on);
}

void GrabTool::SetShowForces(bool on)
{
  this->Forces = on;
  if (this->Hand)
    this->Hand->SetShowForces(on);
  this->Of.views.Scene().Draw();
}

void GrabTool::Heard(vtkObject* object, unsigned long event)
{
  if (object == this->Session)
    this->Of.plan.Took();
  else if (object != this->Hand)
    this->Hand->Update(); // a frame begins
  else if (event == vtkHaspHapticInteractor::GrabEvent ||
           event == vtkHaspHapticInteractor::ReleaseEvent)
  {
    this->Telling.start();
    if (event == vtkHaspHapticInteractor::ReleaseEvent)
      this->FollowSoon(); // what has changed meanwhile
    Q_EMIT this->HeldChanged();
    Q_EMIT this->StateChanged();
  }
  else
    Q_EMIT this->StateChanged(); // it touches, or does not any more
}

/// A press on a fragment that takes nothing: it turns the view, which is not what was meant.
void GrabTool::SayWhyNot()
{
  if (this->Hand->GetState() != vtkHaspHapticInteractor::Baking)
    return;
  const int* at = this->Of.views.Scene().interactor()->GetEventPosition();
  const auto touched = this->Of.scene.PlaceAt(at[0], at[1]);
  if (touched && this->Known.contains(touched->object))
    this->Of.Say(tr("What is felt is still being prepared (%1 %): take the fragment in hand when "
                    "that is done.")
                   .arg(int(100.0 * this->Hand->GetProgress())));
}

vtkHaspHapticInteractor* GrabTool::Haptic() const
{
  return this->Hand;
}

GrabState GrabTool::State() const
{
  GrabState state;
  if (!this->Session)
    return state;
  state.isReady = this->Hand->GetState() == vtkHaspHapticInteractor::Ready;
  state.share = this->Hand->GetProgress();
  state.held = this->Held();
  if (state.held.empty())
    return state;
  const HapticSnapshot& seen = this->Hand->GetLoop()->GetSnapshot();
  state.isTouching = seen.contacts > 0;
  state.contactN = glm::length(seen.contact.force);
  state.attractionN = glm::length(seen.attraction.force);
  state.deepestMm = std::max(0.0, -seen.deepestMm);
  return state;
}

} // namespace hasp
