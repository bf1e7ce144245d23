#include "Evaluation/BestMatch.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// Least cost for `few` rows and at least as many columns: the column of each row.
template <typename Cost>
std::vector<std::size_t> Assign(std::size_t few, std::size_t many, const Cost& cost)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t none = few;
  // Dual prices; column `many` is where each augmenting path begins.
  std::vector<double> rowPrice(few, 0.0), columnPrice(many + 1, 0.0);
  std::vector<std::size_t> rowOf(many + 1, none), before(many + 1, many);
  for (std::size_t row = 0; row < few; ++row)
  {
    std::vector<double> way(many, infinity);
    std::vector<bool> reached(many + 1, false);
    std::size_t at = many;
    rowOf[many] = row;
    do
    {
      reached[at] = true;
      const std::size_t from = rowOf[at];
      double step = infinity;
      std::size_t next = many;
      for (std::size_t column = 0; column < many; ++column)
      {
        if (reached[column])
          continue;
        const double reduced = cost(from, column) - rowPrice[from] - columnPrice[column];
        if (reduced < way[column])
        {
          way[column] = reduced;
          before[column] = at;
        }
        if (way[column] < step)
        {
          step = way[column];
          next = column;
        }
      }
      for (std::size_t column = 0; column <= many; ++column)
        if (reached[column])
        {
          rowPrice[rowOf[column]] += step;
          columnPrice[column] -= step;
        }
        else if (column < many)
          way[column] -= step;
      at = next;
    } while (rowOf[at] != none);
    for (; at != many; at = before[at]) // the path's columns change hands
      rowOf[at] = rowOf[before[at]];
  }
  std::vector<std::size_t> columns(few, many);
  for (std::size_t column = 0; column < many; ++column)
    if (rowOf[column] != none)
      columns[rowOf[column]] = column;
  return columns;
}

} // namespace

std::vector<std::size_t> BestMatch(
  std::size_t rows, std::size_t columns, std::span<const double> scores)
{
  if (scores.size() != rows * columns)
    throw std::invalid_argument("best match: " + std::to_string(scores.size()) + " scores for " +
                                std::to_string(rows) + " rows and " + std::to_string(columns) +
                                " columns; must be their product");
  for (const double score : scores)
    if (!(score >= 0.0) || !std::isfinite(score))
      throw std::invalid_argument(
        "best match: a score is " + std::to_string(score) + ", must be finite and >= 0");
  std::vector<std::size_t> match(rows, columns);
  if (rows <= columns)
    match =
      Assign(rows, columns, [&](std::size_t r, std::size_t c) { return -scores[r * columns + c]; });
  else
  {
    const std::vector<std::size_t> rowOf =
      Assign(columns, rows, [&](std::size_t c, std::size_t r) { return -scores[r * columns + c]; });
    for (std::size_t column = 0; column < columns; ++column)
      if (rowOf[column] < rows)
        match[rowOf[column]] = column;
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (match[row] < columns && scores[row * columns + match[row]] == 0.0)
      match[row] = columns;
  return match;
}

} // namespace hasp
