#pragma once
#include <glm/vec2.hpp>

#include <cstdint>

namespace hasp
{

/// Neighbouring numbers become unlike; each 64-bit number has one of its own (splitmix64).
inline std::uint64_t MixedBits(std::uint64_t v)
{
  v = (v ^ v >> 30U) * 0xBF58476D1CE4E5B9U;
  v = (v ^ v >> 27U) * 0x94D049BB133111EBU;
  return v ^ v >> 31U;
}

/// Owen-scrambled Sobol points (hash-based nested uniform scrambling: Laine and Karras 2011, Burley
/// 2020 "Practical Hash-based Owen Scrambling", with Vegdahl's hash), padded: each pair of
/// dimensions is the (0,2)-sequence of Sobol in an order and with a scramble of its own, so there
/// is no last dimension.
///
/// Of the indices of an aligned block of 2^k, the first 2^k say, the points of each pair are a
/// (0,2)-net: every interval of 2^-a by 2^(a-k) holds exactly one. So a number of points that is a
/// power of 2 serves best. The error of a smooth integrand of two dimensions falls about with
/// points^-1.5, and for each seed the mean is true on average over the seeds. Pairs are independent
/// of each other, which is what padding costs: an integrand of four dimensions that are not two and
/// two falls more slowly, though no more slowly than random.
///
/// Deviates from Burley, who pads sets of four dimensions. Takes 10 to 15 ns a pair. The same
/// numbers on every machine.
class SobolSequence
{
public:
  /// Point number `index` of the sequence `seed` (a pixel's number, say).
  SobolSequence(std::uint32_t seed, std::uint32_t index)
    : Seed(std::uint64_t(seed) << 32U),
      MirroredIndex(Mirrored(index))
  {
  }
  /// The next two dimensions, each in [0,1) and a multiple of 2^-32.
  glm::dvec2 Next()
  {
    const std::uint64_t hash = this->NextHash();
    const std::uint32_t first = this->First(hash);
    // The second dimension's matrix is Pascal's triangle modulo 2: a product of five shifts.
    std::uint32_t second = Mirrored(first);
    second ^= second >> 16U;
    second ^= (second & 0xFF00FF00U) >> 8U;
    second ^= (second & 0xF0F0F0F0U) >> 4U;
    second ^= (second & 0xCCCCCCCCU) >> 2U;
    second ^= (second & 0xAAAAAAAAU) >> 1U;
    return { Scrambled(Mirrored(first), XSeed(hash)), Scrambled(second, MixedBits(hash)) };
  }
  /// The next dimension; one of a pair whose other is not used.
  double Next1()
  {
    const std::uint64_t hash = this->NextHash();
    return Scrambled(Mirrored(this->First(hash)), XSeed(hash));
  }

private:
  static std::uint32_t Mirrored(std::uint32_t v)
  {
    v = v >> 16U | v << 16U;
    v = (v & 0x00FF00FFU) << 8U | (v & 0xFF00FF00U) >> 8U;
    v = (v & 0x0F0F0F0FU) << 4U | (v & 0xF0F0F0F0U) >> 4U;
    v = (v & 0x33333333U) << 2U | (v & 0xCCCCCCCCU) >> 2U;
    return (v & 0x55555555U) << 1U | (v & 0xAAAAAAAAU) >> 1U;
  }
  /// A permutation in which no bit depends on a higher one: on mirrored bits, Owen's scrambling.
  static std::uint32_t Permuted(std::uint32_t v, std::uint32_t seed)
  {
    v ^= v * 0x3D20ADEAU;
    v += seed;
    v *= seed >> 16U | 1U;
    v ^= v * 0x05526C56U;
    return v ^ v * 0x53A22864U;
  }
  static double Scrambled(std::uint32_t mirrored, std::uint64_t seed)
  {
    return Mirrored(Permuted(mirrored, static_cast<std::uint32_t>(seed))) / 4294967296.0;
  }
  static std::uint64_t XSeed(std::uint64_t hash) { return hash >> 32U; }
  std::uint64_t NextHash() { return MixedBits(this->Seed + ++this->Pair); }
  /// Sobol's first dimension mirrors the bits of the index, and so does the shuffle of the order.
  std::uint32_t First(std::uint64_t hash) const
  {
    return Permuted(this->MirroredIndex, static_cast<std::uint32_t>(hash));
  }

  std::uint64_t Seed;
  std::uint32_t MirroredIndex, Pair = 0;
};

/// Independent random points of the same interface (splitmix64): what evenness is measured against.
class RandomSequence
{
public:
  RandomSequence(std::uint32_t seed, std::uint32_t index)
    : State(MixedBits(std::uint64_t(seed) << 32U | index))
  {
  }
  glm::dvec2 Next()
  {
    const std::uint64_t bits = this->NextBits();
    return { (bits >> 32U) / 4294967296.0, (bits & 0xFFFFFFFFU) / 4294967296.0 };
  }
  double Next1() { return (this->NextBits() >> 32U) / 4294967296.0; }

private:
  std::uint64_t NextBits() { return MixedBits(this->State += 0x9E3779B97F4A7C15U); }

  std::uint64_t State;
};

} // namespace hasp
