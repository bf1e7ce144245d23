#include "Evaluation/MeshSamples.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
/// Well-shaped parts have a tenth of it, besides one of each triangle.
constexpr std::size_t MostSamples = 4'000'000;

void Halve(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double spacing,
  MeshSample sample, std::vector<MeshSample>& samples)
{
  const double ab = glm::distance(a, b), bc = glm::distance(b, c), ca = glm::distance(c, a);
  const double longest = std::max({ ab, bc, ca });
  if (longest <= spacing)
  {
    if (samples.size() > MostSamples + sample.triangle)
      throw std::runtime_error("mesh: over " + std::to_string(MostSamples) +
                               " places would be measured, as its triangles are so long and "
                               "thin; mesh it anew");
    sample.point = (a + b + c) / 3.0;
    samples.push_back(sample);
    return;
  }
  sample.areaMm2 *= 0.5;
  const glm::dvec3 &p = longest == ab   ? a
                        : longest == bc ? b
                                        : c,
                   &q = longest == ab   ? b
                        : longest == bc ? c
                                        : a,
                   &o = longest == ab   ? c
                        : longest == bc ? a
                                        : b;
  const glm::dvec3 middle = 0.5 * (p + q);
  Halve(p, middle, o, spacing, sample, samples);
  Halve(middle, q, o, spacing, sample, samples);
}
} // namespace

double HeightOf(const TriangleMesh& mesh, const glm::uvec3& t)
{
  const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
  const double longest =
    std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
  return longest > 0.0 ? glm::length(glm::cross(b - a, c - a)) / longest : 0.0;
}

std::vector<MeshSample> SampleMesh(const TriangleMesh& mesh, double spacingMm)
{
  if (!(spacingMm > 0.0) || !std::isfinite(spacingMm))
    throw std::invalid_argument(
      "mesh samples: spacingMm is " + std::to_string(spacingMm) + ", must be finite and above 0");
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    if (const std::uint32_t most = std::max({ t.x, t.y, t.z }); most >= mesh.points.size())
      throw std::invalid_argument("mesh: a triangle names point " + std::to_string(most) + " of " +
                                  std::to_string(mesh.points.size()));
    area += 0.5 * glm::length(glm::cross(
                    mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]));
  }
  // Well-shaped parts have a fifth of their longest side's square and more.
  const double spacing = std::max(spacingMm, std::sqrt(area / 100000.0));
  std::vector<MeshSample> samples;
  samples.reserve(mesh.triangles.size());
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n)
  {
    const glm::uvec3& t = mesh.triangles[n];
    if (!(HeightOf(mesh, t) >= SliverMm))
      continue;
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice = glm::length(normal);
    Halve(a, b, c, spacing, { {}, normal / twice, 0.5 * twice, n }, samples);
  }
  return samples;
}

} // namespace hasp
