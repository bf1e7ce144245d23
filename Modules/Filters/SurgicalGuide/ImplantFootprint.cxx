#include "ImplantFootprint.h"

#include "Distance/GridSolid.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr float FarMm = 1e3F;
constexpr double SecondShare = 0.05; // of the largest part's area
constexpr std::size_t MostHoles = 2000;

struct Piece
{
  glm::dvec2 a, b;
};

/// The line where a layer is 0, square by square; where it could part two ways, the middle decides.
std::vector<Piece> ZeroLine(const ColumnLayer& layer)
{
  const int width = layer.grid.dims.x, height = layer.grid.dims.y;
  std::vector<Piece> line;
  for (int j = 0; j + 1 < height; ++j)
    for (int i = 0; i + 1 < width; ++i)
    {
      const std::size_t first = std::size_t(j) * width + i;
      const std::size_t corners[4] = { first, first + 1, first + width + 1, first + width };
      glm::dvec2 crossings[4];
      int count = 0;
      double middle = 0.0;
      for (int c = 0; c < 4; ++c)
      {
        const double a = layer.values[corners[c]], b = layer.values[corners[(c + 1) % 4]];
        middle += a;
        if ((a > 0.0) != (b > 0.0))
          crossings[count++] =
            glm::mix(layer.Place(corners[c]), layer.Place(corners[(c + 1) % 4]), a / (a - b));
      }
      if (count == 2)
        line.push_back({ crossings[0], crossings[1] });
      // The first corner is joined with its opposite, or cut off.
      else if (count == 4 && (middle > 0.0) == (layer.values[first] > 0.0F))
        line.insert(line.end(), { { crossings[0], crossings[1] }, { crossings[2], crossings[3] } });
      else if (count == 4)
        line.insert(line.end(), { { crossings[3], crossings[0] }, { crossings[1], crossings[2] } });
    }
  return line;
}

double SquaredDistance(const glm::dvec2& place, const Piece& piece)
{
  const glm::dvec2 along = piece.b - piece.a, v = place - piece.a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? glm::clamp(glm::dot(v, along) / squared, 0.0, 1.0) : 0.0;
  const glm::dvec2 off = v - t * along;
  return glm::dot(off, off);
}

/// Columns of one connected part, where the layer is positive.
using Part = std::vector<std::uint32_t>;

Part TakePart(const ColumnLayer& layer, std::uint32_t seed, std::vector<std::uint8_t>& taken)
{
  const auto width = std::uint32_t(layer.grid.dims.x);
  Part part{ seed };
  taken[seed] = 1;
  for (std::size_t next = 0; next < part.size(); ++next)
  {
    const std::uint32_t n = part[next], i = n % width;
    const auto visit = [&](bool there, std::uint32_t m)
    {
      if (!there || taken[m] || !(layer.values[m] > 0.0F))
        return;
      taken[m] = 1;
      part.push_back(m);
    };
    visit(i > 0, n - 1);
    visit(i + 1 < width, n + 1);
    visit(n >= width, n - width);
    visit(n + width < layer.values.size(), n + width);
  }
  return part;
}

/// The largest first.
std::vector<Part> PartsOf(const ColumnLayer& layer)
{
  std::vector<std::uint8_t> taken(layer.values.size());
  std::vector<Part> parts;
  for (std::uint32_t n = 0; n < layer.values.size(); ++n)
    if (!taken[n] && layer.values[n] > 0.0F)
      parts.push_back(TakePart(layer, n, taken));
  std::stable_sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size() > b.size(); });
  return parts;
}

/// The middle of a part, as high as the outline's.
glm::dvec3 MiddleOf(const ColumnLayer& layer, const Part& part, std::span<const glm::dvec3> outline)
{
  glm::dvec2 sum(0.0);
  for (const std::uint32_t n : part)
    sum += layer.Place(n) / double(part.size());
  double height = 0.0;
  for (const glm::dvec3& p : outline)
    height += ((p - layer.grid.origin) * layer.grid.direction).z / double(outline.size());
  return layer.grid.origin + layer.grid.direction * glm::dvec3(sum, height);
}

void RefuseSecond(const ColumnLayer& layer, const Part& first, const Part& second,
  std::span<const glm::dvec3> outline)
{
  const glm::dvec3 a = MiddleOf(layer, first, outline), b = MiddleOf(layer, second, outline);
  std::ostringstream text;
  text.precision(4);
  text << "implant: there is more than one hole within the outline, such as at (" << a.x << ", "
       << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y << ", " << b.z
       << "); go around one of them, or take less clearance or thickness";
  throw std::runtime_error(text.str());
}
} // namespace

double ColumnLayer::At(const glm::dvec2& place) const
{
  const glm::ivec2 cells = glm::ivec2(this->grid.Cells());
  const glm::dvec2 at =
    glm::clamp(place / glm::dvec2(this->grid.spacing), glm::dvec2(0.0), glm::dvec2(cells));
  const glm::ivec2 cell = glm::clamp(glm::ivec2(at), glm::ivec2(0), cells - 1);
  const glm::dvec2 local = at - glm::dvec2(cell);
  const float* v = &this->values[std::size_t(cell.y) * this->grid.dims.x + cell.x];
  const double low = glm::mix(double(v[0]), double(v[1]), local.x);
  v += this->grid.dims.x;
  return glm::mix(low, glm::mix(double(v[0]), double(v[1]), local.x), local.y);
}

ColumnLayer DistanceToZero(ColumnLayer layer)
{
  const std::vector<Piece> line = ZeroLine(layer);
  ParallelFor(0, std::int64_t(layer.values.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        double least = double(FarMm) * FarMm;
        const glm::dvec2 place = layer.Place(std::size_t(n));
        for (const Piece& piece : line)
          least = std::min(least, SquaredDistance(place, piece));
        layer.values[n] = std::copysign(float(std::sqrt(least)), layer.values[n]);
      }
    });
  return layer;
}

ColumnLayer MakeFootprint(const ColumnLayer& toBlocked, double clearanceMm, double radiusMm,
  std::span<const glm::dvec3> outline)
{
  ColumnLayer eroded = toBlocked;
  for (float& value : eroded.values)
    value -= float(clearanceMm + radiusMm);
  const std::vector<Part> parts = PartsOf(eroded);
  if (parts.empty())
  {
    std::ostringstream text;
    text << "implant: there is no hole within the outline that a disc of "
         << 2.0 * (clearanceMm + radiusMm)
         << " mm goes through along the axis (the implant's thickness, and clearanceMm twice)";
    throw std::runtime_error(text.str());
  }
  if (parts.size() > 1 && double(parts[1].size()) > SecondShare * double(parts[0].size()))
    RefuseSecond(eroded, parts[0], parts[1], outline);
  for (std::size_t n = 1; n < parts.size(); ++n)
    for (const std::uint32_t column : parts[n])
      eroded.values[column] = -float(eroded.grid.spacing.x);
  ColumnLayer footprint = DistanceToZero(std::move(eroded));
  for (float& value : footprint.values)
    value += float(radiusMm);
  return footprint;
}

SolidPointer MakeFootprintSolid(const ColumnLayer& footprint)
{
  auto both = std::make_shared<std::vector<float>>();
  both->reserve(2 * footprint.values.size());
  for (int layer = 0; layer < 2; ++layer)
    for (const float value : footprint.values)
      both->push_back(-value);
  GridGeometry ends = footprint.grid;
  ends.spacing.z *= footprint.grid.Cells().z;
  ends.dims.z = 2;
  return MakeGridSolid(std::move(both), ends);
}

std::vector<glm::dvec2> PlacePerforation(const ColumnLayer& footprint, double pitchMm, double room)
{
  glm::dvec2 middle(0.0),
    size = glm::dvec2(footprint.grid.spacing) * glm::dvec2(footprint.grid.Cells());
  double count = 0.0;
  for (std::size_t n = 0; n < footprint.values.size(); ++n)
    if (footprint.values[n] > 0.0F)
    {
      middle += footprint.Place(n);
      count += 1.0;
    }
  middle /= std::max(count, 1.0);
  const double row = pitchMm * std::sqrt(0.75);
  const int rows = int(size.y / row) + 1, columns = int(size.x / pitchMm) + 2;
  std::vector<glm::dvec2> holes;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i)
    {
      const glm::dvec2 place = middle + glm::dvec2((i + (j % 2 ? 0.5 : 0.0)) * pitchMm, j * row);
      if (!(footprint.At(place) >= room))
        continue;
      if (holes.size() == MostHoles)
        throw std::runtime_error("implant: there would be more than " + std::to_string(MostHoles) +
                                 " holes; raise holePitchMm");
      holes.push_back(place);
    }
  return holes;
}

} // namespace hasp
