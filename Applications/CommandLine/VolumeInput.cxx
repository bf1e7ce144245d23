#include "VolumeInput.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspFileNames.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <chrono>
#include <cstdio>
#include <iostream>
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

std::size_t Bytes(vtkImageData* image)
{
  const vtkDataArray* samples = image->GetPointData()->GetScalars();
  return static_cast<std::size_t>(samples->GetNumberOfValues()) *
         static_cast<std::size_t>(samples->GetDataTypeSize());
}

} // namespace

LoadedVolume ReadVolume(const std::string& path, int series, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + FileLabel(path));
  const ProgressFunction progress = [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
  VolumeReadSettings settings;
  settings.series = series;
  try
  {
    const auto start = std::chrono::steady_clock::now();
    LoadedVolume volume = LoadVolume(OpenVolume(path, settings, progress), progress);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    session.resources.push_back({ "volume", Bytes(volume.image), spent.count(),
      volume.passport.format + ", " + volume.passport.sampleType });
    return volume;
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, SafeText(error));
  }
}

void SayWarnings(const Passport& passport, Session& session)
{
  session.progress.Wipe();
  if (!session.quiet)
    for (const std::string& warning : passport.warnings)
      std::cerr << "hasp: warning: " << warning << std::endl;
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
