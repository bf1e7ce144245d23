#include "VolumeInput.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::size_t SampleBytes(const Passport& passport)
{
  const std::size_t each = passport.sampleType == "float32" ? 4
                           : passport.sampleType == "uint8" ? 1
                                                            : 2;
  return passport.faults.empty() ? each * passport.geometry.Size() : 0;
}

std::size_t Bytes(vtkImageData* image)
{
  const vtkDataArray* samples = image->GetPointData()->GetScalars();
  return static_cast<std::size_t>(samples->GetNumberOfValues()) *
         static_cast<std::size_t>(samples->GetDataTypeSize());
}

/// What `read` gives, its exceptions as failures of the verb.
template <typename Read>
auto Reading(const VolumeChoices& choices, Session& session, const Read& read)
{
  RequireInput(choices.input);
  std::error_code error;
  if (std::filesystem::is_regular_file(std::filesystem::path(choices.input) / "plan.json", error))
    throw Failure(
      ExitCode::BadInput, FileLabel(choices.input) +
                            ": it is a plan, all that is decided on a case, and no volume: hasp "
                            "plan says what is in it, hasp run makes what it is for");
  session.progress.Step("reading " + FileLabel(choices.input));
  const ProgressFunction progress = [&session](double share)
  { return session.progress.Share(share); };
  VolumeReadSettings settings;
  settings.series = choices.series;
  settings.resample = choices.resample;
  settings.hash = choices.hash;
  try
  {
    return read(settings, progress);
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, SafeText(error));
  }
}

} // namespace

void AddSeriesOptions(CLI::App& verb, VolumeChoices& choices)
{
  verb.add_option(
    "--series", choices.series, "Which DICOM series, from 1, where there are several");
  verb.add_flag("--resample", choices.resample,
    "Make a regular volume of a tilted, gappy or uneven DICOM series, and say its error in mm");
}

void AddVolumeOptions(CLI::App& verb, VolumeChoices& choices)
{
  verb.add_option("IN", choices.input, "Volume: a file, or a folder of slices")->required();
  AddSeriesOptions(verb, choices);
}

LoadedVolume ReadVolume(const VolumeChoices& choices, Session& session)
{
  return Reading(choices, session,
    [&](const VolumeReadSettings& settings, const ProgressFunction& progress)
    {
      const auto start = std::chrono::steady_clock::now();
      LoadedVolume volume = LoadVolume(OpenVolume(choices.input, settings, progress), progress);
      const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
      session.resources.push_back({ "volume", Bytes(volume.image), spent.count(),
        volume.passport.format + ", " + volume.passport.sampleType });
      return volume;
    });
}

Passport InspectVolume(const VolumeChoices& choices, Session& session)
{
  return Reading(choices, session,
    [&](const VolumeReadSettings& settings, const ProgressFunction& progress)
    {
      const auto start = std::chrono::steady_clock::now();
      Passport passport = InspectVolume(choices.input, settings, progress);
      const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
      session.resources.push_back({ "volume", SampleBytes(passport), spent.count(),
        passport.format + ", " + passport.sampleType + ", for the passport" });
      return passport;
    });
}

void SayWarnings(const Passport& passport, Session& session)
{
  for (const std::string& warning : passport.warnings)
    SayWarning(session, warning);
}

void RequireIsoValue(double isoValue, const Passport& passport)
{
  if (isoValue > passport.minimum && isoValue <= passport.maximum)
    return;
  throw Failure(ExitCode::WrongUse,
    "--isovalue " + Number(isoValue) + " has no surface: the volume's values run from " +
      Number(passport.minimum) + " to " + Number(passport.maximum) + "; choose one between");
}

} // namespace hasp
