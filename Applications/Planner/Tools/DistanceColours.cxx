#include "Tools/DistanceColours.h"

#include "Distance/BodyDistance.h"
#include "PropPose.h"
#include "Tools/Planner.h"
#include "vtkHaspDistanceColours.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{

constexpr char ArrayName[] = "SignedDistance";

vtkSmartPointer<vtkActor> ColouredActor(vtkPolyData* surface, vtkScalarsToColors* colours)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

} // namespace

DistanceColours::DistanceColours(Planner& planner, QObject* parent)
  : QObject(parent),
    Of(planner),
    Job(planner.jobs),
    Covered(planner.views.Scene())
{
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<DistanceColours*>(self)->Update(); });
}

DistanceColours::~DistanceColours()
{
  this->SetOn(false);
}

void DistanceColours::SetOn(bool on)
{
  if (on == this->IsOn())
    return;
  vtkRenderer* renderer = this->Of.views.Scene().Renderer();
  if (on)
  {
    this->Colours = MakeDistanceColours({ .rangeMm = RangeMm });
    this->Scale = MakeDistanceScale(this->Colours);
    renderer->AddActor2D(this->Scale);
    this->FrameTag =
      renderer->GetRenderWindow()->AddObserver(vtkCommand::StartEvent, this->Command);
    connect(&this->Of.plan, &PlanSession::Changed, this, &DistanceColours::Follow);
    connect(&this->Of.scene, &PlanScene::PropsChanged, this, &DistanceColours::Follow);
    this->Follow();
  }
  else
  {
    this->Of.plan.disconnect(this);
    this->Of.scene.disconnect(this);
    renderer->GetRenderWindow()->RemoveObserver(this->FrameTag);
    renderer->RemoveActor2D(this->Scale);
    this->Scale = nullptr;
    this->ShowColours(); // none
    this->Colours = nullptr;
    this->Known.clear();
    this->Job.Drop();
  }
  this->Of.views.Scene().Draw();
}

void DistanceColours::SetFragments(std::vector<PlanId> fragments)
{
  if (fragments == this->Fragments)
    return;
  this->Fragments = std::move(fragments);
  if (this->IsOn())
    this->Follow();
}

bool DistanceColours::IsColoured(PlanId fragment) const
{
  return std::find(this->Fragments.begin(), this->Fragments.end(), fragment) !=
         this->Fragments.end();
}

void DistanceColours::Follow()
{
  std::erase_if(this->Known, [&](const auto& known)
    { return ShownBody::Of(this->Of.scene.PropOf(known.first)) != known.second.shown; });
  this->MakeMissing();
  this->ShowColours();
}

void DistanceColours::MakeMissing()
{
  if (this->Fragments.empty() || this->Job.IsUnderWay())
    return; // the one that is under way asks again
  std::vector<DistanceWork> missing;
  for (const PlanFragment& fragment : this->Of.plan.Now().fragments)
  {
    const std::optional<ShownBody> body = ShownBody::Of(this->Of.scene.PropOf(fragment.id));
    if (!body || fragment.state == FragmentState::Resected)
      continue;
    const MadeDistance& known =
      this->Known.try_emplace(fragment.id, MadeDistance{ fragment.id, *body, {}, {} })
        .first->second;
    const bool mesh = this->IsColoured(fragment.id) && !known.mesh,
               distance = !this->IsColoured(fragment.id) && !known.distance;
    if (mesh || distance)
      missing.push_back(MakeWork(fragment.id, *body, mesh, distance));
  }
  if (!missing.empty())
    this->Job.Begin(tr("Measuring distances"),
      [this, missing = std::move(missing)](const ProgressFunction& progress)
      {
        auto made = std::make_shared<const std::vector<MadeDistance>>(DoWork(missing, progress));
        return [this, made] { this->Take(*made); };
      });
}

void DistanceColours::Take(const std::vector<MadeDistance>& made)
{
  for (const MadeDistance& one : made)
    if (const auto known = this->Known.find(one.fragment);
        known != this->Known.end() && known->second.shown == one.shown)
    {
      known->second.mesh = one.mesh ? one.mesh : known->second.mesh;
      known->second.distance = one.distance ? one.distance : known->second.distance;
    }
  for (auto& [id, coloured] : this->Shown)
    coloured.poses.clear(); // of what there was
  this->Follow();
}

void DistanceColours::ShowColours()
{
  vtkRenderer* renderer = this->Of.views.Scene().Renderer();
  const auto meshOf = [&](PlanId id) -> vtkPolyData*
  {
    const auto known = this->Known.find(id);
    return this->IsOn() && this->IsColoured(id) && known != this->Known.end() ? known->second.mesh
                                                                              : nullptr;
  };
  std::erase_if(this->Shown,
    [&](const auto& shown)
    {
      vtkPolyData* mesh = meshOf(shown.first);
      const bool goes = !mesh || mesh->GetPoints() != shown.second.surface->GetPoints();
      if (goes)
        renderer->RemoveActor(shown.second.actor);
      return goes;
    });
  std::vector<vtkProp*> covered;
  for (const PlanId id : this->Fragments)
    if (vtkPolyData* mesh = meshOf(id))
    {
      Coloured& shown = this->Shown[id];
      if (!shown.actor)
      {
        shown.surface = vtkSmartPointer<vtkPolyData>::New();
        shown.surface->ShallowCopy(mesh);
        vtkNew<vtkFloatArray> distances;
        distances->SetName(ArrayName);
        distances->SetNumberOfValues(mesh->GetNumberOfPoints());
        shown.surface->GetPointData()->SetScalars(distances);
        shown.actor = ColouredActor(shown.surface, this->Colours);
        renderer->AddActor(shown.actor);
      }
      covered.push_back(this->Of.scene.PropOf(id));
    }
  this->Covered.Set(covered);
}

vtkPolyData* DistanceColours::SurfaceOf(PlanId fragment) const
{
  const auto found = this->Shown.find(fragment);
  return found == this->Shown.end() ? nullptr : found->second.surface;
}

void DistanceColours::Update()
{
  for (auto& [id, coloured] : this->Shown)
    this->Colour(id, coloured);
}

void DistanceColours::Colour(PlanId fragment, Coloured& coloured)
{
  vtkProp3D* prop = this->Of.scene.PropOf(fragment);
  if (!prop)
    return;
  std::vector<RigidPose> poses{ UserPose(prop) };
  std::vector<PlacedDistance> others;
  for (const auto& [id, known] : this->Known)
    if (vtkProp3D* other = this->Of.scene.PropOf(id);
        other && !this->IsColoured(id) && known.distance && !known.distance->distances.empty())
    {
      poses.push_back(UserPose(other));
      others.push_back({ known.distance.get(), poses.back() });
    }
  if (poses == coloured.poses)
    return;
  auto* least = vtkFloatArray::SafeDownCast(coloured.surface->GetPointData()->GetScalars());
  FindLeastDistances(coloured.surface, poses[0], others,
    { least->GetPointer(0), std::size_t(least->GetNumberOfValues()) });
  least->Modified();
  coloured.actor->SetUserMatrix(prop->GetUserMatrix());
  coloured.poses = std::move(poses);
}

} // namespace hasp
