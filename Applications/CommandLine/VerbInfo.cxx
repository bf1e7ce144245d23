#include "CellsInput.h"
#include "CellsText.h"
#include "Evaluation/MeshCheck.h"
#include "Failure.h"
#include "PassportText.h"
#include "SegmentList.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "SurfacePassportText.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "Isosurface/ClusteredCells.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>

namespace hasp
{
namespace
{

void RefuseVolumeOptions(const VolumeChoices& choices)
{
  if (choices.series != 0 || choices.resample)
    throw Failure(ExitCode::WrongUse,
      "--series and --resample are for volumes; leave them out for surfaces and cells");
}

void RunOnCells(const VolumeChoices& choices, Session& session)
{
  RefuseVolumeOptions(choices);
  const auto cells = ReadCells(choices.input, session);
  session.resources.push_back({ "active cells", cells->Bytes(), 0.0, "held for the passport" });
  session.progress.Wipe();
  if (session.json)
    session.result["cells"] = CellsJson(*cells);
  else
    std::cout << CellsText(*cells);
}

void RunOnSurface(const VolumeChoices& choices, Session& session)
{
  RefuseVolumeOptions(choices);
  const auto start = std::chrono::steady_clock::now();
  const LoadedSurface read = ReadSurface(choices.input, FileLabel(choices.input), true, session);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ "surface", BytesOf(read), spent.count(),
    read.passport.format + ", " + read.passport.coordinateType });
  session.progress.Step("checking the mesh");
  const TriangleMesh triangles = MakeTriangleMesh(read.surface);
  const MeshCheck mesh = CheckMesh(WeldPoints(triangles));
  const std::string hash = SurfaceHash(triangles);
  session.progress.Wipe();
  if (session.json)
  {
    session.result["passport"] = SurfacePassportJson(read.passport, mesh);
    session.result["hash"] = hash;
  }
  else
    std::cout << SurfacePassportText(read.passport, mesh)
              << (hash.empty() ? "" : "hash        " + hash + "\n");
}

/// None: it is no segmentation, or its faults tell more than the first of them.
std::optional<LoadedVolume> ReadSegmentation(const VolumeChoices& choices, Session& session)
{
  if (!IsSegmentationName(choices.input))
    return {};
  try
  {
    return ReadVolume(choices, session);
  }
  catch (const Failure& failure)
  {
    if (failure.code == ExitCode::WrongUse)
      throw;
    return {};
  }
}

void Run(const VolumeChoices& choices, Session& session)
{
  if (IsCellFileName(choices.input))
    return RunOnCells(choices, session);
  if (IsSurfaceName(choices.input))
    return RunOnSurface(choices, session);
  const std::optional<LoadedVolume> segmentation = ReadSegmentation(choices, session);
  const Passport passport = segmentation ? segmentation->passport : InspectVolume(choices, session);
  session.progress.Wipe();
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  if (segmentation)
    segments = DescribeSegments(*segmentation, session.showNames);
  if (session.json)
  {
    session.result["passport"] = PassportJson(passport);
    if (segmentation)
      session.result["segments"] = segments;
  }
  else
    std::cout << PassportText(passport) << SegmentsText(segments);
  if (passport.faults.empty())
    return;
  session.resultStands = true;
  throw Failure(ExitCode::BadInput, ImportError(choices.input, passport).what());
}

} // namespace

void AddInfoVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<VolumeChoices>();
  options->hash = true;
  CLI::App* verb =
    app.add_subcommand("info", "Check a volume, a surface or active cells and print the passport");
  AddVolumeOptions(*verb, *options);
  verb->get_option("IN")->description(
    "Volume: a file, or a folder of slices; surface; or active cells, .hcells");
  AddCommonOptions(*verb, session);
  verb->footer(
    "The passport holds size, place, orientation, values and warnings, and nothing of the "
    "patient.\nA volume that no verb would take has faults; the passport lists all of them, with "
    "what to do.\n--resample mends tilt, gaps of up to 5 slices or 10 mm, uneven slices and copies "
    "of a slice,\nand says by how many millimetres surfaces may be off for it. A slice that is "
    "missing at the\nfirst or last place cannot be seen.\nExamples:\n"
    "  hasp info head.mha\n"
    "  hasp info slices/ --series 2 --json\n"
    "  hasp info slices/ --resample\n"
    "  hasp info guide.stl\n"
    "  hasp info head.hcells\n"
    "  hasp info case.seg.nrrd --show-names   # its segments, with their names\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input: the volume has faults.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
