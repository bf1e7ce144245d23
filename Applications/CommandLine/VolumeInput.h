#pragma once
#include "vtkHaspVolumeFile.h"

#include "vtkImageData.h"

#include <string>

namespace hasp
{

struct Session;

/// Reads a file or a folder of slices (`series` as in VolumeReadSettings), with progress, and lists
/// the "volume" among the resources. Throws Failure: BadInput; WrongUse for a bad series.
LoadedVolume ReadVolume(const std::string& path, int series, Session& session);

/// Says the passport's warnings on standard error, unless --quiet: for verbs that use the values
/// and print no passport.
void SayWarnings(const Passport& passport, Session& session);

/// Throws Failure: WrongUse, with the volume's range, unless lowest < isovalue <= highest: inside
/// is sample >= isovalue, so any other value has no surface.
void RequireIsoValue(double isoValue, const Passport& passport);

} // namespace hasp
