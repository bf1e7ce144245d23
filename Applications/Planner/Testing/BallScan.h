#pragma once
#include <array>
#include <filesystem>
#include <vector>

/// Balls of bone in a body of soft tissue in air, with noise, as a scan: what is seen of them is
/// known in closed form.
struct BallScan
{
  using Place = std::array<double, 3>; ///< LPS, mm

  static constexpr double RadiusMm = 8.0; ///< where values are half way from tissue's to bone's
  static constexpr int Air = 3000, Tissue = 4000, Bone = 5500; ///< no HU
  static constexpr int Noise = 60;                             ///< at most

  std::vector<Place> balls;
  std::array<int, 3> half{ 50, 90, 70 }; ///< voxels of 1 mm on both sides of the origin's

  /// As MetaImage.
  void Write(const std::filesystem::path& file) const;

private:
  double ValueAt(const Place& place) const;
};
