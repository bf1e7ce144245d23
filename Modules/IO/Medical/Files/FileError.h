#pragma once
#include "vtkHaspFileNames.h"

#include <filesystem>
#include <string>

namespace hasp
{

/// The name's ending in lower case, with its dot: readers and writers go by it. ".nii.gz" and
/// ".seg.nrrd" are endings of two parts.
std::string LowerExtension(const std::filesystem::path& path);

/// A std::runtime_error that begins with the file's label. `what` holds no text of the file: what
/// stands in a file may be a patient's name.
[[noreturn]] void ThrowFileError(const std::filesystem::path& file, const std::string& what);

/// Shortest text that reads well: "12.5", "0.001".
std::string Text(double value);

} // namespace hasp
