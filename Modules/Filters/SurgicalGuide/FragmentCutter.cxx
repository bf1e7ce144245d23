#include "FragmentCutter.h"

#include "BladeSection.h"
#include "BoneSolid.h"
#include "FragmentLabels.h"
#include "FragmentPieces.h"

#include "Distance/Csg.h"
#include "Distance/MeshCoverage.h"
#include "Distance/SharpContour.h"
#include "Grid/ProgressPart.h"
#include "WorkingGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr const char* Who = "cuts";
constexpr double FaceTolerance = 0.02; ///< of the grid's spacing

std::runtime_error MissesBone(std::size_t cut)
{
  return std::runtime_error(
    "cuts[" + std::to_string(cut) + "] does not meet bone: move its blade, or make it larger");
}

/// Leaves of the marks the islands that blades belong to.
void KeepCutIslands(
  const GridGeometry& ct, const CutRecipe& recipe, std::vector<std::uint8_t>& mark)
{
  constexpr std::uint8_t Bone = 1, Cut = 2;
  const glm::dvec3 step = glm::dvec3(0.5 * glm::length(ct.spacing)); // a blade is thinner than it
  for (std::size_t n = 0; n < recipe.cuts.size(); ++n)
  {
    const Blade blade(recipe.cuts[n].blade);
    double least = std::numeric_limits<double>::infinity();
    std::size_t seed = 0;
    const auto [first, last] = SamplesIn(ct, blade.Bounds());
    for (int k = first.z; k <= last.z; ++k)
      for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i)
        {
          const std::size_t sample = (std::size_t(k) * ct.dims.y + j) * ct.dims.x + i;
          if (!mark[sample])
            continue;
          const glm::dvec3 at = blade.Local(ct.IndexToWorld(glm::dvec3(i, j, k)));
          const glm::dvec3 out = glm::abs(at) - blade.Half() - step;
          if (out.x <= 0.0 && out.y <= 0.0 && out.z <= 0.0 && glm::length(at) < least)
            least = glm::length(at), seed = sample;
        }
    if (!std::isfinite(least))
      throw MissesBone(n);
    if (mark[seed] == Bone)
      FloodSamples(ct.dims, mark, seed, Bone, Cut);
  }
  for (std::uint8_t& m : mark)
    m = m == Cut;
}

/// The bone that a tool takes, on a grid along its blade. No face of the blade lies along points of
/// the grid: a contour moves such ones inwards by a hundredth of a step.
TriangleMesh KerfMesh(const CutTool& tool, const SolidPointer& bone, double spacingMm)
{
  const glm::dvec3 half = tool.blade.Half();
  const glm::dvec3 steps = glm::max(glm::ceil(half / spacingMm), 2.0); // from the middle to a face
  GridGeometry grid;
  grid.direction = tool.blade.Axes();
  grid.spacing = half / (steps - 0.25);
  grid.dims = 2 * glm::ivec3(steps) + 5;
  grid.origin = tool.blade.World(-0.5 * glm::dvec3(grid.Cells()) * grid.spacing);
  return SharpContour(*MakeIntersection({ bone, tool.tool }), grid);
}

/// A cut made: its tool, and the bone that it took.
struct MadeCut
{
  CutTool tool;
  TriangleMesh kerf;
};

SolidPointer Without(const SolidPointer& bone, const std::vector<MadeCut>& made)
{
  if (made.empty())
    return bone;
  std::vector<SolidPointer> parts;
  for (const MadeCut& cut : made)
    parts.push_back(cut.tool.tool);
  return MakeDifference(bone, MakeUnion(parts));
}

/// Pieces that hang together before the last of the cuts were made: fragments, then kerfs.
class Groups
{
public:
  explicit Groups(const CutBone& cut)
  {
    for (const BoneFragment& fragment : cut.fragments)
      this->Volume.push_back(fragment.volumeMm3);
    for (const CutMeasure& measure : cut.cuts)
      this->Volume.push_back(measure.kerfMm3);
    for (std::size_t n = 0; n < this->Volume.size(); ++n)
      this->Parent.push_back(n);
  }
  std::size_t Of(std::size_t piece) const
  {
    while (this->Parent[piece] != piece)
      piece = this->Parent[piece];
    return piece;
  }
  void Join(std::size_t a, std::size_t b)
  {
    a = this->Of(a);
    b = this->Of(b);
    if (a == b)
      return;
    this->Parent[b] = a;
    this->Volume[a] += this->Volume[b];
  }
  /// Of the groups that pieces belong to, each once.
  std::set<std::size_t> Of(const std::vector<std::size_t>& pieces) const
  {
    std::set<std::size_t> found;
    for (const std::size_t piece : pieces)
      found.insert(this->Of(piece));
    return found;
  }
  double VolumeOf(const std::set<std::size_t>& groups) const
  {
    double sum = 0.0;
    for (const std::size_t group : groups)
      sum += this->Volume[group];
    return sum;
  }

private:
  std::vector<std::size_t> Parent;
  std::vector<double> Volume;
};

/// Undoes the cuts from the last to the first: what each has parted are the groups of pieces,
/// joined by the cuts after it, that have its faces.
void MeasureSides(const std::vector<MadeCut>& made, double toleranceMm, CutBone& result)
{
  Groups groups(result);
  const std::size_t fragments = result.fragments.size();
  for (std::size_t n = made.size(); n-- > 0;)
  {
    CutMeasure& cut = result.cuts[n];
    const auto piecesOn = [&](int side, std::vector<int>& numbers)
    {
      std::vector<std::size_t> pieces;
      for (std::size_t f = 0; f < fragments; ++f)
        if (HasFace(result.fragments[f].mesh, made[n].tool, side, toleranceMm))
        {
          pieces.push_back(f);
          numbers.push_back(result.fragments[f].number);
        }
      for (std::size_t later = n + 1; later < made.size(); ++later)
        if (HasFace(made[later].kerf, made[n].tool, side, toleranceMm))
          pieces.push_back(fragments + later);
      return pieces;
    };
    const std::vector<std::size_t> front = piecesOn(1, cut.front), back = piecesOn(-1, cut.back);
    const std::set<std::size_t> frontGroups = groups.Of(front), backGroups = groups.Of(back);
    const bool joined = std::any_of(frontGroups.begin(), frontGroups.end(),
      [&](std::size_t group) { return backGroups.count(group) > 0; });
    cut.parted = !front.empty() && !back.empty() && !joined;
    if (cut.parted)
    {
      cut.frontMm3 = groups.VolumeOf(frontGroups);
      cut.backMm3 = groups.VolumeOf(backGroups);
    }
    for (const std::vector<std::size_t>& side : { front, back })
      for (const std::size_t piece : side)
        groups.Join(fragments + n, piece);
  }
}

/// Makes the cuts, each in what those before it left, and measures what they take.
std::vector<MadeCut> MakeCuts(const CutRecipe& recipe, const SolidPointer& bone,
  FragmentLabels& labels, CutBone& result, const ProgressFunction& progress)
{
  double step = 0.25;
  for (const BoneCut& cut : recipe.cuts)
    step = std::min(step, 0.25 * cut.blade.kerfMm);
  std::vector<MadeCut> made;
  for (std::size_t n = 0; n < recipe.cuts.size(); ++n)
  {
    ReportProgress(progress, double(n) / double(recipe.cuts.size()));
    const SolidPointer before = Without(bone, made);
    const auto section = FindSection(recipe.cuts[n], *before, labels, step);
    if (!section)
      throw MissesBone(n);
    TriangleMesh kerf = KerfMesh(section->tool, before, CutSpacing(recipe));
    CutMeasure measure;
    measure.kerfMm3 = VolumeOf(kerf);
    measure.areaMm2 = measure.kerfMm3 / recipe.cuts[n].blade.kerfMm;
    measure.leftMm2 = section->leftMm2;
    if (!(measure.kerfMm3 > 0.0))
      throw MissesBone(n);
    labels.Part(section->fragment, section->tool);
    result.cuts.push_back(measure);
    made.push_back({ section->tool, std::move(kerf) });
  }
  return made;
}
} // namespace

double CutBone::UnaccountedShare() const
{
  double sum = -this->boneMm3;
  for (const BoneFragment& fragment : this->fragments)
    sum += fragment.volumeMm3;
  for (const CutMeasure& cut : this->cuts)
    sum += cut.kerfMm3;
  return std::abs(sum) / this->boneMm3;
}

CutBone CutFragments(
  const BoneImage& image, const CutRecipe& recipe, const ProgressFunction& progress)
{
  ValidateCutRecipe(recipe);
  std::vector<std::uint8_t> keep =
    MarkBone(Who, image, recipe.isovalue, recipe.ignoreBelowMm3, PartOf(progress, 0.0, 0.1));
  KeepCutIslands(GeometryOf(image.grey), recipe, keep);
  CheckResected(GeometryOf(image.grey), keep, recipe.resected);
  const BoneDistance distance = DistanceOfBone(
    Who, image.grey, recipe.isovalue, keep, recipe.spacingMm, PartOf(progress, 0.1, 0.5));
  const double spacing = CutSpacing(recipe);
  const GridGeometry grid = WithSpacing(distance.grid, spacing);
  CheckPoints(Who, grid.dims, spacing, GridRemedy);
  const SolidPointer bone = distance.Solid();
  FragmentLabels labels(GeometryOf(image.grey), keep);
  CutBone result;
  const std::vector<MadeCut> made =
    MakeCuts(recipe, bone, labels, result, PartOf(progress, 0.5, 0.6));
  result.boneMm3 = VolumeOf(SharpContour(*bone, grid, {}, nullptr, PartOf(progress, 0.6, 0.75)));
  const TriangleMesh mesh =
    SharpContour(*Without(bone, made), grid, {}, nullptr, PartOf(progress, 0.75, 0.95));
  result.fragments = FragmentsOf(mesh, recipe.crumbBelowMm3);
  MeasureSides(made, FaceTolerance * spacing, result);
  MarkResected(result.fragments, recipe.resected);
  ReportProgress(progress, 1.0);
  return result;
}

std::vector<std::uint16_t> LabelFragments(
  const std::vector<BoneFragment>& fragments, const GridGeometry& geometry)
{
  geometry.Validate();
  std::vector<std::uint16_t> labels(geometry.Size(), 0);
  if (fragments.size() > std::numeric_limits<std::uint16_t>::max())
    throw std::invalid_argument("cuts: " + std::to_string(fragments.size()) +
                                " fragments, a label image tells 65535 apart at most");
  for (const BoneFragment& fragment : fragments)
  {
    glm::dvec3 low(1e30), high(-1e30);
    for (const glm::dvec3& p : fragment.mesh.points)
    {
      low = glm::min(low, geometry.WorldToIndex(p));
      high = glm::max(high, geometry.WorldToIndex(p));
    }
    const glm::dvec3 last(geometry.Cells());
    const glm::ivec3 first(glm::clamp(glm::floor(low), glm::dvec3(0.0), last)),
      end(glm::clamp(glm::ceil(high), glm::dvec3(0.0), last));
    GridGeometry box = geometry;
    box.dims = end - first + 1;
    box.origin = geometry.IndexToWorld(glm::dvec3(first));
    const std::vector<float> share = MeshCoverage(fragment.mesh, box);
    for (std::size_t n = 0; n < share.size(); ++n)
      if (share[n] > 0.5F)
      {
        const glm::ivec3 at = first + SamplePlace(box.dims, n);
        labels[(std::size_t(at.z) * geometry.dims.y + at.y) * geometry.dims.x + at.x] =
          std::uint16_t(fragment.number);
      }
  }
  return labels;
}

} // namespace hasp
