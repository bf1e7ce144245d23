#pragma once
#include "Light/Environment.h"

#include <filesystem>

namespace hasp
{

/// Reads a picture of the Radiance format (.hdr, .pic): 8 bits a channel and a shared exponent, run
/// length encoded or plain. Its EXPOSURE is taken back out. Values as Radiance's, without the half
/// step that its own library adds.
///
/// Throws std::runtime_error, with what is wrong, in which row, and what to do: no such file, no
/// Radiance picture, XYZE colours, rows that do not go from the top left, more than 16384 x 8192
/// pixels (found before memory is taken, as is a file far too short), a file that ends early or
/// runs beyond its rows' ends. What follows the last row is not read. The message names no folder.
EnvironmentMap ReadRadianceFile(const std::filesystem::path& path);

} // namespace hasp
