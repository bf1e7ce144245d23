#pragma once
#include "vtkHaspVolumeFile.h"

#include "vtkImageData.h"

#include <string>

namespace CLI
{
class App;
}

namespace hasp
{

struct Session;

/// What verbs that read a volume let their users choose of it.
struct VolumeChoices
{
  std::string input;     ///< a file, or a folder of slices
  int series = 0;        ///< as in VolumeReadSettings
  bool resample = false; ///< likewise
  bool hash = false;     ///< likewise; no option, the verb decides
};

/// Adds --series and --resample to a verb.
void AddSeriesOptions(CLI::App& verb, VolumeChoices& choices);

/// Adds these, and IN.
void AddVolumeOptions(CLI::App& verb, VolumeChoices& choices);

/// Reads a file or a folder of slices, with progress, and lists the "volume" among the resources.
/// Throws Failure: BadInput; WrongUse for a bad series.
LoadedVolume ReadVolume(const VolumeChoices& choices, Session& session);

/// Reads it likewise, and gives its passport even if it is refused: then it holds the faults. The
/// samples are dropped again.
/// Throws Failure where there is no file, and for a bad series.
Passport InspectVolume(const VolumeChoices& choices, Session& session);

/// Says the passport's warnings on standard error, unless --quiet: for verbs that use the values
/// and print no passport.
void SayWarnings(const Passport& passport, Session& session);

/// Throws Failure: WrongUse, with the volume's range, unless lowest < isovalue <= highest: inside
/// is sample >= isovalue, so any other value has no surface.
void RequireIsoValue(double isoValue, const Passport& passport);

} // namespace hasp
