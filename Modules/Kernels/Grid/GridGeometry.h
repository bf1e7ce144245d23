#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace hasp
{

/// Where the samples of a volume lie in the world (patient LPS, millimetres).
///
/// dims       samples per axis, each >= 1; x varies fastest in memory
/// origin     world position of sample (0,0,0), mm
/// spacing    distance of neighbouring samples along each axis, mm, > 0; may differ per axis
/// direction  unit columns: the world directions of the index axes. They are orthogonal; a
/// determinant
///            of -1 (rows stored bottom-up, say) is as good as +1.
///
/// Index coordinates are continuous: sample (i,j,k) lies at index (i,j,k). Any thread; a value
/// type.
struct GridGeometry
{
  glm::ivec3 dims{ 0 };
  glm::dvec3 origin{ 0.0 };
  glm::dvec3 spacing{ 1.0 };
  glm::dmat3 direction{ 1.0 };

  /// Samples in all. Computed in 64 bits.
  std::size_t Size() const;

  /// Cells per axis: one less than samples, and at least 0.
  glm::ivec3 Cells() const;

  glm::dvec3 IndexToWorld(const glm::dvec3& index) const;
  glm::dvec3 WorldToIndex(const glm::dvec3& world) const;

  /// Columns: world vector of one index step along each axis, mm.
  glm::dmat3 IndexToWorldMatrix() const;

  /// A gradient per index step becomes a gradient per millimetre in world directions
  /// (inverse transpose of IndexToWorldMatrix).
  glm::dvec3 GradientToWorld(const glm::dvec3& perIndexStep) const;

  /// Throws std::invalid_argument, with the value found and the legal range, unless dims >= 1
  /// and their product fits 62 bits, spacing is finite and > 0, origin is finite, and direction is
  /// orthonormal within 1e-4.
  void Validate() const;
};

} // namespace hasp
