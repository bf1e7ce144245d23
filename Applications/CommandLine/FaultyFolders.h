#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// A folder of DICOM slices with one fault that makes any plan on it wrong.
struct FaultyFolder
{
  std::string fault; ///< "one slice is missing"
  std::filesystem::path folder;
};

/// Copies of a sound series (explicit little endian, one file a slice, at least six, in the order
/// of their names along the stack), each with another fault, as folders of `into`. Throws
/// std::runtime_error if the series is not such a one.
std::vector<FaultyFolder> MakeFaultyFolders(
  const std::filesystem::path& soundSeries, const std::filesystem::path& into);

} // namespace hasp
