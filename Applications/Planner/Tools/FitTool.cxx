#include "Tools/FitTool.h"

#include "Tools/DevicePointer.h"

#include "HapticExchange.h"
#include "Tools/FitLook.h"
#include "Tools/Planner.h"
#include "Tools/ToolMarks.h"
#include "View/CellProp.h"
#include "View/MeshProp.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"

#include "Planning/PlanLists.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QColor>
#include <QPainter>

#include <glm/geometric.hpp>

namespace hasp
{
namespace
{

constexpr int TellMs = 100;
constexpr double SpacingMm = 0.5; ///< of the distances that are felt
const SceneLook BoneLook{ { 0.93, 0.87, 0.76 }, 1.0, false };
const SceneLook PartLook{ { 0.35, 0.62, 0.85 }, 1.0, false };
const QColor TouchColour(230, 40, 40);

} // namespace

FitTool::FitTool(Planner& planner, QObject* parent)
  : Tool(parent),
    Of(planner),
    Faults([&planner](const QString& text) { planner.SayFault(text); }),
    Others(planner.views.Scene())
{
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject* object, unsigned long event, void* self, void*)
    { static_cast<FitTool*>(self)->Heard(object, event); });
  this->Telling.setInterval(TellMs);
  connect(&planner, &Planner::DeviceChanged, this, &FitTool::TakeDevice);
  connect(&this->Telling, &QTimer::timeout, this,
    [this]
    {
      const FitState now = this->State();
      if (now.isHeld)
        this->Of.views.Scene().Moving();
      else if (now.isReady)
        this->Telling.stop();
      Q_EMIT this->StateChanged();
    });
}

FitTool::~FitTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void FitTool::SetBody(std::shared_ptr<const PartOnBone> body)
{
  if (this->IsInHand() && body != this->Tried)
    this->Of.tools.Take(nullptr);
  this->Tried = std::move(body);
}

void FitTool::Begin()
{
  if (!this->Tried)
    return this->Of.SayFault(
      tr("There is no part to be tried: choose one, and try it from there."));
  SceneView& view = this->Of.views.Scene();
  this->Bone = std::make_unique<CellProp>(view, this->Tried->bone, this->Tried->isovalue);
  this->Bone->SetLook(BoneLook);
  this->Part = std::make_unique<MeshProp>(view, this->Tried->part);
  this->Part->SetLook(PartLook);
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& seen)
    {
      if (const auto pixel = this->TouchAt ? seen.PixelOf(*this->TouchAt) : std::nullopt)
        PaintBall(painter, *pixel, TouchColour, {}, true, seen.Off(*this->TouchAt) > 1.0);
    });
  this->Cover();
  connect(&this->Of.scene, &PlanScene::PropsChanged, this, &FitTool::Cover);
  this->Before->DeepCopy(view.Renderer()->GetActiveCamera());
  this->TakeHand();
  LookAtWay(view.Renderer(), *this->Tried);
}

void FitTool::TakeHand()
{
  SceneView& view = this->Of.views.Scene();
  this->Hand = vtkSmartPointer<vtkHaspHapticInteractor>::New();
  this->Faults.Follow(this->Hand);
  this->Faults.Follow(this->Hand->GetLoop());
  this->Hand->SetRenderer(view.Renderer());
  this->Hand->SetSpacing(SpacingMm);
  for (const unsigned long event :
    { vtkHaspHapticInteractor::GrabEvent, vtkHaspHapticInteractor::ReleaseEvent,
      vtkHaspHapticInteractor::ContactEvent, vtkHaspHapticInteractor::FreeEvent })
    this->Hand->AddObserver(event, this->Command);
  this->FrameTag = view.renderWindow()->AddObserver(vtkCommand::StartEvent, this->Command);
  this->Lift();
  this->Hand->AddTouchable(this->Bone->Actor());
  this->Hand->AddTool(this->Part->Actor());
  this->TakeDevice();
  this->Hand->Start();
  this->Telling.start();
}

/// The planner's, or else the mouse; what is in hand is let go.
void FitTool::TakeDevice()
{
  if (this->Hand && !GiveDevice(*this->Hand, this->Of))
    this->Hand->UseMouse();
}

void FitTool::End()
{
  if (!this->IsInHand())
    return;
  SceneView& view = this->Of.views.Scene();
  disconnect(&this->Of.scene, &PlanScene::PropsChanged, this, &FitTool::Cover);
  view.renderWindow()->RemoveObserver(this->FrameTag);
  this->Telling.stop();
  this->Hand->RemoveObserver(this->Command);
  this->Hand->Release();
  this->Hand->Stop();
  this->Hand = nullptr;
  this->TouchAt.reset();
  this->Marks.reset();
  this->Part.reset();
  this->Bone.reset();
  this->Others.Set({});
  view.Renderer()->GetActiveCamera()->DeepCopy(this->Before);
  view.Renderer()->GetActiveCamera()->Modified(); // DeepCopy says nothing: it drew what was before
  view.Renderer()->ResetCameraClippingRange();
  view.Draw();
  Q_EMIT this->StateChanged();
}

QString FitTool::Hint() const
{
  return tr("Drag the part onto the bone; the wheel moves it in depth, the middle button turns it, "
            "Shift holds it. Beside the part the view turns. Esc: back");
}

/// What else the view shows: the bone lies where it was scanned, or where the plan puts it.
void FitTool::Cover()
{
  std::vector<vtkProp*> props;
  const auto add = [&](vtkProp* prop)
  {
    if (prop)
      props.push_back(prop);
  };
  add(this->Of.scene.ScanProp());
  ForEachPlanObject(
    this->Of.plan.Now(), [&](const auto& object) { add(this->Of.scene.PropOf(object.id)); });
  this->Others.Set(props);
}

void FitTool::Lift()
{
  this->PutAt(PartOnBone::LiftMm);
}

void FitTool::PutAt(double offMm)
{
  if (!this->IsInHand())
    return;
  this->Hand->Release();
  const glm::dvec3 move = offMm * this->Tried->withdrawal;
  vtkNew<vtkMatrix4x4> matrix;
  for (int axis = 0; axis < 3; ++axis)
    matrix->SetElement(axis, 3, move[axis]);
  this->Part->Actor()->SetUserMatrix(matrix);
  this->TouchAt.reset();
  this->Marks->Update();
  this->Of.views.Scene().Draw();
  Q_EMIT this->StateChanged();
}

void FitTool::Show(const Seat& seat)
{
  if (!this->IsInHand())
    return;
  this->PutAt(-seat.depthMm);
  if (seat.touched)
    this->TouchAt = seat.boneAt;
  this->Marks->Update();
}

FitState FitTool::State() const
{
  FitState state;
  if (!this->IsInHand())
    return state;
  state.isReady = this->Hand->GetState() == vtkHaspHapticInteractor::Ready;
  state.share = this->Hand->GetProgress();
  state.isHeld = this->Hand->GetHeldTool() >= 0;
  state.isTouching = state.isHeld && this->Hand->GetLoop()->GetSnapshot().contacts > 0;
  const glm::dvec3 middle = this->Tried->Middle();
  const double at[] = { middle.x, middle.y, middle.z, 1.0 };
  double now[4];
  this->Part->Actor()->GetMatrix()->MultiplyPoint(at, now);
  state.offMm = glm::dot(glm::dvec3(now[0], now[1], now[2]) - middle, this->Tried->withdrawal);
  return state;
}

void FitTool::Heard(vtkObject* object, unsigned long)
{
  if (object != this->Hand)
    this->Hand->Update(); // a frame begins
  else
  {
    this->Telling.start();
    Q_EMIT this->StateChanged();
  }
}

} // namespace hasp
