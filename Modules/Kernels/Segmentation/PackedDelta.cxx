#include "Segmentation/PackedDelta.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void CheckDims(const glm::ivec3& packed, const glm::ivec3& map)
{
  if (packed != map)
    throw std::invalid_argument("packed label delta: made for a map of other dims");
}

/// Seven bits a byte, the lowest first; the highest bit says that more follow.
void Put(std::vector<std::uint8_t>& bytes, std::uint64_t value)
{
  for (; value >= 128; value >>= 7)
    bytes.push_back(static_cast<std::uint8_t>(value | 128));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

class ByteReader
{
public:
  explicit ByteReader(const std::vector<std::uint8_t>& bytes)
    : Next(bytes.begin()),
      End(bytes.end())
  {
  }
  std::uint64_t Take()
  {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7)
    {
      if (this->Next == this->End)
        break;
      const std::uint8_t byte = *this->Next++;
      value |= std::uint64_t(byte & 127) << shift;
      if (byte < 128)
        return value;
    }
    throw std::invalid_argument("packed label delta: its bytes end within a number");
  }
  bool Done() const { return this->Next == this->End; }

private:
  std::vector<std::uint8_t>::const_iterator Next, End;
};

/// Walks along a map and counts voxels that have a label, or all.
class Walk
{
public:
  Walk(GridView<const Label> map, bool bone)
    : Map(map.data),
      Size(map.geometry.Size()),
      InBone(bone)
  {
  }
  std::uint64_t Voxel() const { return this->At; }

  /// On to a voxel; the count of those passed.
  std::uint64_t To(std::uint64_t voxel)
  {
    const Label* begin = this->Map + this->At;
    std::uint64_t passed = voxel - this->At;
    this->At = voxel;
    if (this->InBone)
      passed -= static_cast<std::uint64_t>(std::count(begin, begin + passed, Label(0)));
    this->Count += passed;
    return passed;
  }

  /// On to the end; the count of all voxels of the map.
  std::uint64_t CountAll()
  {
    this->To(this->Size);
    return this->Count;
  }

  /// Past `count` of those that are counted: at the one behind them.
  void Pass(std::uint64_t count)
  {
    this->Count += count;
    if (!this->InBone)
    {
      this->Check(count <= this->Size - this->At);
      this->At += count;
      return;
    }
    for (; count > 0; ++this->At)
    {
      this->Check(this->At < this->Size);
      count -= this->Map[this->At] != 0;
    }
  }

  /// The next stretch of voxels that are counted, at most `count` of them: its length.
  std::uint32_t Stretch(std::uint64_t count)
  {
    if (this->InBone)
      while (this->At < this->Size && this->Map[this->At] == 0)
        ++this->At;
    this->Check(this->At < this->Size);
    const std::uint64_t most = std::min(
      { count, this->Size - this->At, std::uint64_t(std::numeric_limits<std::uint32_t>::max()) });
    if (!this->InBone)
      return static_cast<std::uint32_t>(most);
    const Label* begin = this->Map + this->At;
    return static_cast<std::uint32_t>(std::find(begin, begin + most, Label(0)) - begin);
  }

private:
  void Check(bool inMap) const
  {
    if (!inMap)
      throw std::invalid_argument("packed label delta: a run goes beyond the map");
  }

  const Label* Map;
  std::uint64_t Size;
  bool InBone;
  std::uint64_t At = 0, Count = 0;
};

/// Runs that are one, counted as the walk counts.
class Packer
{
public:
  explicit Packer(PackedDelta& into) : Into(into) {}

  void Add(std::uint64_t gap, std::uint64_t length, Label before, Label after)
  {
    if (gap == 0 && this->Length > 0 && before == this->Before && after == this->After)
    {
      this->Length += length;
      return;
    }
    this->Flush();
    this->IsNewPair = before != this->Before || after != this->After;
    this->Gap = gap;
    this->Length = length;
    this->Before = before;
    this->After = after;
  }

  void Flush()
  {
    if (this->Length == 0)
      return;
    Put(this->Into.bytes, this->Gap);
    Put(this->Into.bytes, this->Length << 1 | std::uint64_t(this->IsNewPair));
    if (this->IsNewPair)
    {
      Put(this->Into.bytes, this->Before);
      Put(this->Into.bytes, this->After);
    }
    ++this->Into.runs;
    this->Length = 0;
  }

private:
  PackedDelta& Into;
  std::uint64_t Gap = 0, Length = 0;
  Label Before = 0, After = 0; ///< what no run has
  bool IsNewPair = false;
};

} // namespace

PackedDelta PackDelta(const LabelDelta& delta, GridView<const Label> after)
{
  CheckDims(delta.dims, after.geometry.dims);
  constexpr std::size_t few = 4096; // of which a pass over the map would cost more than it saves
  PackedDelta packed;
  packed.dims = delta.dims;
  packed.inBone = delta.runs.size() > few &&
                  std::all_of(delta.runs.begin(), delta.runs.end(),
                    [](const LabelRun& run) { return run.before != 0 && run.after != 0; });
  Walk walk(after, packed.inBone);
  Packer packer(packed);
  for (const LabelRun& run : delta.runs)
  {
    packer.Add(walk.To(run.first), run.length, run.before, run.after);
    if (walk.To(run.first + run.length) != run.length)
      throw std::invalid_argument("packed label delta: a run at voxel " +
                                  std::to_string(run.first) +
                                  " lies where the map has no label; give the map with it made");
  }
  packer.Flush();
  packed.bone = packed.inBone ? walk.CountAll() : 0;
  packed.bytes.shrink_to_fit();
  return packed;
}

LabelDelta UnpackDelta(const PackedDelta& packed, GridView<const Label> after)
{
  CheckDims(packed.dims, after.geometry.dims);
  LabelDelta delta{ packed.dims, {} };
  Walk walk(after, packed.inBone);
  ByteReader reader(packed.bytes);
  LabelRun run{ 0, 0, 0, 0 };
  for (std::uint64_t n = 0; n < packed.runs; ++n)
  {
    walk.Pass(reader.Take());
    const std::uint64_t coded = reader.Take();
    if (coded & 1)
    {
      run.before = static_cast<Label>(reader.Take());
      run.after = static_cast<Label>(reader.Take());
    }
    for (std::uint64_t left = coded >> 1; left > 0; left -= run.length)
    {
      run.length = walk.Stretch(left);
      run.first = walk.Voxel();
      walk.To(run.first + run.length);
      delta.Append(run);
    }
  }
  if (!reader.Done())
    throw std::invalid_argument("packed label delta: there are bytes behind its last run");
  if (packed.inBone && walk.CountAll() != packed.bone)
    throw std::invalid_argument("packed label delta: the map has not the " +
                                std::to_string(packed.bone) +
                                " voxels of bone that it was made for");
  delta.runs.shrink_to_fit();
  return delta;
}

} // namespace hasp
