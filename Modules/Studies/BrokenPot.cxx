#include "Studies/BrokenPot.h"

#include "Grid/ParallelFor.h"
#include "Studies/RoughPlane.h"
#include "Studies/SeededShare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double RangeMm = 8.0;

void Check(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument("broken pot: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(low) +
                                ", " + std::to_string(high) + "]");
}

/// The middle of the wall, from the axis up to the rim: radius and height, mm.
std::vector<glm::dvec2> Profile()
{
  std::vector<glm::dvec2> profile{ { 0.0, 3.0 }, { 30.0, 3.0 } };
  for (int n = 1; n <= 40; ++n)
  {
    const double t = n / 40.0;
    profile.push_back({ 30.0 + 24.0 * std::sin(2.3 * t) - 5.0 * t * t, 3.0 + 104.0 * t });
  }
  return profile;
}

class Pot
{
public:
  explicit Pot(const BrokenPotSettings& settings) : Settings(settings), Curve(Profile())
  {
    for (int n = 0; n < settings.sherds; ++n)
      this->Seeds.push_back(this->SeedOf(n));
    for (int a = 0; a < settings.sherds; ++a)
      for (int b = 0; b < a; ++b)
      {
        this->Faces.push_back(this->FaceBetween(b, a));
        this->Lost.push_back(this->LossOf(b, a));
      }
  }

  /// To the wall, NEGATIVE INSIDE; exact.
  double Wall(const glm::dvec3& x) const
  {
    const glm::dvec2 p(std::hypot(x.x, x.y), x.z);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 1; n < this->Curve.size(); ++n)
    {
      const glm::dvec2 a = this->Curve[n - 1], ab = this->Curve[n] - a;
      const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
      least = std::min(least, glm::length(p - a - t * ab));
    }
    return least - 0.5 * this->Settings.wallMm;
  }

  /// To a sherd, NEGATIVE INSIDE: exact at one surface, a bound where several meet.
  double Sherd(int sherd, const glm::dvec3& x) const
  {
    double mm = this->Wall(x);
    for (int other = 0; other < int(this->Seeds.size()) && mm < RangeMm; ++other)
    {
      if (other == sherd)
        continue;
      const std::size_t face = FaceOf(sherd, other);
      const double sign = sherd < other ? 1.0 : -1.0; // the lower number lies behind
      const RoughPlane& rough = this->Faces[face];
      // Most faces are far behind: their waves need not be summed.
      if (sign * rough.PlaneMm(x) + rough.MostMm() + this->Settings.erodedMm <= mm)
        continue;
      mm = std::max(mm, sign * rough.FootOf(x).mm + this->LossAt(face, x));
    }
    return mm;
  }

private:
  static std::size_t FaceOf(int a, int b)
  {
    const int high = std::max(a, b), low = std::min(a, b);
    return std::size_t(high * (high - 1) / 2 + low);
  }

  /// Spread by the golden angle along the profile, a little at random.
  glm::dvec3 SeedOf(int n) const
  {
    const double count = this->Settings.sherds;
    const auto share = [&](std::uint64_t k)
    { return SeededShare(this->Settings.seed, 10 * n + k); };
    const double along = (n + 0.2 + 0.6 * share(0)) / count;
    const double angle = 2.399963229728653 * n + 0.5 * (share(1) - 0.5);
    // From the middle of the bottom up; as much of the profile as of its area, roughly.
    const double at = std::sqrt(along) * double(this->Curve.size() - 1);
    const std::size_t k = std::min(std::size_t(at), this->Curve.size() - 2);
    const glm::dvec2 p = glm::mix(this->Curve[k], this->Curve[k + 1], at - double(k));
    return { p.x * std::cos(angle), p.x * std::sin(angle), p.y };
  }

  FractureFace Plain(int low, int high) const
  {
    FractureFace face;
    face.point = 0.5 * (this->Seeds[low] + this->Seeds[high]);
    face.outward = glm::normalize(this->Seeds[high] - this->Seeds[low]);
    face.roughMm = this->Settings.roughMm;
    face.shortestMm = 3.0;
    face.longestMm = 12.0;
    face.seed = 10'000 * this->Settings.seed + 100 * std::uint64_t(high) + std::uint64_t(low);
    return face;
  }
  RoughPlane FaceBetween(int low, int high) const { return RoughPlane(this->Plain(low, high)); }
  RoughPlane LossOf(int low, int high) const
  {
    FractureFace face = this->Plain(low, high);
    face.roughMm = 1.0;
    face.seed += 5'000;
    return RoughPlane(face);
  }
  /// Between nothing and half of erodedMm for each of both faces.
  double LossAt(std::size_t face, const glm::dvec3& x) const
  {
    if (this->Settings.erodedMm == 0.0)
      return 0.0;
    return this->Settings.erodedMm *
           std::clamp(0.5 + 0.25 * this->Lost[face].HeightMm(x), 0.0, 1.0);
  }

  BrokenPotSettings Settings;
  std::vector<glm::dvec2> Curve;
  std::vector<glm::dvec3> Seeds;
  std::vector<RoughPlane> Faces, Lost;
};

/// The box of a sherd, by a coarse look at the whole pot.
struct Box
{
  glm::dvec3 low{ 1e9 }, high{ -1e9 };
};
Box BoxOf(const Pot& pot, int sherd)
{
  constexpr double Step = 2.0;
  Box box;
  for (double z = -4.0; z <= 116.0; z += Step)
    for (double y = -64.0; y <= 64.0; y += Step)
      for (double x = -64.0; x <= 64.0; x += Step)
        if (const glm::dvec3 p(x, y, z); pot.Wall(p) < Step && pot.Sherd(sherd, p) < Step)
        {
          box.low = glm::min(box.low, p - Step);
          box.high = glm::max(box.high, p + Step);
        }
  return box;
}

PlacedBody BakeSherd(const Pot& pot, int sherd, const BrokenPotSettings& settings)
{
  const Box box = BoxOf(pot, sherd);
  if (box.low.x > box.high.x)
    throw std::runtime_error("broken pot: sherd " + std::to_string(sherd) + " is nothing");
  GridGeometry grid;
  grid.spacing = glm::dvec3(settings.spacingMm);
  grid.origin = box.low - RangeMm;
  grid.dims = glm::ivec3(glm::ceil((box.high - box.low + 2.0 * RangeMm) / settings.spacingMm)) + 1;
  std::vector<float> distances(grid.Size());
  ParallelFor(0, std::int64_t(grid.dims.y) * grid.dims.z, 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
        for (int i = 0; i < grid.dims.x; ++i)
        {
          const glm::dvec3 x =
            grid.IndexToWorld({ i, double(row % grid.dims.y), double(row / grid.dims.y) });
          distances[std::size_t(row) * grid.dims.x + i] = float(pot.Sherd(sherd, x));
        }
    });
  const glm::dvec3 origin = 0.5 * (box.low + box.high);
  const GridView<const float> view{ distances.data(), grid };
  auto map = std::make_shared<const DistanceMap>(
    view, DistanceMapSettings{ .rangeMm = RangeMm - 0.5, .origin = origin });
  auto shell = PointShell::OfSurface(view, origin, { .points = 16'384 });
  return { std::make_shared<const FitBody>(std::move(map), std::move(shell)), { origin } };
}
} // namespace

BrokenPot MakeBrokenPot(const BrokenPotSettings& settings, const ProgressFunction& progress)
{
  Check("sherds", settings.sherds, 2, 60);
  Check("wallMm", settings.wallMm, 2.0, 20.0);
  Check("roughMm", settings.roughMm, 0.0, 3.0);
  Check("erodedMm", settings.erodedMm, 0.0, 2.0);
  Check("spacingMm", settings.spacingMm, 0.2, 2.0);
  const Pot pot(settings);
  BrokenPot made;
  for (int n = 0; n < settings.sherds; ++n)
  {
    ReportProgress(progress, double(n) / settings.sherds);
    made.sherds.push_back(BakeSherd(pot, n, settings));
    made.areaMm2.push_back(made.sherds.back().body->SurfaceArea());
  }
  ReportProgress(progress, 1.0);
  return made;
}

} // namespace hasp
