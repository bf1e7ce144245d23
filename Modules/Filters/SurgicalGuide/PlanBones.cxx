#include "PlanBones.h"

#include "BoneSolid.h"
#include "FragmentLabels.h"
#include "FragmentPieces.h"

#include "Distance/Coverage.h"
#include "Distance/SharpContour.h"
#include "Grid/ProgressPart.h"
#include "Planning/PlanLists.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr const char* Who = "bone";
constexpr double CrumbBelowMm3 = 20.0; ///< CutRecipe's default; only marks them

std::size_t SampleAt(const glm::ivec3& dims, const glm::ivec3& at)
{
  return (std::size_t(at.z) * dims.y + at.y) * dims.x + at.x;
}

/// One byte a sample: the island of bone that a seed is in, or within FarthestSeedMm of.
std::vector<std::uint8_t> IslandAt(const AnyGridView& grey, double isovalue, const glm::dvec3& seed)
{
  const GridGeometry& grid = GeometryOf(grey);
  std::vector<std::uint8_t> mark(grid.Size());
  std::visit(
    [&](const auto& view)
    {
      for (std::size_t n = 0; n < mark.size(); ++n)
        mark[n] = double(view.data[n]) >= isovalue;
    },
    grey);
  const glm::dvec3 reach(FarthestSeedMm + 0.5 * glm::length(grid.spacing));
  const auto [first, last] = SamplesIn(grid, { seed - reach, seed + reach });
  double least = glm::length(reach);
  std::size_t found = mark.size();
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i)
      {
        const std::size_t sample = SampleAt(grid.dims, { i, j, k });
        const double away = glm::distance(grid.IndexToWorld(glm::dvec3(i, j, k)), seed);
        if (mark[sample] && away < least)
          least = away, found = sample;
      }
  if (found == mark.size())
    throw std::runtime_error("there is no bone at source.seed: is it in this scan's world, and the "
                             "isovalue right?");
  FloodSamples(grid.dims, mark, found, 1, 2);
  for (std::uint8_t& m : mark)
    m = m == 2;
  return mark;
}

/// "cuts[2] …", as CutFragments numbers them, by the plan's ids.
std::string NameCuts(std::string text, const std::vector<PlanId>& cuts)
{
  for (std::size_t n = 0; n < cuts.size(); ++n)
  {
    const std::string key = "cuts[" + std::to_string(n) + "]";
    if (const auto at = text.find(key); at != std::string::npos)
      text.replace(at, key.size(), "cut " + std::to_string(cuts[n]));
  }
  return text;
}

/// "fragment 5: …"
auto Naming(PlanId fragment)
{
  return [before = "fragment " + std::to_string(fragment) + ": "](const std::string& text)
  { return before + text; };
}
} // namespace

PlanBones::PlanBones(const Plan& plan, const PlanImages& images) : Of(plan), Images(images) {}

const PlanFragment& PlanBones::Fragment(PlanId id) const
{
  return *FindPlanObject<PlanFragment>(this->Of, id); // of a valid plan
}

const PlanFragment& PlanBones::Root(PlanId id) const
{
  const PlanFragment* fragment = &this->Fragment(id);
  while (const auto* piece = std::get_if<PieceSource>(&fragment->source))
    fragment = &this->Fragment(piece->fragment);
  return *fragment;
}

PlanId PlanBones::VolumeOf(const PlanFragment& root) const
{
  if (const auto* component = std::get_if<ComponentSource>(&root.source))
    return component->volume;
  return FindPlanObject<PlanSegmentation>(this->Of, std::get<LabelSource>(root.source).segmentation)
    ->volume;
}

double PlanBones::Isovalue(PlanId fragment) const
{
  const PlanFragment& root = this->Root(fragment);
  if (const auto* component = std::get_if<ComponentSource>(&root.source))
    return component->isovalue;
  return std::get<LabelSource>(root.source).isovalue;
}

double PlanBones::SpacingMm(PlanId fragment) const
{
  const PlanFragment& root = this->Root(fragment);
  if (const auto* component = std::get_if<ComponentSource>(&root.source))
    return component->spacingMm;
  return std::get<LabelSource>(root.source).spacingMm;
}

const AnyGridView& PlanBones::Grey(PlanId volume) const
{
  const auto found = this->Images.find(volume);
  if (found == this->Images.end())
    throw std::invalid_argument(std::string(PlanNoun(this->Of, volume)) + " " +
                                std::to_string(volume) + " is not among those given");
  return found->second;
}

const std::vector<std::uint8_t>& PlanBones::Mark(const PlanFragment& root)
{
  const auto found = this->Marks.find(root.id);
  if (found != this->Marks.end())
    return found->second;
  const AnyGridView& grey = this->Grey(this->VolumeOf(root));
  std::vector<std::uint8_t> mark;
  if (const auto* component = std::get_if<ComponentSource>(&root.source))
    mark = IslandAt(grey, component->isovalue, component->seed);
  else
  {
    const auto& source = std::get<LabelSource>(root.source);
    const BoneImage bone{ grey, this->Grey(source.segmentation), int(source.label) };
    mark = MarkBone(Who, bone, source.isovalue, 0.0, {});
  }
  return this->Marks.emplace(root.id, std::move(mark)).first->second;
}

PlanBones::Pieces& PlanBones::PiecesOf(PlanId divided, const ProgressFunction& progress)
{
  if (const auto found = this->Divided.find(divided); found != this->Divided.end())
    return found->second;
  const PlanFragment& root = this->Root(divided);
  Pieces pieces;
  std::vector<PlanId> chain{ divided }; // up to the whole bone: what was cut first is cut first
  while (const auto* piece = std::get_if<PieceSource>(&this->Fragment(chain.back()).source))
    chain.push_back(piece->fragment);
  for (auto fragment = chain.rbegin(); fragment != chain.rend(); ++fragment)
    for (const PlanId cut : CutsThrough(this->Of, *fragment))
      if (std::find(pieces.cuts.begin(), pieces.cuts.end(), cut) == pieces.cuts.end())
        pieces.cuts.push_back(cut);
  if (pieces.cuts.empty())
    pieces.bone.fragments = FragmentsOf(this->Mesh(root.id, progress), CrumbBelowMm3);
  else
  {
    CutRecipe recipe;
    recipe.isovalue = this->Isovalue(root.id);
    recipe.spacingMm = this->SpacingMm(root.id);
    recipe.crumbBelowMm3 = CrumbBelowMm3;
    for (const PlanId id : pieces.cuts)
    {
      const PlanCut& cut = *FindPlanObject<PlanCut>(this->Of, id);
      recipe.cuts.push_back({ cut.blade, cut.reachMm });
    }
    const AnyGridView& grey = this->Grey(this->VolumeOf(root));
    const GridView<const std::uint8_t> mark{ this->Mark(root).data(), GeometryOf(grey) };
    pieces.bone = SayingErrors(
      [&] {
        return CutFragments({ grey, mark, 1 }, recipe, progress);
      },
      [&](const std::string& text) { return NameCuts(text, pieces.cuts); });
  }
  return this->Divided.emplace(divided, std::move(pieces)).first->second;
}

std::size_t PlanBones::PieceAt(const Pieces& pieces, const PlanFragment& piece) const
{
  const auto& source = std::get<PieceSource>(piece.source);
  std::vector<MeshRays> rays;
  for (const BoneFragment& fragment : pieces.bone.fragments)
    rays.emplace_back(fragment.mesh);
  const auto [found, away] = NearestFragment(pieces.bone.fragments, rays, source.seed);
  if (!(away <= FarthestSeedMm))
  {
    std::ostringstream text;
    text << "source.seed is " << away << " mm from all pieces of fragment " << source.fragment
         << ", must be within " << FarthestSeedMm << " mm";
    throw std::runtime_error(text.str());
  }
  for (const PlanFragment& other : this->Of.fragments)
    if (const auto* sibling = std::get_if<PieceSource>(&other.source);
        sibling && sibling->fragment == source.fragment && other.id < piece.id &&
        NearestFragment(pieces.bone.fragments, rays, sibling->seed).first == found)
      throw std::runtime_error("it is one piece with fragment " + std::to_string(other.id) +
                               ": a cut does not part them, or a source.seed is in the other");
  return found;
}

const TriangleMesh& PlanBones::Mesh(PlanId id, const ProgressFunction& progress)
{
  return SayingErrors([&]() -> const TriangleMesh&
    { return this->MeshOf(this->Fragment(id), progress); },
    Naming(id));
}

const TriangleMesh& PlanBones::MeshOf(
  const PlanFragment& fragment, const ProgressFunction& progress)
{
  const PlanId id = fragment.id;
  if (const auto* piece = std::get_if<PieceSource>(&fragment.source))
  {
    const Pieces& pieces = this->PiecesOf(piece->fragment, progress);
    return pieces.bone.fragments[this->PieceAt(pieces, fragment)].mesh;
  }
  if (const auto found = this->Whole.find(id); found != this->Whole.end())
    return found->second;
  const BoneDistance bone = DistanceOfBone(Who, this->Grey(this->VolumeOf(fragment)),
    this->Isovalue(id), this->Mark(fragment), this->SpacingMm(id), PartOf(progress, 0.0, 0.6));
  TriangleMesh mesh =
    SharpContour(*bone.Solid(), bone.grid, {}, nullptr, PartOf(progress, 0.6, 1.0));
  return this->Whole.emplace(id, std::move(mesh)).first->second;
}

std::vector<PlanCutMeasure> PlanBones::Cuts(PlanId fragment)
{
  const auto* piece = std::get_if<PieceSource>(&this->Fragment(fragment).source);
  return piece ? this->CutsOf(piece->fragment) : std::vector<PlanCutMeasure>{};
}

const CutBone& PlanBones::Divide(PlanId divided, const ProgressFunction& progress)
{
  return SayingErrors(
    [&]() -> const CutBone& { return this->PiecesOf(divided, progress).bone; }, Naming(divided));
}

std::vector<PlanCutMeasure> PlanBones::CutsOf(PlanId divided)
{
  std::vector<PlanCutMeasure> measures;
  const Pieces& pieces = this->PiecesOf(divided, {});
  for (std::size_t n = 0; n < pieces.bone.cuts.size(); ++n)
    measures.push_back({ pieces.cuts[n], pieces.bone.cuts[n] });
  return measures;
}

/// Samples that are bone, though the greater part of their voxel is not, get a neighbour's number:
/// grey values say how much of them counts.
void PlanBones::Number(Pieces& pieces, const PlanFragment& root)
{
  const std::vector<std::uint8_t>& mark = this->Mark(root);
  const GridGeometry& grid = GeometryOf(this->Grey(this->VolumeOf(root)));
  const std::vector<std::uint16_t> labels = LabelFragments(pieces.bone.fragments, grid);
  pieces.numbers = labels;
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    if (labels[n] != 0 || !mark[n])
      continue;
    const glm::ivec3 at = SamplePlace(grid.dims, n), last = grid.dims - 1;
    const glm::ivec3 low = glm::max(at - 1, 0), high = glm::min(at + 1, last);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          pieces.numbers[n] = std::max(pieces.numbers[n], labels[SampleAt(grid.dims, { i, j, k })]);
  }
}

void PlanBones::Label(const PlanFragment& fragment, std::uint16_t as,
  std::vector<std::uint16_t>& numbers, const ProgressFunction& progress)
{
  const PlanFragment& root = this->Root(fragment.id);
  const std::vector<std::uint8_t>& mark = this->Mark(root);
  const Pieces* pieces = nullptr;
  std::uint16_t number = 1;
  if (const auto* source = std::get_if<PieceSource>(&fragment.source))
  {
    Pieces& made = this->PiecesOf(source->fragment, progress);
    if (made.numbers.empty())
      this->Number(made, root);
    pieces = &made;
    number = std::uint16_t(made.bone.fragments[this->PieceAt(made, fragment)].number);
  }
  for (std::size_t s = 0; s < mark.size(); ++s)
    if ((pieces ? pieces->numbers[s] : mark[s]) == number)
      numbers[s] = as;
}

BoneLabels PlanBones::Labels(std::span<const PlanId> fragments, const ProgressFunction& progress)
{
  const PlanId volume = this->VolumeOf(this->Root(fragments[0]));
  BoneLabels labels{ this->Grey(volume), {} };
  labels.numbers.resize(GeometryOf(labels.grey).Size());
  for (std::size_t n = 0; n < fragments.size(); ++n)
  {
    const PlanFragment& root = this->Root(fragments[n]);
    if (this->VolumeOf(root) != volume)
      throw std::invalid_argument("fragments " + std::to_string(fragments[0]) + " and " +
                                  std::to_string(fragments[n]) +
                                  " are of two scans, must be of one");
    SayingErrors(
      [&] {
        this->Label(this->Fragment(fragments[n]), std::uint16_t(n + 1), labels.numbers, progress);
      },
      Naming(fragments[n]));
  }
  return labels;
}

} // namespace hasp
