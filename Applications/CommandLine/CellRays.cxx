#include "CellRays.h"

#include "CellDepth.h"
#include "CellRenderers.h"
#include "CellScene.h"
#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellTracer.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

namespace hasp
{
namespace
{

std::shared_ptr<const ClusteredCells> CellsOf(vtkImageData* image, double isovalue, bool compact)
{
  const AnyGridView grid = ViewImage(image);
  return std::make_shared<const ClusteredCells>(ExtractActiveCells(
    grid, MinMaxBlocks(grid), isovalue, compact ? CellPrecision::Compact : CellPrecision::Exact));
}

} // namespace

struct CellRays::Internals
{
  explicit Internals(std::shared_ptr<const ClusteredCells> cells) : tracer(std::move(cells)) {}

  CellTracer tracer;
  std::vector<CellRay> rays;
  std::vector<std::optional<CellHit>> hits;
};

CellRays::CellRays(const CellScene& scene, bool compact)
  : Inside(std::make_unique<Internals>(CellsOf(scene.image, scene.isovalue, compact)))
{
}

CellRays::~CellRays() = default;

void CellRays::SetRays(std::span<const WorldRay> rays)
{
  const GridGeometry& g = this->Inside->tracer.Cells().geometry;
  this->Inside->rays.clear();
  for (const WorldRay& ray : rays)
  {
    const glm::dvec3 origin = g.WorldToIndex(ray.origin);
    this->Inside->rays.push_back({ origin, g.WorldToIndex(g.origin + ray.direction) });
  }
  this->Inside->hits.resize(rays.size());
}

void CellRays::Trace()
{
  Internals& in = *this->Inside;
  ParallelFor(0, std::int64_t(in.rays.size()), 4096, // as many rays a task as the rival
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        in.hits[n] = in.tracer.Trace(in.rays[n]);
    });
}

SurfacePoints CellRays::Points() const
{
  const GridGeometry& g = this->Inside->tracer.Cells().geometry;
  SurfacePoints points;
  for (const std::optional<CellHit>& hit : this->Inside->hits)
    points.push_back(hit ? std::optional(g.IndexToWorld(hit->Position())) : std::nullopt);
  return points;
}

std::size_t CellRays::CellBytes() const
{
  return this->Inside->tracer.Cells().Bytes();
}

std::size_t CellRays::TreeBytes() const
{
  return this->Inside->tracer.Bytes();
}

namespace
{

class TracerMethod : public IsosurfaceMethod
{
public:
  explicit TracerMethod(const IsosurfaceView& view) : Rays({ "", "", view.image, view.isovalue })
  {
    this->Rays.SetRays(PixelRays(view));
  }
  std::string Name() const override { return "CellTracer, Embree, a ray a pixel"; }
  void Draw() override { this->Rays.Trace(); }
  SurfacePoints Points() override { return this->Rays.Points(); }
  std::size_t Bytes() const override { return this->Rays.CellBytes() + this->Rays.TreeBytes(); }

private:
  CellRays Rays;
};

} // namespace

std::unique_ptr<IsosurfaceMethod> MakeTracerMethod(const IsosurfaceView& view)
{
  return std::make_unique<TracerMethod>(view);
}

} // namespace hasp
