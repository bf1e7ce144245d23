#include "Distance/NearSurface.h"

#include "Grid/ParallelFor.h"
#include "SolidChecks.h"

namespace hasp
{

namespace
{
constexpr int Edge = NearSurface::Edge;
constexpr int BoxEdge = 8; ///< blocks of a box along each axis

/// Half the longest diagonal of `samples` samples along each axis, mm, and a little for rounding.
double Reach(const GridGeometry& geometry, int samples)
{
  const glm::dmat3 step = geometry.IndexToWorldMatrix();
  double most = 0.0;
  for (int n = 0; n < 4; ++n)
    most = std::max(
      most, glm::length(step[0] + (n & 1 ? -1.0 : 1.0) * step[1] + (n & 2 ? -1.0 : 1.0) * step[2]));
  return 0.5 * (samples - 1) * most * (1.0 + 1e-9) + SolidTieMm;
}

class Evaluation
{
public:
  Evaluation(const ImplicitSolid& solid, const GridGeometry& geometry, double bandMm)
    : Solid(solid),
      Steepness(solid.Steepness()),
      ReachOfBlock(Reach(geometry, Edge)),
      ReachOfBox(Reach(geometry, Edge * BoxEdge))
  {
    this->Field.geometry = geometry;
    this->Field.bandMm = bandMm;
    this->Field.blocks = (geometry.dims + (Edge - 1)) / Edge;
    this->Boxes = (this->Field.blocks + (BoxEdge - 1)) / BoxEdge;
    const glm::dvec3 blocks(this->Field.blocks);
    const double all = blocks.x * blocks.y * blocks.z;
    if (all > double(std::numeric_limits<std::uint32_t>::max()))
      throw std::invalid_argument("near surface: the grid has " + SolidNumber(all) +
                                  " blocks of 8^3 samples; at most 2^32 - 1: a coarser grid");
    this->Field.sides.resize(static_cast<std::size_t>(all));
  }

  NearSurface Run(const ProgressFunction& progress)
  {
    const std::int64_t boxes = std::int64_t(this->Boxes.x) * this->Boxes.y * this->Boxes.z;
    this->ForEach(boxes, 0.0, 0.1, progress, [&](std::int64_t n) { this->Sort(n); });
    for (std::size_t n = 0; n < this->Field.sides.size(); ++n)
      if (this->Field.sides[n] == NearSurface::Side::Near)
        this->Field.near.push_back(static_cast<std::uint32_t>(n));
    this->Field.values.resize(this->Field.near.size() * NearSurface::BlockSamples);
    this->ForEach(std::int64_t(this->Field.near.size()), 0.1, 1.0, progress,
      [&](std::int64_t n) { this->Evaluate(n); });
    return std::move(this->Field);
  }

private:
  template <typename Body>
  static void ForEach(std::int64_t count, double begin, double end,
    const ProgressFunction& progress, const Body& body)
  {
    constexpr std::int64_t Batch = 128; // between two reports
    for (std::int64_t at = 0; at < count; at += Batch)
    {
      ReportProgress(progress, begin + (end - begin) * double(at) / double(count));
      ParallelFor(at, std::min(count, at + Batch), 4,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
            body(n);
        });
    }
  }

  /// Of the samples from `first` on, by the value in the middle of a cube of them.
  NearSurface::Side SideOf(const glm::ivec3& first, int samples, double reach) const
  {
    const glm::dvec3 middle = glm::dvec3(first) + 0.5 * (samples - 1);
    const double value = this->Solid.At(this->Field.geometry.IndexToWorld(middle));
    const double least = this->Field.bandMm + this->Steepness * reach;
    return value >= least    ? NearSurface::Side::Outside
           : value <= -least ? NearSurface::Side::Inside
                             : NearSurface::Side::Near;
  }

  void Sort(std::int64_t box)
  {
    const glm::ivec3 first =
      BoxEdge * glm::ivec3(box % this->Boxes.x, box / this->Boxes.x % this->Boxes.y,
                  box / this->Boxes.x / this->Boxes.y);
    const glm::ivec3 end = glm::min(first + BoxEdge, this->Field.blocks);
    const NearSurface::Side whole = this->SideOf(first * Edge, Edge * BoxEdge, this->ReachOfBox);
    for (int k = first.z; k < end.z; ++k)
      for (int j = first.y; j < end.y; ++j)
        for (int i = first.x; i < end.x; ++i)
          this->Field
            .sides[(std::size_t(k) * this->Field.blocks.y + j) * this->Field.blocks.x + i] =
            whole != NearSurface::Side::Near
              ? whole
              : this->SideOf(glm::ivec3(i, j, k) * Edge, Edge, this->ReachOfBlock);
  }

  void Evaluate(std::int64_t held)
  {
    const glm::ivec3 first = this->Field.FirstSample(this->Field.near[held]);
    const glm::ivec3 dims = this->Field.geometry.dims;
    const float band = static_cast<float>(this->Field.bandMm);
    float* value = this->Field.values.data() + held * NearSurface::BlockSamples;
    for (int k = first.z; k < first.z + Edge; ++k)
      for (int j = first.y; j < first.y + Edge; ++j)
        for (int i = first.x; i < first.x + Edge; ++i)
          *value++ = i < dims.x && j < dims.y && k < dims.z
                       ? glm::clamp(static_cast<float>(this->Solid.At(
                                      this->Field.geometry.IndexToWorld({ i, j, k }))),
                           -band, band)
                       : band;
  }

  const ImplicitSolid& Solid;
  double Steepness, ReachOfBlock, ReachOfBox;
  glm::ivec3 Boxes;
  NearSurface Field;
};
} // namespace

glm::ivec3 NearSurface::FirstSample(std::uint32_t block) const
{
  const std::uint32_t x = this->blocks.x, y = this->blocks.y;
  return Edge * glm::ivec3(block % x, block / x % y, block / x / y);
}

NearSurface EvaluateNearSurface(const ImplicitSolid& solid, const GridGeometry& geometry,
  double bandMm, const ProgressFunction& progress)
{
  geometry.Validate();
  RequirePositive("near surface", "band", bandMm);
  return Evaluation(solid, geometry, bandMm).Run(progress);
}

std::vector<float> DenseValues(const NearSurface& field)
{
  const glm::ivec3 dims = field.geometry.dims;
  const float band = static_cast<float>(field.bandMm);
  std::vector<float> dense(field.geometry.Size());
  const auto forBlock = [&](std::uint32_t block, const auto& valueAt)
  {
    const glm::ivec3 first = field.FirstSample(block), end = glm::min(first + Edge, dims);
    for (int k = first.z; k < end.z; ++k)
      for (int j = first.y; j < end.y; ++j)
        for (int i = first.x; i < end.x; ++i)
          dense[(std::size_t(k) * dims.y + j) * dims.x + i] =
            valueAt(((k - first.z) * Edge + (j - first.y)) * Edge + (i - first.x));
  };
  for (std::size_t n = 0; n < field.sides.size(); ++n)
    if (field.sides[n] != NearSurface::Side::Near)
      forBlock(static_cast<std::uint32_t>(n),
        [&](int) { return field.sides[n] == NearSurface::Side::Inside ? -band : band; });
  for (std::size_t held = 0; held < field.near.size(); ++held)
    forBlock(
      field.near[held], [&](int n) { return field.values[held * NearSurface::BlockSamples + n]; });
  return dense;
}

} // namespace hasp
