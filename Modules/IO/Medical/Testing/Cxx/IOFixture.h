#pragma once
#include "vtkHaspVolumeFile.h"

#include "Grid/GridGeometry.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// A folder of its own for each test, removed afterwards, and a small volume whose every sample is
/// different, so that any flip, shift or swap of axes shows.
class IOFixture : public ::testing::Test
{
protected:
  IOFixture();
  ~IOFixture() override;

  /// Oblique and anisotropic; samples run from -400 to 560.
  hasp::GridGeometry Truth() const;
  static std::vector<std::int16_t> Samples(const hasp::GridGeometry& geometry);

  /// Each sample of the volume lies where the truth has it in the world, and nowhere else.
  static void ExpectSame(const hasp::LoadedVolume& volume, const hasp::GridGeometry& truth,
    const std::vector<std::int16_t>& samples);

  /// The same within a distance.
  static void ExpectPlaces(const hasp::LoadedVolume& volume, const hasp::GridGeometry& truth,
    const std::vector<std::int16_t>& samples, double toleranceMm);

  /// Opening and loading throws std::runtime_error whose text holds all of these and no path.
  void ExpectRefused(const std::filesystem::path& path, const std::vector<std::string>& says,
    const hasp::VolumeReadSettings& settings = {}) const;

  static hasp::LoadedVolume Read(
    const std::filesystem::path& path, const hasp::VolumeReadSettings& settings = {});
  static void WriteBytes(const std::filesystem::path& path, const std::string& bytes);
  static std::string ReadBytes(const std::filesystem::path& path);

  std::filesystem::path Folder;
};

/// value as raw bytes appended to a string.
template <typename T>
void AppendBytes(std::string& to, const T* values, std::size_t count)
{
  to.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}
