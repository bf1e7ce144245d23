#include "Segmentation/LabelDelta.h"

#include "Segmentation/BoxRows.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr std::uint64_t MostInARun = std::numeric_limits<std::uint32_t>::max();

std::uint64_t EndOf(const LabelRun& run)
{
  return run.first + run.length;
}

std::string Dims(const glm::ivec3& dims)
{
  return std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " + std::to_string(dims.z);
}

void CheckRuns(const LabelDelta& delta, std::uint64_t voxels)
{
  std::uint64_t end = 0;
  for (const LabelRun& run : delta.runs)
  {
    // The first comparison keeps the sum of the second from running over.
    if (run.first < end || run.first >= voxels || run.length < 1 || EndOf(run) > voxels)
      throw std::invalid_argument("label delta: a run of " + std::to_string(run.length) +
                                  " voxels at " + std::to_string(run.first) +
                                  ", must be in order and in a map of " + std::to_string(voxels));
    end = EndOf(run);
  }
}

/// Throws unless each voxel of a run is of the label `from` of it.
void CheckFits(const LabelDelta& delta, GridView<const Label> labels, Label LabelRun::*from)
{
  if (delta.dims != labels.geometry.dims)
    throw std::invalid_argument("label delta: made for a map of " + Dims(delta.dims) +
                                " voxels, this one has " + Dims(labels.geometry.dims));
  CheckRuns(delta, labels.geometry.Size());
  constexpr std::int64_t grain = 4096;
  const auto runs = static_cast<std::int64_t>(delta.runs.size());
  // The first of each piece, so that the message is the same with any number of threads.
  std::vector<const Label*> wrong(static_cast<std::size_t>((runs + grain - 1) / grain));
  ParallelFor(0, runs, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const LabelRun& run = delta.runs[static_cast<std::size_t>(n)];
        const Label* begin = labels.data + run.first;
        const Label* other =
          std::find_if(begin, begin + run.length, [&](Label label) { return label != run.*from; });
        if (other == begin + run.length)
          continue;
        wrong[static_cast<std::size_t>(first / grain)] = other;
        return;
      }
    });
  for (const Label* other : wrong)
    if (other)
      throw std::invalid_argument("label delta: voxel " + std::to_string(other - labels.data) +
                                  " has label " + std::to_string(*other) +
                                  " and not the one that was recorded; changes are made and taken "
                                  "back in order, each on the map it was made for");
}

void Write(const LabelDelta& delta, GridView<Label> labels, Label LabelRun::*into)
{
  ParallelFor(0, static_cast<std::int64_t>(delta.runs.size()), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const LabelRun& run = delta.runs[static_cast<std::size_t>(n)];
        std::fill_n(labels.data + run.first, run.length, run.*into);
      }
    });
}

GridView<const Label> ReadOnly(GridView<Label> labels)
{
  return { labels.data, labels.geometry };
}

/// One delta's runs, piece by piece.
class RunReader
{
public:
  explicit RunReader(const std::vector<LabelRun>& runs) : Next(runs.begin()), End(runs.end())
  {
    this->Advance(0);
  }
  bool Done() const { return this->Left.length == 0; }
  std::uint64_t First() const
  {
    return this->Done() ? std::numeric_limits<std::uint64_t>::max() : this->Left.first;
  }
  std::uint64_t Length() const { return this->Left.length; }

  /// The next `length` voxels, at most Length().
  LabelRun Take(std::uint64_t length)
  {
    LabelRun run = this->Left;
    run.length = static_cast<std::uint32_t>(length);
    this->Advance(length);
    return run;
  }

private:
  void Advance(std::uint64_t length)
  {
    this->Left.first += length;
    this->Left.length -= static_cast<std::uint32_t>(length);
    if (this->Left.length == 0 && this->Next != this->End)
      this->Left = *this->Next++;
  }

  std::vector<LabelRun>::const_iterator Next, End;
  LabelRun Left{ 0, 0, 0, 0 };
};

} // namespace

std::uint64_t LabelDelta::Voxels() const
{
  std::uint64_t sum = 0;
  for (const LabelRun& run : this->runs)
    sum += run.length;
  return sum;
}

VoxelBox LabelDelta::Box() const
{
  if (this->runs.empty())
    return {};
  const auto nx = static_cast<std::uint64_t>(this->dims.x);
  const auto ny = static_cast<std::uint64_t>(this->dims.y);
  const auto at = [&](std::uint64_t voxel)
  { return glm::ivec3(int(voxel % nx), int(voxel / nx % ny), int(voxel / (nx * ny))); };
  VoxelBox box{ this->dims, glm::ivec3(0) };
  for (const LabelRun& run : this->runs)
  {
    const glm::ivec3 a = at(run.first), b = at(EndOf(run) - 1);
    box = { glm::min(box.low, glm::min(a, b)), glm::max(box.high, glm::max(a, b) + 1) };
    if (a.y != b.y || a.z != b.z) // goes on in the next row
    {
      box.low.x = 0;
      box.high.x = this->dims.x;
    }
    if (a.z != b.z)
    {
      box.low.y = 0;
      box.high.y = this->dims.y;
    }
  }
  return box;
}

void LabelDelta::Append(const LabelRun& run)
{
  if (run.length < 1 || run.before == run.after)
    return;
  if (!this->runs.empty())
  {
    LabelRun& last = this->runs.back();
    if (run.first < EndOf(last))
      throw std::invalid_argument("label delta: a run at voxel " + std::to_string(run.first) +
                                  " behind one that ends at " + std::to_string(EndOf(last)) +
                                  "; runs come in order");
    if (run.first == EndOf(last) && run.before == last.before && run.after == last.after &&
        std::uint64_t(run.length) + last.length <= MostInARun)
    {
      last.length += run.length;
      return;
    }
  }
  this->runs.push_back(run);
}

void ApplyDelta(const LabelDelta& delta, GridView<Label> labels)
{
  CheckFits(delta, ReadOnly(labels), &LabelRun::before);
  Write(delta, labels, &LabelRun::after);
}

void RevertDelta(const LabelDelta& delta, GridView<Label> labels)
{
  CheckFits(delta, ReadOnly(labels), &LabelRun::after);
  Write(delta, labels, &LabelRun::before);
}

LabelDelta DifferenceOf(
  GridView<const Label> before, GridView<const Label> after, const VoxelBox& box)
{
  const glm::ivec3 dims = before.geometry.dims;
  if (dims != after.geometry.dims)
    throw std::invalid_argument("label maps of " + Dims(dims) + " and " +
                                Dims(after.geometry.dims) + " voxels have no difference");
  if (!box.Empty() && box.In(dims) != box)
    throw std::invalid_argument(
      "the box of a difference must lie in the map of " + Dims(dims) + " voxels");
  return ProposeRows(before, box,
    [&](int j, int k, std::span<Label> row)
    { std::copy_n(&after(box.low.x, j, k), row.size(), row.begin()); },
    {});
}

LabelDelta JoinDeltas(const LabelDelta& first, const LabelDelta& second)
{
  if (first.dims != second.dims)
    throw std::invalid_argument("label deltas of maps of " + Dims(first.dims) + " and " +
                                Dims(second.dims) + " voxels cannot be joined");
  CheckRuns(first, std::numeric_limits<std::uint64_t>::max());
  CheckRuns(second, std::numeric_limits<std::uint64_t>::max());
  LabelDelta joined{ first.dims, {} };
  RunReader a(first.runs), b(second.runs);
  while (!a.Done() || !b.Done())
    if (a.First() < b.First())
      joined.Append(a.Take(std::min(a.Length(), b.First() - a.First())));
    else if (b.First() < a.First())
      joined.Append(b.Take(std::min(b.Length(), a.First() - b.First())));
    else
    {
      const std::uint64_t length = std::min(a.Length(), b.Length());
      LabelRun run = a.Take(length);
      const LabelRun next = b.Take(length);
      if (next.before != run.after)
        throw std::invalid_argument("label deltas: the second finds label " +
                                    std::to_string(next.before) + " at voxel " +
                                    std::to_string(run.first) + " where the first left " +
                                    std::to_string(run.after) + "; give them in order");
      run.after = next.after;
      joined.Append(run);
    }
  joined.runs.shrink_to_fit();
  return joined;
}

} // namespace hasp
