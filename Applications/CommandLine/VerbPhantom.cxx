#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Grid/Phantom.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>
#include <stdexcept>

namespace hasp
{
namespace
{

struct PhantomOptions
{
  std::string output;
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  PhantomSettings settings;
  bool intact = false;
};

/// 4 GiB of samples: what readers take back by default.
constexpr std::size_t LargestPhantom = std::size_t{ 1 } << 31;

void Run(const PhantomOptions& options, Session& session)
{
  RequireWritable(options.output, { ".mha", ".vti" });
  PhantomSettings settings = options.settings;
  settings.defect = !options.intact;
  session.progress.Step("sampling the phantom");
  const auto start = std::chrono::steady_clock::now();
  vtkSmartPointer<vtkImageData> image;
  try
  {
    const GridGeometry grid =
      PhantomGrid({ options.spacing[0], options.spacing[1], options.spacing[2] }, settings);
    if (grid.Size() > LargestPhantom)
      throw std::invalid_argument("the phantom would have " + std::to_string(grid.Size()) +
                                  " samples, at most " + std::to_string(LargestPhantom) +
                                  "; give a larger --spacing");
    image = MakeImage(grid, SamplePhantom(grid, settings));
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back(
    { "volume", static_cast<std::size_t>(image->GetNumberOfPoints()) * sizeof(std::int16_t),
      spent.count(), "phantom, int16" });
  session.progress.Step("writing " + FileLabel(options.output));
  try
  {
    WriteVolume(image, options.output);
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  session.result["output"] = FileLabel(options.output);
}

} // namespace

void AddPhantomVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<PhantomOptions>();
  CLI::App* verb = app.add_subcommand("phantom", "Write a head-like CT with known truth");
  verb->add_option("--output", options->output, "The .mha or .vti file; its folder must exist")
    ->required();
  verb->add_option("--spacing", options->spacing, "x,y,z in mm; one value each, may differ")
    ->delimiter(',')
    ->check(Within(0.05, 50.0))
    ->capture_default_str();
  verb->add_option("--noise", options->settings.noiseHU, "Standard deviation of added noise, HU")
    ->check(Within(0.0, 1000.0))
    ->capture_default_str();
  verb->add_option("--seed", options->settings.seed, "Of the noise")->capture_default_str();
  verb->add_flag("--intact", options->intact, "Without the hole in the right frontal bone");
  AddCommonOptions(*verb, session);
  verb->footer("Bone is 1000 HU, soft tissue 40, air -1000; the bone's surface is known in closed "
               "form.\nExample: hasp phantom --spacing 1,1,1.5 --output head.mha\n"
               "Exit codes: 0 done, 1 wrong use.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
