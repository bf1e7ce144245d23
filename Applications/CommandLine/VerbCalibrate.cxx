#include "Devices/TrackerCalibration.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace hasp
{
namespace
{

struct Choices
{
  std::string points, output;
  std::optional<std::array<double, 3>> eyesMm; ///< between the eyes, in the marker's axes
};

CalibrationFit Fit(const Choices& choices)
{
  try
  {
    CalibrationFit fit = FitTrackerToRoom(ReadCalibrationPairs(choices.points));
    if (choices.eyesMm)
      fit.calibration.eyesInMarkerMm = { (*choices.eyesMm)[0], (*choices.eyesMm)[1],
        (*choices.eyesMm)[2] };
    ValidateTrackerCalibration(fit.calibration);
    return fit;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, error.what());
  }
}

std::string Text(const CalibrationFit& fit)
{
  char line[160];
  std::snprintf(line, sizeof line,
    "%zu points, residual %.2f mm RMS; the room is %.4f times as wide as the tracker says\n",
    fit.residualsMm.size(), fit.rmsMm, fit.spreadRatio);
  std::string text = line;
  for (std::size_t n = 0; n < fit.residualsMm.size(); ++n)
  {
    std::snprintf(line, sizeof line, "  point %zu: %.2f mm\n", n + 1, fit.residualsMm[n]);
    text += line;
  }
  return text;
}

void Run(const Choices& choices, Session& session)
{
  RequireWritable(choices.output, { ".json" });
  RequireInput(choices.points);
  const CalibrationFit fit = Fit(choices);
  WriteFile(choices.output, FormatTrackerCalibration(fit.calibration));
  session.result["output"] = FileLabel(choices.output);
  session.result["rms_mm"] = fit.rmsMm;
  session.result["residuals_mm"] = fit.residualsMm;
  session.result["spread_ratio"] = fit.spreadRatio;
  session.progress.Wipe();
  if (!session.json)
    std::cout << Text(fit);
}

} // namespace

void AddCalibrateVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  CLI::App* verb =
    app.add_subcommand("calibrate", "Find where a head tracker stands before the screen");
  verb
    ->add_option(
      "POINTS", choices->points, ".csv file of points that the tracker and you have measured")
    ->required();
  verb->add_option("--output", choices->output, "The .json file; its folder must exist")
    ->required();
  verb
    ->add_option("--eyes-in-marker", choices->eyesMm,
      "x,y,z mm from what is tracked to the middle between the eyes, along the tracked axes")
    ->delimiter(',')
    ->check(Within(-1000.0, 1000.0));
  AddCommonOptions(*verb, session);
  verb->footer(
    "POINTS has the line trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm, then a line a "
    "point:\nhold what is tracked to the screen's corners and to places in front of it, and write "
    "down what the\ntracker says and where it is: mm from the middle of the screen, x right, y up, "
    "z "
    "towards you.\nThree points fit always well; take four or more, not on a line. Residuals of a "
    "few mm are usual;\na point that stands out was mistaken.\nExample:\n"
    "  hasp calibrate points.csv --output desk.json\n"
    "  hasp view head.mha --stereo interlaced --screen 520x292 --head tracker.so "
    "--head-calibration desk.json\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, choices] { session.run = [&session, choices] { Run(*choices, session); }; });
}

} // namespace hasp
