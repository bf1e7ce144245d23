#include "BladeSection.h"

#include "Distance/Csg.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/GridSolid.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace hasp
{

namespace
{
/// Bone in a blade as samples, and its sections: what of them is connected within the blade.
class SectionSamples
{
public:
  SectionSamples(const Blade& blade, const ImplicitSolid& bone, double stepMm)
    : Middle(blade.World({}))
  {
    // One sample more at each end, so that the tool's box ends before the samples do.
    const glm::ivec3 steps = glm::max(glm::ivec3(glm::ceil(2.0 * blade.Half() / stepMm)), 1);
    this->Grid.dims = steps + 3;
    this->Grid.spacing = 2.0 * blade.Half() / glm::dvec3(steps);
    this->Grid.direction = blade.Axes();
    this->Grid.origin = blade.World(-blade.Half() - this->Grid.spacing);
    this->Inside.resize(this->Grid.Size());
    const std::size_t row = std::size_t(this->Grid.dims.x);
    ParallelFor(0, std::int64_t(this->Inside.size() / row), 16,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::size_t n = std::size_t(first) * row; n < std::size_t(last) * row; ++n)
          this->Inside[n] = bone.At(this->World(n)) < 0.0;
      });
  }

  /// Numbers the sections, and asks whose they are: the fragment of most of their samples.
  void FindSections(const FragmentLabels& labels)
  {
    this->Section.resize(this->Inside.size());
    for (std::size_t n = 0; n < this->Inside.size(); ++n)
    {
      if (this->Inside[n] != 1)
        continue;
      std::map<std::uint32_t, std::size_t> votes;
      const auto number = std::uint32_t(this->Fragment.size());
      FloodSamples(this->Grid.dims, this->Inside, n, 1, 2,
        [&](std::size_t sample)
        {
          this->Section[sample] = number;
          if (const std::uint32_t label = labels.At(this->World(sample)))
            ++votes[label];
        });
      const auto most = std::max_element(votes.begin(), votes.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
      this->Fragment.push_back(most == votes.end() ? 0 : most->first);
    }
    this->Taken.assign(this->Fragment.size(), false);
  }

  /// Takes the section nearest to the blade's middle; its fragment, or 0 if there is none.
  std::uint32_t TakeNearest()
  {
    double least = 1e30;
    std::uint32_t nearest = 0;
    for (std::size_t n = 0; n < this->Inside.size(); ++n)
      if (this->Inside[n] && this->Fragment[this->Section[n]] != 0)
        if (const double away = glm::distance(this->World(n), this->Middle); away < least)
          least = away, nearest = this->Section[n];
    if (least == 1e30)
      return 0;
    this->Taken[nearest] = true;
    return this->Fragment[nearest];
  }

  /// And what else of the fragment, or too small to be anybody's, lies within so much of that.
  void TakeWithin(std::uint32_t fragment, double reachMm)
  {
    const auto waits = [&](std::size_t s)
    { return !this->Taken[s] && (this->Fragment[s] == fragment || this->Fragment[s] == 0); };
    for (bool more = true; more;)
    {
      more = false;
      bool any = false;
      for (std::size_t s = 0; s < this->Taken.size(); ++s)
        any |= waits(s);
      if (!any)
        return;
      const std::vector<float> squared = this->SquaredFrom(true);
      for (std::size_t n = 0; n < this->Inside.size(); ++n)
        if (this->Inside[n] && waits(this->Section[n]) && squared[n] <= reachMm * reachMm)
          more = this->Taken[this->Section[n]] = true;
    }
  }

  bool LeavesNothing() const
  {
    return std::find(this->Taken.begin(), this->Taken.end(), false) == this->Taken.end();
  }

  /// What is nearer to bone that is taken than to bone that stays, known to half a sample: an
  /// eighth of the thinnest kerf, of which it keeps half to either side.
  SolidPointer Region() const
  {
    const std::vector<float> taken = this->SquaredFrom(true), left = this->SquaredFrom(false);
    std::vector<std::uint8_t> nearer(taken.size());
    for (std::size_t n = 0; n < taken.size(); ++n)
      nearer[n] = taken[n] < left[n];
    return MakeGridSolid(
      std::make_shared<const std::vector<float>>(SignedEuclideanDistance(this->Grid, nearer)),
      this->Grid);
  }

  double LeftMm2() const
  {
    std::size_t left = 0;
    for (std::size_t n = 0; n < this->Inside.size(); ++n)
      left += this->Inside[n] && !this->Taken[this->Section[n]];
    return double(left) * this->Grid.spacing.x * this->Grid.spacing.y / this->Grid.dims.z;
  }

private:
  glm::dvec3 World(std::size_t sample) const
  {
    return this->Grid.IndexToWorld(glm::dvec3(SamplePlace(this->Grid.dims, sample)));
  }

  std::vector<float> SquaredFrom(bool taken) const
  {
    std::vector<std::uint8_t> seeds(this->Inside.size());
    for (std::size_t n = 0; n < seeds.size(); ++n)
      seeds[n] = this->Inside[n] && this->Taken[this->Section[n]] == taken;
    return NearestSeeds(this->Grid, seeds).squared;
  }

  glm::dvec3 Middle;
  GridGeometry Grid;
  std::vector<std::uint8_t> Inside;    ///< 0: no bone, 2: bone in a section
  std::vector<std::uint32_t> Section;  ///< of each sample of bone
  std::vector<std::uint32_t> Fragment; ///< of each section
  std::vector<bool> Taken;             ///< likewise
};
} // namespace

std::optional<BladeSection> FindSection(
  const BoneCut& cut, const ImplicitSolid& bone, const FragmentLabels& labels, double stepMm)
{
  const Blade blade(cut.blade);
  SectionSamples samples(blade, bone, stepMm);
  samples.FindSections(labels);
  const std::uint32_t fragment = samples.TakeNearest();
  if (fragment == 0)
    return std::nullopt;
  samples.TakeWithin(fragment, cut.reachMm);
  CutTool tool{ blade, nullptr, blade.Box() };
  if (!samples.LeavesNothing())
  {
    tool.region = samples.Region();
    tool.tool = MakeIntersection({ tool.tool, tool.region });
  }
  return BladeSection{ tool, fragment, samples.LeftMm2() };
}

} // namespace hasp
