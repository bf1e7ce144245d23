#pragma once
#include "Devices/HeadPose.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

/// A head's poses in the order of their times, which increase strictly.
using HeadPath = std::vector<TimedHeadPose>;

constexpr std::size_t MostHeadPathPoses = 1'000'000; ///< in a file
constexpr double MostHeadPathTimeS = 1e9;            ///< from 0: a nanosecond still shows there

/// Throws std::invalid_argument unless there is a pose, each passes ValidateHeadPose, and times are
/// finite, within +-MostHeadPathTimeS and strictly increasing; says which pose (from 1).
void ValidateHeadPath(std::span<const TimedHeadPose> path);

/// Between `a` (share 0) and `b` (share 1): straight for the position, the shortest turn at an even
/// speed (slerp) for the orientation. Unit quaternion. Any thread; no state.
HeadPose MixHeadPoses(const HeadPose& a, const HeadPose& b, double share);

/// The pose at a time between two of the path, or its first or last outside. The path must be
/// valid and is not checked again. Any thread; O(log n).
HeadPose HeadPoseAt(std::span<const TimedHeadPose> path, double timeS);

/// Head paths as text: a line that names the columns, then a line a pose, numbers as C prints them,
/// no blanks:
///
///   timeS,xMm,yMm,zMm,qw,qx,qy,qz
///   0,0,0,600,1,0,0,0
///   0.0166,1.5,0,600,0.99,0,0.141,0
///
/// Strict: other columns, blanks, missing or more numbers, and whatever ValidateHeadPath refuses
/// are errors: std::runtime_error (file) or std::invalid_argument (content). They say the line,
/// never the file's name or text. At most MostHeadPathPoses and 256 MiB, held against the file's
/// size before memory is taken. What is written is read back to the last bit. Any thread; O(n).
HeadPath ParseHeadPath(std::string_view text);
std::string FormatHeadPath(std::span<const TimedHeadPose> path);

HeadPath ReadHeadPath(const std::string& file);
/// Writes a temporary file beside `file` and renames it: the old file or the new one, never half.
void WriteHeadPath(const std::string& file, std::span<const TimedHeadPose> path);

} // namespace hasp
