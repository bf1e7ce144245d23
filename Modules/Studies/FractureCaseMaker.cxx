#include "Studies/FractureCaseMaker.h"

#include "Grid/ProgressPart.h"
#include "Grid/ScannerFaults.h"
#include "Studies/CoarseScan.h"
#include "Studies/SeededShare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

void Require(double value, double least, double most, const char* name)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument(std::string("fracture case: ") + name + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(least) +
                                ", " + std::to_string(most) + "]");
}

void Check(const FractureCaseChoices& choices)
{
  Require(choices.shiftMm, 0.0, 60.0, "shiftMm");
  Require(choices.turnDegrees, 0.0, 180.0, "turnDegrees");
  Require(choices.lostChips, 0.0, 20.0, "lostChips");
  Require(choices.chipMm, 0.1, 15.0, "chipMm");
  Require(choices.noiseHU, 0.0, 1000.0, "noiseHU");
  Require(double(choices.seed), 0.0, 1e15, "seed");
}

/// A direction of evenly drawn places on the sphere.
glm::dvec3 AnyWay(std::uint64_t seed, std::uint64_t first)
{
  const double z = 2.0 * SeededShare(seed, first) - 1.0;
  const double angle = 2.0 * glm::pi<double>() * SeededShare(seed, first + 1);
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

glm::dvec3 PlaceOf(const GridGeometry& grid, std::size_t v)
{
  const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
  return grid.IndexToWorld(glm::dvec3(v % row, v % slice / row, v / slice));
}

struct Amount
{
  std::uint64_t voxels = 0;
  glm::dvec3 centroid{ 0.0 };
};

/// Of each label, from 0.
std::vector<Amount> AmountsOf(const FracturedScan& scan, std::size_t labels)
{
  std::vector<Amount> amounts(labels);
  for (std::size_t v = 0; v < scan.truth.size(); ++v)
    if (const Label label = scan.truth[v])
    {
      ++amounts[label].voxels;
      amounts[label].centroid += PlaceOf(scan.geometry, v);
    }
  for (Amount& amount : amounts)
    amount.centroid /= std::max(1.0, double(amount.voxels));
  return amounts;
}

/// Piece p goes away from its bone's middle.
RigidPose MoveOf(const FractureCaseChoices& choices, std::size_t piece, const glm::dvec3& centroid,
  const glm::dvec3& middle)
{
  const std::uint64_t seed = choices.seed + 77;
  const glm::dvec3 out = glm::distance(centroid, middle) > 1e-6 ? glm::normalize(centroid - middle)
                                                                : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 way = glm::normalize(out + 0.57 * AnyWay(seed, 100 * piece));
  const glm::dvec3 axis = AnyWay(seed, 100 * piece + 10);
  const glm::dquat turn = TurnBy(axis * glm::radians(choices.turnDegrees));
  return { centroid + choices.shiftMm * way - turn * centroid, turn };
}

/// Voxels where bone of a piece, other bone and none meet: the edges of fractures.
std::vector<std::size_t> EdgesOf(const FracturedScan& scan, std::size_t firstPiece)
{
  const glm::ivec3& dims = scan.geometry.dims;
  const std::int64_t steps[] = { 1, dims.x, std::int64_t(dims.x) * dims.y };
  std::vector<std::size_t> edges;
  for (int k = 1; k + 1 < dims.z; ++k)
    for (int j = 1; j + 1 < dims.y; ++j)
      for (int i = 1; i + 1 < dims.x; ++i)
      {
        const std::size_t v = (std::size_t(k) * dims.y + j) * dims.x + i;
        if (scan.truth[v] < firstPiece)
          continue;
        bool other = false, none = false;
        for (const std::int64_t step : steps)
          for (const std::int64_t way : { -step, step })
          {
            const Label label = scan.truth[v + way];
            none = none || label == 0;
            other = other || (label != 0 && label != scan.truth[v]);
          }
        if (other && none)
          edges.push_back(v);
      }
  return edges;
}

/// A box of any turn, a little rough.
FractureChip ChipAt(
  const glm::dvec3& place, std::size_t bone, const FractureCaseChoices& choices, std::uint64_t n)
{
  const std::uint64_t seed = choices.seed + 177;
  const glm::dquat turn = TurnBy(AnyWay(seed, 10 * n) * (3.0 * SeededShare(seed, 10 * n + 2)));
  FractureChip chip{ bone, {} };
  for (int side = 0; side < 6; ++side)
  {
    FractureFace face;
    glm::dvec3 way(0.0);
    way[side % 3] = side < 3 ? 1.0 : -1.0;
    face.outward = glm::normalize(turn * way);
    face.point = place + 0.5 * choices.chipMm * face.outward;
    face.roughMm = 0.05 * choices.chipMm;
    face.shortestMm = choices.chipMm;
    face.longestMm = 2.0 * choices.chipMm;
    face.seed = 1000 * choices.seed + 500 + 10 * n + std::uint64_t(side);
    chip.faces.push_back(face);
  }
  return chip;
}

void AddChips(
  const FracturedScan& intact, const FractureCaseChoices& choices, FractureSettings& settings)
{
  settings.chips.clear();
  if (choices.lostChips == 0)
    return;
  const std::size_t first = 2 + settings.bones.size();
  const std::vector<std::size_t> edges = EdgesOf(intact, first);
  if (edges.empty())
    throw std::runtime_error("fracture case: no fracture has an edge that a chip could come from");
  for (std::uint32_t n = 0; n < choices.lostChips; ++n)
  {
    const double share = SeededShare(choices.seed + 277, n);
    const std::size_t v = edges[std::size_t(share * double(edges.size()))];
    const std::size_t bone = settings.pieces[intact.truth[v] - first].bone;
    settings.chips.push_back(ChipAt(PlaceOf(intact.geometry, v), bone, choices, n));
  }
}

/// No faults, no moves, nothing lost: whose bone each voxel is.
FractureSettings Unbroken(FractureSettings settings)
{
  settings.crackMm = settings.erodedMm = 0.0;
  settings.chips.clear();
  for (FracturePiece& piece : settings.pieces)
    piece.moved = {};
  return settings;
}

/// The scanner: coarser, blurred, with faults.
void Scan(FracturedScan& scan, const FractureSettings& settings, const FractureCaseChoices& choices,
  std::uint64_t seed)
{
  const CoarseScan coarse(scan.geometry, { choices.spacingMm, choices.blurMm });
  scan.samples = coarse.Samples(scan.samples);
  scan.truth = coarse.Labels(scan.truth, scan.samples, settings.boneHU);
  scan.geometry = coarse.Geometry();
  PhantomSettings faults;
  faults.noiseHU = choices.noiseHU;
  faults.coneBeam.on = choices.coneBeam;
  faults.coneBeam.cupping = 0.2;
  faults.seed = seed;
  const ScannerFaults scanner(scan.geometry, faults, settings.axis, {});
  if (!scanner.Any())
    return;
  const glm::ivec3& dims = scan.geometry.dims;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
      {
        std::int16_t& sample = scan.samples[(std::size_t(k) * dims.y + j) * dims.x + i];
        sample = RoundedSample(scanner(double(sample), { i, j, k }));
      }
}

FractureCaseSurface SurfaceOf(const FractureFace& face)
{
  FractureCaseSurface surface;
  surface.point = face.point;
  surface.normal = -face.outward; // the piece lies behind
  surface.seed = face.seed;
  surface.bandsMm = { { face.longestMm, 1.0 },
    { face.shortestMm, face.shortestMm / face.longestMm } };
  surface.rmsHeightMm = face.roughMm;
  return surface;
}

/// By how much the voxels of each moved label are off.
void MeasureStarts(const FracturedScan& intact, FractureCaseTruth& truth)
{
  for (FractureCaseFragment& fragment : truth.fragments)
  {
    double sum = 0.0;
    for (std::size_t v = 0; v < intact.truth.size(); ++v)
      if (intact.truth[v] == fragment.label)
      {
        const glm::dvec3 place = PlaceOf(intact.geometry, v);
        const double mm = glm::distance(fragment.anatomicalToFractured.Place(place), place);
        sum += mm;
        fragment.startMostMm = std::max(fragment.startMostMm, mm);
      }
    fragment.startMeanMm = sum / std::max(1.0, double(fragment.voxelsAnatomical));
  }
}

FractureCaseTruth TruthOf(const FractureSettings& settings, const FractureCaseChoices& choices,
  const MadeFractureCase& made)
{
  FractureCaseTruth truth;
  truth.name = "made";
  truth.geometry = made.intact.geometry;
  const std::size_t first = 2 + settings.bones.size(), labels = first + settings.pieces.size();
  const std::vector<Amount> before = AmountsOf(made.intact, labels),
                            after = AmountsOf(made.fractured, labels);
  const glm::dvec3& spacing = truth.geometry.spacing;
  for (std::size_t b = 0; b < settings.bones.size(); ++b)
    truth.fixed.push_back(static_cast<Label>(2 + b));
  for (std::size_t p = 0; p < settings.pieces.size(); ++p)
  {
    const FracturePiece& piece = settings.pieces[p];
    const auto label = static_cast<Label>(first + p);
    FractureCaseCut& cut = truth.cuts.emplace_back();
    cut.newLabel = label;
    cut.parent = static_cast<Label>(2 + piece.bone);
    for (const FractureFace& face : piece.faces)
      cut.surfaces.push_back(SurfaceOf(face));
    truth.fragments.push_back(
      { label, piece.name, piece.moved, before[label].voxels, after[label].voxels,
        double(before[label].voxels) * spacing.x * spacing.y * spacing.z, before[label].centroid });
  }
  truth.damage = { true, choices.crackMm, choices.erodedMm, choices.lostChips, choices.chipMm,
    choices.noiseHU, choices.blurMm, choices.coneBeam, choices.seed };
  return truth;
}

} // namespace

MadeFractureCase MakeFractureCase(GridView<const std::int16_t> intact, FractureSettings settings,
  std::span<const std::uint8_t> named, const FractureCaseChoices& choices,
  const ProgressFunction& progress)
{
  Check(choices);
  if (settings.pieces.empty())
    throw std::runtime_error("fracture case: there is no piece");
  PhantomSettings& scanner = settings.scanner;
  scanner.noiseHU = scanner.fieldRadiusMm = 0.0;
  scanner.coneBeam.on = settings.metal = false;
  MadeFractureCase made;
  made.intact = BreakScan(intact, Unbroken(settings), named, PartOf(progress, 0.0, 0.4));
  const std::size_t first = 2 + settings.bones.size();
  const std::vector<Amount> amounts = AmountsOf(made.intact, first + settings.pieces.size());
  for (std::size_t p = 0; p < settings.pieces.size(); ++p)
  {
    const Amount& piece = amounts[first + p];
    if (piece.voxels < 50)
      throw std::runtime_error("fracture case: piece " + std::to_string(p + 1) + " has " +
                               std::to_string(piece.voxels) +
                               " voxels, must have 50 at least: take another seed, fewer "
                               "fragments or a finer scan");
    settings.pieces[p].moved =
      MoveOf(choices, p, piece.centroid, amounts[2 + settings.pieces[p].bone].centroid);
  }
  settings.crackMm = choices.crackMm;
  settings.erodedMm = choices.erodedMm;
  AddChips(made.intact, choices, settings);
  made.fractured = BreakScan(intact, settings, named, PartOf(progress, 0.4, 0.9));
  Scan(made.intact, settings, choices, choices.seed + 1);
  Scan(made.fractured, settings, choices, choices.seed);
  made.truth = TruthOf(settings, choices, made);
  MeasureStarts(made.intact, made.truth);
  ReportProgress(progress, 1.0);
  return made;
}

} // namespace hasp
