#include "Light/Environment.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

namespace
{

constexpr double Pi = std::numbers::pi;
constexpr int BlockSize = 16; // pixels: 192 bytes that are added up in less time than a cache miss
constexpr double EdgeOfPixel = 0x1p-17;
constexpr glm::ivec2 LargestMap{ 16384, 8192 };
/// Light is gathered in so many cells for the irradiance.
constexpr int CellColumns = 32, CellRows = 16;
/// Normals of the upper half: up to the pole and down to the horizon, both included.
constexpr int NormalColumns = 128, NormalSteps = 32;

double Largest(const glm::vec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

bool IsRadiance(const glm::vec3& v)
{
  // Not a number compares false.
  const float most = std::numeric_limits<float>::max();
  return v.x >= 0 && v.x <= most && v.y >= 0 && v.y <= most && v.z >= 0 && v.z <= most;
}

void RequireSize(const EnvironmentMap& map)
{
  const std::string is =
    "environment map: " + std::to_string(map.size.x) + " x " + std::to_string(map.size.y);
  if (map.size.x < 1 || map.size.y < 1 || map.size.x > LargestMap.x || map.size.y > LargestMap.y)
    throw std::invalid_argument(is + " pixels; a size from 1 x 1 to 16384 x 8192 is needed, so "
                                     "scale it down or say its size");
  if (map.pixels.size() != std::size_t(map.size.x) * map.size.y)
    throw std::invalid_argument(is + " has " + std::to_string(map.pixels.size()) +
                                " pixels; width times height are needed, row by row");
}

void RequireRadiance(const EnvironmentMap& map, const std::string& of)
{
  std::size_t wrong = 0, first = 0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i)
    if (!IsRadiance(map.pixels[i]) && wrong++ == 0)
      first = i;
  if (wrong > 0)
    throw std::invalid_argument("environment map" + of +
                                ": pixels negative or not finite: " + std::to_string(wrong) +
                                ", the first in column " + std::to_string(first % map.size.x) +
                                " of row " + std::to_string(first / map.size.x) +
                                "; radiance is finite and at least 0, so mend or clamp them");
}

/// Right, forward, up.
glm::dmat3 AxesOf(const glm::dvec3& up, double turnRadians)
{
  const double longest = std::max({ std::abs(up.x), std::abs(up.y), std::abs(up.z) });
  if (!(longest > 0) || !std::isfinite(up.x + up.y + up.z) || !std::isfinite(turnRadians))
    throw std::invalid_argument("environment: up is (" + std::to_string(up.x) + ", " +
                                std::to_string(up.y) + ", " + std::to_string(up.z) +
                                ") and the turn " + std::to_string(turnRadians) +
                                " radians; both are finite and up is not 0");
  const glm::dvec3 z = glm::normalize(up / longest); // whose square might not be a double else
  const glm::dvec3 near = std::abs(z.x) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(near - z * glm::dot(near, z)), y = glm::cross(z, x);
  const double c = std::cos(turnRadians), s = std::sin(turnRadians);
  return { x * c + y * s, y * c - x * s, z };
}

/// The direction in the axes of the map; column and row in radians from the left and the top.
glm::dvec2 AnglesOf(const glm::dvec3& v)
{
  return { std::atan2(v.x, v.y) + Pi, std::atan2(std::sqrt(v.x * v.x + v.y * v.y), v.z) };
}

/// In [0, count), also for what is not a number.
int Clamped(double at, int count)
{
  return at > 0 ? static_cast<int>(std::min(at, count - 1.0)) : 0;
}

/// Cosine of the angle from up at the upper edge of a row.
double EdgeCosine(int row, int rows)
{
  return std::cos(Pi * row / rows);
}

/// Integrals over an interval of the angle from up: of the sine, its square, and sine times cosine.
/// As products, which lose nothing where the interval is small.
struct RowIntegrals
{
  RowIntegrals(int row, int rows)
  {
    const double width = Pi / rows, middle = (row + 0.5) * width;
    this->sine = 2 * std::sin(middle) * std::sin(width / 2);
    this->square =
      (width - std::sin(width)) / 2 + std::sin(width) * std::sin(middle) * std::sin(middle);
    this->cosine = std::sin(2 * middle) * std::sin(width) / 2;
  }
  double sine, square, cosine;
};

/// What of one channel comes from a cell: as much as from `vector` for normals that its directions
/// are all before, or all behind; where they are on both sides, they spread over the cosine by
/// about `spread` either way.
struct CellLight
{
  glm::dvec3 vector{ 0 };
  double flux = 0.0, spread = 0.0, halfInverse = 0.0;

  void Finish()
  {
    // The variance is that of both axes; a box of half width w has the variance w^2 / 3.
    const double square = this->flux * this->flux - glm::dot(this->vector, this->vector);
    this->spread = std::sqrt(std::max(0.0, 1.5 * square));
    this->halfInverse = this->spread > 0 ? 0.5 / this->spread : 0.0;
  }
  /// The integral of radiance times |cosine|.
  double Even(const glm::dvec3& normal) const
  {
    const glm::dvec3& v = this->vector; // by hand: most of a debug build's time is here
    const double cosine = std::abs(normal.x * v.x + normal.y * v.y + normal.z * v.z);
    return cosine >= this->spread ? cosine : cosine * cosine * this->halfInverse + this->spread / 2;
  }
};

using Cells = std::vector<std::array<CellLight, 3>>;

/// The map's light, over scale, in cells. Pixels larger than cells are cut.
Cells CellsOf(const EnvironmentMap& map, double scale)
{
  const int across = (CellColumns + map.size.x - 1) / map.size.x;
  const int down = (CellRows + map.size.y - 1) / map.size.y;
  const int width = map.size.x * across, height = map.size.y * down;
  std::vector<glm::dvec3> columns(width); // integrals over a column: of sine, cosine and 1
  const double step = 2 * Pi / width;
  for (int x = 0; x < width; ++x)
  {
    const double middle = (x + 0.5) * step - Pi, chord = 2 * std::sin(step / 2);
    columns[x] = { std::sin(middle) * chord, std::cos(middle) * chord, step };
  }
  Cells cells(std::size_t(CellColumns) * CellRows);
  for (int y = 0; y < height; ++y)
  {
    const RowIntegrals row(y, height);
    const glm::vec3* pixels = &map.pixels[std::size_t(y / down) * map.size.x];
    auto* cellRow = &cells[std::size_t(y) * CellRows / height * CellColumns];
    for (int cell = 0, x = 0; cell < CellColumns; ++cell)
    {
      glm::dvec3 sums[3] = {};
      for (; std::int64_t(x) * CellColumns < std::int64_t(cell + 1) * width; ++x)
      {
        const glm::vec3& pixel = pixels[x / across];
        for (int c = 0; c < 3; ++c)
          sums[c] += double(pixel[c]) * columns[x];
      }
      for (int c = 0; c < 3; ++c)
      {
        const glm::dvec3 sum = sums[c] / scale;
        cellRow[cell][c].vector +=
          glm::dvec3(sum.x * row.square, sum.y * row.square, sum.z * row.cosine);
        cellRow[cell][c].flux += sum.z * row.sine;
      }
    }
  }
  for (auto& cell : cells)
    for (CellLight& channel : cell)
      channel.Finish();
  return cells;
}

std::vector<glm::vec3> EvenIrradianceOf(const Cells& all)
{
  Cells cells; // that are not black
  for (const auto& cell : all)
    if (cell[0].flux + cell[1].flux + cell[2].flux > 0)
      cells.push_back(cell);
  std::vector<glm::vec3> table;
  table.reserve(std::size_t(NormalColumns) * (NormalSteps + 1));
  for (int row = 0; row <= NormalSteps; ++row)
    for (int column = 0; column < NormalColumns; ++column)
    {
      const double azimuth = 2 * Pi * column / NormalColumns - Pi;
      const double fromUp = Pi / 2 * row / NormalSteps, sine = std::sin(fromUp);
      const glm::dvec3 normal(std::sin(azimuth) * sine, std::cos(azimuth) * sine, std::cos(fromUp));
      glm::dvec3 sum(0);
      for (const auto& cell : cells)
        for (int c = 0; c < 3; ++c)
          sum[c] += cell[c].Even(normal);
      table.emplace_back(sum / 2.0);
    }
  return table;
}

} // namespace

Environment::Environment(
  EnvironmentMap map, const glm::dvec3& up, double turnRadians, float strength)
  : Axes(AxesOf(up, turnRadians))
{
  RequireSize(map);
  if (!(strength >= 0) || !std::isfinite(strength))
    throw std::invalid_argument("environment: a strength of " + std::to_string(strength) +
                                "; a finite number that is at least 0 is needed");
  RequireRadiance(map, "");
  if (strength != 1)
  {
    for (glm::vec3& pixel : map.pixels)
      pixel *= strength;
    RequireRadiance(map, " times the strength " + std::to_string(strength));
  }

  this->Map = std::move(map);
  this->SumUp();
}

/// All that follows from the map.
void Environment::SumUp()
{
  const auto& pixels = this->Map.pixels;
  const glm::vec3 first = pixels.front();
  if (std::all_of(pixels.begin(), pixels.end(), [&](const auto& p) { return p == first; }))
  {
    *this = Uniform(first);
    return;
  }
  this->SumPixels();
  const auto cells = CellsOf(this->Map, this->Sum);
  for (const auto& cell : cells)
    for (int c = 0; c < 3; ++c)
      this->LightVectors[c] += cell[c].vector * this->Sum;
  this->EvenIrradiance = EvenIrradianceOf(cells);
}

template <typename Share>
Environment Environment::Part(const Share& share) const
{
  if (!this->Samples())
    return Uniform(this->Same * static_cast<float>(share(Largest(this->Same))));
  Environment part;
  part.Axes = this->Axes;
  part.Map = this->Map;
  for (glm::vec3& pixel : part.Map.pixels)
    pixel *= static_cast<float>(share(Largest(pixel)));
  part.SumUp();
  return part;
}

Environment Environment::UpTo(double radiance) const
{
  return this->Part([&](double largest) { return largest > radiance ? radiance / largest : 1.0; });
}

Environment Environment::Above(double radiance) const
{
  return this->Part(
    [&](double largest) { return largest > radiance ? 1.0 - radiance / largest : 0.0; });
}

Environment Environment::Uniform(const glm::vec3& radiance)
{
  if (!IsRadiance(radiance))
    throw std::invalid_argument("environment: a radiance of (" + std::to_string(radiance.x) + ", " +
                                std::to_string(radiance.y) + ", " + std::to_string(radiance.z) +
                                "); finite numbers that are at least 0 are needed");
  Environment environment;
  environment.Same = radiance;
  environment.Greatest = Largest(radiance);
  environment.Sum = 4 * Pi * environment.Greatest;
  return environment;
}

void Environment::SumPixels()
{
  const glm::ivec2 size = this->Map.size;
  const int blocks = (size.x + BlockSize - 1) / BlockSize;
  this->BlockSums.reserve(std::size_t(blocks) * size.y);
  this->RowSums.assign(1, 0.0);
  this->RowSums.reserve(size.y + 1);
  const glm::vec3* pixel = this->Map.pixels.data();
  for (int y = 0; y < size.y; ++y)
  {
    double sum = 0.0;
    for (int x = 0; x < size.x; ++x, ++pixel)
    {
      const double largest = Largest(*pixel);
      this->Greatest = std::max(this->Greatest, largest);
      sum += largest;
      if (x % BlockSize == BlockSize - 1 || x == size.x - 1)
        this->BlockSums.push_back(sum);
    }
    const double solidAngle = RowIntegrals(y, size.y).sine * 2 * Pi / size.x;
    this->RowSums.push_back(this->RowSums.back() + sum * solidAngle);
  }
  this->Sum = this->RowSums.back();
}

std::size_t Environment::PixelOf(const glm::dvec3& direction) const
{
  const glm::ivec2 size = this->Map.size;
  const glm::dvec2 at = AnglesOf(this->ToMap(direction)) / glm::dvec2(2 * Pi, Pi);
  return std::size_t(Clamped(at.y * size.y, size.y)) * size.x + Clamped(at.x * size.x, size.x);
}

glm::vec3 Environment::Radiance(const glm::dvec3& direction) const
{
  return this->Samples() ? this->Map.pixels[this->PixelOf(direction)] : this->Same;
}

double Environment::Density(const glm::dvec3& direction) const
{
  return this->Sum > 0 ? Largest(this->Radiance(direction)) / this->Sum : 0.0;
}

EnvironmentSample Environment::Sample(const glm::dvec2& point) const
{
  double azimuth = (2 * point.x - 1) * Pi, cosine = 1 - 2 * point.y;
  glm::vec3 radiance = this->Same;
  if (this->Samples())
  {
    const glm::ivec2 size = this->Map.size;
    // Sums that do not grow are of black rows, blocks and pixels: the first sum that is above the
    // target is never one of these.
    const double rowTarget = std::min(point.y, 1 - 0x1p-53) * this->Sum;
    const auto rowEnd =
      std::upper_bound(this->RowSums.begin() + 1, this->RowSums.end() - 1, rowTarget);
    const int row = static_cast<int>(rowEnd - this->RowSums.begin()) - 1;
    const double down =
      std::clamp((rowTarget - rowEnd[-1]) / (rowEnd[0] - rowEnd[-1]), EdgeOfPixel, 1 - EdgeOfPixel);

    const int blocks = (size.x + BlockSize - 1) / BlockSize;
    const auto rowBlocks = this->BlockSums.begin() + std::size_t(row) * blocks;
    const double target = std::min(point.x, 1 - 0x1p-53) * rowBlocks[blocks - 1];
    const auto block = std::upper_bound(rowBlocks, rowBlocks + blocks - 1, target) - rowBlocks;
    double before = block > 0 ? rowBlocks[block - 1] : 0.0;
    const glm::vec3* pixels = &this->Map.pixels[std::size_t(row) * size.x];
    int column = static_cast<int>(block) * BlockSize;
    double largest = Largest(pixels[column]);
    for (; column < size.x - 1 && before + largest <= target; largest = Largest(pixels[++column]))
      before += largest;
    const double across = std::clamp((target - before) / largest, EdgeOfPixel, 1 - EdgeOfPixel);

    radiance = pixels[column];
    azimuth = (2 * (column + across) / size.x - 1) * Pi;
    const double top = EdgeCosine(row, size.y), bottom = EdgeCosine(row + 1, size.y);
    cosine = top + (bottom - top) * down;
  }
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const glm::dvec3 local(std::sin(azimuth) * sine, std::cos(azimuth) * sine, cosine);
  return { this->Axes * local, radiance, this->Sum > 0 ? Largest(radiance) / this->Sum : 0.0 };
}

glm::vec3 Environment::Irradiance(const glm::dvec3& unitNormal) const
{
  const double most = std::numeric_limits<float>::max();
  if (!this->Samples())
    return glm::min(glm::dvec3(this->Same) * Pi, most);
  const glm::dvec3 normal = this->ToMap(unitNormal);
  const glm::dvec2 at = AnglesOf(normal.z < 0 ? -normal : normal) *
                        glm::dvec2(NormalColumns / (2 * Pi), NormalSteps / (Pi / 2));
  const int left = Clamped(at.x, NormalColumns), above = Clamped(at.y, NormalSteps);
  const int right = (left + 1) % NormalColumns;
  const glm::vec3* row = &this->EvenIrradiance[std::size_t(above) * NormalColumns];
  const glm::vec3* next = row + NormalColumns;
  const double across = at.x - left, down = at.y - above;
  const glm::dvec3 even = glm::mix(glm::mix(glm::dvec3(row[left]), glm::dvec3(row[right]), across),
    glm::mix(glm::dvec3(next[left]), glm::dvec3(next[right]), across), down);
  glm::dvec3 sum;
  for (int c = 0; c < 3; ++c)
    sum[c] = even[c] * this->Sum + glm::dot(normal, this->LightVectors[c]) / 2;
  return glm::clamp(sum, 0.0, most);
}

std::size_t Environment::Bytes() const
{
  return this->Map.pixels.capacity() * sizeof(glm::vec3) +
         (this->RowSums.capacity() + this->BlockSums.capacity()) * sizeof(double) +
         this->EvenIrradiance.capacity() * sizeof(glm::vec3);
}

} // namespace hasp
