#pragma once
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hasp
{

/// Points of a body's surface as the kernels read them: structure of arrays, every array 64-byte
/// aligned and padded to a multiple of Lanes with points at FarAway, which never touch. Body axes,
/// mm. Somebody else owns them.
struct ContactPoints
{
  static constexpr int Lanes = 16;         ///< the widest vector of floats
  static constexpr float FarAway = 1.0e9F; ///< mm, on each axis

  const float *x = nullptr, *y = nullptr, *z = nullptr;
  const float *nx = nullptr, *ny = nullptr, *nz = nullptr; ///< outward, unit
  /// mm^2 that each point stands for; null: all for `area`.
  const float* areas = nullptr;
  float area = 0.0F;
  std::uint32_t count = 0; ///< a multiple of Lanes
};

/// One run of points, or several, as the coarse phase leaves them: what kernels take at once. Does
/// not own them.
class ContactRuns
{
public:
  ContactRuns(const ContactPoints& one) noexcept : Runs(&one, 1) {}
  ContactRuns(std::span<const ContactPoints> runs) noexcept : Runs(runs) {}

  const ContactPoints* begin() const noexcept { return this->Runs.data(); }
  const ContactPoints* end() const noexcept { return this->begin() + this->Runs.size(); }

private:
  std::span<const ContactPoints> Runs;
};

/// A run of points near each other, held by one ball: what the coarse phase accepts or rejects.
struct PointCluster
{
  glm::vec3 center{ 0.0F }; ///< body axes
  float radius = 0.0F;      ///< mm
  std::uint32_t first = 0;  ///< a multiple of ContactPoints::Lanes
  std::uint32_t count = 0;  ///< the same
};

} // namespace hasp
