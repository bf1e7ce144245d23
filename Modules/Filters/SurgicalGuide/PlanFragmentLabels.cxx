#include "PlanFragmentLabels.h"

#include "Blade.h"
#include "FragmentLabels.h"
#include "PlanBones.h"

#include "Evaluation/TriangleTree.h"
#include "Grid/LabelGrid.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Planning/PlanLists.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr std::size_t MostFragments = 65'535;
constexpr std::int64_t Grain = 1 << 16;

std::string BeforeFault(PlanId fragment)
{
  return "fragment " + std::to_string(fragment) + ": ";
}

PlanId ScanOf(const Plan& plan, std::span<const PlanId> fragments)
{
  if (fragments.size() > MostFragments)
    throw std::invalid_argument(std::to_string(fragments.size()) + " fragments, at most " +
                                std::to_string(MostFragments) + " are numbered at a time");
  PlanId scan = 0;
  for (const PlanId fragment : fragments)
  {
    const PlanId its = VolumeOfFragment(plan, fragment);
    if (its == 0)
      throw std::invalid_argument(
        BeforeFault(fragment) +
        (WholeOf(plan, fragment) ? "it is a surface, and has no voxels" : "there is none"));
    if (scan != 0 && its != scan)
      throw std::invalid_argument("fragments " + std::to_string(fragments[0]) + " and " +
                                  std::to_string(fragment) + " are of two scans, must be of one");
    scan = its;
  }
  return scan;
}

/// Of a segmentation's labels: the number and the isovalue of the fragment that is one.
struct NumberedLabel
{
  std::uint16_t number = 0;
  double isovalue = 0.0;
};
using NumberedLabels = std::vector<NumberedLabel>; ///< by label

/// All whole fragments of a segmentation in one pass.
void NumberLabels(const AnyGridView& grey, const AnyGridView& labels, const NumberedLabels& wanted,
  std::vector<std::uint16_t>& numbers)
{
  const auto number = [&](const auto& grey, const auto& labels)
  {
    ParallelFor(0, std::int64_t(numbers.size()), Grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t s = begin; s < end; ++s)
        {
          const auto label = labels.data[s];
          if (!(label > 0) || std::size_t(label) >= wanted.size())
            continue;
          const NumberedLabel& is = wanted[std::size_t(label)];
          if (is.number > numbers[s] && double(grey.data[s]) >= is.isovalue)
            numbers[s] = is.number;
        }
      });
  };
  std::visit(number, grey, labels);
}

/// What a blade holds of a number that is not in the mesh becomes nobody's.
void RemoveDust(const Osteotomy& osteotomy, const TriangleTree& mesh, const GridGeometry& grid,
  std::uint16_t number, std::vector<std::uint16_t>& numbers)
{
  const glm::dvec3 skew = glm::normalize(glm::dvec3(1.0, 2.0, 3.0)); // along no edge, most likely
  const Blade blade(osteotomy);
  const auto [first, last] = SamplesIn(grid, blade.Bounds());
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i)
      {
        std::uint16_t& is = numbers[(std::size_t(k) * grid.dims.y + j) * grid.dims.x + i];
        if (is != number)
          continue;
        const glm::dvec3 at = grid.IndexToWorld(glm::dvec3(i, j, k));
        const glm::dvec3 inBlade = glm::abs(blade.Local(at));
        if (glm::all(glm::lessThanEqual(inBlade, blade.Half())) && !mesh.Inside(at, skew))
          is = 0;
      }
}

class FragmentNumbers
{
public:
  FragmentNumbers(const Plan& plan, const PlanImages& images, std::span<const PlanId> fragments)
    : Of(plan),
      Images(images),
      Fragments(fragments)
  {
    this->Found.faults.resize(fragments.size());
    if (fragments.empty())
      return;
    this->Scan = PlanBones(plan, images).Grey(ScanOf(plan, fragments));
    this->Found.numbers.resize(GeometryOf(this->Scan).Size());
    for (std::size_t n = 0; n < fragments.size(); ++n)
    {
      const auto& whole = *WholeOf(plan, fragments[n]);
      const auto* label = std::get_if<LabelSource>(&whole.source);
      if (label && whole.id == fragments[n])
        this->ByLabel[label->segmentation].push_back(n);
      else
        this->ByBone[whole.id].push_back(n);
    }
  }

  PlanFragmentVoxels Take(const ProgressFunction& progress)
  {
    const double steps = std::max<double>(1.0, this->ByLabel.size() + this->ByBone.size());
    double done = 0.0;
    for (const auto& [segmentation, which] : this->ByLabel)
    {
      ReportProgress(progress, done++ / steps);
      this->Label(segmentation, which);
    }
    for (const auto& [whole, which] : this->ByBone)
    {
      this->Cut(which, PartOf(progress, done / steps, (done + 1.0) / steps));
      ++done;
    }
    return std::move(this->Found);
  }

private:
  void Label(PlanId segmentation, const std::vector<std::size_t>& which)
  {
    try
    {
      const AnyGridView& labels = PlanBones(this->Of, this->Images).Grey(segmentation);
      CheckLabelGrid("bone", GeometryOf(this->Scan), GeometryOf(labels));
      NumberedLabels wanted;
      for (const std::size_t n : which)
      {
        const auto& source =
          std::get<LabelSource>(FindPlanObject<PlanFragment>(this->Of, this->Fragments[n])->source);
        wanted.resize(std::max<std::size_t>(wanted.size(), source.label + 1));
        wanted[source.label] = { std::uint16_t(n + 1), source.isovalue };
      }
      NumberLabels(this->Scan, labels, wanted, this->Found.numbers);
    }
    catch (const std::invalid_argument& error)
    {
      for (const std::size_t n : which)
        this->Found.faults[n] = BeforeFault(this->Fragments[n]) + error.what();
    }
  }

  /// Fragments of one bone: what is made of a bone serves all of them, and goes with it.
  void Cut(const std::vector<std::size_t>& which, const ProgressFunction& progress)
  {
    PlanBones bones(this->Of, this->Images);
    std::vector<PlanId> fragments;
    for (const std::size_t n : which)
      fragments.push_back(this->Fragments[n]);
    try
    {
      this->Join(this->Numbers(bones, fragments, progress), which);
      return;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception&) // of one of them: each by itself then
    {
    }
    for (std::size_t n = 0; n < which.size(); ++n)
      try
      {
        this->Join(this->Numbers(bones, { &fragments[n], 1 }, progress), { which[n] });
      }
      catch (const Cancelled&)
      {
        throw;
      }
      catch (const std::invalid_argument& error)
      {
        this->Found.faults[which[n]] = error.what();
      }
      catch (const std::runtime_error& error)
      {
        this->Found.faults[which[n]] = error.what();
      }
  }

  std::vector<std::uint16_t> Numbers(
    PlanBones& bones, std::span<const PlanId> fragments, const ProgressFunction& progress) const
  {
    std::vector<std::uint16_t> numbers = bones.Labels(fragments, progress).numbers;
    for (std::size_t n = 0; n < fragments.size(); ++n)
    {
      const std::vector<PlanId> cuts = CutsOfPiece(this->Of, fragments[n]);
      if (cuts.empty())
        continue;
      const TriangleTree mesh(bones.Mesh(fragments[n], {}));
      for (const PlanId cut : cuts)
        RemoveDust(FindPlanObject<PlanCut>(this->Of, cut)->blade, mesh, GeometryOf(this->Scan),
          std::uint16_t(n + 1), numbers);
    }
    return numbers;
  }

  void Join(const std::vector<std::uint16_t>& from, const std::vector<std::size_t>& which)
  {
    std::vector<std::uint16_t>& to = this->Found.numbers;
    ParallelFor(0, std::int64_t(to.size()), Grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t s = begin; s < end; ++s)
          if (from[s] != 0)
            to[s] = std::max(to[s], std::uint16_t(which[from[s] - 1] + 1));
      });
  }

  const Plan& Of;
  const PlanImages& Images;
  std::span<const PlanId> Fragments;
  AnyGridView Scan;
  std::map<PlanId, std::vector<std::size_t>> ByLabel, ByBone; ///< numbers of fragments
  PlanFragmentVoxels Found;
};
} // namespace

const PlanFragment* WholeOf(const Plan& plan, PlanId fragment)
{
  const PlanFragment* whole = FindPlanObject<PlanFragment>(plan, fragment);
  while (whole)
    if (const auto* piece = std::get_if<PieceSource>(&whole->source))
      whole = FindPlanObject<PlanFragment>(plan, piece->fragment);
    else
      break;
  return whole;
}

std::vector<PlanId> CutsOfPiece(const Plan& plan, PlanId fragment)
{
  std::vector<PlanId> cuts;
  const PlanFragment* now = FindPlanObject<PlanFragment>(plan, fragment);
  while (now)
  {
    const auto* piece = std::get_if<PieceSource>(&now->source);
    if (!piece)
      break;
    for (const PlanId cut : CutsThrough(plan, piece->fragment))
      if (std::find(cuts.begin(), cuts.end(), cut) == cuts.end())
        cuts.push_back(cut);
    now = FindPlanObject<PlanFragment>(plan, piece->fragment);
  }
  return cuts;
}

PlanId VolumeOfFragment(const Plan& plan, PlanId fragment)
{
  const PlanFragment* whole = WholeOf(plan, fragment);
  if (!whole)
    return 0;
  if (const auto* component = std::get_if<ComponentSource>(&whole->source))
    return component->volume;
  if (const auto* label = std::get_if<LabelSource>(&whole->source))
    if (const auto* segmentation = FindPlanObject<PlanSegmentation>(plan, label->segmentation))
      return segmentation->volume;
  return 0;
}

double IsovalueOfFragment(const Plan& plan, PlanId fragment)
{
  const PlanFragment* whole = WholeOf(plan, fragment);
  if (!whole)
    return 0.0;
  if (const auto* component = std::get_if<ComponentSource>(&whole->source))
    return component->isovalue;
  const auto* label = std::get_if<LabelSource>(&whole->source);
  return label ? label->isovalue : 0.0;
}

PlanFragmentVoxels PlanFragmentLabels(const Plan& plan, const PlanImages& images,
  std::span<const PlanId> fragments, const ProgressFunction& progress)
{
  return FragmentNumbers(plan, images, fragments).Take(progress);
}

double FragmentSpacing(const glm::dvec3& voxelMm)
{
  return std::clamp(std::min({ voxelMm.x, voxelMm.y, voxelMm.z }), 0.1, 2.0);
}

} // namespace hasp
