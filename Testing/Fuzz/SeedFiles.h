#pragma once
#include <filesystem>
#include <string>

namespace hasp
{

struct ClusteredCells;

/// Small sound files to start from: sample types, byte orders and packings as the format has them.
/// The ending of `fileName` says which format. All throw std::exception on failure.
void MakeVolumeSeeds(const std::filesystem::path& folder, const std::string& fileName);
void MakeSegmentationSeeds(const std::filesystem::path& folder);
void MakeInvesaliusSeeds(const std::filesystem::path& folder);
void MakeSurfaceSeeds(const std::filesystem::path& folder, const std::string& fileName);
void MakeCellSeeds(const std::filesystem::path& folder);

/// A .hcells file with the checksums that its bytes have: what is left to be found are lies.
std::string SealCells(const std::string& bytes);
/// Finds each cell and reads its corners, as who draws them would; aborts if a cell is not found.
void UseCells(const ClusteredCells& cells);

/// A series of five plain slices in folder/plain, and its third slice in each transfer syntax that
/// can be written here.
void MakeDicomSeeds(const std::filesystem::path& folder);

} // namespace hasp
