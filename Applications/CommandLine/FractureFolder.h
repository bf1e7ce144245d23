#pragma once
#include "Studies/FractureCaseMaker.h"

#include <string>

namespace hasp
{

/// What bone is a case's is >= this, where samples are HU.
constexpr double CaseBoneHU = 226.0;

/// Writes a made case as a folder that is not there yet or empty, whole or not at all: the files of
/// FractureCaseFile.h, and plan.hasp, a plan of the broken scan with its label map and a fragment
/// for each label, those that did not move locked. Throws Failure: WrongUse.
void WriteFractureFolder(const MadeFractureCase& made, const std::string& folder);

} // namespace hasp
