#include "Conversion.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VolumeInput.h"
#include "vtkHaspDicomOutput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/VolumeDifference.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double FarthestMm = 1e-4; // what headers of eight digits keep of a metre

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string SizeText(const glm::ivec3& dims)
{
  return std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " + std::to_string(dims.z);
}

/// What was written, and what came back of it.
struct Outcome
{
  std::size_t bytes = 0;
  DicomOutput slices;
  Passport back;
  VolumeDifference difference;
};

ProgressFunction Progress(Session& session)
{
  return [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
}

DicomOutputSettings SettingsFor(const ConvertOptions& options, const Passport& passport)
{
  DicomOutputSettings settings;
  settings.modality = options.modality.empty() ? passport.modality : options.modality;
  if (options.hounsfield && settings.modality.empty())
    settings.modality = "CT";
  settings.hounsfield = settings.modality == "CT" && (options.hounsfield || passport.hounsfield);
  if (options.hounsfield && !settings.hounsfield)
    throw Failure(ExitCode::WrongUse, "--hounsfield is for a CT; leave out --modality");
  settings.allowQuantisation = options.quantise;
  settings.knownNotBurnedIn = passport.burnedIn == "no";
  if (passport.resampled)
  {
    settings.slicesMade = passport.resampled->slicesMade;
    settings.madeErrorMm = passport.resampled->errorKnown ? passport.resampled->error95 : 0.0;
  }
  settings.sliceThicknessMm = passport.resampled ? 0.0 : passport.thicknessMm.value_or(0.0);
  settings.kVp = settings.modality == "CT" ? passport.kvp.value_or(0.0) : 0.0;
  return settings;
}

/// Names in a segmentation are somebody's free text.
std::vector<Segment> ShownSegments(std::vector<Segment> segments)
{
  for (std::size_t n = 0; n < segments.size() && !FileNamesShown(); ++n)
    segments[n].name = "segment " + std::to_string(n + 1);
  return segments;
}

void Write(const ConvertOptions& options, OutputKind kind, const LoadedVolume& volume,
  const std::string& name, Session& session, Outcome& outcome)
{
  try
  {
    if (kind == OutputKind::Slices)
      outcome.slices = WriteDicomSeries(
        volume.image, name, SettingsFor(options, volume.passport), Progress(session));
    else if (kind == OutputKind::Segmentation)
      WriteSegmentation(volume.image, ShownSegments(volume.segments), name);
    else
      WriteVolume(volume.image, name);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
}

void Compare(
  const LoadedVolume& volume, const std::string& name, Session& session, Outcome& outcome)
{
  session.progress.Step("reading it back");
  outcome.bytes = BytesOf(name);
  try
  {
    const LoadedVolume back =
      LoadVolume(OpenVolume(name, { .hash = true }, Progress(session)), Progress(session));
    outcome.back = back.passport;
    outcome.difference = CompareVolumes(ViewImage(volume.image), ViewImage(back.image));
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw FailedCheck("what was written cannot be read back and was not kept", { SafeText(error) });
  }
  const VolumeDifference& d = outcome.difference;
  std::vector<std::string> faults;
  if (!d.sameSize)
    faults.push_back("it has " + SizeText(outcome.back.geometry.dims) + " samples, not " +
                     SizeText(volume.passport.geometry.dims));
  if (d.positionMm > FarthestMm)
    faults.push_back("samples lie up to " + Number(d.positionMm) + " mm from their place; the " +
                     "format cannot hold this geometry");
  if (d.largest > outcome.slices.quantisationError || (d.samples > 0 && d.largest == 0.0))
    faults.push_back(std::to_string(d.samples) + " samples differ, by up to " + Number(d.largest) +
                     ", the first at index (" + std::to_string(d.first.x) + ", " +
                     std::to_string(d.first.y) + ", " + std::to_string(d.first.z) + ")");
  if (!faults.empty())
    throw FailedCheck("what was written is not what was read and was not kept", faults);
}

/// What the new format has no place for.
std::vector<std::string> Lost(const Passport& before, const Passport& after)
{
  std::vector<std::string> lost;
  if (!before.modality.empty() && after.modality != before.modality)
    lost.push_back("modality");
  if (before.hounsfield && !after.hounsfield)
    lost.push_back("that values are HU");
  if (before.resampled && before.resampled->slicesMade > 0)
    lost.push_back("which slices resampling made and its error in mm (keep this passport)");
  if (before.segments > after.segments)
    lost.push_back("names and colours of segments");
  return lost;
}

void Print(const Passport& before, const Outcome& outcome, Session& session)
{
  const Passport& after = outcome.back;
  const VolumeDifference& d = outcome.difference;
  const std::vector<std::string> lost = Lost(before, after);
  session.progress.Wipe();
  const auto describe = [](const Passport& p)
  { return p.format + ", " + SizeText(p.geometry.dims) + ", " + p.sampleType; };
  if (!session.json)
  {
    std::cout << "read        " << describe(before) << "\nwrote       " << describe(after) << ", "
              << outcome.bytes << " bytes\ncompared    ";
    if (d.samples == 0)
      std::cout << "identical: every sample";
    else
      std::cout << d.samples << " samples rounded, by up to " << Number(d.largest)
                << "; all others identical";
    std::cout << ", places within " << Number(d.positionMm) << " mm\n";
    if (!after.hash.empty())
      std::cout << "hash        " << after.hash << "\n";
    for (const std::string& what : lost)
      std::cout << "lost        " << what << ": the format has no place for it\n";
  }
  session.result["read"] = { { "format", before.format }, { "sample_type", before.sampleType } };
  session.result["written"] = { { "format", after.format }, { "sample_type", after.sampleType },
    { "bytes", outcome.bytes } };
  session.result["written"]["hash"] = after.hash;
  if (after.hash.empty()) // built without OpenSSL
    session.result["written"]["hash"] = nullptr;
  if (outcome.slices.slices > 0)
    session.result["written"]["slices"] = outcome.slices.slices;
  session.result["compared"] = { { "identical", d.samples == 0 }, { "position_mm", d.positionMm },
    { "samples_rounded", d.samples }, { "largest_rounding", d.largest } };
  session.result["lost"] = lost;
}

} // namespace

void ConvertVolume(const ConvertOptions& options, OutputKind kind, Session& session)
{
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  if (kind == OutputKind::Segmentation && volume.segments.empty())
    throw Failure(ExitCode::WrongUse,
      "the volume has no segments; give OUT the ending .nrrd, or another of a volume");
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  try
  {
    WriteInspected(
      options.output,
      [&](const std::string& name)
      {
        session.progress.Step(
          "writing " +
          std::string(kind == OutputKind::Slices ? "slices" : FileLabel(options.output)));
        Write(options, kind, volume, name, session, outcome);
      },
      [&](const std::string& name) { Compare(volume, name, session, outcome); });
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back(
    { "converted file", outcome.bytes, spent.count(), "written, read back and compared" });
  Print(volume.passport, outcome, session);
}

} // namespace hasp
