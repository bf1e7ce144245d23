// What it costs to ask trees of solids, and what laziness saves: a plate with 20 x 20 holes and a
// line of text, on a grid of 0.4 mm (least of three runs, all cores).
// Usage: BenchKernelSolids
#include "Distance/Csg.h"
#include "Distance/NearSurface.h"
#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"

#include <chrono>
#include <cstdio>
#include <functional>

namespace
{

double LeastMilliseconds(const std::function<void()>& run)
{
  double least = 1e300;
  for (int n = 0; n < 3; ++n)
  {
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    least = std::min(least, spent.count());
  }
  return least;
}

/// The same solid without bounds: nothing of it can be left out.
class Endless : public hasp::ImplicitSolid
{
public:
  explicit Endless(hasp::SolidPointer part) : Part(std::move(part)) {}
  double At(const glm::dvec3& x) const noexcept override { return this->Part->At(x); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override { return this->Part->SampleAt(x); }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return this->Part->FaceAt(face, x);
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return {}; }

private:
  hasp::SolidPointer Part;
};

hasp::SolidPointer Plate(const std::function<hasp::SolidPointer(hasp::SolidPointer)>& wrap)
{
  std::vector<hasp::SolidPointer> tools;
  for (int n = 0; n < 400; ++n)
  {
    const glm::dvec3 at(n % 20 * 3 - 28.5, n / 20 * 3 - 28.5, 0);
    tools.push_back(
      wrap(hasp::MakeCylinder(at - glm::dvec3(0, 0, 4), at + glm::dvec3(0, 0, 4), 1)));
  }
  tools.push_back(
    wrap(hasp::MakeText("HASP 2026", { -25, 30, 2 }, { 1, 0, 0 }, { 0, 1, 0 }, 4, 0.6)));
  return hasp::MakeDifference(hasp::MakeBox({ 0, 2, 0 }, glm::dmat3(1), { 31, 34, 2 }),
    wrap(hasp::MakeUnion(std::move(tools))));
}

} // namespace

int main()
{
  hasp::GridGeometry grid;
  grid.dims = { 220, 230, 100 };
  grid.spacing = glm::dvec3(0.4);
  grid.origin = { -44, -44, -20 };
  const auto lazy = Plate([](hasp::SolidPointer part) { return part; });
  const auto eager = Plate([](hasp::SolidPointer part) { return std::make_shared<Endless>(part); });
  std::printf(
    "grid %d x %d x %d, %u faces\n", grid.dims.x, grid.dims.y, grid.dims.z, lazy->Faces());
  hasp::NearSurface field;
  const auto near = [&](const hasp::SolidPointer& solid, double band)
  { return LeastMilliseconds([&] { field = hasp::EvaluateNearSurface(*solid, grid, band); }); };
  const double lazyNear = near(lazy, 0.8);
  const double held = double(field.near.size()) * hasp::NearSurface::BlockSamples;
  std::printf("near the surface (0.8 mm): %.1f ms, %.0f of %.0f samples, %.3f us a sample\n",
    lazyNear, held, double(grid.Size()), 1e3 * lazyNear / held);
  std::printf("without bounds:            %.1f ms\n", near(eager, 0.8));
  std::printf("all samples:               %.1f ms\n", near(lazy, 1e3));
  return 0;
}
