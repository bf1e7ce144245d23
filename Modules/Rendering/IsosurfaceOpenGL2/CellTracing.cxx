#include "CellTracing.h"

#include "CellScene.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace
{

double MillisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

/// Pixels [first, end) of a viewport.
struct PixelRectangle
{
  glm::ivec2 first, end;
};

/// What a box may cover. All, if a corner is not before the eye.
PixelRectangle Cover(const glm::dvec3& low, const glm::dvec3& high, const CellScene& scene)
{
  const glm::dvec2 size(scene.viewportSize);
  glm::dvec2 least(1e30), most(-1e30);
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 corner(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
    const glm::dvec4 clip = scene.indexToClip * glm::dvec4(corner, 1.0);
    if (!(clip.w > 0.0))
      return { glm::ivec2(0), scene.viewportSize };
    const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size;
    least = glm::min(least, pixel);
    most = glm::max(most, pixel);
  }
  const auto inside = [&](const glm::dvec2& pixel)
  { return glm::ivec2(glm::clamp(pixel, glm::dvec2(0.0), size)); };
  return { inside(glm::floor(least) - 1.0), inside(glm::ceil(most) + 1.0) };
}

/// The scene's view, through a part of its viewport.
hasp::PictureView ViewOf(const CellScene& scene, const PixelRectangle& part)
{
  hasp::PictureView view;
  view.size = glm::max(part.end - part.first, glm::ivec2(0));
  view.planes.assign(scene.planes.begin() + 1, scene.planes.end()); // the tracer knows the near one
  const glm::dvec2 whole(scene.viewportSize), size(glm::max(view.size, glm::ivec2(1)));
  const glm::dvec2 scale = whole / size;
  const glm::dvec2 offset = (whole - 2.0 * glm::dvec2(part.first) - size) / size;
  glm::dmat4 toPart(1.0);
  toPart[0].x = scale.x;
  toPart[1].y = scale.y;
  toPart[3].x = offset.x;
  toPart[3].y = offset.y;
  view.indexToClip = toPart * scene.indexToClip;
  return view;
}

} // namespace

#if HASP_WITH_EMBREE

bool CellTracing::Available()
{
  return true;
}

void CellTracing::Update(const hasp::ClusteredCells& cells, vtkMTimeType time)
{
  if (this->Tracer && time == this->CellsTime)
    return;
  hasp::TracedPicture picture = std::move(this->Traced); // the next one takes its memory
  this->Release();
  this->Traced = std::move(picture);
  const auto start = std::chrono::steady_clock::now();
  // The mapper owns the cells, and changes them only before the next Update.
  const std::shared_ptr<const hasp::ClusteredCells> borrowed(std::shared_ptr<void>(), &cells);
  this->Tracer = std::make_shared<const hasp::CellTracer>(borrowed);
  this->CellsTime = time;
  this->Low = glm::dvec3(1e30);
  this->High = glm::dvec3(-1e30);
  for (const hasp::CellCluster& cluster : cells.clusters)
  {
    this->Low = glm::min(this->Low, glm::dvec3(cluster.Origin()));
    this->High = glm::max(this->High, glm::dvec3(cluster.Origin() + 8));
  }
  this->Milliseconds = MillisecondsSince(start);
}

void CellTracing::Trace(const CellScene& scene, vtkMTimeType since, bool lit)
{
  const PixelRectangle part = Cover(this->Low, this->High, scene);
  hasp::PictureView view = ViewOf(scene, part);
  const bool has = !lit || this->Traced.places.size() == this->Traced.cells.size();
  if (this->Time > since && part.first == this->First && view == this->View && has)
    return;
  const auto start = std::chrono::steady_clock::now();
  this->Time = {}; // if tracing fails there is none
  this->First = part.first;
  this->Tracer->TracePicture(view, this->Traced, lit);
  this->View = std::move(view);
  this->Time.Modified();
  this->TraceMilliseconds = MillisecondsSince(start);
}

std::size_t CellTracing::TreeBytes() const
{
  return this->Tracer ? this->Tracer->Bytes() : 0;
}

#else

bool CellTracing::Available()
{
  return false;
}

void CellTracing::Update(const hasp::ClusteredCells&, vtkMTimeType)
{
  throw std::runtime_error("this build of Hasp was made without ray tracing; configure it with "
                           "HASP_ENABLE_EMBREE=ON (Debian: libembree-dev)");
}

void CellTracing::Trace(const CellScene&, vtkMTimeType, bool) {}

std::size_t CellTracing::TreeBytes() const
{
  return 0;
}

#endif

std::size_t CellTracing::PictureBytes() const
{
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  return bytes(this->Traced.cells) + bytes(this->Traced.places) + bytes(this->Traced.corners) +
         bytes(this->Traced.gradients);
}
