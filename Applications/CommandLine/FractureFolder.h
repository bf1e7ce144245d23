#pragma once
#include "Studies/FractureCaseMaker.h"

#include <string>

namespace hasp
{

/// What bone is a case's is >= this, where samples are HU.
constexpr double CaseBoneHU = 226.0;

/// Writes a made case as a folder that is not there yet or empty, whole or not at all: the files of
/// FractureCaseFile.h, and plan.hasp, a plan of the broken scan with its label map and a fragment
/// for each label, those that did not move locked.
/// strokes   so many at most of a simulated user (SimulateUser), where samples are HU: seconds for
///           each, and 21 bytes a voxel; 0: none
/// Throws Failure: WrongUse.
void WriteFractureFolder(const MadeFractureCase& made, int strokes, const std::string& folder);

} // namespace hasp
