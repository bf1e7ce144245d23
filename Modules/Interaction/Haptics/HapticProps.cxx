#include "HapticProps.h"

#include "Haptics/VirtualCoupling.h"
#include "PropPose.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{

vtkMapper* MapperOf(vtkProp3D* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor != nullptr ? actor->GetMapper() : nullptr;
}

/// The samples without what VTK may do to the image meanwhile: a shallow copy of our own.
BakedVolume Samples(vtkImageData* image, double isovalue)
{
  auto own =
    std::shared_ptr<vtkImageData>(vtkImageData::New(), [](vtkImageData* made) { made->Delete(); });
  own->ShallowCopy(image);
  return { ViewImage(own.get()), own, isovalue };
}

std::string Fault(const HapticProp& it, const std::exception& error)
{
  return "prop " + std::to_string(it.id) + " in the order of adding: " + error.what();
}

RigidPose BodyInProp(const HapticProp& it)
{
  return { it.origin, { 1, 0, 0, 0 } };
}

/// What is there to be touched now; null: nothing.
vtkDataSet* DataOf(const HapticProp& it)
{
  if (it.image)
    return it.image;
  if (it.cells)
    return it.cells->GetImage();
  auto* mapper = vtkPolyDataMapper::SafeDownCast(MapperOf(it.prop));
  return mapper != nullptr ? mapper->GetInput() : nullptr;
}

} // namespace

RigidPose HapticProp::Pose() const
{
  return (this->prop ? PoseOf(this->prop.Get()) : this->fixed) * BodyInProp(*this);
}

double HapticProp::Isovalue() const
{
  return this->cells ? this->cells->GetIsoValue() : this->isovalue;
}

HapticProps::HapticProps() = default;
HapticProps::~HapticProps() = default;

HapticProp& HapticProps::Find(vtkProp3D* prop)
{
  for (HapticProp& it : this->Props)
    if (prop != nullptr && it.prop == prop) // images stand there without one
      return it;
  vtkMapper* mapper = MapperOf(prop);
  auto* cells = vtkHaspClusteredCellMapper::SafeDownCast(mapper);
  if (cells == nullptr && vtkPolyDataMapper::SafeDownCast(mapper) == nullptr)
    throw std::invalid_argument(
      "only actors with a vtkHaspClusteredCellMapper or a vtkPolyDataMapper "
      "can be touched or moved; of others add their image and isovalue");
  PoseOf(prop); // throws
  HapticProp made;
  made.id = ++this->Ids;
  made.prop = prop;
  made.cells = cells;
  this->Props.push_back(std::move(made));
  return this->Props.back();
}

void HapticProps::AddTouchable(vtkProp3D* prop)
{
  HapticProp& it = this->Find(prop);
  it.ready = it.ready && it.touchable;
  it.touchable = true;
}

void HapticProps::AddTouchable(vtkImageData* image, double isovalue, const RigidPose& imageToWorld)
{
  if (!IsPose(imageToWorld))
    throw std::invalid_argument(
      "an image that is touched needs a pose: finite, its turn of length 1");
  ViewImage(image); // throws
  HapticProp made;
  made.id = ++this->Ids;
  made.image = image;
  made.isovalue = isovalue;
  made.fixed = imageToWorld;
  made.touchable = true;
  this->Props.push_back(std::move(made));
}

int HapticProps::AddTool(const std::vector<vtkProp3D*>& group)
{
  if (group.empty())
    throw std::invalid_argument("a tool has no props");
  for (vtkProp3D* prop : group) // all of them, or none
    if (this->Find(prop).tool >= 0)
      throw std::invalid_argument("a prop is in another tool already; remove it there first");
  const int tool = this->Tools++;
  for (vtkProp3D* prop : group)
  {
    HapticProp& it = this->Find(prop);
    it.tool = tool;
    it.ready = false;
    it.baked.dynamic = nullptr;
  }
  return tool;
}

void HapticProps::Remove(vtkProp3D* prop)
{
  std::erase_if(
    this->Props, [prop](const HapticProp& it) { return prop != nullptr && it.prop == prop; });
}

bool HapticProps::Wanted() const
{
  const auto any = [this](auto is)
  { return std::any_of(this->Props.begin(), this->Props.end(), is); };
  return any([](const HapticProp& it) { return it.touchable; }) &&
         any([](const HapticProp& it) { return it.tool >= 0; });
}

bool HapticProps::Complete() const
{
  return std::all_of(this->Props.begin(), this->Props.end(),
    [](const HapticProp& it) { return it.ready || it.failed; });
}

double HapticProps::Progress() const
{
  if (this->Props.empty())
    return 1.0;
  double done = this->Work ? this->Work->Progress() : 0.0;
  for (const HapticProp& it : this->Props)
    done += it.ready || it.failed;
  return std::min(1.0, done / static_cast<double>(this->Props.size()));
}

bool HapticProps::Update(std::vector<std::string>& faults)
{
  bool changed = std::erase_if(this->Props,
                   [](const HapticProp& it) { return !it.prop && it.image == nullptr; }) > 0;
  const auto at = std::find_if(this->Props.begin(), this->Props.end(),
    [this](const HapticProp& it) { return it.id == this->WorkOf; });
  if (this->Work && at == this->Props.end())
    this->Work.reset(); // it went: cancelled
  changed = this->DropStale() || changed;
  if (this->Work && this->Work->Done())
  {
    try
    {
      at->baked = this->Work->Take();
      at->ready = true;
      changed = true;
    }
    catch (const std::exception& error)
    {
      at->failed = true;
      faults.push_back(Fault(*at, error));
    }
    this->Work.reset();
  }
  if (!this->Work && this->Wanted())
    this->BeginNext(faults);
  return changed;
}

bool HapticProps::DropStale()
{
  bool changed = false;
  for (HapticProp& it : this->Props)
  {
    if (it.prop)
      it.cells = vtkHaspClusteredCellMapper::SafeDownCast(MapperOf(it.prop));
    const bool worked = this->Work && it.id == this->WorkOf;
    vtkDataSet* data = DataOf(it);
    const bool other =
      data != it.bakedData || (data != nullptr && data->GetMTime() != it.bakedTime);
    const bool follows = it.baked.dynamic && !it.touchable;
    const bool moved = it.cells && !follows && it.Isovalue() != it.bakedIsovalue;
    if (!(it.ready || it.failed || worked) || !(other || moved))
      continue;
    if (worked)
      this->Work.reset();
    if (other)
      it.baked.dynamic = nullptr;
    changed = changed || it.ready;
    it.ready = it.failed = false;
  }
  return changed;
}

void HapticProps::BeginNext(std::vector<std::string>& faults)
{
  const auto next = std::find_if(this->Props.begin(), this->Props.end(),
    [](const HapticProp& it) { return !it.ready && !it.failed; });
  if (next == this->Props.end())
    return;
  try
  {
    BakingJob job;
    if (vtkMapper* mapper = MapperOf(next->prop))
      mapper->Update();
    vtkDataSet* data = DataOf(*next);
    next->bakedIsovalue = next->Isovalue();
    next->bakedData = data;
    next->bakedTime = data != nullptr ? data->GetMTime() : 0;
    if (auto* image = vtkImageData::SafeDownCast(data))
      job.body = Samples(image, next->bakedIsovalue);
    else if (auto* surface = vtkPolyData::SafeDownCast(data))
      job.body = TrianglesOf(surface);
    else
      throw std::invalid_argument("its mapper has no volume and no surface");
    double bounds[6];
    data->GetBounds(bounds);
    for (int axis = 0; axis < 3; ++axis)
      next->origin[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    job.origin = next->origin;
    job.map = next->touchable;
    job.shell = next->tool >= 0;
    job.dynamic = this->dynamicShells;
    job.spacingMm = this->spacingMm;
    job.points = this->shellPoints;
    this->WorkOf = next->id;
    this->Work = std::make_unique<BodyBaking>(std::move(job));
  }
  catch (const std::exception& error)
  {
    next->failed = true;
    faults.push_back(Fault(*next, error));
  }
}

bool HapticProps::ToolReady(int tool) const
{
  bool any = false;
  for (const HapticProp& it : this->Props)
    if (it.tool == tool)
    {
      if (!it.Feels())
        return false;
      any = true;
    }
  return any;
}

std::vector<HapticShell> HapticProps::Shells(int tool, const RigidPose& toolInWorld) const
{
  std::vector<HapticShell> shells;
  for (const HapticProp& it : this->Props)
    if (it.tool == tool && tool >= 0 && it.Feels())
      shells.push_back({ it.baked.shell, toolInWorld.Inverse() * it.Pose(), it.baked.dynamic });
  return shells;
}

std::vector<HapticBody> HapticProps::Bodies(int tool) const
{
  std::vector<HapticBody> bodies;
  for (const HapticProp& it : this->Props)
    if (it.touchable && it.ready && it.baked.map && (tool < 0 || it.tool != tool))
      bodies.push_back({ it.baked.map, it.Pose() });
  return bodies;
}

decltype(HapticControl::isovalues) HapticProps::Isovalues(int tool) const
{
  auto values = HapticControl().isovalues;
  std::size_t shell = 0;
  for (const HapticProp& it : this->Props)
    if (it.tool == tool && it.Feels() && shell < values.size())
    {
      if (it.baked.dynamic)
        values[shell] = it.Isovalue();
      ++shell;
    }
  return values;
}

void HapticProps::ListResources(ResourceList& list) const
{
  ResourceUse maps{ "haptic maps", 0, 0.0, "nothing to touch, or no tool" };
  ResourceUse shells{ "haptic shells", 0, 0.0, "nothing to touch, or no tool" };
  for (const HapticProp& it : this->Props)
  {
    ResourceList of;
    if (it.baked.map)
      it.baked.map->ListResources(of);
    for (const ResourceUse& use : of)
      maps.bytes += use.bytes;
    of.clear();
    if (it.baked.shell)
      it.baked.shell->ListResources(of);
    for (const ResourceUse& use : of)
      shells.bytes += use.bytes;
  }
  if (this->Wanted())
    maps.reason = shells.reason = "a tool and something to touch";
  list.push_back(maps);
  list.push_back(shells);
}

} // namespace hasp
