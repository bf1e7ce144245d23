#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace hasp
{

/// The pairing of rows with columns that has the largest sum of scores, each row and each column
/// used at most once (the assignment problem; Kuhn 1955, Munkres 1957, by shortest augmenting paths
/// as Jonker and Volgenant 1987).
///
/// scores   rows * columns values >= 0, finite, row after row
/// Returns for each row its column, or columns where the row has none or its score there is 0.
/// Of pairings with the same sum one is taken, always the same. Throws std::invalid_argument if
/// sizes do not fit or a score is negative or not finite. Any thread; O(s^2 l) with s the smaller
/// and l the larger of rows and columns: 2,000 of each take some 10 s at worst.
std::vector<std::size_t> BestMatch(
  std::size_t rows, std::size_t columns, std::span<const double> scores);

} // namespace hasp
