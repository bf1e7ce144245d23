#include "Haptics/Solve6.h"

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double Regularisation = 1e-12;

using Lower = std::array<std::array<double, 6>, 6>;

/// Leaves L below the diagonal and D on it.
bool Factor(Lower& a) noexcept
{
  for (int j = 0; j < 6; ++j)
  {
    for (int k = 0; k < j; ++k)
      a[j][j] -= a[j][k] * a[j][k] * a[k][k];
    if (!(a[j][j] > 0.0) || !std::isfinite(a[j][j]))
      return false;
    for (int i = j + 1; i < 6; ++i)
    {
      for (int k = 0; k < j; ++k)
        a[i][j] -= a[i][k] * a[j][k] * a[k][k];
      a[i][j] /= a[j][j];
    }
  }
  return true;
}

void Substitute(const Lower& a, Vector6& x) noexcept
{
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < i; ++k)
      x[i] -= a[i][k] * x[k];
  for (int i = 0; i < 6; ++i)
    x[i] /= a[i][i];
  for (int i = 5; i >= 0; --i)
    for (int k = i + 1; k < 6; ++k)
      x[i] -= a[k][i] * x[k];
}

} // namespace

bool Solve6(const Symmetric6& matrix, const Vector6& right, double lengthMm, Vector6& x) noexcept
{
  x = {};
  if (!(lengthMm > 0.0) || !std::isfinite(lengthMm))
    return false;
  // theta = u / length: rows and columns of the turn are divided by it.
  const auto scale = [&](int i) { return i < 3 ? 1.0 : 1.0 / lengthMm; };
  Lower a{};
  double trace = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = i; j < 6; ++j)
      a[j][i] = matrix[UpperIndex(i, j)] * scale(i) * scale(j);
    trace += a[i][i];
  }
  for (int i = 0; i < 6; ++i)
    a[i][i] += Regularisation * trace / 6.0;
  if (!Factor(a))
    return false;
  Vector6 solved;
  for (int i = 0; i < 6; ++i)
    solved[i] = right[i] * scale(i);
  Substitute(a, solved);
  if (!std::all_of(solved.begin(), solved.end(), [](double value) { return std::isfinite(value); }))
    return false;
  for (int i = 0; i < 6; ++i)
    x[i] = solved[i] * scale(i);
  return true;
}

Vector6 Multiply6(const Symmetric6& matrix, const Vector6& x) noexcept
{
  Vector6 product{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      product[i] += matrix[UpperIndex(std::min(i, j), std::max(i, j))] * x[j];
  return product;
}

} // namespace hasp
