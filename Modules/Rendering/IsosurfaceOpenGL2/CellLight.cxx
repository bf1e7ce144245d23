#include "CellLight.h"

#include "CellScene.h"
#include "CellTracing.h"
#include "Grid/Stopwatch.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#if HASP_WITH_EMBREE

namespace
{

/// The first of the scene's lights, as the cells' world sees it.
std::optional<glm::dvec4> FirstLight(const CellScene& scene, const hasp::GridGeometry& geometry)
{
  if (scene.lightColor.empty())
    return {};
  const glm::dmat4 viewToIndex = glm::inverse(scene.indexToView);
  if (scene.lightCone[0].z > 0.5F)
  {
    const glm::dvec4 place = viewToIndex * glm::dvec4(glm::dvec3(scene.lightPosition[0]), 1.0);
    return glm::dvec4(geometry.IndexToWorld(glm::dvec3(place)), 1.0);
  }
  const glm::dvec3 towards = glm::dmat3(viewToIndex) * -glm::dvec3(scene.lightDirection[0]);
  const glm::dvec3 world = geometry.IndexToWorldMatrix() * towards;
  if (!(glm::dot(world, world) > 0.0))
    return {}; // it stands where it looks at, and lights nothing
  return glm::dvec4(world, 0.0);
}

} // namespace

/// A picture is one of a pair where a rig says so, whatever is drawn between its eyes, or where the
/// last one was of the same renderer's other eye.
hasp::LightEye CellLight::EyeOf(vtkRenderer* renderer, bool ofRig, vtkMTimeType picture)
{
  if (picture == this->Seen)
    return this->Eye;
  const bool left = renderer->GetActiveCamera()->GetLeftEye();
  const bool pair = ofRig || (this->Renderer == renderer && left != this->Left);
  this->Seen = picture;
  this->Renderer = renderer;
  this->Left = left;
  this->Eye = !pair ? hasp::LightEye::Alone : left ? hasp::LightEye::First : hasp::LightEye::Second;
  return this->Eye;
}

void CellLight::Update(const CellTracing& tracing, const CellScene& scene, vtkRenderer* renderer,
  const Wanted& wanted, vtkMTimeType time, const Edit& edit)
{
  const hasp::Stopwatch watch;
  if (!wanted.ambientOcclusion && this->CacheBytes() > 0)
    this->Cache.reset();
  if (!this->Cache)
    this->Cache = std::make_shared<hasp::LightCache>();
  if (time != this->CellsTime)
  {
    if (edit.time == this->CellsTime)
      this->Cache->Forget(edit.low, edit.high);
    else
      this->Cache->Forget();
  }
  this->CellsTime = time;
  hasp::PictureLightSettings settings;
  settings.eye = this->EyeOf(renderer, scene.otherIndexToClip.has_value(), tracing.PictureTime());
  if (wanted.ambientOcclusion)
    settings.ambientDistanceMm = wanted.distanceMm;
  const hasp::CellTracer& tracer = tracing.GetTracer();
  if (wanted.shadows)
    settings.light = FirstLight(scene, tracer.Cells().geometry);
  this->Cache->Light(tracer, tracing.GetView(), tracing.Picture(), settings, this->Pixels);
  this->Time.Modified();
  this->Spent = watch.Milliseconds();
}

std::size_t CellLight::CacheBytes() const
{
  return this->Cache ? this->Cache->Bytes() : 0;
}

std::size_t CellLight::SharedBytes() const
{
  return this->Cache ? this->Cache->SharedBytes() : 0;
}

#else

void CellLight::Update(
  const CellTracing&, const CellScene&, vtkRenderer*, const Wanted&, vtkMTimeType, const Edit&)
{
}

std::size_t CellLight::SharedBytes() const
{
  return 0;
}

std::size_t CellLight::CacheBytes() const
{
  return 0;
}

#endif
