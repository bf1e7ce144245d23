#include "Isosurface/CellTracer.h"
#include "Isosurface/CellTracerScene.h"

namespace hasp
{

CellTracer::CellTracer(std::shared_ptr<const ClusteredCells> cells, const std::string& device)
  : Embree(std::make_unique<const Scene>(std::move(cells), device))
{
}

CellTracer::~CellTracer() = default;

const ClusteredCells& CellTracer::Cells() const
{
  return this->Embree->Cells();
}

std::size_t CellTracer::Bytes() const
{
  return this->Embree->Bytes();
}

std::optional<CellHit> CellTracer::Trace(const CellRay& ray) const
{
  CellWalkRay walk;
  CellWalkEntry entry;
  if (!this->Embree->Enter(ray, walk, entry))
    return std::nullopt;
  this->Embree->Nearest(walk);
  if (!walk.Hit())
    return std::nullopt;
  return this->Embree->HitOf(walk, entry);
}

bool CellTracer::Occluded(const CellRay& ray) const
{
  CellWalkRay walk;
  CellWalkEntry entry;
  return this->Embree->Enter(ray, walk, entry) && this->Embree->Any(walk);
}

} // namespace hasp
