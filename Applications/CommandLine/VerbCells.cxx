#include "CellsText.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeSlabReader.h"

#include "Isosurface/SlabExtraction.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

struct CellsOptions
{
  VolumeChoices volume;
  std::string output;
  double isoValue = 0.0;
  bool compact = false;
  std::size_t limitMiB = 4096;
};

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What `work` gives, its exceptions as failures of the verb.
template <typename Work>
auto Doing(ExitCode otherwise, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::WrongUse, WithoutFunctionNames(SafeText(error)));
  }
  catch (const std::exception& error)
  {
    throw Failure(otherwise, SafeText(error));
  }
}

ProgressFunction ShowOn(Session& session)
{
  return [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
}

std::unique_ptr<VolumeSlabReader> OpenSlabs(const CellsOptions& options, Session& session)
{
  RequireInput(options.volume.input);
  session.progress.Step("reading " + FileLabel(options.volume.input));
  VolumeReadSettings settings;
  settings.series = options.volume.series;
  settings.resample = options.volume.resample;
  settings.memoryLimitBytes = options.limitMiB << 20;
  auto reader = Doing(ExitCode::BadInput,
    [&] {
      return std::make_unique<VolumeSlabReader>(options.volume.input, settings, ShowOn(session));
    });
  SayWarnings(reader->GetPassport(), session);
  if (!reader->Streams() && !session.quiet)
    std::cerr << "hasp: the volume is loaded, " << reader->BytesHeld()
              << " bytes: only MetaImage, NRRD and NIfTI of int16, uint16, uint8 and float32 are "
                 "read in slabs\n";
  return reader;
}

/// The kernel's refusal in the words of the command line.
Failure TooSmall(std::size_t limitMiB, std::size_t neededBytes, double share)
{
  return Failure(ExitCode::WrongUse,
    "--memory-limit is " + std::to_string(limitMiB) + " MiB, and " +
      std::to_string(neededBytes / (1 << 20) + 1) + " are needed at least, after " +
      std::to_string(int(100.0 * share)) +
      " % of the volume: raise it, crop the volume or choose another --isovalue");
}

ClusteredCells Extract(VolumeSlabReader& reader, const CellsOptions& options, Session& session)
{
  session.progress.Step("extracting active cells");
  const std::size_t limit = options.limitMiB << 20;
  SlabSettings settings;
  settings.precision = options.compact ? CellPrecision::Compact : CellPrecision::Exact;
  const std::size_t loaded = reader.Streams() ? 0 : std::min(limit, reader.BytesHeld());
  settings.memoryCapBytes = limit - loaded;
  const auto start = Clock::now();
  double reading = 0.0;
  const SlabSource slabs = [&](int first, int count)
  {
    const auto asked = Clock::now();
    const AnyGridView slab = reader.Read(first, count);
    reading += MillisecondsSince(asked);
    return slab;
  };
  ClusteredCells cells = Doing(ExitCode::BadInput,
    [&]
    {
      try
      {
        return ExtractActiveCellsFromSlabs(
          reader.GetPassport().geometry, slabs, options.isoValue, settings, ShowOn(session));
      }
      catch (const MemoryCapExceeded& error)
      {
        throw TooSmall(options.limitMiB, loaded + error.neededBytes, error.share);
      }
    });
  const Passport& passport = reader.GetPassport();
  session.resources.push_back({ reader.Streams() ? "volume, a slab of it" : "volume",
    reader.BytesHeld(), reading, passport.format + ", " + passport.sampleType });
  session.resources.push_back({ "active cells", cells.Bytes(), MillisecondsSince(start) - reading,
    std::to_string(cells.Count()) + " cells, slab by slab" });
  session.resources.push_back({ "mesh", 0, 0.0, "active cells need none" });
  return cells;
}

void Run(const CellsOptions& options, Session& session)
{
  RequireWritable(options.output, { ".hcells" });
  if (!std::isfinite(static_cast<float>(options.isoValue)))
    throw Failure(ExitCode::WrongUse, "--isovalue must be a finite number");
  const auto reader = OpenSlabs(options, session);
  const ClusteredCells cells = Extract(*reader, options, session);
  if (cells.Count() == 0)
    throw Failure(ExitCode::WrongUse,
      "--isovalue has no surface in the volume; hasp info says its values' range");
  session.progress.Step("writing " + FileLabel(options.output));
  const auto start = Clock::now();
  Doing(ExitCode::WrongUse, [&] { WriteCells(cells, options.output, ShowOn(session)); });
  const double spent = MillisecondsSince(start);
  std::error_code gone;
  session.resources.push_back({ "file", std::filesystem::file_size(options.output, gone), spent,
    "on disk; the cells were checked before" });
  session.progress.Wipe();
  session.result["output"] = FileLabel(options.output);
  if (session.json)
    session.result["cells"] = CellsJson(cells);
  else
    std::cout << CellsText(cells);
}

} // namespace

void AddCellsVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<CellsOptions>();
  CLI::App* verb =
    app.add_subcommand("cells", "Write an isosurface as active cells, without a mesh");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--isovalue", options->isoValue, "In the volume's units; bone in CT: 226")
    ->required();
  verb->add_option("--output", options->output, "The .hcells file; its folder must exist")
    ->required();
  verb->add_flag("--compact", options->compact,
    "8 bits a corner in place of the samples; the surface moves by about 0.004 voxel (RMS)");
  verb
    ->add_option("--memory-limit", options->limitMiB,
      "MiB that slices and cells may take together; a volume that cannot be read in slabs counts "
      "whole")
    ->check(CLI::Range(1, 1 << 20))
    ->capture_default_str();
  AddCommonOptions(*verb, session);
  verb->footer(
    "The file holds all that drawing the exact surface takes: hasp render draws it without the "
    "volume.\nMetaImage, NRRD and NIfTI are read some slices at a time, so the volume need not fit "
    "into memory.\nExamples:\n"
    "  hasp cells head.mha --isovalue 226 --output head.hcells\n"
    "  hasp cells huge.nrrd --isovalue 226 --compact --memory-limit 512 --output huge.hcells\n"
    "  hasp render head.hcells --output head.png\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
