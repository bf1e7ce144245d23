#include "DynamicRival.h"

#include <algorithm>
#include <cmath>

namespace rival::o2
{

#include "ContactRivalCell-inl.h"

namespace
{
constexpr int Side = 8;
}

DynamicShell::DynamicShell(const Map& own, const Map& other, std::size_t room)
  : Own(own),
    Other(other),
    Room(room)
{
  this->Ring.reserve(room);
  for (int z = 0; z + 1 < own.dims.z; z += Side)
    for (int y = 0; y + 1 < own.dims.y; y += Side)
      for (int x = 0; x + 1 < own.dims.x; x += Side)
      {
        Block block{ { x, y, z }, {} };
        this->FindCells(block);
        if (!block.cells.empty())
          this->Blocks.push_back({ block.first, {} });
      }
  this->Near.reserve(this->Blocks.size());
}

bool DynamicShell::Crossed(const glm::ivec3& cell) const
{
  const std::size_t row = this->Own.dims.x, slice = row * this->Own.dims.y;
  const float* p = this->Own.mm + cell.z * slice + cell.y * row + cell.x;
  int inside = 0;
  for (const std::size_t at : { std::size_t(0), std::size_t(1), row, row + 1, slice, slice + 1,
         slice + row, slice + row + 1 })
    inside += p[at] < 0.0F ? 1 : 0;
  return inside > 0 && inside < 8;
}

void DynamicShell::FindCells(Block& block) const
{
  const glm::ivec3 end = glm::min(block.first + Side, this->Own.dims - 1);
  for (int z = block.first.z; z < end.z; ++z)
    for (int y = block.first.y; y < end.y; ++y)
      for (int x = block.first.x; x < end.x; ++x)
        if (this->Crossed({ x, y, z }))
          block.cells.emplace_back(x, y, z);
}

bool DynamicShell::Project(Point& point) const
{
  for (int step = 0; step < 5; ++step)
  {
    Corners corners;
    if (!Find(this->Own, point.position, corners))
      return false;
    const glm::vec3 slope = corners.Gradient() * this->Own.perSpacing;
    const float length = glm::length(slope);
    if (!(length > 0.0F))
      return false;
    const float off = corners.Value() / length, voxel = 1.0F / this->Own.perSpacing;
    point.normal = slope / length;
    point.position -= glm::clamp(off, -0.5F * voxel, 0.5F * voxel) * point.normal;
    if (std::abs(off) < 0.02F * voxel)
      return true;
  }
  return false;
}

void DynamicShell::Update(const Pose& pose, int draws, float marginMm)
{
  const float voxel = 1.0F / this->Own.perSpacing, radius = 0.5F * Side * voxel * std::sqrt(3.0F);
  this->Near.clear();
  for (Block& block : this->Blocks)
  {
    const glm::vec3 middle =
      this->Own.origin + voxel * (glm::vec3(block.first) + 0.5F * static_cast<float>(Side));
    Corners corners;
    if (Find(this->Other, pose.turn * middle + pose.position, corners) &&
        corners.Value() <= radius + marginMm)
      this->Near.push_back(&block);
    else
      block.cells.clear();
  }
  for (int n = 0; n < draws && !this->Near.empty(); ++n)
  {
    Block& block = *this->Near[this->Random() % this->Near.size()];
    if (block.cells.empty())
      this->FindCells(block);
    const glm::ivec3 cell = block.cells[this->Random() % block.cells.size()];
    const float x = this->Share(), y = this->Share(), z = this->Share();
    Point point{ this->Own.origin + voxel * (glm::vec3(cell) + glm::vec3(x, y, z)), {} };
    if (!this->Project(point))
      continue;
    if (this->Ring.size() < this->Room)
      this->Ring.push_back(point);
    else
      this->Ring[this->Head++ % this->Room] = point;
  }
}

} // namespace rival::o2
