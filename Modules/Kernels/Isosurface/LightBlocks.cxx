#include "Isosurface/LightBlocks.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hasp
{

namespace
{

constexpr int Ways = 8;
constexpr std::uint32_t None = LightSpot::None;
constexpr std::uint64_t Low = 0xFFFFFFFFU;              // of a word
constexpr std::uint64_t HalfFull = 0x8000000080000000U; // of the sums of a word, either
constexpr int PlaceBits = 18;                           // of a block along an axis
constexpr float Whole = 128.0F; // the weight of a sample: 2^25 of them fit into a sum

/// Level, face and place of a block. A 1 on top, so that none is 0.
LightBlocks::Key KeyOf(const LightPlace& place, const glm::ivec3& block)
{
  return std::uint64_t(1) << 63 | std::uint64_t(place.level) << 57 |
         std::uint64_t(place.face) << 54 | std::uint64_t(block.z) << 2 * PlaceBits |
         std::uint64_t(block.y) << PlaceBits | std::uint64_t(block.x);
}

/// Neighbouring keys fall into unlike buckets: Steele, Lea, Flood 2014.
std::uint64_t Scramble(std::uint64_t v)
{
  v = (v ^ v >> 30U) * 0xBF58476D1CE4E5B9U;
  v = (v ^ v >> 27U) * 0x94D049BB133111EBU;
  return v ^ v >> 31U;
}

/// The lattice corners around a place, x fastest.
struct Corners
{
  LightBlocks::Key first;  ///< of the block of the lowest corner
  std::uint32_t blocks[8]; ///< how many blocks on from there, a bit an axis
  int entries[8];          ///< in that block
  std::uint8_t weights[8]; ///< trilinear, about Whole together

  explicit Corners(const LightPlace& place) : first(KeyOf(place, place.corner >> 2))
  {
    const glm::ivec3 in = place.corner & (LightBlocks::Side - 1);
    const glm::vec3 high = place.within, low = 1.0F - high;
    for (int c = 0; c < 8; ++c)
    {
      const int x = in.x + (c & 1), y = in.y + (c >> 1 & 1), z = in.z + (c >> 2);
      this->blocks[c] = static_cast<std::uint32_t>(x >> 2 | y >> 2 << 1 | z >> 2 << 2);
      this->entries[c] = (z & 3) << 4 | (y & 3) << 2 | (x & 3);
      const float share =
        (c & 1 ? high.x : low.x) * (c & 2 ? high.y : low.y) * (c & 4 ? high.z : low.z);
      this->weights[c] = static_cast<std::uint8_t>(Whole * share + 0.5F);
    }
  }

  LightBlocks::Key KeyOfBlock(std::uint32_t steps) const
  {
    return this->first + (steps & 1U) + (std::uint64_t(steps >> 1U & 1U) << PlaceBits) +
           (std::uint64_t(steps >> 2U) << 2 * PlaceBits);
  }
};

} // namespace

LightPlace LightPlace::Coarser() const
{
  const glm::vec3 odd(this->corner & 1);
  return { this->corner >> 1, 0.5F * (odd + this->within), this->level + 1, this->face };
}

LightBlocks::LightBlocks(std::size_t count, Of what)
  : Count(count),
    Keys(count, 0),
    Used(count, 0),
    Words(what == Of::Colors ? 2 : 1),
    Sums(new std::uint64_t[count * Entries * this->Words]) // cleared when it is used
{
}

std::size_t LightBlocks::Bytes() const
{
  return this->Count *
         (sizeof(Key) + sizeof(std::uint32_t) + Entries * this->Words * sizeof(std::uint64_t));
}

std::uint32_t LightBlocks::Find(Key key) const
{
  const std::size_t bucket = Scramble(key) & (this->Count / Ways - 1);
  for (std::size_t way = bucket * Ways; way < (bucket + 1) * Ways; ++way)
    if (this->Keys[way] == key)
      return static_cast<std::uint32_t>(way);
  return None;
}

std::uint32_t LightBlockFinder::operator()(LightBlocks::Key key)
{
  const std::size_t slot = (key * 0x9E3779B97F4A7C15U) >> 59U;
  if (this->Keys[slot] != key)
  {
    this->Keys[slot] = key;
    this->Found[slot] = this->Blocks->Find(key);
    if (this->Found[slot] != LightSpot::None)
      std::atomic_ref(this->Blocks->Used[this->Found[slot]])
        .store(this->Blocks->Now, std::memory_order_relaxed);
  }
  return this->Found[slot];
}

LightSpot LightBlocks::Find(Finder& finder, const LightPlace& place) const
{
  const Corners corners(place);
  LightSpot spot;
  spot.whole = true;
  std::uint32_t blocks[8];
  std::uint32_t known = 0; // which of blocks
  for (int c = 0; c < 8; ++c)
  {
    const std::uint32_t steps = corners.blocks[c];
    if ((known >> steps & 1U) == 0)
    {
      known |= 1U << steps;
      blocks[steps] = finder(corners.KeyOfBlock(steps));
      spot.whole = spot.whole && blocks[steps] != None;
    }
    spot.sums[c] = blocks[steps] == None ? None : blocks[steps] * Entries + corners.entries[c];
    spot.weights[c] = corners.weights[c];
    if (spot.sums[c] != None)
      __builtin_prefetch(&this->Sums[spot.sums[c] * this->Words]);
  }
  return spot;
}

LightMean LightBlocks::Mean(const LightSpot& spot) const
{
  std::uint64_t open = 0, samples = 0;
  for (int c = 0; c < 8; ++c)
  {
    if (spot.sums[c] == None)
      continue;
    const std::uint64_t sum = this->Sums[spot.sums[c]];
    open += spot.weights[c] * (sum >> 32U);
    samples += spot.weights[c] * (sum & 0xFFFFFFFFU);
  }
  if (samples == 0)
    return {};
  return { float(double(open) / double(samples)), static_cast<float>(samples) / (Whole * Whole) };
}

void LightBlocks::Add(const LightSpot& spot, int rays, int open)
{
  const std::uint64_t sample = std::uint64_t(open) << 32U | std::uint64_t(rays);
  for (int c = 0; c < 8; ++c)
    if (spot.sums[c] != None && spot.weights[c] != 0)
      std::atomic_ref(this->Sums[spot.sums[c]])
        .fetch_add(sample * spot.weights[c], std::memory_order_relaxed);
}

ColorMean LightBlocks::MeanColor(const LightSpot& spot) const
{
  std::uint64_t red = 0, green = 0, blue = 0, samples = 0;
  for (int c = 0; c < 8; ++c)
  {
    if (spot.sums[c] == None)
      continue;
    const std::uint64_t* sum = &this->Sums[std::size_t(spot.sums[c]) * 2];
    red += spot.weights[c] * (sum[0] >> 32U);
    green += spot.weights[c] * (sum[0] & Low);
    blue += spot.weights[c] * (sum[1] >> 32U);
    samples += spot.weights[c] * (sum[1] & Low);
  }
  if (samples == 0)
    return {};
  const double share = double(ColorStep) / double(samples);
  return { glm::vec3(share * glm::dvec3(double(red), double(green), double(blue))),
    static_cast<float>(samples) / (Whole * Whole) };
}

void LightBlocks::AddColor(const LightSpot& spot, const glm::vec3& color, float round)
{
  const auto steps = [&](float v) // 0 for what is no number, too
  {
    return static_cast<std::uint64_t>(
      (v > 0.0F ? std::min(v, BrightestColor) : 0.0F) / ColorStep + round);
  };
  const std::uint64_t first = steps(color.r) << 32U | steps(color.g),
                      second = steps(color.b) << 32U | 1U;
  for (int c = 0; c < 8; ++c)
    if (spot.sums[c] != None && spot.weights[c] != 0)
    {
      std::uint64_t* sum = &this->Sums[std::size_t(spot.sums[c]) * 2];
      const auto now = [&](int n)
      { return std::atomic_ref(sum[n]).load(std::memory_order_relaxed); };
      if (((now(0) | now(1)) & HalfFull) != 0) // knows enough, and must not run over
        continue;
      std::atomic_ref(sum[0]).fetch_add(first * spot.weights[c], std::memory_order_relaxed);
      std::atomic_ref(sum[1]).fetch_add(second * spot.weights[c], std::memory_order_relaxed);
    }
}

void LightBlocks::Age(float samples)
{
  const auto most = static_cast<std::uint64_t>(samples * Whole);
  for (std::size_t n = 0; n < this->Count; ++n)
    for (std::size_t entry = n * Entries; this->Keys[n] != 0 && entry < (n + 1) * Entries; ++entry)
    {
      std::uint64_t* sum = &this->Sums[entry * 2];
      const std::uint64_t count = sum[1] & Low;
      if (count <= most)
        continue;
      const auto less = [&](std::uint64_t v) { return v * most / count; };
      sum[0] = less(sum[0] >> 32U) << 32U | less(sum[0] & Low);
      sum[1] = less(sum[1] >> 32U) << 32U | most;
    }
}

void LightBlocks::ListMissing(
  Finder& finder, const LightPlace& place, std::vector<Key>& missing) const
{
  const Corners corners(place);
  std::uint32_t seen = 0; // blocks
  for (const std::uint32_t steps : corners.blocks)
  {
    if (seen >> steps & 1U)
      continue;
    seen |= 1U << steps;
    const Key key = corners.KeyOfBlock(steps);
    if (finder(key) == None)
      missing.push_back(key);
  }
}

void LightBlocks::Make(Key key)
{
  if (this->Find(key) != None)
    return;
  const std::size_t bucket = Scramble(key) & (this->Count / Ways - 1);
  std::size_t oldest = bucket * Ways;
  for (std::size_t way = bucket * Ways; way < (bucket + 1) * Ways; ++way)
    if (this->Used[way] < this->Used[oldest])
      oldest = way;
  if (this->Used[oldest] == this->Now)
    return;
  this->Keys[oldest] = key;
  this->Used[oldest] = this->Now;
  const std::size_t words = Entries * this->Words;
  std::fill_n(this->Sums.get() + oldest * words, words, 0);
}

void LightBlocks::Forget()
{
  std::fill(this->Keys.begin(), this->Keys.end(), 0);
  std::fill(this->Used.begin(), this->Used.end(), 0);
}

void LightBlocks::Forget(const glm::dvec3& low, const glm::dvec3& high)
{
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    const Key key = this->Keys[n];
    if (key == 0)
      continue;
    const auto part = [&](int shift)
    { return static_cast<double>(key >> shift & ((1U << PlaceBits) - 1)); };
    const double side = std::ldexp(1.0, static_cast<int>(key >> 57 & 63));
    const glm::dvec3 first =
      side * Side * glm::dvec3(part(0), part(PlaceBits), part(2 * PlaceBits));
    // Samples reach one step beyond the corners that they are added to.
    const glm::dvec3 from = first - side, to = first + side * Side;
    if (glm::all(glm::lessThanEqual(from, high)) && glm::all(glm::greaterThanEqual(to, low)))
    {
      this->Keys[n] = 0;
      this->Used[n] = 0;
    }
  }
}

} // namespace hasp
