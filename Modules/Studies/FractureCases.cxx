#include "Studies/FractureCases.h"

#include "Studies/SeededShare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

// Places are millimetres of the default phantom, from the skull's centre: +x left, +y posterior,
// +z superior (PhantomAnatomy.cxx).

namespace hasp
{
namespace
{

void CheckCase(const FractureCaseSettings& s)
{
  if (!(s.spacingMm >= 0.2 && s.spacingMm <= 2.0))
    throw std::invalid_argument(
      "fracture case: spacingMm is " + std::to_string(s.spacingMm) + ", must be in [0.2, 2]");
}

AnalyticSolid Joined(const PhantomSettings& scanner, PhantomPart bone, PhantomPart teeth)
{
  return AnalyticSolid::Union({ PhantomSolid(scanner, bone), PhantomSolid(scanner, teeth) });
}

/// What all cases of the phantom have: both bones, the scanner, cracks.
FractureSettings HeadSettings(const FractureCaseSettings& s)
{
  FractureSettings settings;
  PhantomSettings& scanner = settings.scanner;
  scanner.blurMm = glm::dvec3(std::max(0.35, 0.55 * s.spacingMm));
  scanner.noiseHU = 25.0;
  scanner.grain = true;
  scanner.seed = s.seed;
  if (s.coneBeam)
  {
    scanner.noiseHU = 60.0;
    scanner.coneBeam.on = true;
    scanner.coneBeam.cupping = 0.2;
    scanner.metal.on = settings.metal = true;
    scanner.metal.streakHU = 200.0;
    scanner.metal.bandHU = 150.0;
  }
  settings.crackMm = s.crackMm;
  settings.erodedMm = s.erodedMm;
  settings.bones = { { "cranium", Joined(scanner, PhantomPart::Cranium, PhantomPart::UpperTeeth) },
    { "mandible", Joined(scanner, PhantomPart::Mandible, PhantomPart::LowerTeeth) } };
  return settings;
}

/// Pieces and faces get seeds of their own, and pieces their moves.
class PieceMaker
{
public:
  PieceMaker(const FractureCaseSettings& settings, std::vector<FracturePiece>& pieces)
    : Settings(settings),
      Pieces(pieces)
  {
  }

  struct Plane
  {
    glm::dvec3 point, outward;
  };
  /// away   where the piece goes when it is moved, any length
  void Add(const std::string& name, std::size_t bone, const std::vector<Plane>& planes,
    const glm::dvec3& away)
  {
    FracturePiece piece{ name, bone, {}, {} };
    glm::dvec3 middle(0.0);
    for (const Plane& plane : planes)
    {
      FractureFace face;
      face.point = plane.point;
      face.outward = glm::normalize(plane.outward);
      face.seed = 1000 * this->Settings.seed + 10 * this->Pieces.size() + piece.faces.size();
      piece.faces.push_back(face);
      middle += plane.point / double(planes.size());
    }
    if (this->Settings.moved)
      piece.moved = this->Move(middle, glm::normalize(away));
    this->Pieces.push_back(std::move(piece));
  }

private:
  /// 0.4 to 0.8 mm away and some sideways, 0.3 to 0.7 degrees about the middle.
  RigidPose Move(const glm::dvec3& middle, const glm::dvec3& away) const
  {
    const std::uint64_t first = 100 * this->Pieces.size();
    const auto share = [&](std::uint64_t n)
    { return SeededShare(this->Settings.seed + 77, first + n); };
    const glm::dvec3 any(share(0) - 0.5, share(1) - 0.5, share(2) - 0.5);
    const glm::dvec3 axis(share(3) - 0.5, share(4) - 0.5, share(5) - 0.5);
    const glm::dvec3 shift = (0.4 + 0.4 * share(6)) * away + 0.4 * any;
    const glm::dquat turn = TurnBy(glm::normalize(axis) * glm::radians(0.3 + 0.4 * share(7)));
    return { middle + shift - turn * middle, turn };
  }

  FractureCaseSettings Settings;
  std::vector<FracturePiece>& Pieces;
};

/// The voxels of a grid that lie in a box.
GridGeometry Cropped(const GridGeometry& grid, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::ivec3 from =
    glm::clamp(glm::ivec3(glm::ceil(grid.WorldToIndex(low))), glm::ivec3(0), grid.dims - 1);
  const glm::ivec3 to =
    glm::clamp(glm::ivec3(glm::floor(grid.WorldToIndex(high))), from, grid.dims - 1);
  GridGeometry cropped = grid;
  cropped.origin = grid.IndexToWorld(from);
  cropped.dims = to - from + 1;
  return cropped;
}

} // namespace

FractureCase BrokenHead(const FractureCaseSettings& s)
{
  CheckCase(s);
  FractureCase broken{ "broken head", {}, HeadSettings(s) };
  broken.settings.axis = { 0.0, -20.0, 0.0 };
  broken.settings.scanner.fieldRadiusMm = s.coneBeam ? 90.0 : 0.0;
  PieceMaker maker(s, broken.settings.pieces);
  maker.Add("maxilla", 0, { { { 0, -60, -49 }, { 0, 0.05, 1 } }, { { 0, -30, -56 }, { 0, 1, 0 } } },
    { 0, -0.5, -1 });
  maker.Add("left zygoma", 0,
    { { { 38, -67, -40 }, { -22, -11, -7 } }, { { 50.5, -60.5, -20 }, { 0, 0.1, 1 } },
      { { 60, -44, -35 }, { 0.47, 0.88, 0 } } },
    { 1.0, -0.7, -0.3 });
  maker.Add("left parietal piece", 0,
    { { { 50, -15, 45 }, { 0, -1, 0.1 } }, { { 50, 42, 40 }, { 0.1, 1, 0 } },
      { { 60, 10, 20 }, { 0, 0.1, -1 } }, { { 12, 10, 80 }, { -1, 0.1, 0 } } },
    { 0.8, 0, 0.5 });
  maker.Add("left frontal piece", 0,
    { { { 30, -5, 60 }, { 0, 1, 0 } }, { { 30, -68, 45 }, { 0, -1, -0.2 } },
      { { 40, -40, 28 }, { 0, 0.1, -1 } }, { { 17, -40, 60 }, { -1, 0, 0.1 } } },
    { 0.5, -0.6, 0.5 });
  broken.geometry = PhantomGrid(glm::dvec3(s.spacingMm), broken.settings.scanner);
  return broken;
}

FractureCase BrokenMandible(const FractureCaseSettings& s)
{
  CheckCase(s);
  FractureCase broken{ "broken mandible", {}, HeadSettings(s) };
  broken.settings.bones[1].name = "chin and left body";
  broken.settings.axis = { 0.0, -45.0, 0.0 };
  broken.settings.scanner.fieldRadiusMm = s.coneBeam ? 78.0 : 0.0;
  PieceMaker maker(s, broken.settings.pieces);
  const PieceMaker::Plane right{ { -5, 0, -80 }, { 1, 0, 0 } }; // no bone is there: a limit alone
  const PieceMaker::Plane left{ { 5, 0, -80 }, { -1, 0, 0 } };
  // Labels are numbered by pieces; the condyle goes before the ramus that it stands on.
  maker.Add("right condyle", 1,
    { { { -53, -9, -57 }, { 0.1, -0.39, -0.91 } }, { { -53, -22, -50 }, { 0, -1, 0 } }, right },
    { -0.5, 0.3, 0.6 });
  maker.Add("right body and ramus", 1, { { { -26.8, -54.6, -96 }, { 0.471, -0.882, 0 } }, right },
    { -0.6, 0.8, 0.1 });
  maker.Add(
    "left ramus", 1, { { { 40, -32, -92 }, { -0.4, -0.9, -0.15 } }, left }, { 0.5, 0.8, 0.3 });
  broken.geometry = Cropped(PhantomGrid(glm::dvec3(s.spacingMm), broken.settings.scanner),
    { -75.0, -100.0, -115.0 }, { 75.0, 20.0, -40.0 });
  return broken;
}

FractureSettings PlantedCuts(GridView<const std::int16_t> scan, std::span<const std::uint8_t> named,
  const FractureCaseSettings& s)
{
  const GridGeometry& grid = scan.geometry;
  if (named.size() != grid.Size())
    throw std::invalid_argument("planted cuts: named must have one value a voxel");
  glm::dvec3 low(1e300), high(-1e300);
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        if (named[scan.Offset(i, j, k)] != 0)
        {
          const glm::dvec3 at = grid.IndexToWorld({ i, j, k });
          low = glm::min(low, at);
          high = glm::max(high, at);
        }
  if (low.x > high.x)
    throw std::invalid_argument("planted cuts: nothing is named, must hold one voxel at least");
  FractureSettings settings;
  settings.crackMm = s.crackMm;
  settings.erodedMm = s.erodedMm;
  settings.bones = { { "skull" } };
  settings.scanner.blurMm = { 0.5, 0.5, 0.3 };
  settings.scanner.sliceMm = std::max({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
  settings.scanner.seed = s.seed;
  settings.axis = 0.5 * (low + high);
  if (s.coneBeam)
  {
    settings.scanner.noiseHU = 60.0;
    settings.scanner.coneBeam.on = true;
    settings.scanner.coneBeam.cupping = 0.2;
  }
  // Shares of the box: 0 right, anterior, inferior; 1 left, posterior, superior.
  const auto at = [&](double x, double y, double z)
  { return low + (high - low) * glm::dvec3(x, y, z); };
  PieceMaker maker(s, settings.pieces);
  maker.Add("left parietal piece", 0,
    { { at(0.9, 0.42, 0.75), { 0, -1, 0.1 } }, { at(0.9, 0.78, 0.75), { 0.1, 1, 0 } },
      { at(0.95, 0.6, 0.6), { 0, 0.1, -1 } }, { at(0.6, 0.6, 0.95), { -1, 0.1, 0 } } },
    { 0.8, 0, 0.5 });
  maker.Add("occipital piece", 0,
    { { at(0.5, 0.86, 0.5), { 0, -1, 0.1 } }, { at(0.5, 0.9, 0.35), { 0, 0, -1 } },
      { at(0.5, 0.9, 0.72), { 0, 0.1, 1 } } },
    { 0, 1, 0 });
  maker.Add("right temporal piece", 0,
    { { at(0.1, 0.4, 0.6), { 0, -1, 0 } }, { at(0.1, 0.62, 0.6), { 0, 1, 0.1 } },
      { at(0.1, 0.5, 0.5), { 0, 0, -1 } }, { at(0.1, 0.5, 0.78), { 0.1, 0, 1 } },
      { at(0.35, 0.5, 0.65), { 1, 0, 0 } } },
    { -1, 0, 0.1 });
  return settings;
}

std::vector<std::uint8_t> LargestBone(GridView<const std::int16_t> scan, double boneHU)
{
  const glm::ivec3& dims = scan.geometry.dims;
  const std::size_t row = dims.x, slice = row * dims.y, size = scan.geometry.Size();
  std::vector<std::uint8_t> seen(size, 0), largest;
  std::vector<std::size_t> best;
  for (std::size_t start = 0; start < size; ++start)
  {
    if (seen[start] != 0 || double(scan.data[start]) < boneHU)
      continue;
    std::vector<std::size_t> piece{ start };
    seen[start] = 1;
    const auto visit = [&](bool inside, std::size_t voxel)
    {
      if (!inside || seen[voxel] != 0 || double(scan.data[voxel]) < boneHU)
        return;
      seen[voxel] = 1;
      piece.push_back(voxel);
    };
    for (std::size_t n = 0; n < piece.size(); ++n)
    {
      const std::size_t v = piece[n], i = v % row, j = v % slice / row, k = v / slice;
      visit(i > 0, v - 1);
      visit(i + 1 < row, v + 1);
      visit(j > 0, v - row);
      visit(j + 1 < static_cast<std::size_t>(dims.y), v + row);
      visit(k > 0, v - slice);
      visit(k + 1 < static_cast<std::size_t>(dims.z), v + slice);
    }
    if (piece.size() > best.size())
      best = std::move(piece);
  }
  largest.assign(size, 0);
  for (const std::size_t voxel : best)
    largest[voxel] = 1;
  return largest;
}

} // namespace hasp
