#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace hasp
{

/// Least squares of N unknowns by the normal equations, for what is well conditioned: N up to 6,
/// unknowns of similar size. One thread.
template <std::size_t N>
class NormalEquations
{
public:
  /// coefficients . unknowns = value
  void Add(const std::array<double, N>& coefficients, double value)
  {
    for (std::size_t r = 0; r < N; ++r)
    {
      for (std::size_t c = 0; c < N; ++c)
        this->Rows[r][c] += coefficients[r] * coefficients[c];
      this->Rows[r][N] += coefficients[r] * value;
    }
    this->Values += value;
    ++this->Count;
  }
  double MeanValue() const { return this->Count > 0 ? this->Values / double(this->Count) : 0.0; }

  /// Nothing where the equations do not fix the unknowns.
  std::optional<std::array<double, N>> Solve() const
  {
    auto rows = this->Rows;
    for (std::size_t c = 0; c < N; ++c)
    {
      std::size_t pivot = c;
      for (std::size_t r = c + 1; r < N; ++r)
        if (std::abs(rows[r][c]) > std::abs(rows[pivot][c]))
          pivot = r;
      if (!(std::abs(rows[pivot][c]) > 1e-9 * std::abs(this->Rows[c][c])))
        return std::nullopt;
      std::swap(rows[c], rows[pivot]);
      for (std::size_t r = 0; r < N; ++r)
        if (const double share = rows[r][c] / rows[c][c]; r != c)
          for (std::size_t k = c; k <= N; ++k)
            rows[r][k] -= share * rows[c][k];
    }
    std::array<double, N> unknowns;
    for (std::size_t c = 0; c < N; ++c)
      unknowns[c] = rows[c][N] / rows[c][c];
    return unknowns;
  }

private:
  std::array<std::array<double, N + 1>, N> Rows{};
  double Values = 0.0;
  std::size_t Count = 0;
};

} // namespace hasp
