#include "Studies/SignedRank.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{
namespace
{

constexpr std::size_t MostExact = 200;

/// Twice the ranks, whole numbers whatever the ties, in the order of sizes.
std::vector<std::size_t> TwiceRanks(const std::vector<double>& sorted)
{
  std::vector<std::size_t> ranks(sorted.size());
  for (std::size_t first = 0; first < sorted.size();)
  {
    std::size_t end = first + 1;
    while (end < sorted.size() && std::abs(sorted[end]) == std::abs(sorted[first]))
      ++end;
    std::fill(ranks.begin() + std::ptrdiff_t(first), ranks.begin() + std::ptrdiff_t(end),
      first + 1 + end); // the mean of ranks first + 1 to end, twice
    first = end;
  }
  return ranks;
}

/// Share of all signs whose ranks above zero, twice, sum up to no more than `least`.
double ShareUpTo(const std::vector<std::size_t>& ranks, std::size_t least)
{
  std::vector<double> shares{ 1.0 }; // of each sum
  for (const std::size_t rank : ranks)
  {
    std::vector<double> next(shares.size() + rank, 0.0);
    for (std::size_t sum = 0; sum < shares.size(); ++sum)
    {
      next[sum] += 0.5 * shares[sum];
      next[sum + rank] += 0.5 * shares[sum];
    }
    shares = std::move(next);
  }
  double share = 0.0;
  for (std::size_t sum = 0; sum <= std::min(least, shares.size() - 1); ++sum)
    share += shares[sum];
  return share;
}

double NormalShareUpTo(const std::vector<std::size_t>& ranks, double least)
{
  double mean = 0.0, variance = 0.0; // of a sum of ranks of which each counts by a coin
  for (const std::size_t twice : ranks)
  {
    mean += 0.25 * double(twice);
    variance += 0.0625 * double(twice) * double(twice);
  }
  return 0.5 * std::erfc((mean - least - 0.5) / std::sqrt(2.0 * variance));
}

} // namespace

SignedRank TestSignedRanks(std::span<const double> differences)
{
  std::vector<double> sorted;
  for (const double difference : differences)
  {
    if (!std::isfinite(difference))
      throw std::invalid_argument(
        "signed ranks: a difference is " + std::to_string(difference) + "; all must be finite");
    if (difference != 0.0)
      sorted.push_back(difference);
  }
  std::sort(
    sorted.begin(), sorted.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const std::vector<std::size_t> ranks = TwiceRanks(sorted);
  SignedRank result;
  result.n = int(sorted.size());
  for (std::size_t n = 0; n < sorted.size(); ++n)
    (sorted[n] > 0.0 ? result.above : result.below) += 0.5 * double(ranks[n]);
  const double least = std::min(result.above, result.below);
  const double side = ranks.size() <= MostExact ? ShareUpTo(ranks, std::size_t(2.0 * least + 0.5))
                                                : NormalShareUpTo(ranks, least);
  result.p = std::min(1.0, 2.0 * side);
  return result;
}

} // namespace hasp
