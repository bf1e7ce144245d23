#pragma once
#include <span>

namespace hasp
{

/// Wilcoxon's signed-rank test of paired differences (Wilcoxon 1945): are they as often and as far
/// above zero as below?
struct SignedRank
{
  int n = 0;          ///< differences that are not zero: zeros are left out, as Wilcoxon did
  double above = 0.0; ///< sum of ranks of those above zero; equal sizes share their mean rank
  double below = 0.0;
  double p = 1.0; ///< both sides: of sums as far from their mean as these, if none of it is so
};

/// The distribution is the exact one, of all 2^n signs with the ranks as they are, ties and all, up
/// to 200 differences; beyond that the normal one with the variance of tied ranks and a correction
/// of a half for continuity. Throws std::invalid_argument on a difference that is not finite. Any
/// thread; O(n^3) up to 200.
SignedRank TestSignedRanks(std::span<const double> differences);

} // namespace hasp
