#include "Failure.h"
#include "Files.h"
#include "PictureFile.h"
#include "SceneChoices.h"
#include "Session.h"
#include "Verbs.h"
#include "ViewKeys.h"
#include "ViewWindow.h"
#include "Windows.h"
#include "vtkHaspFileNames.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace hasp
{
namespace
{

struct Choices
{
  SceneChoices scene;
  SceneOptions options;
  std::string output;
};

ViewSettings SettingsOf(const LoadedScene& loaded, const SceneOptions& options)
{
  ViewSettings settings;
  settings.isoValue = options.isoValue;
  settings.camera = options.camera;
  if (loaded.passport)
  {
    settings.range = { loaded.passport->minimum, loaded.passport->maximum };
    settings.unit = loaded.passport->hounsfield ? "HU" : "";
  }
  return settings;
}

void Run(Choices choices, Session& session)
{
  if (!choices.output.empty())
    RequireWritable(choices.output, { ".png" });
  RequireDisplay();
  const LoadedScene loaded = ReadScene(choices.scene, choices.options, session);
  const SceneOptions& options = choices.options;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  window->SetWindowName("hasp view"); // no name of a file: it may be a patient's
  window->SetSize(options.resolution[0], options.resolution[1]);
  window->AddRenderer(renderer);
  interactor->SetRenderWindow(window);
  interactor->Initialize(); // first: VTK 9.1 crashes at the end where the window opened the display
  RequireOpenGL(window);
  SurfaceScene scene(renderer, loaded.input, options, session);
  ViewWindow view(scene, window, interactor, SettingsOf(loaded, options));
  session.progress.Wipe();
  if (choices.output.empty())
    view.Run();
  else
  {
    session.progress.Step("drawing");
    WriteFile(choices.output, PngFile(view.DrawComplete()));
    session.result["output"] = FileLabel(choices.output);
  }
  for (const ResourceUse& use : view.Resources())
    session.resources.push_back(use);
  session.result["isovalue"] = view.IsoValue();
}

} // namespace

void AddViewVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  SurfaceDrawing& drawing = choices->options.drawing;
  drawing.interactive = true;
  const auto& mappers = SurfaceMappers();
  if (std::find(mappers.begin(), mappers.end(), "raycaching") != mappers.end())
    drawing.mapper = "raycaching"; // an isovalue that changes all the time
  CLI::App* verb =
    app.add_subcommand("view", "Show an isosurface in a window, with a slider for the isovalue");
  AddSceneOptions(*verb, choices->scene, choices->options);
  verb->add_option("--output", choices->output,
    "Wait for no one: write the window as a .png file when it is complete, and end");
  AddCommonOptions(*verb, session);
  verb->footer(ViewKeys() + "\n"
                            "Examples:\n"
                            "  hasp view head.mha\n"
                            "  hasp view head.mha --isovalue 300 --ambient-occlusion 25 --shadows\n"
                            "  hasp view head.mha --surface guide.stl --view right\n"
                            "  hasp view head.mha --output window.png\n"
                            "It needs a display; hasp render draws pictures without.\n"
                            "Exit codes: 0 done, 1 wrong use, 2 bad input, 4 cannot draw.");
  verb->callback(
    [&session, choices] { session.run = [&session, choices] { Run(*choices, session); }; });
}

} // namespace hasp
