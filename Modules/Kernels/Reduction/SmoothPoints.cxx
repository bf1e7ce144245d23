#include "Reduction/SmoothPoints.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double MostBoxes = 1 << 24;
constexpr int FewestNeighbours = 3; // of fewer, a mean says nothing

/// All that are smooth, in their order.
std::vector<OrientedPoint> Smoothed(
  std::span<const OrientedPoint> all, double radiusMm, double flatness)
{
  const PointBoxes boxes(all, radiusMm);
  std::vector<glm::dvec3> means(all.size(), glm::dvec3(0.0));
  ParallelFor(0, std::int64_t(all.size()), 256,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        const OrientedPoint& at = all[n];
        glm::dvec3 sum(0.0);
        int count = 0;
        boxes.NearTo(at.place, radiusMm,
          [&](std::uint32_t k)
          {
            const OrientedPoint& other = all[k];
            const glm::dvec3 way = other.place - at.place;
            // The far side of a thin wall looks the other way, and says nothing about this one.
            if (glm::dot(way, way) > radiusMm * radiusMm ||
                glm::dot(other.normal, at.normal) < -0.2)
              return;
            sum += other.normal;
            ++count;
          });
        if (count >= FewestNeighbours)
          means[n] = sum / double(count);
      }
    });
  std::vector<OrientedPoint> smooth;
  for (std::size_t n = 0; n < all.size(); ++n)
    if (const double length = glm::length(means[n]); length >= flatness)
      smooth.push_back({ all[n].place, means[n] / length });
  return smooth;
}

std::vector<OrientedPoint> EveryNth(std::vector<OrientedPoint> points, std::size_t step)
{
  std::vector<OrientedPoint> some;
  for (std::size_t n = 0; n < points.size(); n += step)
    some.push_back(points[n]);
  return some;
}

constexpr double SmoothBoxMm = 3.0;
} // namespace

PointBoxes::PointBoxes(std::span<const OrientedPoint> points, double boxMm) : BoxMm(boxMm)
{
  glm::dvec3 high(-1e300);
  this->Low = points.empty() ? glm::dvec3(0.0) : glm::dvec3(1e300);
  for (const OrientedPoint& p : points)
  {
    this->Low = glm::min(this->Low, p.place);
    high = glm::max(high, p.place);
  }
  if (!points.empty())
  {
    const glm::dvec3 size = high - this->Low;
    const auto boxes = [&](double mm)
    {
      const glm::dvec3 counts = glm::floor(size / mm) + 1.0;
      return counts.x * counts.y * counts.z;
    };
    while (boxes(this->BoxMm) > MostBoxes)
      this->BoxMm *= 2.0;
    this->Counts = glm::ivec3(glm::floor(size / this->BoxMm)) + 1;
  }
  this->Starts.assign(std::size_t(this->Counts.x) * this->Counts.y * this->Counts.z + 1, 0);
  std::vector<std::size_t> box(points.size());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const glm::ivec3 at = this->BoxOf(points[n].place);
    box[n] = (std::size_t(at.z) * this->Counts.y + at.y) * this->Counts.x + at.x;
    ++this->Starts[box[n] + 1];
  }
  for (std::size_t b = 1; b < this->Starts.size(); ++b)
    this->Starts[b] += this->Starts[b - 1];
  this->Order.resize(points.size());
  std::vector<std::uint32_t> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t n = 0; n < points.size(); ++n)
    this->Order[next[box[n]]++] = std::uint32_t(n);
}

SmoothPoints::SmoothPoints(std::span<const OrientedPoint> all, double areaMm2, double radiusMm,
  double flatness, double keptMm2)
  : Kept(Smoothed(all, radiusMm, flatness)),
    Area(areaMm2 * double(Kept.size())),
    Boxes({}, SmoothBoxMm)
{
  this->Kept =
    EveryNth(std::move(this->Kept), std::max<std::size_t>(1, std::size_t(keptMm2 / areaMm2 + 0.5)));
  this->Area = this->Kept.empty() ? 0.0 : this->Area / double(this->Kept.size());
  this->Boxes = PointBoxes(this->Kept, SmoothBoxMm);
}

} // namespace hasp
