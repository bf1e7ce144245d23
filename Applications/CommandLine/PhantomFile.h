#pragma once
#include "Grid/Phantom.h"

#include <nlohmann/json.hpp>

#include <string>

namespace hasp
{

class ProgressLine;

/// Samples the phantom and writes it: in slabs of a bounded size, or, as .vti, whole. Returns the
/// bytes of samples that were held at a time. Throws std::invalid_argument or std::runtime_error.
std::size_t WritePhantomFile(const GridGeometry& grid, const PhantomSettings& settings,
  const std::string& path, ProgressLine& progress);

/// What was made and its truth, for --json: grid, tissues, parts with volumes, landmarks, defect.
nlohmann::ordered_json DescribePhantom(const GridGeometry& grid, const PhantomSettings& settings);

} // namespace hasp
