#include "Segmentation/ConeBeamField.h"

#include <glm/gtc/constants.hpp>

namespace hasp
{
namespace
{

/// Weights and second differences as one symmetric, positive semidefinite matrix, never stored.
class Plate
{
public:
  Plate(const BlockGrid& grid, const std::vector<double>& weight, double lengthMm)
    : Grid(grid),
      Weight(weight)
  {
    const double stiffness = std::pow(lengthMm / glm::two_pi<double>(), 4.0);
    for (int a = 0; a < 3; ++a)
    {
      const int b = (a + 1) % 3;
      this->Bend[a] = stiffness / std::pow(grid.edgeMm[a], 4.0);
      this->Twist[a] = 2.0 * stiffness / std::pow(grid.edgeMm[a] * grid.edgeMm[b], 2.0);
      // Holds what no sample holds, such as the slope where all lie in one block.
      this->Stretch[a] = 1e-4 * std::sqrt(stiffness) / std::pow(grid.edgeMm[a], 2.0);
    }
    this->Step = { 1, grid.count.x, std::ptrdiff_t(grid.count.x) * grid.count.y };
  }

  /// out = A f
  void Apply(const std::vector<double>& f, std::vector<double>& out) const
  {
    for (std::size_t n = 0; n < f.size(); ++n)
      out[n] = this->Weight[n] * f[n];
    this->ForEachDifference(
      [&](std::size_t n, auto steps, auto shares, double stiffness)
      {
        double difference = 0.0;
        for (std::size_t s = 0; s < steps.size(); ++s)
          difference += shares[s] * f[n + steps[s]];
        for (std::size_t s = 0; s < steps.size(); ++s)
          out[n + steps[s]] += stiffness * shares[s] * difference;
      });
  }

  std::vector<double> Diagonal() const
  {
    std::vector<double> diagonal = this->Weight;
    this->ForEachDifference(
      [&](std::size_t n, auto steps, auto shares, double stiffness)
      {
        for (std::size_t s = 0; s < steps.size(); ++s)
          diagonal[n + steps[s]] += stiffness * shares[s] * shares[s];
      });
    return diagonal;
  }

private:
  using Steps2 = std::array<std::ptrdiff_t, 2>;
  using Steps3 = std::array<std::ptrdiff_t, 3>;
  using Steps4 = std::array<std::ptrdiff_t, 4>;

  /// Each difference that lies within the grid: its first block, its steps and shares, its weight.
  template <typename Visit>
  void ForEachDifference(const Visit& visit) const
  {
    constexpr std::array<double, 2> slope{ -1.0, 1.0 };
    constexpr std::array<double, 3> bend{ 1.0, -2.0, 1.0 };
    constexpr std::array<double, 4> twist{ 1.0, -1.0, -1.0, 1.0 };
    const glm::ivec3& count = this->Grid.count;
    std::size_t n = 0;
    for (int z = 0; z < count.z; ++z)
      for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x, ++n)
        {
          const glm::ivec3 left = count - glm::ivec3(x, y, z);
          for (int a = 0; a < 3; ++a)
          {
            const int b = (a + 1) % 3;
            const std::ptrdiff_t step = this->Step[a], other = this->Step[b];
            if (left[a] > 1)
              visit(n, Steps2{ 0, step }, slope, this->Stretch[a]);
            if (left[a] > 2)
              visit(n, Steps3{ 0, step, 2 * step }, bend, this->Bend[a]);
            if (left[a] > 1 && left[b] > 1)
              visit(n, Steps4{ 0, step, other, step + other }, twist, this->Twist[a]);
          }
        }
  }

  const BlockGrid& Grid;
  const std::vector<double>& Weight;
  std::array<double, 3> Bend{}, Twist{}, Stretch{};
  std::array<std::ptrdiff_t, 3> Step{};
};

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
    sum += a[n] * b[n];
  return sum;
}

} // namespace

void FitThinPlate(const BlockGrid& grid, const BlockData& data, double lengthMm, double tolerance,
  std::vector<double>& field, const ProgressFunction& progress)
{
  constexpr int mostSteps = 1000;
  const Plate plate(grid, data.weight, lengthMm);
  const std::size_t size = field.size();
  std::vector<double> residual(size), way(size), image(size), scaled(size);
  std::vector<double> inverse = plate.Diagonal();
  for (double& d : inverse)
    d = d > 0.0 ? 1.0 / d : 0.0;
  plate.Apply(field, image);
  double aim = 0.0;
  for (std::size_t n = 0; n < size; ++n)
  {
    const double wanted = data.weight[n] * data.value[n];
    residual[n] = wanted - image[n];
    aim += wanted * wanted * inverse[n];
  }
  double before = 0.0;
  for (int step = 0; step < mostSteps; ++step)
  {
    ReportProgress(progress, double(step) / mostSteps);
    for (std::size_t n = 0; n < size; ++n)
      scaled[n] = inverse[n] * residual[n];
    const double now = Dot(residual, scaled);
    if (!(now > tolerance * tolerance * aim))
      return;
    for (std::size_t n = 0; n < size; ++n)
      way[n] = scaled[n] + (before > 0.0 ? now / before : 0.0) * way[n];
    before = now;
    plate.Apply(way, image);
    const double length = now / Dot(way, image);
    for (std::size_t n = 0; n < size; ++n)
    {
      field[n] += length * way[n];
      residual[n] -= length * image[n];
    }
  }
}

void BlurBlocks(const BlockGrid& grid, double sigmaMm, std::vector<double>& values)
{
  const glm::ivec3& count = grid.count;
  const std::array<std::size_t, 3> steps{ 1, std::size_t(count.x), std::size_t(count.x) * count.y };
  for (int a = 0; a < 3; ++a)
  {
    const double sigma = sigmaMm / grid.edgeMm[a];
    const int reach = std::min(static_cast<int>(std::ceil(3.0 * sigma)), count[a] - 1);
    std::vector<double> weights(reach + 1);
    double sum = 0.0;
    for (int d = 0; d <= reach; ++d)
    {
      weights[d] = std::exp(-0.5 * d * d / (sigma * sigma));
      sum += d == 0 ? weights[d] : 2.0 * weights[d];
    }
    std::vector<double> line(count[a]);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      if (n / steps[a] % count[a] != 0)
        continue; // no line begins here
      for (int i = 0; i < count[a]; ++i)
        line[i] = values[n + i * steps[a]];
      for (int i = 0; i < count[a]; ++i)
      {
        double blurred = 0.0;
        for (int d = std::max(-reach, -i); d <= std::min(reach, count[a] - 1 - i); ++d)
          blurred += weights[std::abs(d)] * line[i + d];
        values[n + i * steps[a]] = blurred / sum;
      }
    }
  }
}

} // namespace hasp
