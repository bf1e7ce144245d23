#pragma once
#include <array>
#include <cstddef>

namespace hasp
{

/// Three of a translation, then three of a turn.
using Vector6 = std::array<double, 6>;
/// A symmetric 6x6 matrix: its upper triangle row by row, as ContactSums::matrix.
using Symmetric6 = std::array<double, 21>;

/// Where element (row, column) of the upper triangle lies; row <= column.
constexpr std::size_t UpperIndex(std::size_t row, std::size_t column)
{
  return row * (11 - row) / 2 + column;
}

/// Solves `matrix` x = `right` by L D L^T, for a stiffness of forces and torques: N/mm, N and
/// N mm/rad. False, and x = 0, if something is not finite or the matrix is not positive definite.
///
/// lengthMm > 0: how far from the origin the body reaches. Turns count as the way of a point
/// there, so that both blocks are N/mm and a body of 1 mm solves as well as one of 10 m.
///
/// Regularised: 1e-12 of the mean diagonal, scaled so, is added to the diagonal. Hence directions
/// that nothing holds, the turn about a line on which all points lie, get a finite answer: about 0
/// if nothing pushes along them. Anything that holds by more than that is solved within 1e-12 of
/// its stiffness. A coupling adds its own stiffness and never needs this.
///
/// Any thread; no memory. Written out because the haptic kernels are to build without Eigen; 0.2
/// us.
bool Solve6(const Symmetric6& matrix, const Vector6& right, double lengthMm, Vector6& x) noexcept;

/// matrix * x.
Vector6 Multiply6(const Symmetric6& matrix, const Vector6& x) noexcept;

} // namespace hasp
