#include "DistanceErrors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{

void DistanceErrors::Add(double errorMm, const glm::dvec3& world, const std::string& shape)
{
  const double error = errorMm / this->UnitMm, size = std::abs(error);
  ++this->Total;
  this->Squares += error * error;
  this->Sum += error;
  const bool number = std::isfinite(size);
  ++this->Counts[number ? static_cast<int>(std::min<double>(Bins, size / BinVoxels)) : Bins];
  if (!(size <= this->Largest) && std::isfinite(this->Largest))
  {
    this->Largest = number ? size : std::numeric_limits<double>::infinity();
    this->Where = world;
    this->Shape = shape;
  }
}

void DistanceErrors::Add(const DistanceErrors& other)
{
  this->Total += other.Total;
  this->Squares += other.Squares;
  this->Sum += other.Sum;
  for (std::size_t bin = 0; bin < this->Counts.size(); ++bin)
    this->Counts[bin] += other.Counts[bin];
  if (other.Largest > this->Largest)
  {
    this->Largest = other.Largest;
    this->Where = other.Where;
    this->Shape = other.Shape;
  }
}

double DistanceErrors::Rms() const
{
  return std::sqrt(this->Squares / static_cast<double>(this->Total));
}

double DistanceErrors::P99() const
{
  const auto within = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(this->Total)));
  std::size_t count = 0;
  for (int bin = 0; bin < Bins; ++bin)
    if ((count += this->Counts[bin]) >= within)
      return (bin + 1) * BinVoxels;
  return std::max(Bins * BinVoxels, this->Largest);
}

double DistanceErrors::Bias() const
{
  return this->Sum / static_cast<double>(this->Total);
}

std::string DistanceErrors::Text() const
{
  const double mm = this->UnitMm;
  char text[260];
  std::snprintf(text, sizeof text,
    "RMS %.3g voxel (%.3g mm), 99th percentile %.3g (%.3g), most %.3g (%.3g) of %s at (%.1f, %.1f, "
    "%.1f) mm, bias %.2g",
    this->Rms(), mm * this->Rms(), this->P99(), mm * this->P99(), this->Most(), mm * this->Most(),
    this->Shape.c_str(), this->Where.x, this->Where.y, this->Where.z, this->Bias());
  return text;
}

void AddErrors(const std::vector<float>& distances, const std::vector<double>& truth,
  const GridGeometry& grid, const ErrorRange& range, const std::string& shape,
  DistanceErrors& errors)
{
  const glm::ivec3 n = grid.dims;
  const int border = range.borderVoxels;
  const double voxel = std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
  for (int k = border; k < n.z - border; ++k)
    for (int j = border; j < n.y - border; ++j)
      for (int i = border; i < n.x - border; ++i)
      {
        const std::size_t v = (std::size_t(k) * n.y + j) * n.x + i;
        if (truth[v] >= range.leastVoxels * voxel && truth[v] <= range.mostVoxels * voxel)
          errors.Add(distances[v] - truth[v], grid.IndexToWorld(glm::dvec3(i, j, k)), shape);
      }
}

} // namespace hasp
