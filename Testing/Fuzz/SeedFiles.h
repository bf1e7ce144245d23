#pragma once
#include <filesystem>
#include <string>

namespace hasp
{

/// Small sound files to start from: sample types, byte orders and packings as the format has them.
/// The ending of `fileName` says which format. All throw std::exception on failure.
void MakeVolumeSeeds(const std::filesystem::path& folder, const std::string& fileName);
void MakeSegmentationSeeds(const std::filesystem::path& folder);
void MakeInvesaliusSeeds(const std::filesystem::path& folder);
void MakeSurfaceSeeds(const std::filesystem::path& folder, const std::string& fileName);

/// A series of five plain slices in folder/plain, and its third slice in each transfer syntax that
/// can be written here.
void MakeDicomSeeds(const std::filesystem::path& folder);

} // namespace hasp
