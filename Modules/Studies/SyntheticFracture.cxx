#include "Studies/SyntheticFracture.h"

#include "Grid/ParallelFor.h"
#include "Grid/PhantomAnatomy.h"
#include "Grid/ProgressPart.h"
#include "Grid/ScannerFaults.h"
#include "Grid/Trilinear.h"
#include "Studies/FractureSides.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

void Require(bool holds, const std::string& name, double value, const char* range)
{
  if (!holds || !std::isfinite(value))
    throw std::invalid_argument(
      "fracture: " + name + " is " + std::to_string(value) + ", must be " + range);
}

void CheckPose(const RigidPose& pose)
{
  for (int a = 0; a < 3; ++a)
    Require(true, "a piece's position", pose.position[a], "finite");
  const double length = glm::length(pose.orientation);
  Require(std::abs(length - 1.0) < 1e-9, "the length of a piece's orientation", length, "1");
}

void CheckFracture(const FractureSettings& s)
{
  CheckPhantom(s.scanner);
  const std::size_t labels = 2 + s.bones.size() + s.pieces.size();
  Require(!s.bones.empty() && labels <= MaxLabel, "the number of bones and pieces",
    double(s.bones.size() + s.pieces.size()), "1 to 65533, with one bone at least");
  for (const FractureBone& bone : s.bones)
    if (s.bones.size() > 1 && !bone.solid)
      throw std::invalid_argument(
        "fracture: of several bones each must have a solid that says where it is");
  for (const FracturePiece& piece : s.pieces)
  {
    Require(piece.bone < s.bones.size(), "a piece's bone", double(piece.bone), "< bones");
    Require(!piece.faces.empty(), "the number of a piece's faces", 0.0, ">= 1");
    CheckPose(piece.moved);
  }
  for (const FractureChip& chip : s.chips)
  {
    Require(chip.bone < s.bones.size(), "a chip's bone", double(chip.bone), "< bones");
    Require(!chip.faces.empty(), "the number of a chip's faces", 0.0, ">= 1");
  }
  Require(s.crackMm >= 0.0 && s.crackMm <= 10.0, "crackMm", s.crackMm, "in [0, 10]");
  Require(s.erodedMm >= 0.0 && s.erodedMm <= 10.0, "erodedMm", s.erodedMm, "in [0, 10]");
  Require(true, "crackHU", s.crackHU, "finite");
  for (int a = 0; a < 3; ++a)
    Require(true, "axis", s.axis[a], "finite");
  Require(s.boneHU > s.crackHU, "boneHU", s.boneHU, "> crackHU");
}

/// A box of voxels, `to` not included.
struct Block
{
  glm::ivec3 from, to;
};

/// A fragment as one block sees it.
struct Candidate
{
  NearSides sides;
  RigidPose back; ///< to the intact world
  bool unmoved;
};

/// The largest sample of each block, so that blocks of air and soft tissue are known at once.
class LargestSamples
{
public:
  static constexpr glm::ivec3 Side{ 16, 8, 8 };

  explicit LargestSamples(GridView<const std::int16_t> grid)
    : Grid(grid),
      Blocks((grid.geometry.dims + Side - 1) / Side),
      Largest(static_cast<std::size_t>(Blocks.x) * Blocks.y * Blocks.z)
  {
    ParallelFor(0, this->Count(), 64,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
          this->Largest[n] = this->LargestIn(this->At(n));
      });
  }
  std::int64_t Count() const { return static_cast<std::int64_t>(this->Largest.size()); }
  Block At(std::int64_t n) const
  {
    const glm::ivec3 at = this->Place(n) * Side;
    return { at, glm::min(at + Side, this->Grid.geometry.dims) };
  }
  /// Of all samples within a distance of the block, mm, or more.
  std::int16_t Around(std::int64_t n, double mm) const
  {
    // Interpolation reaches one voxel further.
    const glm::dvec3 reach = mm / this->Grid.geometry.spacing + 1.0;
    const glm::ivec3 blocks(glm::ceil(reach / glm::dvec3(Side)));
    const glm::ivec3 at = mm == 0.0 ? this->Place(n) : glm::max(this->Place(n) - blocks, 0);
    const glm::ivec3 to = mm == 0.0 ? at : glm::min(this->Place(n) + blocks, this->Blocks - 1);
    std::int16_t largest = this->Largest[n];
    for (int k = at.z; k <= to.z; ++k)
      for (int j = at.y; j <= to.y; ++j)
        for (int i = at.x; i <= to.x; ++i)
          largest = std::max(largest,
            this->Largest[(static_cast<std::size_t>(k) * this->Blocks.y + j) * this->Blocks.x + i]);
    return largest;
  }

private:
  glm::ivec3 Place(std::int64_t n) const
  {
    const std::int64_t row = this->Blocks.x, slice = row * this->Blocks.y;
    return { n % row, n % slice / row, n / slice };
  }
  std::int16_t LargestIn(const Block& block) const
  {
    std::int16_t largest = -32768;
    for (int k = block.from.z; k < block.to.z; ++k)
      for (int j = block.from.y; j < block.to.y; ++j)
        for (int i = block.from.x; i < block.to.x; ++i)
          largest = std::max(largest, this->Grid(i, j, k));
    return largest;
  }

  GridView<const std::int16_t> Grid;
  glm::ivec3 Blocks;
  std::vector<std::int16_t> Largest;
};

/// Fills samples and truth block by block.
class Breaker
{
public:
  Breaker(GridView<const std::int16_t> intact, const FractureSettings& settings,
    std::span<const std::uint8_t> named, FracturedScan& broken)
    : Intact(intact),
      Settings(settings),
      Named(named),
      Sides(settings),
      Faults(intact.geometry, settings.scanner, settings.axis,
        settings.metal ? MakePhantomShapes(settings.scanner).metal : std::vector<RoundConeShape>()),
      Largest(intact),
      Broken(broken)
  {
  }

  void Run(const ProgressFunction& progress)
  {
    constexpr std::int64_t atOnce = 4096;
    const std::int64_t blocks = this->Largest.Count();
    for (std::int64_t first = 0; first < blocks; first += atOnce)
    {
      ReportProgress(progress, double(first) / double(blocks));
      ParallelFor(first, std::min(first + atOnce, blocks), 8,
        [&](std::int64_t from, std::int64_t to)
        {
          for (std::int64_t n = from; n < to; ++n)
            this->Fill(n);
        });
    }
    ReportProgress(progress, 1.0);
  }

private:
  struct Mixed
  {
    double value;
    Label label;
  };

  void Fill(std::int64_t n)
  {
    const GridGeometry& grid = this->Intact.geometry;
    const Block block = this->Largest.At(n);
    const glm::dvec3 middle = grid.IndexToWorld(0.5 * glm::dvec3(block.from + block.to - 1));
    const double radius =
      1.001 * 0.5 * glm::length(grid.spacing * glm::dvec3(block.to - block.from - 1));
    double movedMm = 0.0;
    std::vector<Candidate> candidates;
    if (double(this->Largest.Around(n, 0.0)) > this->Settings.crackHU || this->AnyMoved())
      candidates = this->CandidatesOf(middle, radius, movedMm);
    // Without candidates, too: what was there has gone elsewhere.
    const bool bone = double(this->Largest.Around(n, movedMm)) > this->Settings.crackHU;
    const bool plain = candidates.size() == 1 && candidates[0].unmoved && candidates[0].sides.all;
    for (int k = block.from.z; k < block.to.z; ++k)
      for (int j = block.from.y; j < block.to.y; ++j)
        for (int i = block.from.x; i < block.to.x; ++i)
        {
          const glm::ivec3 at(i, j, k);
          Mixed mixed{ double(this->Intact(i, j, k)), 0 };
          if (bone)
            mixed = plain ? this->Whole(at, candidates[0]) : this->Mix(at, candidates);
          this->Put(at, mixed);
        }
  }

  bool AnyMoved() const
  {
    return std::any_of(this->Settings.pieces.begin(), this->Settings.pieces.end(),
      [](const FracturePiece& piece) { return !(piece.moved == RigidPose{}); });
  }

  std::vector<Candidate> CandidatesOf(
    const glm::dvec3& middle, double radius, double& movedMm) const
  {
    std::vector<Candidate> candidates;
    for (std::uint32_t fragment = 0; fragment < this->Sides.Fragments(); ++fragment)
    {
      const RigidPose& pose = this->Sides.PoseOf(fragment);
      const bool unmoved = pose == RigidPose{};
      Candidate candidate{ {}, pose.Inverse(), unmoved };
      const glm::dvec3 from = unmoved ? middle : candidate.back.Place(middle);
      candidate.sides = this->Sides.Near(fragment, from, radius);
      if (candidate.sides.none)
        continue;
      if (!unmoved) // the ball's far side moves by no more than a turn's chord besides
        movedMm = std::max(movedMm,
          glm::distance(from, middle) + radius * glm::length(RotationVector(pose.orientation)));
      candidates.push_back(std::move(candidate));
    }
    return candidates;
  }

  bool IsNamed(const glm::dvec3& index) const
  {
    if (this->Named.empty())
      return true;
    const glm::ivec3 at =
      glm::clamp(glm::ivec3(glm::round(index)), glm::ivec3(0), this->Intact.geometry.dims - 1);
    return this->Named[this->Intact.Offset(at.x, at.y, at.z)] != 0;
  }

  Label LabelOf(std::uint32_t fragment) const { return static_cast<Label>(2 + fragment); }

  Mixed Whole(const glm::ivec3& at, const Candidate& candidate) const
  {
    return { double(this->Intact(at.x, at.y, at.z)),
      this->IsNamed(at) ? this->LabelOf(candidate.sides.fragment) : Label(0) };
  }

  Mixed Mix(const glm::ivec3& at, const std::vector<Candidate>& candidates) const
  {
    const glm::dvec3 world = this->Intact.geometry.IndexToWorld(at);
    const double here = this->Intact(at.x, at.y, at.z);
    double shares = 0.0, bone = 0.0, most = 0.0;
    Label label = 0;
    const bool unmoved = std::all_of(candidates.begin(), candidates.end(),
      [](const Candidate& candidate) { return candidate.unmoved; });
    for (const Candidate& candidate : candidates)
    {
      glm::dvec3 from = world, index(at);
      double value = here;
      if (!candidate.unmoved)
      {
        from = candidate.back.Place(world);
        index = this->Intact.geometry.WorldToIndex(from);
        value = SampleTrilinear(this->Intact, index).value_or(this->Settings.scanner.airHU);
      }
      const double excess = value - this->Settings.crackHU;
      if (excess <= 0.0)
        continue;
      const double share = this->Sides.Share(candidate.sides, from);
      shares += share;
      bone += share * excess;
      if (share * excess > most)
      {
        most = share * excess;
        label = this->IsNamed(index) ? this->LabelOf(candidate.sides.fragment) : Label(0);
      }
      if (unmoved && share == 1.0) // the others have none
        break;
    }
    bone /= std::max(1.0, shares);
    const double crack = this->Settings.crackHU, before = std::min(here, crack);
    const double covered = std::min(bone / (this->Settings.boneHU - crack), 1.0);
    return { before + covered * (crack - before) + bone, label };
  }

  void Put(const glm::ivec3& at, const Mixed& mixed)
  {
    const std::size_t voxel = this->Intact.Offset(at.x, at.y, at.z);
    const std::int16_t clean = RoundedSample(mixed.value);
    const bool shown = double(clean) >= this->Settings.boneHU && this->Faults.Sees(at);
    this->Broken.truth[voxel] = shown ? mixed.label : Label(0);
    this->Broken.samples[voxel] = RoundedSample(this->Faults(double(clean), at));
  }

  GridView<const std::int16_t> Intact;
  const FractureSettings& Settings;
  std::span<const std::uint8_t> Named;
  FractureSides Sides;
  ScannerFaults Faults;
  LargestSamples Largest;
  FracturedScan& Broken;
};

} // namespace

FracturedScan BreakScan(GridView<const std::int16_t> intact, const FractureSettings& settings,
  std::span<const std::uint8_t> named, const ProgressFunction& progress)
{
  intact.geometry.Validate();
  CheckFracture(settings);
  if (!named.empty() && named.size() != intact.geometry.Size())
    throw std::invalid_argument("fracture: named has " + std::to_string(named.size()) +
                                " values, must have one a voxel, " +
                                std::to_string(intact.geometry.Size()) + ", or none");
  FracturedScan broken;
  broken.geometry = intact.geometry;
  broken.samples.resize(intact.geometry.Size());
  broken.truth.resize(intact.geometry.Size());
  for (const FractureBone& bone : settings.bones)
    broken.names.push_back(bone.name);
  for (const FracturePiece& piece : settings.pieces)
    broken.names.push_back(piece.name);
  Breaker(intact, settings, named, broken).Run(progress);
  return broken;
}

std::vector<std::int16_t> IntactPhantom(
  const GridGeometry& geometry, const FractureSettings& settings, const ProgressFunction& progress)
{
  CheckFracture(settings);
  geometry.Validate();
  PhantomSettings clean = settings.scanner;
  clean.noiseHU = 0.0;
  clean.coneBeam.on = false;
  clean.fieldRadiusMm = 0.0;
  clean.metal.streakHU = clean.metal.bandHU = 0.0;
  std::vector<std::int16_t> intact(geometry.Size());
  SamplePhantomSlab(geometry, clean, 0, geometry.dims.z, intact, progress);
  return intact;
}

FracturedScan BreakPhantom(
  const GridGeometry& geometry, const FractureSettings& settings, const ProgressFunction& progress)
{
  const std::vector<std::int16_t> intact =
    IntactPhantom(geometry, settings, PartOf(progress, 0.0, 0.6));
  return BreakScan(GridView<const std::int16_t>{ intact.data(), geometry }, settings, {},
    PartOf(progress, 0.6, 1.0));
}

} // namespace hasp
