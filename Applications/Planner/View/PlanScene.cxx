#include "View/PlanScene.h"

#include "Model/JobQueue.h"
#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "Planning/PlanLists.h"
#include "View/FirstLook.h"
#include "View/ScanLooks.h"
#include "View/SceneCamera.h"
#include "View/SceneLayers.h"
#include "View/SceneView.h"
#include "View/ViewLight.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <map>

namespace hasp
{

struct PlanScene::Internals
{
  explicit Internals(SceneContext context) : of(std::move(context)), layers(of) {}

  SceneContext of;
  std::map<PlanId, bool> asked; ///< to be visible, or not
  double isovalue = 0.0;        ///< that was told last
  FirstLook first;
  SceneLayers layers;
  ViewLight light{ of.view };
  ScanLooks looks{ of, layers.skin, light };
};

PlanScene::PlanScene(PlanSession& plan, ScanShelf& scans, JobQueue& jobs, SceneView& view)
  : Self(std::make_unique<Internals>(SceneContext{ plan, scans, jobs, view,
      [this](PlanId object) { return this->IsVisible(object); },
      [this](PlanId object) { return this->PropOf(object); },
      [this]
      {
        this->Sync();
        Q_EMIT this->PropsChanged();
      },
      [this](const QString& text) { Q_EMIT this->Refused(text); } }))
{
  qRegisterMetaType<hasp::PlanId>("hasp::PlanId"); // of SelectedChanged
  connect(&plan, &PlanSession::Replaced, this, &PlanScene::Forget);
  connect(&plan, &PlanSession::Changed, this, &PlanScene::Sync);
  connect(&plan, &PlanSession::PartsChanged, this, &PlanScene::Sync);
  connect(&scans, &ScanShelf::Added, this, &PlanScene::Sync);
  view.before = [this]
  {
    for (SceneLayer* layer : this->Self->layers.All())
      layer->Prepare();
    this->Self->light.Prepare();
  };
  view.after = [this]
  {
    bool refining = this->Self->light.Finish();
    for (const SceneLayer* layer : this->Self->layers.All())
      refining = refining || layer->IsRefining();
    return refining;
  };
  this->Sync();
}

PlanScene::~PlanScene()
{
  this->Self->of.view.before = nullptr;
  this->Self->of.view.after = nullptr;
}

void PlanScene::Forget()
{
  Internals& self = *this->Self;
  self.asked.clear();
  self.first.Begin(!self.of.plan.Now().fragments.empty());
  self.of.labelMaps.clear();
  self.layers.Forget();
  this->Select(0);
}

void PlanScene::Sync()
{
  Internals& self = *this->Self;
  if (self.of.selected != 0 && !PlanNoun(self.of.plan.Now(), self.of.selected))
  {
    self.of.selected = 0;
    Q_EMIT this->SelectedChanged(0);
  }
  bool changed = false;
  for (SceneLayer* layer : self.layers.All())
    changed = layer->Sync() || changed;
  if (changed)
    Q_EMIT this->PropsChanged();
  this->Show();
  if (self.isovalue != this->Isovalue())
  {
    self.isovalue = this->Isovalue();
    Q_EMIT this->IsovalueChanged(self.isovalue);
  }
}

void PlanScene::Show()
{
  Internals& self = *this->Self;
  self.first.Follow(self.of.view.Renderer(), self.layers);
  self.of.view.Draw();
}

void PlanScene::SetIsovalue(double value, bool moving)
{
  this->Self->layers.scan.SetIsovalue(value, moving);
  if (moving)
    this->Self->of.view.Moving();
  this->Self->of.view.Draw();
  if (value == this->Self->isovalue)
    return;
  this->Self->isovalue = value;
  Q_EMIT this->IsovalueChanged(value);
}

double PlanScene::Isovalue() const
{
  return this->Self->layers.scan.Isovalue();
}

void PlanScene::SetShownVolume(PlanId volume)
{
  if (volume == this->ShownVolume())
    return;
  this->Self->layers.scan.SetVolume(volume);
  this->Sync();
  Q_EMIT this->PropsChanged();
}

PlanId PlanScene::ShownVolume() const
{
  return this->Self->layers.scan.Volume();
}

vtkImageData* PlanScene::ShownImage() const
{
  return this->Self->layers.scan.Image();
}

bool PlanScene::IsVisible(PlanId object) const
{
  const bool isVolume = FindPlanObject<PlanVolume>(this->Self->of.plan.Now(), object);
  if (isVolume && object != this->ShownVolume())
    return false;
  const auto asked = this->Self->asked.find(object);
  if (asked != this->Self->asked.end())
    return asked->second;
  return !isVolume || !this->Self->layers.fragments.HasAny(object);
}

void PlanScene::SetVisible(PlanId object, bool visible)
{
  if (this->IsVisible(object) == visible)
    return;
  this->Self->asked[object] = visible;
  if (visible && FindPlanObject<PlanVolume>(this->Self->of.plan.Now(), object))
    this->Self->layers.scan.SetVolume(object);
  this->Sync();
  Q_EMIT this->PropsChanged();
}

PlanId PlanScene::Selected() const
{
  return this->Self->of.selected;
}

void PlanScene::Select(PlanId object)
{
  if (object == this->Self->of.selected)
    return;
  this->Self->of.selected = object;
  this->Sync();
  Q_EMIT this->SelectedChanged(object);
}

ScanLooks& PlanScene::Looks() const
{
  return this->Self->looks;
}

vtkProp3D* PlanScene::PropOf(PlanId object) const
{
  for (const SceneLayer* layer : this->Self->layers.All())
    if (vtkProp3D* prop = layer->PropOf(object))
      return prop;
  return nullptr;
}

vtkProp3D* PlanScene::ScanProp() const
{
  return this->Self->layers.scan.PropOf(this->ShownVolume());
}

void PlanScene::PutSurface(const std::string& hash, vtkPolyData* mesh)
{
  this->Self->layers.surfaces.Put(hash, mesh);
  this->Sync();
}

vtkImageData* PlanScene::ImageOfFragment(PlanId fragment) const
{
  return this->Self->layers.fragments.ImageOf(fragment);
}

std::optional<PlanScene::Place> PlanScene::PlaceAt(int x, int y) const
{
  vtkRenderer* renderer = this->Self->of.view.Renderer();
  renderer->ResetCameraClippingRange(); // the line is as long as that
  SceneRay ray;
  RayOfPixel(renderer, x, y, &ray.from.x, &ray.to.x);
  std::optional<SceneHit> hit;
  for (const SceneLayer* layer : this->Self->layers.All())
    layer->Pick(ray, hit);
  if (!hit)
    return std::nullopt;
  return Place{ hit->object, hit->world, hit->inScan, hit->normal };
}

void PlanScene::LookFrom(char side)
{
  LookFromSide(this->Self->of.view.Renderer(), this->Self->layers.Bounds(), side);
  this->Self->of.view.Draw();
}

void PlanScene::ShowAll()
{
  LookAtAll(this->Self->of.view.Renderer(), this->Self->layers.Bounds());
  this->Self->of.view.Draw();
}

vtkBoundingBox PlanScene::Bounds() const
{
  return this->Self->layers.Bounds();
}

void PlanScene::ListResources(ResourceList& list) const
{
  for (const SceneLayer* layer : this->Self->layers.All())
    layer->ListResources(list);
  this->Self->light.ListResources(list);
}

} // namespace hasp
