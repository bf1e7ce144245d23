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

/// A tracker that says metres or inches is far off; a ruler is not.
constexpr double LeastSpread = 0.9, MostSpread = 1.1;

struct Choices
{
  std::string points, sightings, output;
  std::optional<std::array<double, 3>> eyesMm; ///< between the eyes, in the marker's axes
};

struct Fits
{
  CalibrationFit place;               ///< of the tracker in the room
  std::optional<CalibrationFit> seat; ///< of the marker on the head, on top
  const TrackerCalibration& Calibration() const { return (seat ? *seat : place).calibration; }
};

void RequireMillimetres(const CalibrationFit& fit)
{
  if (fit.spreadRatio >= LeastSpread && fit.spreadRatio <= MostSpread)
    return;
  char text[160];
  std::snprintf(text, sizeof text,
    "the room is %.4g times as wide as the tracker says, must be %g to %g: are the tracker's "
    "numbers millimetres?",
    fit.spreadRatio, LeastSpread, MostSpread);
  throw Failure(ExitCode::BadInput, text);
}

Fits Fit(const Choices& choices)
{
  try
  {
    Fits fits{ FitTrackerToRoom(ReadCalibrationPairs(choices.points)), {} };
    RequireMillimetres(fits.place);
    if (choices.eyesMm)
      fits.place.calibration.eyesInMarkerMm = { (*choices.eyesMm)[0], (*choices.eyesMm)[1],
        (*choices.eyesMm)[2] };
    ValidateTrackerCalibration(fits.place.calibration);
    if (!choices.sightings.empty())
      fits.seat = FitMarkerToHead(fits.place.calibration, ReadMarkerSightings(choices.sightings));
    return fits;
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, error.what());
  }
}

std::string Residuals(const CalibrationFit& fit, const char* what)
{
  std::string text;
  char line[80];
  for (std::size_t n = 0; n < fit.residualsMm.size(); ++n)
  {
    std::snprintf(line, sizeof line, "  %s %zu: %.2f mm\n", what, n + 1, fit.residualsMm[n]);
    text += line;
  }
  return text;
}

std::string Text(const Fits& fits)
{
  char line[200];
  std::snprintf(line, sizeof line,
    "%zu points, residual %.2f mm RMS; the room is %.4f times as wide as the tracker says\n",
    fits.place.residualsMm.size(), fits.place.rmsMm, fits.place.spreadRatio);
  std::string text = line + Residuals(fits.place, "point");
  if (!fits.seat)
    return text;
  const glm::dvec3& eyes = fits.seat->calibration.eyesInMarkerMm;
  std::snprintf(line, sizeof line,
    "%zu sightings, residual %.2f mm RMS; the eyes are at %.1f,%.1f,%.1f mm along the marker's "
    "axes\n",
    fits.seat->residualsMm.size(), fits.seat->rmsMm, eyes.x, eyes.y, eyes.z);
  return text + line + Residuals(*fits.seat, "sighting");
}

/// Of what rulers and trackers measure, not of hands that hold still.
void WarnOfLarge(const CalibrationFit& fit, const char* what, Session& session)
{
  constexpr double usual = 10.0; // mm
  const auto worst = std::max_element(fit.residualsMm.begin(), fit.residualsMm.end());
  if (fit.rmsMm <= usual)
    return;
  char text[200];
  std::snprintf(text, sizeof text,
    "the residual of the %ss is %.0f mm, more than rulers and trackers leave; measure again, first "
    "%s %zu (%.0f mm)",
    what, fit.rmsMm, what, std::size_t(worst - fit.residualsMm.begin()) + 1, *worst);
  SayWarning(session, text);
}

void Run(const Choices& choices, Session& session)
{
  RequireWritable(choices.output, { ".json" });
  RequireInput(choices.points);
  if (!choices.sightings.empty())
    RequireInput(choices.sightings);
  const Fits fits = Fit(choices);
  WriteFile(choices.output, FormatTrackerCalibration(fits.Calibration()));
  session.result["output"] = FileLabel(choices.output);
  session.result["rms_mm"] = fits.place.rmsMm;
  session.result["residuals_mm"] = fits.place.residualsMm;
  session.result["spread_ratio"] = fits.place.spreadRatio;
  if (fits.seat)
  {
    session.result["sightings_rms_mm"] = fits.seat->rmsMm;
    session.result["sightings_residuals_mm"] = fits.seat->residualsMm;
  }
  session.progress.Wipe();
  WarnOfLarge(fits.place, "point", session);
  if (fits.seat)
    WarnOfLarge(*fits.seat, "sighting", session);
  if (!session.json)
    std::cout << Text(fits);
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
  CLI::Option* eyes =
    verb
      ->add_option("--eyes-in-marker", choices->eyesMm,
        "x,y,z mm from what is tracked to the middle between the eyes, along the tracked axes, "
        "which are the head's")
      ->delimiter(',')
      ->check(Within(-1000.0, 1000.0));
  verb
    ->add_option("--sightings", choices->sightings,
      ".csv file of what the tracker said while you looked straight at the screen: finds the eyes "
      "and how what is tracked is turned on the head")
    ->excludes(eyes);
  AddCommonOptions(*verb, session);
  verb->footer(
    "POINTS has the line trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm, then a line a "
    "point:\nhold what is tracked to the screen's corners and to places in front of it, and write "
    "down what the\ntracker says and where it is: mm from the middle of the screen, x right, y up, "
    "z "
    "towards you.\nThree points fit always well; take four or more, not on a line. Residuals of a "
    "few mm are usual;\na point that stands out was mistaken.\n"
    "--sightings has the line "
    "trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm, then a\nline a "
    "sighting: the tracker's position and quaternion, and where the middle between your eyes "
    "was.\nHold your head straight; a few places before the screen are better than one.\n"
    "Example:\n"
    "  hasp calibrate points.csv --output desk.json\n"
    "  hasp view head.mha --stereo interlaced --screen 520x292 --head tracker.so "
    "--head-calibration desk.json\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, choices] { session.run = [&session, choices] { Run(*choices, session); }; });
}

} // namespace hasp
